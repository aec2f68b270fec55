// A map as a drawing on squared paper.
#pragma once
#include <string>

#include "formats/map_file.h"

namespace enfilade {

/// The plan of a map as an SVG picture: outlines, names, heights, the numbers of walls, links, triggers, things, lamps,
/// the player, and a legend. Rooms that hang together by plain portals, or lie on one another, are one drawing; others
/// stand beside it, each with its own corner. What points at a part tells its line in the file.
/// map : as the reader leaves it; it may have errors
std::string plan_svg(const MapFile& map);

}  // namespace enfilade
