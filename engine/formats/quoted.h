// Words of a hostile file, fit to be shown in a message.
#pragma once
#include <algorithm>
#include <span>
#include <string>
#include <string_view>

namespace enfilade {

/// The word in single quotes; what a terminal would obey becomes '?', and what is longer than 60 bytes is cut.
std::string quoted(std::string_view word);

/// The known word that takes the fewest changed letters, if it is near enough to be meant; else empty.
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> known);

/// "; did you mean 'X'?" with the known word nearest to this one, or nothing where none is near.
std::string nearest_suggestion(std::string_view word, std::span<const std::string_view> known);

/// "; did you mean 'X'?" with the known word nearest to this one, or "; known here: A, B, C" where none is near.
std::string suggestion(std::string_view word, std::span<const std::string_view> known);

}  // namespace enfilade
