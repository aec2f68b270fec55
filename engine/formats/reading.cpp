#include "formats/reading.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "formats/map_keys.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

std::string is_to_be(const NamedValue& value, std::string_view expected) {
    return in_quotes(value.name) + " must be " + std::string(expected);
}

/// A limit in a message: six digits say enough, and hide the half grid step that vertices may round away.
std::string limit_text(double limit) {
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, limit, std::chars_format::general, 6).ptr};
}

void out_of_range(Reading& reading, const NamedValue& value, Range range, double found) {
    reading.error(value.node.place(), "out-of-range",
                  is_to_be(value, range_text(range)) + ", found " + number_text(found));
}

/// The number in its range, or none with a finding.
std::optional<double> number_in(Reading& reading, const NamedValue& value, Range range) {
    if (value.node.kind() != TomlKind::integer && value.node.kind() != TomlKind::real) {
        wrong_type(reading, value, "a number");
        return {};
    }
    const double number = value.node.number();
    if (!std::isfinite(number)) {
        reading.error(value.node.place(), "bad-number",
                      is_to_be(value, "a finite number") + (std::isnan(number) ? ", found nan" : ", found infinity"));
        return {};
    }
    if (number < range.low || number > range.high) out_of_range(reading, value, range, number);
    return std::clamp(number, range.low, range.high);
}

}  // namespace

std::string range_text(Range range) {
    if (range.high == Range{}.high) return "at least " + limit_text(range.low);
    return "from " + limit_text(range.low) + " to " + limit_text(range.high);
}

void Reading::error(TextPlace place, std::string_view code, std::string sentence) {
    if (findings.size() > kMaxFindings) return;
    if (findings.size() == kMaxFindings)
        findings.push_back({place, Severity::error, "too-many-findings",
                            "there is more wrong than these " + std::to_string(kMaxFindings) + " findings"});
    else
        findings.push_back({place, Severity::error, std::string(code), std::move(sentence)});
}

void wrong_type(Reading& reading, const NamedValue& value, std::string_view expected) {
    std::string found(name_of(value.node.kind()));
    if (value.node.kind() == TomlKind::array) found += " of " + std::to_string(value.node.size());
    reading.error(value.node.place(), "wrong-type", is_to_be(value, expected) + ", found " + found);
}

bool expect(Reading& reading, const NamedValue& value, TomlKind kind) {
    if (value.node.kind() == kind) return true;
    wrong_type(reading, value, name_of(kind));
    return false;
}

bool expect_table(Reading& reading, const NamedValue& value, std::string_view key) {
    if (value.node.kind() == TomlKind::table) return true;
    wrong_type(reading, value, "a table, as in { " + std::string(key) + " = … }");
    return false;
}

bool expect_tables(Reading& reading, const NamedValue& value) {
    if (value.node.kind() != TomlKind::table) return expect(reading, value, TomlKind::array);
    reading.error(value.node.place(), "wrong-type",
                  is_to_be(value, "an array of tables") +
                      ", found one table; write two brackets around its name, as in [[" + std::string(value.name) +
                      "]], or an array, [{ … }]");
    return false;
}

std::optional<std::size_t> read_word(Reading& reading, const NamedValue& value,
                                     std::span<const std::string_view> words) {
    if (!expect(reading, value, TomlKind::string)) return {};
    const auto it = std::find(words.begin(), words.end(), value.node.text());
    if (it != words.end()) return static_cast<std::size_t>(it - words.begin());
    std::string list;
    for (std::string_view word : words) list += (list.empty() ? "\"" : ", \"") + std::string(word) + "\"";
    reading.error(value.node.place(), "unknown-word",
                  is_to_be(value, "one of " + list) + ", found " + in_quotes(value.node.text()) +
                      nearest_suggestion(value.node.text(), words));
    return {};
}

void read_value(Reading& reading, const NamedValue& value, Range range, double& field) {
    if (const auto number = number_in(reading, value, range)) field = *number;
}

void read_value(Reading& reading, const NamedValue& value, Range range, std::optional<double>& field) {
    if (const auto number = number_in(reading, value, range)) field = *number;
}

void read_value(Reading& reading, const NamedValue& value, Range range, int& field) {
    const Range whole{std::max(range.low, -2147483648.0), std::min(range.high, 2147483647.0)};
    if (!expect(reading, value, TomlKind::integer)) return;
    if (const auto number = number_in(reading, value, whole)) field = static_cast<int>(*number);
}

void read_value(Reading& reading, const NamedValue& value, Range, bool& field) {
    if (expect(reading, value, TomlKind::boolean)) field = value.node.boolean();
}

void read_value(Reading& reading, const NamedValue& value, Range range, Vec2& field) {
    if (value.node.kind() != TomlKind::array || value.node.size() != 2)
        return wrong_type(reading, value, "an array of two numbers");
    read_value(reading, {value.name, value.node.at(0)}, range, field.x);
    read_value(reading, {value.name, value.node.at(1)}, range, field.y);
}

void read_value(Reading& reading, const NamedValue& value, Range range, RectRecord& field) {
    field.place = value.node.place();
    if (value.node.kind() != TomlKind::array || value.node.size() != 4)
        return wrong_type(reading, value, "an array of four numbers, x0, y0, x1, y1");
    double* const numbers[] = {&field.a.x, &field.a.y, &field.b.x, &field.b.y};
    for (std::size_t i = 0; i < 4; ++i) read_value(reading, {value.name, value.node.at(i)}, range, *numbers[i]);
}

void read_value(Reading& reading, const NamedValue& value, Range, std::string& field) {
    if (!expect(reading, value, TomlKind::string)) return;
    if (value.node.text().empty())
        return reading.error(value.node.place(), "empty-string", is_to_be(value, "a string that is not empty"));
    field = value.node.text();
}

void read_value(Reading& reading, const NamedValue& value, Range range, std::vector<std::string>& field) {
    if (!expect(reading, value, TomlKind::array)) return;
    field.clear();
    for (std::size_t i = 0; i < value.node.size() && !reading.is_full(); ++i)
        read_value(reading, {value.name, value.node.at(i)}, range, field.emplace_back());
}

void read_value(Reading& reading, const NamedValue& value, Range, TextureSpec& field) {
    field.place = value.node.place();
    if (!expect(reading, value, TomlKind::string)) return;
    Result<TextureSpec> spec = parse_texture_spec(value.node.text());
    if (!spec)
        return reading.error(value.node.place(), "bad-texture-spec", in_quotes(value.name) + ": " + spec.error().what);
    field = std::move(spec).value();
    field.place = value.node.place();
}

void read_value(Reading& reading, const NamedValue& value, Range range, std::optional<TextureSpec>& field) {
    TextureSpec spec;
    read_value(reading, value, range, spec);
    if (!spec.name.empty()) field = std::move(spec);
}

}  // namespace enfilade
