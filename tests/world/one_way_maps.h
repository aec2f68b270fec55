// Pairs of rooms that a one-way portal joins: from the near one into the far one, and not back.
#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "base/hash.h"
#include "world/game.h"

namespace enfilade::test {

/// A pair of rooms in coordinates of their own: the portal is the line x = 0 from y = -width / 2 to width / 2, the near
/// room lies before it, and whoever goes towards +x gets into the far one.
struct OneWayPair {
    double width = 65.0 / 64;  ///< of the portal [m]; 65 is the hypotenuse of many whole triangles
    bool is_link = true;       ///< else the two are neighbours, which lie where they seem to
    bool way_back = false;     ///< whoever passes leaves one
    Vec2 near_turn{65, 0};     ///< where +x of the pair points on the map, in 65ths: near room, far room
    Vec2 far_turn{65, 0};
    double near_bend[2] = {0, 0};  ///< x of the near room's corners beside the portal, at y = -3 and 3 [m]
    double far_bend[2] = {0, 0};   ///< the same of the far room; below 0 it reaches back beside the portal
    double drop = 0;               ///< how far the far floor is below the near one [m]
    double head = 3;               ///< of the opening [m]
    double rise = 0;               ///< of the link [m]
    double pillar = 0;             ///< thickness of the pillar whose face the exit is; 0: it is in the outer wall [m]
    double behind = 0;             ///< from the pillar's back to the outer wall [m]
};

/// Half the height of both rooms on the plan, and how deep they are [m].
inline constexpr double kHalfSide = 3, kDepth = 4;

/// A place of the pair on the map: turned exactly for multiples of 65 grid steps, else up to rounding.
inline Vec2 on_map(Vec2 local, Vec2 turn, Vec2 origin) {
    return origin + Vec2{(turn.x * local.x - turn.y * local.y) / 65, (turn.y * local.x + turn.x * local.y) / 65};
}

/// The same place back in the coordinates of the pair.
inline Vec2 in_pair(Vec2 p, Vec2 turn, Vec2 origin) {
    const Vec2 from = p - origin;
    return {(turn.x * from.x + turn.y * from.y) / 65, (turn.x * from.y - turn.y * from.x) / 65};
}

/// The map of a pair, and the way into its coordinates.
class OneWayMap {
public:
    explicit OneWayMap(const OneWayPair& pair) : pair_(pair), far_origin_(pair.is_link ? Vec2{200, 100} : Vec2{}) {
        const double half = pair.width / 2;
        file_ = map_of({near_room(half), far_room(half)});
        WallRecord& portal = wall_of("near", 2);
        portal.next = "far";
        portal.way_back = pair.way_back;
        if (pair.is_link) {
            exit_of(half).name = "exit";
            portal.via = "exit";
            portal.rise = pair.rise;
        }
    }

    /// Puts the player into the near room, before the portal.
    void place(Vec2 local, double yaw_degrees = 0) {
        const double yaw = yaw_degrees + angle_of(pair_.near_turn).degrees();
        place_player(file_, "near", on_map(local, pair_.near_turn, {}), kEyeOnFloor, yaw);
    }

    /// The same into the far room.
    void place_beyond(Vec2 local, double yaw_degrees) {
        const double yaw = yaw_degrees + angle_of(far_turn()).degrees(), floor = pair_.rise - pair_.drop;
        place_player(file_, "far", on_map(local, far_turn(), far_origin_), floor + kEyeOnFloor, yaw);
    }

    const MapFile& file() const { return file_; }
    double width() const { return pair_.width; }
    /// Where a place is in the coordinates of the pair.
    Vec2 local(const Map& map, const Place& place) const {
        return map[place.sector].name == "near" ? in_pair(place.point, pair_.near_turn, {})
                                                : in_pair(place.point, far_turn(), far_origin_);
    }
    /// The yaw that leads somewhere in the coordinates of the pair.
    Angle yaw_to(const Map& map, const Place& place, Vec2 target) const {
        const Vec2 way = target - local(map, place);
        const Vec2 turn = map[place.sector].name == "near" ? pair_.near_turn : far_turn();
        return angle_of(on_map(way, turn, {}));
    }

private:
    Vec2 far_turn() const { return pair_.is_link ? pair_.far_turn : pair_.near_turn; }

    SectorRecord near_room(double half) const {
        std::vector<Vec2> outline{{-kDepth, -kHalfSide},
                                  {pair_.near_bend[0], -kHalfSide},
                                  {0, -half},
                                  {0, half},
                                  {pair_.near_bend[1], kHalfSide},
                                  {-kDepth, kHalfSide}};
        for (Vec2& v : outline) v = on_map(v, pair_.near_turn, {});
        return room("near", outline, 0, pair_.head);
    }

    SectorRecord far_room(double half) const {
        const double floor = pair_.rise - pair_.drop, ceiling = pair_.rise + pair_.head + 1;
        if (pair_.pillar > 0) return room_around_pillar(half, floor, ceiling);
        std::vector<Vec2> outline{{0, half},
                                  {0, -half},
                                  {pair_.far_bend[0], -kHalfSide},
                                  {kDepth, -kHalfSide},
                                  {kDepth, kHalfSide},
                                  {pair_.far_bend[1], kHalfSide}};
        for (Vec2& v : outline) v = on_map(v, far_turn(), far_origin_);
        return room("far", outline, floor, ceiling);
    }

    SectorRecord room_around_pillar(double half, double floor, double ceiling) const {
        const double back = -pair_.pillar, end = back - pair_.behind;
        std::vector<Vec2> outline{{end, -kHalfSide}, {kDepth, -kHalfSide}, {kDepth, kHalfSide}, {end, kHalfSide}};
        std::vector<Vec2> pillar{{0, half}, {0, -half}, {back, -half}, {back, half}};
        for (Vec2& v : outline) v = on_map(v, far_turn(), far_origin_);
        for (Vec2& v : pillar) v = on_map(v, far_turn(), far_origin_);
        SectorRecord far = room("far", outline, floor, ceiling);
        far.loops.push_back(loop_of(pillar));
        return far;
    }

    WallRecord& wall_of(const std::string& name, std::size_t i) { return sector(file_, name).loops.front().walls[i]; }
    WallRecord& exit_of(double half) {
        return wall(file_, "far", on_map({0, half}, far_turn(), far_origin_),
                    on_map({0, -half}, far_turn(), far_origin_));
    }

    OneWayPair pair_;
    Vec2 far_origin_;
    MapFile file_;
};

/// A pair of any measures through which a player gets: turned, raised, with wild corners, on a pillar or not.
inline OneWayPair any_pair(Random& random) {
    static constexpr Vec2 kTurns[] = {{65, 0}, {0, 65}, {-65, 0}, {0, -65}, {16, 63}, {-33, 56}, {60, -25}, {-39, -52}};
    const auto one_of_turns = [&] { return kTurns[random.below(std::size(kTurns))]; };
    const auto eighths = [&](int low, int high) {
        return (low + static_cast<double>(random.below(static_cast<std::uint64_t>(high - low + 1)))) / 8;
    };
    OneWayPair pair;
    pair.width = random.below(2) == 0 ? 65.0 / 64 : 65.0 / 32;
    pair.is_link = random.below(3) > 0;
    pair.near_turn = one_of_turns();
    pair.far_turn = one_of_turns();
    for (double& x : pair.near_bend) x = eighths(-8, 8);
    for (double& x : pair.far_bend) x = eighths(-8, 8);
    pair.drop = eighths(-6, 16);
    pair.head = pair.drop >= 0 && random.below(3) == 0 ? 1.25 : 3;
    pair.rise = pair.is_link ? eighths(-40, 40) : 0;
    if (random.below(4) == 0) {
        pair.pillar = eighths(1, 4);
        pair.behind = eighths(1, 4);
    }
    return pair;
}

}  // namespace enfilade::test
