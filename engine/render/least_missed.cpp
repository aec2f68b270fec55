#include "render/least_missed.h"

#include <algorithm>
#include <limits>

#include "base/result.h"
#include "math/predicates.h"
#include "render/segment.h"

namespace enfilade {
namespace {

/// How far the ray passes beside a wall that faces the eye, times its distance [m^2].
double missed_by(const Wall& wall, const Pose& pose, double slope) {
    const bool is_swapped = pose.flip < 0;
    const Vec2 left_v = to_view(is_swapped ? wall.b : wall.a, pose),
               right_v = to_view(is_swapped ? wall.a : wall.b, pose);
    return std::max({-edge(left_v, slope), edge(right_v, slope), 0.0});
}

}  // namespace

WallId least_missed(const Map& map, SectorId sector, const Pose& pose, double slope, WallId entry) {
    const Sector& s = map[sector];
    WallId best;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i) {
        const Wall& wall = map.walls[i];
        if (side_of_line(wall.a, wall.b, pose.eye) < 0) continue;
        const bool is_before = entry && (entry == WallId(i) || !is_beyond(wall, map[entry]));
        const double missed = missed_by(wall, pose, slope) + (is_before ? kWorldLimit * kWorldLimit : 0);
        if (missed >= least) continue;
        least = missed;
        best = WallId(i);
    }
    ENFILADE_CHECK(best);  // around a closed outline some wall always faces the eye
    return best;
}

}  // namespace enfilade
