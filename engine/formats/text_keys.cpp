#include "formats/map_keys.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/text.h"
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

namespace {

constexpr std::string_view kShape = "expected \"NAME [SU,SV [OU,OV] [OUm,OVm]]\"";

/// Takes the next word off the front of the text. A comma ends a word and is one by itself.
std::string_view take_word(std::string_view& text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    std::size_t length = 0;
    while (length < text.size() && !is_blank(text[length]) && text[length] != ',') ++length;
    if (length == 0 && !text.empty()) length = 1;
    const std::string_view word = text.substr(0, length);
    text.remove_prefix(length);
    return word;
}

/// Like take_word, but commas belong to names.
std::string_view take_name(std::string_view& text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    std::size_t length = 0;
    while (length < text.size() && !is_blank(text[length])) ++length;
    const std::string_view word = text.substr(0, length);
    text.remove_prefix(length);
    return word;
}

Error bad_spec(std::string what) { return {"", std::move(what)}; }

constexpr std::string_view kMetres = "m";

/// unit: what follows each of the two numbers, maybe nothing
Result<Vec2> take_pair(std::string_view& text, std::string_view what, std::string_view unit = "") {
    Vec2 pair;
    for (double* number : {&pair.x, &pair.y}) {
        const std::string_view word = take_word(text);
        const auto value =
            word.ends_with(unit) ? parse_number(word.substr(0, word.size() - unit.size())) : std::nullopt;
        if (!value)
            return bad_spec(std::string(kShape) + ": " + std::string(what) + " is a pair of numbers" +
                            (unit.empty() ? "" : " with '" + std::string(unit) + "' behind each") + ", found " +
                            (word.empty() ? "the end" : in_quotes(word)));
        *number = *value;
        const std::string_view behind = number == &pair.x ? take_word(text) : ",";
        if (behind == kMetres) return bad_spec("expected 'm' right behind its number, found a blank between them");
        if (behind != ",")
            return bad_spec(std::string(kShape) + ": " + std::string(what) +
                            " is a pair, the second number is missing");
    }
    return pair;
}

bool is_tile(double metres) { return std::abs(metres) >= kMinTile && std::abs(metres) <= kMaxTile; }

bool only_blanks(std::string_view text) { return text.find_first_not_of(" \t") == std::string_view::npos; }

std::string number_pair(Vec2 pair) { return number_text(pair.x) + "," + number_text(pair.y); }

Result<void> take_tile(std::string_view& text, TextureSpec& spec) {
    std::string_view rest = text;
    if (take_word(rest) == "-") {
        text = rest;
        if (only_blanks(text)) return bad_spec(std::string(kShape) + ": behind '-' the offset is missing");
        return {};
    }
    const Result<Vec2> tile = take_pair(text, "SU,SV");
    if (!tile) return tile.error();
    if (!is_tile(tile.value().x) || !is_tile(tile.value().y))
        return bad_spec("SU and SV are metres per tile: expected sizes from 2^-16 to 2^16, found " +
                        number_pair(tile.value()));
    spec.tile_m = tile.value();
    return {};
}

bool is_offset(Vec2 offset) {
    return std::abs(offset.x) <= kMaxTextureOffset && std::abs(offset.y) <= kMaxTextureOffset;
}

bool is_in_metres(std::string_view text) { return take_word(text).ends_with(kMetres); }

Result<void> take_offset(std::string_view& text, TextureSpec& spec) {
    const Result<Vec2> offset = take_pair(text, "OU,OV");
    if (!offset) return offset.error();
    spec.offset_tx = offset.value();
    if (is_offset(spec.offset_tx)) return {};
    return bad_spec("OU and OV are texels: expected at most 2^20, found " + number_pair(spec.offset_tx));
}

Result<void> take_offset_in_metres(std::string_view& text, TextureSpec& spec) {
    const Result<Vec2> offset = take_pair(text, "OUm,OVm", kMetres);
    if (!offset) return offset.error();
    spec.move_by(offset.value());
    if (is_offset(offset.value())) return {};
    return bad_spec("OUm and OVm are metres: expected at most 2^20, found " + number_pair(offset.value()));
}

}  // namespace

Result<TextureSpec> parse_texture_spec(std::string_view text) {
    TextureSpec spec;
    spec.name = take_name(text);
    if (spec.name.empty()) return bad_spec(std::string(kShape) + ", found an empty string");
    if (const Result<void> valid = refuse_as_file_name(spec.name); !valid.ok()) return valid.error();
    if (only_blanks(text)) return spec;
    if (const Result<void> valid = take_tile(text, spec); !valid.ok()) return valid.error();
    if (only_blanks(text)) return spec;
    if (!is_in_metres(text))
        if (const Result<void> valid = take_offset(text, spec); !valid.ok()) return valid.error();
    if (is_in_metres(text))
        if (const Result<void> valid = take_offset_in_metres(text, spec); !valid.ok()) return valid.error();
    if (!only_blanks(text)) return bad_spec(std::string(kShape) + ", found more behind it");
    return spec;
}

std::string to_text(const TextureSpec& spec) {
    std::string text = spec.name;
    const bool has_texels = spec.offset_tx != Vec2{}, has_metres = bool(spec.offset_m);
    if (spec.tile_m) text += " " + number_pair(*spec.tile_m);
    if (!spec.tile_m && (has_texels || has_metres)) text += " -";
    if (has_texels) text += " " + number_pair(spec.offset_tx);
    if (has_metres) text += " " + number_text(spec.offset_m->x) + "m," + number_text(spec.offset_m->y) + "m";
    return text;
}

}  // namespace enfilade
