#include "formats/text_parts.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "base/result.h"
#include "base/text.h"
#include "formats/map_keys.h"

namespace enfilade {
namespace {

/// Longest part of a file's word that a message repeats [bytes].
constexpr std::size_t kShownBytes = 60;

/// How many letters must be put in, taken out, replaced or swapped with their neighbour to turn one word into the
/// other (optimal string alignment; Damerau, "A technique for computer detection and correction of spelling errors",
/// 1964). Cost: the product of the lengths.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> two_ago(b.size() + 1), previous(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::swap(two_ago, previous);
        std::swap(previous, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({replaced, previous[j] + 1, row[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], two_ago[j - 2] + 1);
        }
    }
    return row[b.size()];
}

}  // namespace

std::string in_quotes(std::string_view word) {
    std::size_t length = std::min(word.size(), kShownBytes);
    while (length < word.size() && length > 0 && (static_cast<unsigned char>(word[length]) & 0xC0) == 0x80) --length;
    return "'" + printable_line(word.substr(0, length)) + (length < word.size() ? "…'" : "'");
}

std::string_view nearest_word(std::string_view word, std::span<const std::string_view> known) {
    std::size_t best = word.size() > kShownBytes ? 0 : 1 + word.size() / 3;
    std::string_view nearest;
    for (std::string_view candidate : known) {
        const std::size_t distance =
            best == 0 || candidate.size() > word.size() + best ? best + 1 : edit_distance(word, candidate);
        if (distance > best || distance == 0 || (distance == best && !nearest.empty())) continue;
        best = distance;
        nearest = candidate;
    }
    return nearest;
}

std::string nearest_suggestion(std::string_view word, std::span<const std::string_view> known) {
    const std::string_view nearest = nearest_word(word, known);
    return nearest.empty() ? std::string() : "; did you mean " + in_quotes(nearest) + "?";
}

std::string suggestion(std::string_view word, std::span<const std::string_view> known) {
    if (std::string near = nearest_suggestion(word, known); !near.empty()) return near;
    std::string list = "; known here: ";
    for (std::string_view candidate : known) list += std::string(candidate) + ", ";
    list.resize(list.size() - 2);
    return list;
}

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

std::string coordinate_text(double coordinate) {
    const double grid = snap_to_vertex_grid({coordinate, 0}).x == coordinate ? kVertexGrid : kPointGrid;
    constexpr int kMostDecimals = 12;  // more than either grid needs
    double tenths = 1;
    for (int decimals = 0; decimals <= kMostDecimals; ++decimals, tenths *= 10) {
        const double rounded = std::round(coordinate * tenths) / tenths;
        if (std::fabs(rounded - coordinate) < grid / 2) return number_text(rounded);
    }
    return number_text(coordinate);
}

std::string point_text(Vec2 point) { return "(" + coordinate_text(point.x) + ", " + coordinate_text(point.y) + ")"; }

std::string csv_field(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

namespace {

/// Char of XML 1.0 (section 2.2), of what UTF-8 can hold.
bool is_xml(char32_t c) { return c >= 0x20 ? c != 0xFFFE && c != 0xFFFF : c == '\t' || c == '\n' || c == '\r'; }

/// What stands in XML for the character at the start of the text, of `length` bytes [0: it is none].
std::string xml_character(std::string_view text, std::size_t length) {
    if (length == 0 || !is_xml(utf8_character(text))) return "\uFFFD";
    switch (text[0]) {
        case '&': return "&amp;";
        case '<': return "&lt;";
        case '>': return "&gt;";
        case '"': return "&quot;";
        case '\t': return "&#9;";  // as they are, readers take these for blanks and line ends of their own
        case '\n': return "&#10;";
        case '\r': return "&#13;";
        default: return std::string(text.substr(0, length));
    }
}

}  // namespace

std::string xml_escaped(std::string_view text) {
    std::string safe;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        safe += xml_character(text, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return safe;
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

namespace {

std::string escaped(char c) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    switch (c) {
        case '"': return "\\\"";
        case '\\': return "\\\\";
        case '\n': return "\\n";
        case '\t': return "\\t";
        default: break;
    }
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte != 0x7F) return {c};
    return std::string("\\u00") + kDigits[byte >> 4] + kDigits[byte & 15];
}

}  // namespace

std::string string_text(std::string_view text) {
    std::string quoted = "\"";
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        quoted += length == 0 ? "\\uFFFD" : length == 1 ? escaped(text[0]) : std::string(text.substr(0, length));
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return quoted + '"';
}

std::string value_text(double number) { return number_text(number); }
std::string value_text(int number) { return std::to_string(number); }
std::string value_text(bool truth) { return truth ? "true" : "false"; }
std::string value_text(const std::string& text) { return string_text(text); }
std::string value_text(Vec2 pair) { return "[" + number_text(pair.x) + ", " + number_text(pair.y) + "]"; }
std::string value_text(const TextureSpec& spec) { return string_text(to_text(spec)); }
std::string value_text(const RectRecord& rect) {
    return "[" + number_text(rect.a.x) + ", " + number_text(rect.a.y) + ",  " + number_text(rect.b.x) + ", " +
           number_text(rect.b.y) + "]";
}

std::string value_text(const std::vector<std::string>& texts) {
    std::string list;
    for (const std::string& text : texts) list += (list.empty() ? "" : ", ") + string_text(text);
    return "[" + list + "]";
}

void TableText::add(std::string_view key, std::string_view value) {
    if (style_ == Style::braces && !pairs_.empty()) pairs_ += ", ";
    pairs_.append(key).append(" = ").append(value);
    if (style_ == Style::lines) pairs_ += '\n';
}

std::string TableText::text() const {
    if (style_ == Style::lines) return pairs_;
    return pairs_.empty() ? "{}" : "{ " + pairs_ + " }";
}

}  // namespace enfilade
