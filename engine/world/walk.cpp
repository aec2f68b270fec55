#include "world/body.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace enfilade {
namespace {

/// Touches in one tick after which a body stops: in a corner it takes two, on a round wall one for each piece.
constexpr int kMaxTouches = 5;

/// How far a place is moved off walls it violates, in turn [grid steps]: rounding costs at most one along each axis.
constexpr std::array<double, 4> kStepsOff{0, 1, 2, 4};

/// Parts of the way that are tried where the whole does not fit [1].
constexpr std::array<double, 6> kPartsOfWay{0x1p-1, 0x1p-2, 0x1p-3, 0x1p-4, 0x1p-6, 0x1p-8};

static_assert(kMostQueries == kMaxTouches * (1 + (1 + kPartsOfWay.size()) * kStepsOff.size()));

double round_towards(double x, double sign) {
    const double nearest = snap_to_point_grid(x);
    if (sign > 0 && nearest < x) return nearest + kPointGrid;
    if (sign < 0 && nearest > x) return nearest - kPointGrid;
    return nearest;
}

/// The grid point beside p on the side that `outward` points to.
Vec2 round_outward(Vec2 p, Vec2 outward) { return {round_towards(p.x, outward.x), round_towards(p.y, outward.y)}; }

double length(Vec2 v) { return std::sqrt(dot(v, v)); }

/// The directions in which the walls that are touched at once push.
class Normals {
public:
    void clear() { count_ = 0; }
    void add(Vec2 normal) {
        if (count_ < all_.size()) all_[count_++] = normal;
    }
    void turn(const Rigid& passage) {
        for (std::size_t i = 0; i < count_; ++i) all_[i] = passage.turn(all_[i]);
    }
    Vec2 sum() const {
        Vec2 sum;
        for (std::size_t i = 0; i < count_; ++i) sum = sum + all_[i];
        return sum;
    }

    /// What is left of v when it may go into none of the walls: v, v along one of them, or nothing in a corner.
    /// A length below `least` into a wall is none.
    Vec2 left_of(Vec2 v, double least) const {
        if (is_free(v, least)) return v;
        for (std::size_t i = 0; i < count_; ++i) {
            const Vec2 along = v - all_[i] * std::fmin(0.0, dot(v, all_[i]));
            if (is_free(along, least)) return along;
        }
        return {};
    }

private:
    bool is_free(Vec2 v, double least) const {
        for (std::size_t i = 0; i < count_; ++i)
            if (dot(v, all_[i]) <= -least) return false;
        return true;
    }

    std::array<Vec2, kMaxTouches> all_;
    std::size_t count_ = 0;
};

class Walker {
public:
    Walker(const Instant& now, const Body& body, Vec2 velocity)
        : now_(now), map_(now.map), body_(body), velocity_(velocity) {
        for (const Obstacle& obstacle : beside(body_, obstacles_overlapped(now_, body_)))
            overlapped_.push_back({obstacle.thing, distance_kept(obstacle)});
        std::ranges::stable_sort(overlapped_, {}, &Overlapped::thing);
    }

    Walk run(double seconds) {
        move_ = velocity_ * seconds;
        for (int touches = 0; touches < kMaxTouches && move_ != Vec2{}; ++touches)
            if (!go_to_next_touch()) break;
        velocity_ = normals_.left_of(velocity_, kPointGrid / seconds);
        return {body_.place, passage_, velocity_, std::move(crossings_), queries_, walls_looked_at_};
    }

private:
    bool may_pass(WallId portal, const Rigid& passage) const { return can_pass(now_, body_, portal, passage); }

    /// False where the way is over: all of it gone, or no part of it possible.
    bool go_to_next_touch() {
        const Vec2 from = body_.place.point;
        const Vec2 target = from + round_outward(move_, normals_.sum());
        if (target == from) return false;
        const double way = length(target - from);
        const auto touch = nearer_of(first_contact(map_, within(way), target, body_.radius),
                                     first_contact(map_, beside(body_, obstacles_on_way(now_, body_, target)), target));
        if (!touch) return advance_part(target);
        const Vec2 spent = move_ * touch->fraction;
        move_ = move_ - spent;
        // Nearer than a grid step is touching already.
        Rigid turned;
        const bool moves = touch->fraction * way >= kPointGrid &&
                           advance(from + round_outward((target - from) * touch->fraction, touch->normal), &turned);
        const Vec2 normal = turned.turn(touch->normal);
        if (moves) normals_.clear();
        normals_.add(normal);
        move_ = normals_.left_of(move_, kPointGrid);
        return true;
    }

    /// What the disc might touch on a way of this length.
    Reach within(double way) {
        const double radius = snap_to_point_grid(body_.radius + way) + kPointGrid;
        return counted(reach(map_, body_.place, radius, [this](WallId p, const Rigid& r) { return may_pass(p, r); }));
    }

    Reach counted(Reach found) {
        ++queries_;
        walls_looked_at_ += found.walls_looked_at;
        return found;
    }

    static std::optional<Contact> nearer_of(const std::optional<Contact>& a, const std::optional<Contact>& b) {
        if (!a || !b) return a ? a : b;
        return b->fraction < a->fraction ? b : a;
    }

    /// Those of the solid things that the body might bump into. Of one that it was in already when the walk began, it
    /// only may not get nearer to the middle: so it can leave, but not go deeper.
    Obstacles beside(const Body& body, Obstacles found) const {
        found.erase_if([&](const Obstacle& obstacle) { return !is_beside(obstacle, body); });
        if (overlapped_.empty()) return found;
        for (Obstacle& obstacle : found) {
            const auto old = std::ranges::lower_bound(overlapped_, obstacle.thing, {}, &Overlapped::thing);
            for (auto same = old; same != overlapped_.end() && same->thing == obstacle.thing; ++same)
                obstacle.limit = std::fmin(obstacle.limit, same->distance);
        }
        return found;
    }

    /// How far the body is from the middle of a thing that it is in, or a bit less, on the point grid [m].
    double distance_kept(const Obstacle& obstacle) const {
        const double distance = length(obstacle.centre - map_[obstacle.thing].position);
        return std::fmax(0.0, snap_to_point_grid(distance) - 2 * kPointGrid);
    }

    /// Goes to the target, or as much of the way there as can be; then there is some left to go.
    bool advance_part(Vec2 target) {
        Rigid turned;
        if (advance(target, &turned)) return false;
        for (double part : kPartsOfWay) {
            const Vec2 from = body_.place.point;
            if (!advance(from + round_outward((target - from) * part, normals_.sum()), &turned)) continue;
            move_ = move_ * (1 - part);
            return true;
        }
        velocity_ = {};
        return false;
    }

    /// Puts the body at the target, or a few grid steps off, if it fits there; else leaves everything as it is.
    bool advance(Vec2 target, Rigid* turned) {
        Vec2 off;
        for (double steps : kStepsOff) {
            const Vec2 p = target + round_outward(off * (steps * kPointGrid), off);
            if (p == body_.place.point) return false;
            const Trace way = way_to(p);
            if (way.is_stopped()) return false;
            const Body there = carried(way);
            const Instant arrived = after(way);
            EnteredPortals entered;
            Reach found = counted(around(arrived, there, &entered));
            drop_exits_left(map_, body_.place.point, way.passage, body_.radius, found);
            Obstacles things = beside(there, obstacles_overlapped(arrived, there));
            things.erase_if([&](const Obstacle& obstacle) { return !overlaps(map_, obstacle); });
            if (things.empty() && fits(arrived, there, found, entered)) {
                settle(there, way);
                *turned = way.passage;
                return true;
            }
            if (found.walls.empty() && things.empty()) return false;
            off = inverse(way.passage).turn(away_from(found) + away_from(things));
        }
        return false;
    }

    Trace way_to(Vec2 target) const {
        Trace way = trace(
            map_, body_.place, target, [this](WallId w, const Rigid& r) { return may_pass(w, r); },
            bodies_may_cross(map_));
        const bool is_naive = now_.history && now_.history->motion().crossing == CrossingMethod::naive;
        if (is_naive && !way.is_stopped()) {
            way.end.sector = locate_near(map_, room_after_links(way.crossings), way.end.point);
            ENFILADE_CHECK(way.end.sector);  // the room that the way ended in contains its end
        }
        return way;
    }

    /// The first room of the space that the way ends in.
    SectorId room_after_links(const Crossings& crossings) const {
        SectorId room = body_.place.sector;
        for (const Crossing& crossing : crossings)
            if (crossing.portal && map_[crossing.portal].link != Wall::kNoLink) room = map_[crossing.portal].behind;
        return room;
    }

    /// Through the way back that a door leaves open half of the body may still be where it came from.
    Instant after(const Trace& way) const {
        Instant arrived = now_;
        for (const Crossing& crossing : way.crossings)
            if (const auto left = crossing.portal ? way_back_left(map_, crossing.portal) : std::nullopt)
                arrived.way_back = left;
        return arrived;
    }

    Body carried(const Trace& way) const {
        Body there = body_;
        there.place = way.end;
        there.feet_z += way.passage.rise;
        there.ceiling_z += way.passage.rise;
        return there;
    }

    /// The direction that leads off all walls found, in the space of the place.
    static Vec2 away_from(const Reach& found) {
        Vec2 sum;
        for (const ReachedWall& wall : found.walls) {
            const Vec2 out = wall.centre - nearest_point(wall.stretch, wall.centre);
            if (out != Vec2{}) sum = sum + inverse(wall.passage).turn(out * (1 / length(out)));
        }
        return sum;
    }

    Vec2 away_from(const Obstacles& things) const {
        Vec2 sum;
        for (const Obstacle& thing : things) {
            const Vec2 out = thing.centre - map_[thing.thing].position;
            if (out != Vec2{}) sum = sum + inverse(thing.passage).turn(out * (1 / length(out)));
        }
        return sum;
    }

    void settle(const Body& there, const Trace& way) {
        const Rigid& passage = way.passage;
        now_.way_back = after(way).way_back;
        body_ = there;
        crossings_.append(way.crossings);
        passage_ = then(passage_, passage);
        move_ = passage.turn(move_);
        velocity_ = passage.turn(velocity_);
        normals_.turn(passage);
    }

    Instant now_;
    const Map& map_;
    Body body_;
    Vec2 velocity_, move_;
    Rigid passage_;
    Crossings crossings_;
    Normals normals_;
    int queries_ = 0;
    std::size_t walls_looked_at_ = 0;

    /// A thing that the body was in when the walk began, and how far from its middle.
    struct Overlapped {
        ThingId thing;
        double distance;
    };
    ShortList<Overlapped, 8> overlapped_;  ///< in the order of the things' numbers
};

}  // namespace

Walk walk(const Instant& now, const Body& body, Vec2 velocity, double seconds) {
    return Walker(now, body, velocity).run(seconds);
}

}  // namespace enfilade
