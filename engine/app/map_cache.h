// Where maps that take long to read are kept, compiled, from one start of the program to the next.
#pragma once
#include <cstdint>
#include <string>

#include "map/load.h"

namespace enfilade {

/// What all kept maps may take together [bytes]: some of the largest there are, at 450 bytes a sector.
inline constexpr std::uint64_t kMostCacheBytes = std::uint64_t{2} << 30;

/// The store of one map: a file in the user's folder for caches (XDG base directories), named after the map and the
/// place where it lies. What this program did not write itself is not taken: another version may build another map
/// from the same text. Once the files take more than kMostCacheBytes together, those that were written longest ago go.
///
/// Keeps nothing where there is no home, or where ENFILADE_MAP_CACHE is "off": find() is then always an error.
MapStore cache_of(const std::string& map_path);

}  // namespace enfilade
