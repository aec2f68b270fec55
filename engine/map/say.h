// Points and edges as they appear in findings.
#pragma once
#include <string>

#include "math/vec.h"

namespace enfilade {

/// "(x, y)", with the fewest digits that read back exactly.
std::string point_text(Vec2 point);

/// "(x, y)-(x, y)"
std::string edge_text(Vec2 a, Vec2 b);

}  // namespace enfilade
