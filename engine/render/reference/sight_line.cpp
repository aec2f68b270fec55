// Which lamps shine in which rooms, and whether their light comes straight to a place.

#include <algorithm>
#include <cmath>
#include <optional>

#include "math/predicates.h"
#include "render/reference/cast_ray.h"
#include "render/reference/ray_path.h"

namespace enfilade {
namespace {

/// What is met this near to the way's end does not stand before it [m]: far above rounding at the edge of the world,
/// far below what anyone can see.
constexpr double kArrived = 1e-7;

/// Turns of one space that differ by less are one: compositions of a thousand links are off by 1e-13 [1].
constexpr double kSameTurn = 1e-9;

bool is_near(Vec2 p, Vec2 q, double distance) { return dot(p - q, p - q) < distance * distance; }

bool are_alike(const SeenLamp& a, const SeenLamp& b) {
    return is_near(a.place, b.place, kSameLampPlace) && std::fabs(a.z - b.z) < kSameLampPlace &&
           is_near({a.passage.c, a.passage.s}, {b.passage.c, b.passage.s}, kSameTurn);
}

/// The rooms around one lamp, in the order of the portals between.
class RoomsAround {
public:
    RoomsAround(const Map& map, std::uint32_t lamp, std::vector<std::vector<SeenLamp>>& seen)
        : map_(map), light_(map.lights[lamp]), seen_(seen) {
        enter(light_.sector, {lamp, {}, light_.position, light_.z});
        for (std::size_t i = 0; i < rooms_.size() && rooms_.size() < kMostLampRooms; ++i) look_out_of(rooms_[i]);
    }

private:
    struct RoomAround {
        SectorId sector;
        SeenLamp lamp;
    };

    void enter(SectorId sector, const SeenLamp& lamp) {
        std::vector<SeenLamp>& there = seen_[sector.index];
        const auto is_known = [&](const SeenLamp& other) { return other.lamp == lamp.lamp && are_alike(other, lamp); };
        if (std::any_of(there.begin(), there.end(), is_known)) return;
        there.push_back(lamp);
        rooms_.push_back({sector, lamp});
    }

    void look_out_of(RoomAround room) {
        const Sector& sector = map_[room.sector];
        for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i) {
            const Wall& wall = map_.walls[i];
            if (wall.kind != WallKind::portal || side_of_line(wall.a, wall.b, room.lamp.place) < 0 ||
                !segment_is_nearer(wall.a, wall.b, room.lamp.place, light_.reach))
                continue;
            SeenLamp lamp = room.lamp;
            lamp.passage = then(lamp.passage, map_.passage(wall));
            lamp.place = snap_to_point_grid(lamp.passage.apply(light_.position));
            lamp.z = lamp.passage.apply_height(light_.z);
            enter(wall.behind, lamp);
        }
    }

    const Map& map_;
    const PointLight& light_;
    std::vector<std::vector<SeenLamp>>& seen_;
    std::vector<RoomAround> rooms_;
};

}  // namespace

std::vector<std::vector<SeenLamp>> seen_lamps(const Map& map) {
    std::vector<std::vector<SeenLamp>> seen(map.sectors.size());
    for (std::uint32_t i = 0; i < map.lights.size(); ++i) RoomsAround(map, i, seen);
    return seen;
}

namespace {

/// A way winds around a point where links meet as often as the angle around it fits into half a turn; this is far
/// beyond any honest map.
constexpr int kMostLinksOnWay = 1024;

/// A place on a wall is aimed through, twice as far as it is, so that rounding cannot keep the way from reaching it.
constexpr double kThroughWall = 2;

/// The straight way of light, room after room.
class LightWay {
public:
    LightWay(const Map& map, const Snapshot& snapshot, const SeenLamp& lamp, const LitPlace& at)
        : map_(map), snapshot_(snapshot), lamp_(lamp), at_(at), light_(map.lights[lamp.lamp]) {}

    bool arrives() {
        const Heights home = heights_at(snapshot_, light_.sector);
        if (light_.z < home.floor_z || light_.z > home.ceiling_z) return false;
        if (!aim()) return true;
        for (int links = 0; links <= kMostLinksOnWay;) {
            const WallId out = way_out();
            if (is_at_place(out)) return true;
            if (!out || map_[out].kind != WallKind::portal || !is_open(map_[out])) return false;
            links += map_[out].link != Wall::kNoLink;
            pass(map_[out]);
        }
        return false;
    }

private:
    /// False where the place is right at the lamp.
    bool aim() {
        const Vec2 way = at_.place - lamp_.place;
        way_ = std::sqrt(dot(way, way));
        if (way_ < kArrived) return false;
        length_ = at_.wall ? kThroughWall * way_ : way_ + kArrived;
        sector_ = light_.sector;
        from_ = light_.position;
        to_ = snap_to_point_grid(inverse(lamp_.passage).apply(lamp_.place + way * (length_ / way_)));
        return true;
    }

    /// Metres from the lamp to where the way crosses the line of a wall.
    double metres_to(const Wall& wall) const {
        return fraction_along_path(from_, to_, wall.a, wall.b).value() * length_;
    }

    /// The first wall that the way goes out through, beyond the one it came in by; none: it ends in the sector.
    WallId way_out() const {
        const Sector& sector = map_[sector_];
        const Vec2 low{std::min(from_.x, to_.x), std::min(from_.y, to_.y)};
        const Vec2 high{std::max(from_.x, to_.x), std::max(from_.y, to_.y)};
        std::optional<PathFraction> nearest;
        WallId out;
        for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i) {
            const auto& [a, b] = std::pair(map_.walls[i].a, map_.walls[i].b);
            const bool is_aside = std::max(a.x, b.x) < low.x || std::min(a.x, b.x) > high.x ||
                                  std::max(a.y, b.y) < low.y || std::min(a.y, b.y) > high.y;
            if (is_aside || !path_leaves_through(from_, to_, a, b)) continue;
            const PathFraction at = fraction_along_path(from_, to_, a, b);
            if ((entrance_ && compare(at, *entrance_) <= 0) || (nearest && compare(at, *nearest) >= 0)) continue;
            nearest = at;
            out = WallId(i);
        }
        return out;
    }

    /// Whether the stretch of the way in this room, which ends at `out`, ends at the place or goes by it.
    bool is_at_place(WallId out) const {
        if (sector_ != at_.sector || !is_near(from_, lamp_.place, kSameLampPlace)) return false;
        if (out && out == at_.wall) return true;
        const double entered = entrance_ ? entrance_->value() * length_ : 0;
        const double left = out ? metres_to(map_[out]) : length_;
        return entered <= way_ + kArrived && left >= way_ - kArrived;
    }

    bool is_open(const Wall& portal) const {
        const double height = light_.z + (at_.z - lamp_.z) * (metres_to(portal) / way_) + rise_;
        const double height_behind = height + map_.passage(portal).rise;
        const Heights here = heights_at(snapshot_, portal.sector), behind = heights_at(snapshot_, portal.behind);
        if (height < here.floor_z || height_behind < behind.floor_z) return false;
        if (map_[portal.sector].ceiling.sky && map_[portal.behind].ceiling.sky) return true;
        return height < here.ceiling_z && height_behind < behind.ceiling_z;
    }

    void pass(const Wall& portal) {
        if (portal.link != Wall::kNoLink) {
            const Rigid link = map_.passage(portal);
            from_ = snap_to_point_grid(link.apply(from_));
            to_ = snap_to_point_grid(link.apply(to_));
            rise_ += link.rise;
        }
        sector_ = portal.behind;
        // Rounding behind a link may put an end of the way on the wall's other side if it is right beside it.
        const Wall& exit = map_[portal.exit];
        const int side_from = side_of_line(exit.a, exit.b, from_), side_to = side_of_line(exit.a, exit.b, to_);
        entrance_.reset();
        if (side_from != side_to) entrance_ = fraction_along_path(from_, to_, exit.a, exit.b);
    }

    const Map& map_;
    const Snapshot& snapshot_;
    const SeenLamp& lamp_;
    const LitPlace& at_;
    const PointLight& light_;
    double way_ = 0;     ///< from the lamp to the place [m]
    double length_ = 0;  ///< from from_ to to_ [m]
    SectorId sector_;
    Vec2 from_, to_;   ///< the way, in the space of sector_
    double rise_ = 0;  ///< from heights of the lamp's sector to those of sector_ [m]
    std::optional<PathFraction> entrance_;
};

}  // namespace

bool is_lit(const Map& map, const Snapshot& snapshot, const SeenLamp& lamp, const LitPlace& at) {
    return LightWay(map, snapshot, lamp, at).arrives();
}

}  // namespace enfilade
