#include "support/rooms.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "math/grid.h"
#include "space/locate.h"

namespace enfilade::test {
namespace {

const Surface kTiled{TextureId(0u), {1, 1}, {0, 0}, Peg::ceiling};

void add_loop(Map& map, SectorId sector, const Corners& corners) {
    const std::size_t first = map.walls.size(), count = corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        Wall wall;
        wall.a = corners[i];
        wall.b = corners[(i + 1) % count];
        wall.length = std::hypot(wall.b.x - wall.a.x, wall.b.y - wall.a.y);
        wall.sector = sector;
        wall.next = WallId(first + (i + 1) % count);
        wall.previous = WallId(first + (i + count - 1) % count);
        wall.texture = wall.upper = wall.lower = kTiled;
        wall.upper.peg = Peg::opening_top;
        wall.lower.peg = Peg::opening_bottom;
        map.walls.push_back(wall);
    }
}

/// Turn and shift that put wall `from` onto wall `to`, facing the other way.
Rigid carry(const Wall& from, const Wall& to, double rise) {
    const Vec2 d = from.b - from.a, onto = to.a - to.b;
    Rigid link;
    link.c = dot(d, onto) / dot(d, d);
    link.s = cross(d, onto) / dot(d, d);
    link.shift = (to.a + to.b) * 0.5 - link.turn((from.a + from.b) * 0.5);
    link.rise = rise;
    return link;
}

/// Reflection in the wall's line.
Rigid reflect(const Wall& wall) {
    const Vec2 d = wall.b - wall.a;
    Rigid mirror;
    mirror.c = (d.x * d.x - d.y * d.y) / dot(d, d);
    mirror.s = 2 * d.x * d.y / dot(d, d);
    mirror.flip = -1;
    mirror.shift = wall.a - mirror.turn(wall.a);
    return mirror;
}

}  // namespace

SectorId Rooms::add(const Corners& outline, const std::vector<Corners>& holes) {
    const SectorId id(map.sectors.size());
    Sector sector;
    sector.name = "room " + std::to_string(id.index);
    sector.first_wall = static_cast<std::uint32_t>(map.walls.size());
    sector.floor = {0, kTiled, {}, false};
    sector.ceiling = {3, kTiled, {}, false};
    add_loop(map, id, outline);
    for (const Corners& hole : holes) add_loop(map, id, hole);
    sector.wall_count = static_cast<std::uint32_t>(map.walls.size()) - sector.first_wall;
    sector.min = sector.max = outline.front();
    for (Vec2 v : outline) {
        sector.min = {std::min(sector.min.x, v.x), std::min(sector.min.y, v.y)};
        sector.max = {std::max(sector.max.x, v.x), std::max(sector.max.y, v.y)};
    }
    map.sectors.push_back(sector);
    return id;
}

SectorId Rooms::add_box(double x0, double y0, double x1, double y1) {
    return add({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

void Rooms::set_heights(SectorId sector, double floor_z, double ceiling_z) {
    map.sectors[sector.index].floor.z = floor_z;
    map.sectors[sector.index].ceiling.z = ceiling_z;
}

WallId Rooms::wall(SectorId sector, Vec2 a, Vec2 b) const {
    const Sector& s = map[sector];
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i)
        if (map.walls[i].a == a && map.walls[i].b == b) return WallId(i);
    ENFILADE_CHECK(!"no such wall");
    return {};
}

void Rooms::join() {
    for (std::size_t i = 0; i < map.walls.size(); ++i)
        for (std::size_t j = 0; j < map.walls.size(); ++j) {
            Wall& wall = map.walls[i];
            const Wall& other = map.walls[j];
            if (i == j || wall.a != other.b || wall.b != other.a) continue;
            wall.kind = WallKind::portal;
            wall.behind = other.sector;
            wall.exit = WallId(j);
        }
}

void Rooms::link(WallId from, WallId to, double rise) {
    Wall& wall = map.walls[from.index];
    wall.kind = WallKind::portal;
    wall.behind = map[to].sector;
    wall.exit = to;
    wall.link = static_cast<std::uint32_t>(map.links.size());
    map.links.push_back(carry(wall, map[to], rise));
}

void Rooms::make_mirror(WallId id) {
    Wall& wall = map.walls[id.index];
    wall.kind = WallKind::mirror;
    wall.behind = wall.sector;
    wall.exit = id;
    wall.link = static_cast<std::uint32_t>(map.links.size());
    map.links.push_back(reflect(wall));
}

TextureSet tile_textures() {
    Texture tile;
    tile.name = "tile";
    tile.width = tile.height = 4;
    for (std::uint32_t i = 0; i < 16; ++i)
        tile.pixels.push_back(0xFF000000u | (i * 16) << 16 | (255 - i * 16) << 8 | 0x80);
    TextureSet set;
    set.textures.push_back(tile);
    set.placeholder = make_placeholder();
    return set;
}

View look_from(const Map& map, Vec2 eye, double eye_z, double yaw_degrees) {
    View view;
    view.eye = snap_to_point_grid(eye);
    view.sector = locate(map, view.eye);
    view.eye_z = eye_z;
    view.forward = direction(Angle::from_degrees(yaw_degrees));
    return view;
}

}  // namespace enfilade::test
