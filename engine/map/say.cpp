#include "map/say.h"

#include <array>
#include <charconv>

namespace enfilade {

std::string quoted(std::string_view name) {
    constexpr std::size_t kLongest = 60;  ///< a finding stays one line on a screen [bytes]
    std::string text = "'";
    for (char c : name.substr(0, kLongest)) text += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
    return text + (name.size() > kLongest ? "…'" : "'");
}

std::string to_text(double number) {
    std::array<char, 32> digits;  // the longest shortest double has 24 characters
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number);
    return {digits.data(), end.ptr};
}

std::string to_text(Vec2 point) { return "(" + to_text(point.x) + ", " + to_text(point.y) + ")"; }

std::string edge_text(Vec2 a, Vec2 b) { return to_text(a) + "-" + to_text(b); }

}  // namespace enfilade
