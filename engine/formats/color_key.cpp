#include "formats/color_key.h"

#include <charconv>

#include "formats/quoted.h"

namespace enfilade {

std::optional<std::uint32_t> read_color(Reading& reading, const NamedValue& value) {
    const TomlNode node = value.node;
    if (node.kind() == TomlKind::integer && node.integer() >= 0 && node.integer() <= 0xFFFFFF)
        return static_cast<std::uint32_t>(node.integer());
    const std::string_view text = node.kind() == TomlKind::string ? node.text() : "";
    std::uint32_t color = 0;
    if (text.size() == 7 && text[0] == '#') {
        const auto [end, error] = std::from_chars(text.data() + 1, text.data() + 7, color, 16);
        if (error == std::errc() && end == text.data() + 7) return color;
    }
    reading.error(node.place(), "bad-color",
                  quoted(value.name) + " must be a colour like \"#ff00ff\", found " +
                      (node.kind() == TomlKind::string ? quoted(node.text()) : std::string(name_of(node.kind()))));
    return {};
}

std::string color_text(std::uint32_t color) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text = "#";
    for (int shift = 20; shift >= 0; shift -= 4) text += kDigits[(color >> shift) & 15];
    return text;
}

}  // namespace enfilade
