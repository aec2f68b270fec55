// The maps whose doorways lead where geometry says they cannot, loaded for tests.
#pragma once
#include <string>
#include <vector>

#include "map/load.h"

namespace enfilade::test {

/// All of them that show one scene; maps/wonders.toml joins them.
inline const std::vector<std::string> kLinkedMaps = {"ascent",       "cells",   "facing_doors", "four_doors",
                                                     "hut",          "mirrors", "into_itself",  "no_return",
                                                     "quarter_turn", "tunnels", "three_corners"};

/// maps/NAME.toml, which is sound.
LoadedMap load_linked_map(const std::string& name);

/// The portals of the map that are links, mirrors left out.
std::vector<WallId> links_of(const Map& map);

/// The sector of that name, which there is.
SectorId sector_called(const Map& map, const std::string& name);

}  // namespace enfilade::test
