// Walls in the light of lamps, several pixels at a time where the processor can.
#pragma once
#include "render/column/kernels.h"

namespace enfilade::column {

/// Draws the first pixels of the run as the scalar loop of fill_lit_wall(), or lay_lit_wall() where it is_over, would,
/// without a color table. Returns how many: 0 where the run is too short or the processor cannot.
int paint_lamplit_wall(const Run& run, const WallRun& wall, const WallGlow& glow, bool is_over);

}  // namespace enfilade::column
