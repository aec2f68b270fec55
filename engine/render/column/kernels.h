// The inner loops of what is rare: flats that are far beyond the ends of any room, pictures with holes, and clouds.
// Positions within a picture are whole numbers (2^64 or 2^32 steps a tile), so stepping them is exact and a run's
// pixels do not depend on where it starts.
#pragma once
#include <cstdint>

#include "render/column/plain_kernels.h"

namespace enfilade::column {

/// As PlainKernels::fill_flats, however far: without its limit on depth * step.
void fill_far_flats(const PlainFlats& flats);

/// The texels of the first of the columns as they are painted, with their alpha, into its rows; what all of them have
/// in common with ones: 0 in its uppermost byte where nothing of them is to be seen.
std::uint32_t read_wall(const PlainWalls& walls);

/// A layer of sky with holes, laid over what is there already.
void lay_sky(const Run& run, const SkyRun& layer);

void fill_color(const Run& run, std::uint32_t color);

}  // namespace enfilade::column
