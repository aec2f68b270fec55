// Meaning: names become ids, coordinates go onto the grid, portals find the wall they lead out of, and every rule of
// a sound map is checked with exact predicates. All findings are reported, not the first.
#pragma once
#include <optional>

#include "base/finding.h"
#include "map/map.h"
#include "map/textures.h"

namespace enfilade {

/// The map, or none where a finding (also one that was there before) is an error. Findings are appended, unsorted.
/// Warnings are noted only for a file the reader found no error in: what seems missing may be what could not be read.
/// At most 1000 errors and 1000 warnings are noted, and one more each that says so.
///
/// file: as read_map leaves it (formats/map_toml.h): numbers finite and in range, as many walls as vertices.
/// `textures` must hold every name the file uses (map/textures.h): their sizes turn texels into tiles.
/// Cost: O(n log n) in the number of walls.
std::optional<Map> build_map(const MapFile& file, const TextureSet& textures, Findings& findings);

}  // namespace enfilade
