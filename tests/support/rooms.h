// Small maps made in code, for tests of renderers: rooms by their corners, joined where their walls coincide.
#pragma once
#include <string>
#include <vector>

#include "map/map.h"
#include "map/textures.h"
#include "render/view.h"
#include "world/snapshot.h"

namespace enfilade::test {

using Corners = std::vector<Vec2>;

/// Puts a Map together without a file. Corners lie on the vertex grid and nothing is checked: that is build_map's
/// business. All surfaces have the texture "tile", 1 m a tile, until a test says otherwise.
class Rooms {
public:
    /// An outline, clockwise on the drawing, and holes, anticlockwise. Walls are solid, floor 0 and ceiling 3 m high.
    SectorId add(const Corners& outline, const std::vector<Corners>& holes = {});
    /// A rectangle [x0, x1] x [y0, y1]; its walls are, in order, those at y0, x1, y1, x0.
    SectorId add_box(double x0, double y0, double x1, double y1);
    void set_heights(SectorId sector, double floor_z, double ceiling_z);
    /// The wall from `a` to `b` of `sector`.
    WallId wall(SectorId sector, Vec2 a, Vec2 b) const;

    /// Makes portals of all walls that coincide with one of another room, the other way round.
    void join();
    /// Makes a linked portal of `from` that leads to the room of `to`, midpoint on midpoint.
    void link(WallId from, WallId to, double rise = 0);
    void make_mirror(WallId wall);

    Map map;
};

/// The textures of Rooms: "tile", 4 x 4 texels, each of another colour.
TextureSet tile_textures();

/// The view from a point of the map into the direction of a yaw.
View look_from(const Map& map, Vec2 eye, double eye_z, double yaw_degrees);

}  // namespace enfilade::test
