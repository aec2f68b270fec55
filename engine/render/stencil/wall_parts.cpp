#include "render/stencil/wall_parts.h"

#include <algorithm>

#include "render/open_steps.h"

namespace enfilade::stencil {

Heights heights_of(const Snapshot& snapshot, SectorId room, double eye_z) {
    const enfilade::Heights heights = heights_at(snapshot, room);
    return {heights.floor_z - eye_z, heights.ceiling_z - eye_z};
}

WallParts parts_of(const Map& map, const Snapshot& snapshot, WallId id, double eye_z) {
    const Wall& wall = map[id];
    const WallKind kind = kind_now(map, snapshot, id);
    WallParts parts;
    parts.room = parts.behind = heights_of(snapshot, wall.sector, eye_z);
    if (kind == WallKind::solid) return parts;
    parts.opening = parts.room;
    if (kind == WallKind::mirror) return parts;
    parts.behind = heights_of(snapshot, wall.behind, map.passage(wall).apply_height(eye_z));
    parts.upper = has_upper_step(map, wall);
    parts.lower = has_lower_step(map, wall);
    const double top = std::clamp(parts.behind.ceiling, parts.room.floor, parts.room.ceiling);
    if (parts.upper) parts.opening.ceiling = top;
    if (parts.lower) parts.opening.floor = std::clamp(parts.behind.floor, parts.room.floor, top);
    return parts;
}

double peg_height(const WallParts& parts, Peg peg) {
    switch (peg) {
        case Peg::ceiling: return parts.room.ceiling;
        case Peg::floor: return parts.room.floor;
        case Peg::opening_top: return std::min(parts.room.ceiling, parts.behind.ceiling);
        case Peg::opening_bottom: return std::max(parts.room.floor, parts.behind.floor);
    }
    return parts.room.ceiling;
}

Heights picture_in(const WallParts& parts, const Surface& middle) {
    const bool stands = middle.peg == Peg::floor || middle.peg == Peg::opening_bottom;
    const double anchor = peg_height(parts, middle.peg) + (stands ? middle.tile_m.y : 0);
    const double top = anchor - middle.offset_tiles.y * middle.tile_m.y;
    return {top - middle.tile_m.y, top};
}

}  // namespace enfilade::stencil
