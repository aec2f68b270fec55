// Where two edges cross, exactly, as text for a finding.
#pragma once
#include <string>

#include "math/vec.h"

namespace enfilade {

/// The point where the lines a -> b and c -> d, which are not parallel, cross: "(2, 1.5)" where decimals can say it,
/// else fractions: "(4/3, 2), about (1.333, 2)". All four points on the vertex grid.
std::string crossing_text(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

}  // namespace enfilade
