// One Doom map as one map of ours.
#pragma once
#include <optional>

#include "formats/map_file.h"
#include "wadconv/doom_records.h"
#include "wadconv/pictures.h"
#include "wadconv/report.h"

namespace enfilade::wadconv {

struct ConvertOptions {
    bool open_doors = false;  ///< raise the ceiling of every closed door, so that the whole map can be walked
};

/// What came of a map: the file, or none and report.refused says why.
struct Conversion {
    std::optional<MapFile> file;
    Report report;
};

/// Converts geometry, textures, light and things; x/32, -y/32, z/32, exactly. Specials, tags and flags are kept as
/// `doom`: a line's on the wall of its right side (absent there: special 0, tag 0, flags 1 if it is solid, else 4), a
/// sector's on all of its parts. Cost: O(n log n) in the lines.
Conversion convert_map(const DoomMap& doom, const Pictures& pictures, const ConvertOptions& options);

}  // namespace enfilade::wadconv
