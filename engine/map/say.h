// Names, numbers and places as they appear in findings.
#pragma once
#include <string>
#include <string_view>

#include "math/vec.h"

namespace enfilade {

/// 'name', shortened where it is long, with '?' for bytes a terminal might obey.
std::string quoted(std::string_view name);

/// With the fewest digits that read back exactly.
std::string to_text(double number);

/// "(x, y)"
std::string to_text(Vec2 point);

/// "(x, y)-(x, y)"
std::string edge_text(Vec2 a, Vec2 b);

}  // namespace enfilade
