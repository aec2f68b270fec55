// A million passes through links: nobody drifts, and who goes back arrives where he was.
#include <gtest/gtest.h>

#include <cmath>

#include "base/hash.h"
#include "space/trace.h"
#include "support/map_builder.h"
#include "support/trials.h"
#include "world/step.h"

namespace enfilade {
namespace {

using namespace test;

constexpr int kPasses = 1'000'000;
const SectorId kRoom(0u);

/// A room that goes on in itself on all four sides.
Map torus() {
    MapFile file = map_of({box_room("a", 0, 0, 4, 3)});
    link(file, "a", {4, 0}, {4, 3}, "a", {0, 3}, {0, 0});
    link(file, "a", {0, 0}, {4, 0}, "a", {4, 3}, {0, 3});
    return built(file);
}

/// A square whose east side leads to the north and whose south side leads to the west: every pass is a quarter turn.
Map pinwheel() {
    MapFile file = map_of({box_room("a", 0, 0, 4, 4)});
    link(file, "a", {4, 0}, {4, 4}, "a", {0, 0}, {4, 0});
    link(file, "a", {4, 4}, {0, 4}, "a", {0, 4}, {0, 0});
    return built(file);
}

/// A room with a wall turned by `slant` and a wall along y that is as long, each leading to the other.
Map slanted(Vec2 slant, double length) {
    MapFile file = map_of({room("a", {{0, 0}, {6, 0}, Vec2{6, 0} + slant, {0, slant.y + 4}, {0, length}})});
    link(file, "a", {6, 0}, Vec2{6, 0} + slant, "a", {0, length}, {0, 0});
    return built(file);
}

Vec2 random_step(Random& random, double reach) {
    return snap_to_point_grid({random.uniform(-reach, reach), random.uniform(-reach, reach)});
}

/// Shifts and quarter turns are exact, so the sum of all steps in a plane without links tells the place to the bit.
void expect_same_walk_as_unfolded(const Map& map) {
    Random random(1);
    Place place{kRoom, {1, 1}};
    Vec2 unfolded = place.point;
    Rigid passage;  // from the unfolded plane into the room
    for (int passes = 0; passes < kPasses;) {
        const Vec2 step = random_step(random, 3);
        const Trace way = trace(map, place, place.point + step);
        unfolded = unfolded + inverse(passage).turn(step);
        passage = then(passage, way.passage);
        place = way.end;
        passes += static_cast<int>(way.crossings.size());
        ASSERT_EQ(place.point, passage.apply(unfolded)) << passes;
    }
    count_trials(kPasses, "passes");
}

// hard case C11
TEST(LinkDrift, IsNoneThroughShifts) { expect_same_walk_as_unfolded(torus()); }
// hard case C13
TEST(LinkDrift, IsNoneThroughQuarterTurns) { expect_same_walk_as_unfolded(pinwheel()); }

/// A point and a heading, carried with 64 bits of mantissa.
struct PrecisePose {
    long double x, y, turn = 0;  // [m], [rad]

    /// Through a portal, from what the map says about its two walls: nothing that the engine computed is used.
    void pass(const Map& map, const Wall& portal) {
        const Wall& exit = map[portal.exit];
        const Vec2 from = portal.b - portal.a, onto = exit.a - exit.b;
        const long double length_2 = std::sqrt((long double)dot(from, from) * (long double)dot(onto, onto));
        const long double c = dot(from, onto) / length_2, s = cross(from, onto) / length_2;
        const long double dx = x - ((long double)portal.a.x + portal.b.x) / 2;
        const long double dy = y - ((long double)portal.a.y + portal.b.y) / 2;
        x = ((long double)exit.a.x + exit.b.x) / 2 + c * dx - s * dy;
        y = ((long double)exit.a.y + exit.b.y) / 2 + s * dx + c * dy;
        turn += std::atan2(s, c);
    }
};

/// How far two angles are apart, whole turns aside [rad].
double apart(long double a, long double b) {
    return static_cast<double>(std::remainder(a - b, 2 * 3.14159265358979323846264338L));
}

long double radians(std::uint64_t fine_turn) { return fine_turn * (3.14159265358979323846264338L * 0x1p-63L); }

/// Other angles round, but what they round does not add up.
void expect_little_drift(const Map& map) {
    Random random(2);
    Place place{kRoom, {3, 1.5}};
    PrecisePose precise{3, 1.5};
    std::uint64_t turn = 0;
    double worst_m = 0, worst_rad = 0;
    for (int passes = 0; passes < kPasses;) {
        const Vec2 step = random_step(random, 5);
        const Trace way = trace(map, place, place.point + step);
        if (way.stopped) continue;  // where exactly a wall stops it is not what is asked here
        precise.x += step.x;
        precise.y += step.y;
        for (const Crossing& crossing : way.crossings) {
            precise.pass(map, map[crossing.portal]);
            const Rigid link = map.passage(map[crossing.portal]);
            turn += fine_turn_of({link.c, link.s});
        }
        place = way.end;
        passes += static_cast<int>(way.crossings.size());
        worst_m = std::max(worst_m, (double)std::hypot(precise.x - place.point.x, precise.y - place.point.y));
        worst_rad = std::max(worst_rad, std::fabs(apart(precise.turn, radians(turn))));
    }
    count_trials(kPasses, "passes");
    note_deviation(worst_m, "m");
    note_deviation(worst_rad, "rad");
    EXPECT_LE(worst_m, 1e-6);
    EXPECT_LE(worst_rad, 1e-9);
}

// hard case C11
TEST(LinkDrift, IsSmallThroughATurnByATriangleOfWholeNumbers) { expect_little_drift(slanted({2.5, 2.625}, 3.625)); }

// hard case C11
TEST(LinkDrift, IsSmallThroughATurnOfThirtySevenDegrees) {
    const Vec2 slant = snap_to_vertex_grid(direction(Angle::from_degrees(90 - 37)) * 4);
    expect_little_drift(slanted(slant, 4));
}

// hard case C10
TEST(LinkDrift, IsNoneThereAndBackAtAnyAngle) {
    Random random(3);
    int passes = 0;
    for (int link = 0; link < 500; ++link) {
        const Vec2 slant = snap_to_vertex_grid(direction(Angle::from_degrees(random.uniform(20, 160))) * 4);
        const Map map = slanted(slant, 4);
        for (int i = 0; i < 100; ++i) {
            const Place from{kRoom, snap_to_point_grid({random.uniform(1, 4), random.uniform(1, 2)})};
            if (!contains(map, kRoom, from.point)) continue;
            const Trace there = trace(map, from, from.point + random_step(random, 5));
            if (there.crossings.size() != 1 || there.stopped) continue;
            const Trace back = trace(map, there.end, map.carried(map[there.crossings[0].portal], from.point));
            ASSERT_EQ(back.end, from) << link << ' ' << i;
            const Rigid way = then(there.passage, back.passage);
            ASSERT_EQ(fine_turn_of({there.passage.c, there.passage.s}) + fine_turn_of({back.passage.c, back.passage.s}),
                      0u);
            ASSERT_EQ(way.rise, 0);
            ++passes;
        }
    }
    EXPECT_GT(passes, 5000);
    count_trials(static_cast<std::uint64_t>(passes), "passes");
}

std::int8_t any_pace(Random& random) { return static_cast<std::int8_t>(static_cast<int>(random.below(255)) - 127); }

/// The same keys in a corridor of many rooms and in one room that leads into itself.
// hard case C11
TEST(LinkDrift, IsNoneForAPlayerInACorridorThatRepeatsItself) {
    constexpr int kRooms = 801, kMiddle = 400;
    MapFile corridor, ring = map_of({box_room("r", 0, 0, 4, 3)});
    std::vector<SectorRecord> rooms;
    for (int i = 0; i < kRooms; ++i) rooms.push_back(box_room("r" + std::to_string(i), 4 * i, 0, 4 * i + 4, 3));
    corridor = map_of(std::move(rooms));
    join_all(corridor);
    link(ring, "r", {4, 0}, {4, 3}, "r", {0, 3}, {0, 0});
    place_player(corridor, "r" + std::to_string(kMiddle), {4 * kMiddle + 2, 1.5}, 1.6);
    place_player(ring, "r", {2, 1.5}, 1.6);
    const Map long_map = built(corridor), ring_map = built(ring);
    World straight = *start_of(long_map), around = *start_of(ring_map);
    Random random(4);
    TickInput keys;
    for (int tick = 0; tick < 20'000; ++tick) {
        if (random.below(20) == 0)
            keys = {any_pace(random), any_pace(random), static_cast<std::int32_t>(random.bits() >> 38), 0, 0};
        step(long_map, straight, keys);
        step(ring_map, around, keys);
        const double x = straight.player.place.point.x - 4.0 * straight.player.place.sector.index;
        ASSERT_EQ(around.player.place.point, (Vec2{x, straight.player.place.point.y})) << tick;
        ASSERT_EQ(around.player.velocity, straight.player.velocity) << tick;
        ASSERT_EQ(around.player.yaw, straight.player.yaw) << tick;
    }
}

}  // namespace
}  // namespace enfilade
