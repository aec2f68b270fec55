#include "render/segment.h"

#include <algorithm>

#include "math/predicates.h"

namespace enfilade {
namespace {

/// Both ends of `segment` relative to the line of `line`: the smaller and the larger side.
struct Sides {
    int low;
    int high;
};

Sides sides_of(const Segment& segment, const Segment& line) {
    const int a = corner(line.a, line.b, segment.a), b = corner(line.a, line.b, segment.b);
    return {std::min(a, b), std::max(a, b)};
}

}  // namespace

Segment facing(const Panel& panel, Vec2 eye) {
    const bool from_behind = side_of_line(panel.a, panel.b, eye) < 0;
    return from_behind ? Segment(panel.b, panel.a) : Segment(panel.a, panel.b);
}

bool is_nearer(const Segment& a, const Segment& b) {
    if (sides_of(b, a).high <= 0) return true;
    return sides_of(a, b).low >= 0;
}

bool is_beyond(const Segment& wall, const Segment& entry) {
    const Sides sides = sides_of(wall, entry);
    if (sides.high <= 0) return false;
    return sides.low >= 0 || sides_of(entry, wall).low >= 0;
}

bool are_on_one_line(const Segment& a, const Segment& b) {
    const Sides sides = sides_of(a, b);
    return sides.low == 0 && sides.high == 0;
}

bool is_panel_beyond(const Segment& panel, const Segment& entry) {
    return are_on_one_line(panel, entry) || is_beyond(panel, entry);
}

}  // namespace enfilade
