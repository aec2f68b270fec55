// Parts of texts: what is shown in a message, read line by line, or written as a person would.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/map_file.h"
#include "formats/words.h"
#include "math/vec.h"

namespace enfilade {

// Words of a hostile file, fit to be shown in a message.

/// The word in single quotes; what a terminal would obey becomes '?', and what is longer than 60 bytes is cut.
std::string in_quotes(std::string_view word);

/// The known word that takes the fewest changed letters, if it is near enough to be meant; else empty.
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> known);

/// "; did you mean 'X'?" with the known word nearest to this one, or nothing where none is near.
std::string nearest_suggestion(std::string_view word, std::span<const std::string_view> known);

/// "; did you mean 'X'?" with the known word nearest to this one, or "; known here: A, B, C" where none is near.
std::string suggestion(std::string_view word, std::span<const std::string_view> known);

/// Whether it parts words within a line.
constexpr bool is_blank(char c) { return c == ' ' || c == '\t'; }

// A text, line by line.

struct TextLine {
    std::string_view text;     ///< without its end
    std::uint32_t number = 0;  ///< from 1
};

/// Hands out one line after the other. Lines end with LF or CR LF; an end at the very end of the text starts no line.
class LineReader {
public:
    explicit LineReader(std::string_view text) : rest_(text) {}

    /// The next line, or none.
    std::optional<TextLine> next() {
        if (rest_.empty()) return {};
        const std::size_t end = rest_.find('\n');
        std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        if (line.ends_with('\r')) line.remove_suffix(1);
        return TextLine{line, ++number_};
    }

private:
    std::string_view rest_;
    std::uint32_t number_ = 0;
};

// Values and tables as TOML text, laid out as a person would.

// Numbers as text and back, the same on every machine and in every locale.

/// The fewest digits that read back as exactly this number; "0" for -0. The number is finite.
std::string number_text(double number);

/// A coordinate as an author would write it: the fewest decimals that come to lie on the same point of the grid of
/// vertices, or where it is on none, of the grid of points (math/vec.h).
std::string coordinate_text(double coordinate);
/// "(2.2, -1)", of coordinates.
std::string point_text(Vec2 point);

/// "1 wall", "3 walls": for nouns that only take an s.
std::string counted(std::size_t count, std::string_view noun);

/// The number a text stands for, all of it: "-1.5", "2e3", "+7". None for anything else, also for blanks around it,
/// "nan", "inf", hexadecimals and what is too large for a double.
std::optional<double> parse_number(std::string_view text);

/// A text as a field of CSV: in double quotes where it must be. After RFC 4180 (Shafranovich, 2005).
std::string csv_field(std::string_view text);

/// A text as XML 1.0 has it, also between double quotes; its characters come back when it is read, and U+FFFD for what
/// XML cannot hold: control characters, U+FFFE, U+FFFF and bytes that are not UTF-8.
std::string xml_escaped(std::string_view text);

/// A TOML string in quotes, everything escaped that must be; bytes that are not UTF-8 become U+FFFD.
std::string string_text(std::string_view text);

std::string value_text(double number);
std::string value_text(int number);
std::string value_text(bool truth);
std::string value_text(const std::string& text);
std::string value_text(Vec2 pair);
std::string value_text(const std::vector<std::string>& texts);
std::string value_text(const TextureSpec& spec);
std::string value_text(const RectRecord& rect);
template <Word W>
std::string value_text(W word) {
    return string_text(to_word(word));
}

/// Collects "key = value" pairs, as lines or for braces.
class TableText {
public:
    enum class Style { lines, braces };
    explicit TableText(Style style) : style_(style) {}

    void add(std::string_view key, std::string_view value);
    bool empty() const { return pairs_.empty(); }
    /// Lines, each with its end; or "{ a = 1, b = 2 }" without one.
    std::string text() const;

private:
    Style style_;
    std::string pairs_;
};

}  // namespace enfilade
