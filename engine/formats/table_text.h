// Values and tables as TOML text, laid out as a person would.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/map_file.h"
#include "formats/words.h"
#include "math/vec.h"

namespace enfilade {

// Numbers as text and back, the same on every machine and in every locale.

/// The fewest digits that read back as exactly this number; "0" for -0. The number is finite.
std::string number_text(double number);

/// "1 wall", "3 walls": for nouns that only take an s.
std::string counted(std::size_t count, std::string_view noun);

/// The number a text stands for, all of it: "-1.5", "2e3", "+7". None for anything else, also for blanks around it,
/// "nan", "inf", hexadecimals and what is too large for a double.
std::optional<double> parse_number(std::string_view text);

/// A TOML string in quotes, everything escaped that must be; bytes that are not UTF-8 become U+FFFD.
std::string string_text(std::string_view text);

std::string value_text(double number);
std::string value_text(int number);
std::string value_text(bool truth);
std::string value_text(const std::string& text);
std::string value_text(Vec2 pair);
std::string value_text(const std::vector<std::string>& texts);
std::string value_text(const TextureSpec& spec);
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
