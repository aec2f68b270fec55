#include "space/reach.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "math/predicates.h"
#include "space/trace.h"

namespace enfilade {
namespace {

/// More rooms than meet in any honest corner; without it a corner with one-way portals might be gone around for ever.
constexpr int kMaxRoomsAroundCorner = 256;

/// A sector as seen from the middle of the disc: through which window, and where the middle is in its space.
struct Room {
    SectorId sector;
    Rigid passage;
    Vec2 centre;
    std::optional<Cone> window;
    WallId entrance;  ///< wall of the sector that the window is in; none: the middle is inside
    std::uint32_t rooms_on_way = 1, walls_on_way = 0;  ///< to it, itself the last
    std::uint32_t earlier = 0;  ///< the room before with an entrance of the same row of Search::latest_; 0: none
};

/// The parts in which a wall is seen past the screens before it; more are as good, but take memory.
using Cones = ShortList<Cone, 4>;

class Search {
public:
    Search(const Map& map, const Place& place, double radius, const MayPass& may_pass)
        : map_(map), place_(place), radius_(radius), may_pass_(may_pass) {}

    Reach run() {
        rooms_.push_back({place_.sector, {}, place_.point, {}, {}, 1, map_[place_.sector].wall_count});
        for (std::size_t i = 0; i < rooms_.size(); ++i) {
            const Room room = rooms_[i];
            const Sector& sector = map_[room.sector];
            found_.sectors.push_back({room.sector, room.passage, room.rooms_on_way, room.walls_on_way});
            found_.walls_looked_at += sector.wall_count;
            for (std::uint32_t w = sector.first_wall; w < sector.first_wall + sector.wall_count; ++w)
                look_at(room, WallId(w));
            if (sector.active_panels > 0) look_at_panels(room, sector);
        }
        return std::move(found_);
    }

private:
    void look_at(const Room& room, WallId id) {
        if (id == room.entrance) return;  // nobody sees the front of what he has come through
        const Wall& wall = map_[id];
        if (!box_is_near(wall, room.centre) || !segment_is_nearer(wall.a, wall.b, room.centre, radius_)) return;
        each_cone(room, wall, is_beyond, [&](const Cone& cone) { look_at_part(room, id, cone); });
    }

    void look_at_part(const Room& room, WallId id, const Cone& cone) {
        const Wall& wall = map_[id];
        const Stretch stretch = stretch_in(wall, room.centre, cone);
        const bool is_cut = cone.left != wall.a || cone.right != wall.b;
        if (is_cut && !is_near(stretch, room.centre)) return;
        if (!pass(room, id, cone)) {
            found_.walls.push_back({id, {}, wall.a, wall.b, room.passage, room.centre, stretch, is_cut});
            if (wall.one_way_exit) look_around_exit(room, id, cone);
            return;
        }
        look_around_portal(room, id, cone);
    }

    /// Calls visit(cone) for each in which a wall or panel of the room is seen through its window, past all screens.
    template <class IsBeyond, class Visit>
    void each_cone(const Room& room, const Face& face, IsBeyond is_past, Visit visit) const {
        const auto whole = cone_of(face, room.centre, room.window);
        if (!whole || (room.entrance && !is_past(face, map_[room.entrance], room.centre, *whole))) return;
        if (!map_[room.sector].has_screens) return visit(*whole);
        for (const Cone& cone : seen_past_screens(room, face, *whole)) visit(cone);
    }

    Cones seen_past_screens(const Room& room, const Face& face, const Cone& whole) const {
        const Sector& sector = map_[room.sector];
        Cones cones;
        cones.push_back(whole);
        for (std::uint32_t w = sector.first_wall; w < sector.first_wall + sector.wall_count; ++w)
            if (map_.walls[w].is_screen()) hide_behind(room, map_.walls[w], face, cones);
        return cones;
    }

    /// Takes what is hidden by a screen out of the cones in which a face is seen.
    void hide_behind(const Room& room, const Face& screen, const Face& face, Cones& cones) const {
        const bool is_itself = screen.a == face.a && screen.b == face.b;
        if (is_itself || !segment_is_nearer(screen.a, screen.b, room.centre, radius_)) return;
        const auto shade = cone_of(screen, room.centre, room.window);
        if (!shade || (room.entrance && !is_beyond(screen, map_[room.entrance], room.centre, *shade))) return;
        const auto hidden = cone_of(face, room.centre, shade);
        const Face from_behind{screen.b, screen.a};
        if (!hidden || !is_panel_beyond(face, from_behind, room.centre, *hidden)) return;
        Cones seen;
        for (const Cone& cone : cones) seen.append(without(cone, *shade, room.centre));
        cones = std::move(seen);
    }

    void look_at_panels(const Room& room, const Sector& sector) {
        for (std::uint32_t i = sector.first_panel; i < sector.first_panel + sector.panel_count; ++i)
            if (map_.panels[i].blocks) look_at_panel(room, PanelId(i));
    }

    void look_at_panel(const Room& room, PanelId id) {
        const Face face = facing(map_[id], room.centre);
        if (!box_is_near(face, room.centre) || !segment_is_nearer(face.a, face.b, room.centre, radius_)) return;
        each_cone(room, face, is_panel_beyond, [&](const Cone& cone) {
            const Stretch stretch = stretch_in(face, room.centre, cone);
            const bool is_cut = cone.left != face.a || cone.right != face.b;
            if (is_cut && !is_near(stretch, room.centre)) return;
            found_.walls.push_back({{}, id, face.a, face.b, room.passage, room.centre, stretch, is_cut});
        });
    }

    static Face facing(const Panel& panel, Vec2 p) {
        if (side_of_line(panel.a, panel.b, p) > 0) return {panel.a, panel.b};
        return {panel.b, panel.a};
    }

    enum class End : std::uint8_t { a, b };

    /// Looks around the ends of an open portal that are in sight.
    void look_around_portal(const Room& room, WallId id, const Cone& cone) {
        const Wall& wall = map_[id];
        const Rigid passage = then(room.passage, map_.passage(wall));
        if (cone.left == wall.a && look_around_corner(room, wall.a, {wall.exit, End::b, id}, passage))
            touch_averted(room, wall.previous, wall.a);
        if (cone.right == wall.b && look_around_corner(room, wall.b, {wall.exit, End::a, id}, passage))
            touch_averted(room, wall.next, wall.b);
    }

    /// What is open all around a corner may have come back on another floor than it left: of the room itself, a wall
    /// that ends there and turns its back to the middle blocks with that end all the same.
    void touch_averted(const Room& room, WallId id, Vec2 corner) {
        const Wall& wall = map_[id];
        if (side_of_line(wall.a, wall.b, room.centre) > 0 || is_open(id, room.passage)) return;
        found_.walls.push_back({id, {}, wall.a, wall.b, room.passage, room.centre, {corner, corner}, true});
    }

    /// The same for the exit of a one-way portal: who is still in it has its jambs to both sides.
    void look_around_exit(const Room& room, WallId id, const Cone& cone) {
        const Wall& wall = map_[id];
        if (cone.left == wall.a) look_around_corner(room, wall.a, {id, End::a, {}}, room.passage);
        if (cone.right == wall.b) look_around_corner(room, wall.b, {id, End::b, {}}, room.passage);
    }

    /// A way around a corner, from room to room.
    struct Round {
        WallId exit;  ///< the wall it comes out of first
        End end;      ///< which end of that is the corner
        WallId last;  ///< where it has gone all around; none: at `exit` again
    };

    /// A corner that was gone around: the wall that the way came out of first, in what space.
    struct Corner {
        WallId exit;
        End end;
        Rigid passage;
        bool operator==(const Corner&) const = default;
    };

    /// A wall that ends in the corner blocks with that end, also where the rooms together make more than a full turn,
    /// so that no straight look shows the wall.
    ///
    /// True where there is none: what is open goes all around.
    bool look_around_corner(const Room& room, Vec2 corner, const Round& round, Rigid passage) {
        if (!is_corner_near(corner, room.centre)) return false;
        const Corner here{round.exit, round.end, passage};
        if (std::ranges::find(corners_, here) != corners_.end()) return false;
        corners_.push_back(here);
        WallId exit = round.exit;
        for (int i = 0; i < kMaxRoomsAroundCorner; ++i) {
            ++found_.walls_looked_at;
            const WallId at = round.end == End::b ? map_[exit].next : map_[exit].previous;
            if (at == round.last) return true;
            const Vec2 there = round.end == End::b ? map_[at].a : map_[at].b;
            const Vec2 centre = snap_to_point_grid(passage.apply(place_.point));
            if (map_[map_[at].sector].active_panels > 0) touch_panels_at(there, map_[map_[at].sector], passage, centre);
            if (!is_open(at, passage)) {
                if (is_corner_near(there, centre))
                    found_.walls.push_back({at, {}, map_[at].a, map_[at].b, passage, centre, {there, there}, true});
                return false;
            }
            passage = then(passage, map_.passage(map_[at]));
            exit = map_[at].exit;
            if (exit == round.exit) return true;
        }
        return false;
    }

    /// Asked anew in each space on the way around: links round, and what is touched is touched in its own space.
    bool is_corner_near(Vec2 corner, Vec2 centre) const { return segment_is_nearer(corner, corner, centre, radius_); }

    /// Panels of a room around the corner block with the point that is in it.
    void touch_panels_at(Vec2 corner, const Sector& sector, const Rigid& passage, Vec2 centre) {
        if (!is_corner_near(corner, centre)) return;
        for (std::uint32_t i = sector.first_panel; i < sector.first_panel + sector.panel_count; ++i) {
            const Panel& panel = map_.panels[i];
            if (!panel.blocks || !segment_is_nearer(panel.a, panel.b, corner, kPointGrid)) continue;
            const Face face = facing(panel, centre);
            found_.walls.push_back({{}, PanelId(i), face.a, face.b, passage, centre, {corner, corner}, true});
        }
    }

    bool is_open(WallId id, const Rigid& passage) const { return is_passable(map_, id, passage, may_pass_); }

    /// Quick and exact: false only for walls that are too far away.
    bool box_is_near(const Face& wall, Vec2 p) const {
        return std::max(wall.a.x, wall.b.x) > p.x - radius_ && std::min(wall.a.x, wall.b.x) < p.x + radius_ &&
               std::max(wall.a.y, wall.b.y) > p.y - radius_ && std::min(wall.a.y, wall.b.y) < p.y + radius_;
    }

    bool is_near(const Stretch& stretch, Vec2 p) const {
        const Vec2 to_it = nearest_point(stretch, p) - p;
        return dot(to_it, to_it) < radius_ * radius_;
    }

    bool pass(const Room& room, WallId id, const Cone& cone) {
        const Wall& wall = map_[id];
        if (rooms_.size() >= kMaxReachedSectors || !is_open(id, room.passage)) return false;
        if (wall.link != Wall::kNoLink) return pass_link(room, wall, cone);
        enter(room, {wall.behind, room.passage, room.centre, cone, wall.exit});
        return true;
    }

    /// A look that has been taken shows nothing new. Without this a fan of rooms that each consist of many parts would
    /// be gone through by every part of every room before: portals behind other walls are passed, too.
    void enter(const Room& before, Room room) {
        if (is_shown(room)) return;
        room.rooms_on_way = before.rooms_on_way + 1;
        room.walls_on_way = before.walls_on_way + map_[room.sector].wall_count;
        rooms_.push_back(room);
        if (rooms_.size() > kFewRooms) note_entrances();
    }

    bool is_shown(const Room& room) const {
        if (latest_.empty())
            return std::any_of(rooms_.begin() + 1, rooms_.end(), [&](const Room& o) { return shows_as_much(o, room); });
        std::uint32_t i = latest_[room.entrance.index % kRows];
        while (i != 0 && !shows_as_much(rooms_[i], room)) i = rooms_[i].earlier;
        return i != 0;
    }

    /// Of all rooms so far, the first time; from then on, of the last one.
    void note_entrances() {
        const bool is_first_time = latest_.empty();
        if (is_first_time) latest_.resize(kRows);
        std::size_t i = is_first_time ? 1 : rooms_.size() - 1;
        for (; i < rooms_.size(); ++i) {
            std::uint32_t& latest = latest_[rooms_[i].entrance.index % kRows];
            rooms_[i].earlier = std::exchange(latest, static_cast<std::uint32_t>(i));
        }
    }

    static bool shows_as_much(const Room& other, const Room& room) {
        return other.entrance == room.entrance && other.passage == room.passage && other.centre == room.centre &&
               is_within(*room.window, *other.window, room.centre);
    }

    bool pass_link(const Room& room, const Wall& wall, const Cone& cone) {
        if (links_passed_ >= kMaxReachedLinks) return false;
        const Rigid link = map_.passage(wall);
        const Wall& exit = map_[wall.exit];
        const auto centre = put_on_side(exit, snap_to_point_grid(link.apply(room.centre)), -1);
        if (!centre) return false;
        const auto carried = [&](Vec2 v) {
            return v == wall.a ? exit.b : v == wall.b ? exit.a : snap_to_point_grid(link.apply(v));
        };
        ++links_passed_;
        enter(room, {wall.behind, then(room.passage, link), *centre, Cone{carried(cone.left), carried(cone.right)},
                     wall.exit});
        return true;
    }

    const Map& map_;
    Place place_;
    double radius_;
    const MayPass& may_pass_;
    /// So many are looked through one by one; what more there are is found by their entrances, in rows of one or two
    /// even on the finest ramp.
    static constexpr std::size_t kFewRooms = 16, kRows = 512;

    ShortList<Room, 16> rooms_;
    std::vector<std::uint32_t> latest_;  ///< of the rooms whose entrances share a row, 0: none; empty: few rooms
    std::size_t links_passed_ = 0;
    ShortList<Corner, 16> corners_;
    Reach found_;
};

}  // namespace

Reach reach(const Map& map, const Place& place, double radius, const MayPass& may_pass) {
    return Search(map, place, radius, may_pass).run();
}

}  // namespace enfilade
