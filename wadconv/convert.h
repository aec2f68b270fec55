// One Doom map as one map of ours.
#pragma once
#include <optional>

#include "formats/map_file.h"
#include "wadconv/map_lumps.h"
#include "wadconv/pictures.h"
#include "wadconv/report.h"
#include "wadconv/sounds.h"

namespace enfilade::wadconv {

struct ConvertOptions {
    bool open_doors = false;  ///< raise the ceiling of every closed door, so that the whole map can be walked
};

/// What came of a map: the file, or none and report.refused says why.
struct Conversion {
    std::optional<MapFile> file;
    Report report;
};

/// Converts geometry, textures, light, things, and what lines and sectors do; x/32, -y/32, z/32, exactly. Specials that
/// have no word here, and flags that say more than the wall itself, are kept as `doom`: a line's on the wall of its
/// right side, a sector's on all of its parts. Cost: O(n log n) in the lines.
Conversion convert_map(const DoomMap& doom, const Pictures& pictures, const Sounds& sounds,
                       const ConvertOptions& options);

}  // namespace enfilade::wadconv
