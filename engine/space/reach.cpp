#include "space/reach.h"

#include <algorithm>

#include "math/predicates.h"
#include "space/beside.h"

namespace enfilade {
namespace {

/// A sector as seen from the middle of the disc: through which window, and where the middle is in its space.
struct Room {
    SectorId sector;
    Rigid passage;
    Vec2 centre;
    std::optional<Cone> window;
    WallId entrance;  ///< wall of the sector that the window is in; none: the middle is inside
};

class Search {
public:
    Search(const Map& map, double radius, const MayPass& may_pass) : map_(map), radius_(radius), may_pass_(may_pass) {}

    Reach run(const Place& place) {
        rooms_.push_back({place.sector, {}, place.point, {}, {}});
        for (std::size_t i = 0; i < rooms_.size(); ++i) {
            const Room room = rooms_[i];
            found_.sectors.push_back({room.sector, room.passage});
            const Sector& sector = map_[room.sector];
            for (std::uint32_t w = sector.first_wall; w < sector.first_wall + sector.wall_count; ++w)
                look_at(room, WallId(w));
        }
        return std::move(found_);
    }

private:
    void look_at(const Room& room, WallId id) {
        const Wall& wall = map_[id];
        if (!segment_is_nearer(wall.a, wall.b, room.centre, radius_)) return;
        const auto cone = cone_of(wall, room.centre, room.window);
        if (!cone || (room.entrance && !is_beyond(wall, map_[room.entrance], room.centre, *cone))) return;
        const Stretch stretch = stretch_in(wall, room.centre, *cone);
        const bool is_cut = cone->left != wall.a || cone->right != wall.b;
        if (is_cut && !is_near(stretch, room.centre)) return;
        if (!pass(room, id, *cone)) found_.walls.push_back({id, room.passage, room.centre, stretch, is_cut});
    }

    bool is_near(const Stretch& stretch, Vec2 p) const {
        const Vec2 to_it = nearest_point(stretch, p) - p;
        return dot(to_it, to_it) < radius_ * radius_;
    }

    bool pass(const Room& room, WallId id, const Cone& cone) {
        const Wall& wall = map_[id];
        if (wall.kind != WallKind::portal || rooms_.size() >= kMaxReachedSectors) return false;
        if (may_pass_ && !may_pass_(id, room.passage)) return false;
        if (wall.link == Wall::kNoLink) {
            rooms_.push_back({wall.behind, room.passage, room.centre, cone, wall.exit});
            return true;
        }
        return pass_link(room, wall, cone);
    }

    bool pass_link(const Room& room, const Wall& wall, const Cone& cone) {
        const Rigid link = map_.passage(wall);
        const Wall& exit = map_[wall.exit];
        const auto centre = put_on_side(exit, snap_to_point_grid(link.apply(room.centre)), -1);
        if (!centre) return false;
        const auto carried = [&](Vec2 v) {
            return v == wall.a ? exit.b : v == wall.b ? exit.a : snap_to_point_grid(link.apply(v));
        };
        rooms_.push_back(
            {wall.behind, then(room.passage, link), *centre, Cone{carried(cone.left), carried(cone.right)}, wall.exit});
        return true;
    }

    const Map& map_;
    double radius_;
    const MayPass& may_pass_;
    std::vector<Room> rooms_;
    Reach found_;
};

}  // namespace

Reach reach(const Map& map, const Place& place, double radius, const MayPass& may_pass) {
    return Search(map, radius, may_pass).run(place);
}

Vec2 nearest_point(const Stretch& stretch, Vec2 p) {
    const Vec2 along = stretch.b - stretch.a;
    const double length_squared = dot(along, along);
    if (length_squared == 0) return stretch.a;
    return stretch.a + along * std::clamp(dot(p - stretch.a, along) / length_squared, 0.0, 1.0);
}

}  // namespace enfilade
