#include "formats/number_text.h"

#include <charconv>
#include <cmath>

#include "base/check.h"

namespace enfilade {
namespace {

/// Between these, people write numbers out; beyond, as in 1e-09, the exponent is easier to read.
constexpr double kLeastWrittenOut = 1e-6, kMostWrittenOut = 1e15;

}  // namespace

std::string number_text(double number) {
    ENFILADE_CHECK(std::isfinite(number));
    const double size = std::abs(number);
    const bool written_out = size == 0 || (size >= kLeastWrittenOut && size < kMostWrittenOut);
    const auto format = written_out ? std::chars_format::fixed : std::chars_format::scientific;
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, number + 0.0, format).ptr;
    return {digits, end};
}

std::string counted(std::size_t count, std::string_view noun) {
    return std::to_string(count) + ' ' + std::string(noun) + (count == 1 ? "" : "s");
}

std::optional<double> parse_number(std::string_view text) {
    if (text.starts_with('+')) {
        text.remove_prefix(1);
        if (text.starts_with('-')) return {};
    }
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) return {};
    return number;
}

}  // namespace enfilade
