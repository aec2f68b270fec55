// A map for a command: loaded, or its findings on stderr.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "map/load.h"

namespace enfilade {

/// A map and its pictures, fit for drawing.
struct OpenMap {
    Map map;
    TextureSet textures;
};

/// The map file that an exit of the map at `map_path` leads to: beside it, with or without its ending.
std::string next_map_path(const std::string& map_path, const std::string& name);

/// Where there are errors, they are printed and there is no map. Warnings are counted in one line.
/// skill : 1..kMostSkill; things that do not stand at it are left out; none: all stand
std::optional<OpenMap> open_map(const std::string& path, const std::vector<std::string>& texture_folders,
                                std::optional<int> skill);

}  // namespace enfilade
