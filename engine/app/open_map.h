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

/// Where there are errors, they are printed and there is no map. Warnings are counted in one line.
/// skill : 1..kMostSkill; things that do not stand at it are left out
std::optional<OpenMap> open_map(const std::string& path, const std::vector<std::string>& texture_folders, int skill);

}  // namespace enfilade
