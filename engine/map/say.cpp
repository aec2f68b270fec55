#include "map/say.h"

#include "formats/text_parts.h"

namespace enfilade {

std::string point_text(Vec2 point) { return "(" + number_text(point.x) + ", " + number_text(point.y) + ")"; }

std::string edge_text(Vec2 a, Vec2 b) { return point_text(a) + "-" + point_text(b); }

}  // namespace enfilade
