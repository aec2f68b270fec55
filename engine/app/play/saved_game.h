// Where games are saved.
#pragma once
#include <string>

namespace enfilade {

/// The file for a map's saved game: in the user's folder for data (XDG base directories), named after the map and the
/// folder it lies in; in the working folder where there is no home.
std::string saved_game_of(const std::string& map_path);

}  // namespace enfilade
