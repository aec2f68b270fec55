// Numbers as text and back, the same on every machine and in every locale.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace enfilade {

/// The fewest digits that read back as exactly this number; "0" for -0. The number is finite.
std::string number_text(double number);

/// "1 wall", "3 walls": for nouns that only take an s.
std::string counted(std::size_t count, std::string_view noun);

/// The number a text stands for, all of it: "-1.5", "2e3", "+7". None for anything else, also for blanks around it,
/// "nan", "inf", hexadecimals and what is too large for a double.
std::optional<double> parse_number(std::string_view text);

}  // namespace enfilade
