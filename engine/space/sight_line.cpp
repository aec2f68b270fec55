#include "space/sight_line.h"

#include <algorithm>

#include "math/predicates.h"
#include "space/leg.h"

namespace enfilade {
namespace {

PassedPortal passed_portal(const Map& map, const Leg& leg, WallId id, double rise) {
    const Wall& wall = map[id];
    const double at = fraction_along_path(leg.from, leg.to, wall.a, wall.b).value();
    return {id, leg.from, std::clamp(at, 0.0, 1.0), rise};
}

}  // namespace

void look_along(const Map& map, const Place& from, Vec2 to, SightLine& line) {
    line.passed.clear();
    line.met = {};
    line.rise = 0;
    Leg leg{from.sector, from.point, to, {}};
    int links = 0;
    while (const WallId wall = way_out(map, leg)) {
        const bool is_link = map[wall].link != Wall::kNoLink;
        const bool passes = map[wall].kind == WallKind::portal && !(is_link && ++links > kMaxLinksOnPath);
        const std::optional<Leg> next = passes ? leg_behind(map, leg, wall) : std::nullopt;
        if (!next) {
            line.met = wall;
            break;
        }
        line.passed.push_back(passed_portal(map, leg, wall, line.rise));
        line.rise += map.passage(map[wall]).rise;
        leg = *next;
    }
    line.sector = leg.sector;
    line.from = leg.from;
}

}  // namespace enfilade
