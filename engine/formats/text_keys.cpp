#include "formats/text_keys.h"

#include <algorithm>
#include <charconv>

#include "base/terminal.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

Result<void> expected(std::string_view what, std::string_view found, std::string_view reason) {
    return Error{"", "expected " + std::string(what) + ", found " + in_quotes(found) + std::string(reason)};
}

/// What is wrong with one part of a name; empty if nothing is.
std::string_view fault_of_part(std::string_view part) {
    if (part.empty()) return "; parts of a name have one '/' between them, and none at either end";
    if (part == ".") return "; leave '.' out of it";
    if (part == "..") return "; it must not lead out of its folder by '..'";
    return "";
}

}  // namespace

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
                  in_quotes(value.name) + " must be a colour like \"#ff00ff\", found " +
                      (node.kind() == TomlKind::string ? in_quotes(node.text()) : std::string(name_of(node.kind()))));
    return {};
}

std::string color_text(std::uint32_t color) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text = "#";
    for (int shift = 20; shift >= 0; shift -= 4) text += kDigits[(color >> shift) & 15];
    return text;
}

Result<void> refuse_as_file_name(std::string_view text) {
    constexpr std::string_view kWhat = "a file's name";
    if (!is_printable_line(text)) return expected(kWhat, text, " with characters that are not printed");
    if (text.starts_with('/')) return expected(kWhat, text, "; it must not start with '/', but below its folder");
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find('/', start), text.size());
        const std::string_view fault = fault_of_part(text.substr(start, end - start));
        if (!fault.empty()) return expected(kWhat, text, fault);
        start = end + 1;
    }
    return {};
}

Result<void> refuse_as_path(std::string_view text) {
    if (is_printable_line(text)) return {};
    return expected("a path", text, " with characters that are not printed");
}

bool expect_file_name(Reading& reading, const NamedValue& value, Files files) {
    const std::string_view name = value.node.text();
    const Result<void> valid = files == Files::anywhere ? refuse_as_path(name) : refuse_as_file_name(name);
    if (!valid.ok())
        reading.error(value.node.place(), "bad-file-name", in_quotes(value.name) + ": " + valid.error().what);
    return valid.ok();
}

void read_file_name(Reading& reading, const NamedValue& value, Files files, std::string& field) {
    std::string name;
    read_value(reading, value, {}, name);
    if (!name.empty() && expect_file_name(reading, value, files)) field = std::move(name);
}

void read_file_name(Reading& reading, const NamedValue& value, Files files, std::vector<std::string>& field) {
    if (!expect(reading, value, TomlKind::array)) return;
    field.clear();
    for (std::size_t i = 0; i < value.node.size() && !reading.is_full(); ++i)
        read_file_name(reading, {value.name, value.node.at(i)}, files, field.emplace_back());
}

}  // namespace enfilade
