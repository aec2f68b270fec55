#include "space/sight_line.h"

#include <algorithm>

#include "math/predicates.h"
#include "space/path_segment.h"

namespace enfilade {
namespace {

PassedPortal passed_portal(const Map& map, const PathSegment& segment, WallId id, double rise) {
    const Wall& wall = map[id];
    const double at = fraction_along_path(segment.from, segment.to, wall.a, wall.b).value();
    return {id, segment.from, std::clamp(at, 0.0, 1.0), rise};
}

}  // namespace

void look_along(const Map& map, const Place& from, Vec2 to, SightLine& line) {
    line.passed.clear();
    line.met = {};
    line.rise = 0;
    PathSegment segment{from.sector, from.point, to, {}};
    int links = 0;
    while (const WallId wall = way_out(map, segment)) {
        const bool is_link = map[wall].link != Wall::kNoLink;
        const bool passes = map[wall].kind == WallKind::portal && !(is_link && ++links > kMaxLinksOnPath);
        const std::optional<PathSegment> next = passes ? segment_behind(map, segment, wall) : std::nullopt;
        if (!next) {
            line.met = wall;
            break;
        }
        line.passed.push_back(passed_portal(map, segment, wall, line.rise));
        line.rise += map.passage(map[wall]).rise;
        segment = *next;
    }
    line.sector = segment.sector;
    line.from = segment.from;
}

}  // namespace enfilade
