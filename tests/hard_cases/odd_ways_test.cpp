// Walks that no plan of a house allows: three right angles that lead home, stairs that rise for ever, ways whose order
// matters.
#include <gtest/gtest.h>

#include <algorithm>

#include "hard_cases/linked_maps.h"
#include "math/vec.h"
#include "space/trace.h"
#include "world/step.h"

namespace enfilade::test {
namespace {

/// Somebody who walks along straight lines and turns by right angles, and keeps a list of the rooms passed.
class Wanderer {
public:
    Wanderer(const Map& map, const std::string& room, Vec2 point, Vec2 look)
        : map_(map), place_{sector_called(map, room), point}, look_(look) {}

    void walk(double ahead, double to_the_right = 0) {
        const Vec2 step = look_ * ahead + right_of(look_) * to_the_right;
        const Trace way = trace(map_, place_, snap_to_point_grid(place_.point + step));
        ASSERT_FALSE(way.stopped) << "in " << room();
        place_ = way.end;
        look_ = way.passage.turn(look_);
        risen_ += way.passage.rise;
    }
    void turn_right() { look_ = right_of(look_); }

    const std::string& room() const { return map_[place_.sector].name; }
    const Place& place() const { return place_; }
    Vec2 look() const { return look_; }
    double risen() const { return risen_; }  ///< by links alone [m]

private:
    const Map& map_;
    Place place_;
    Vec2 look_;
    double risen_ = 0;
};

/// From the middle of a room of maps/three_corners.toml to its doors, twice: that of the room behind, too [m].
constexpr double kToTheNextRoom = 2 * 5.375;
constexpr Vec2 kMiddle{-1, -1}, kEast{1, 0};

// hard case C13
TEST(ThreeCorners, BringHomeWhoTurnsRightThreeTimes) {
    const LoadedMap loaded = load_linked_map("three_corners");
    Wanderer wanderer(*loaded.map, "rose", kMiddle, kEast);
    const Place home = wanderer.place();
    std::vector<std::string> rooms;
    for (int corner = 0; corner < 3; ++corner) {
        wanderer.walk(kToTheNextRoom);
        wanderer.turn_right();
        rooms.push_back(wanderer.room());
    }
    EXPECT_EQ(rooms, (std::vector<std::string>{"ochre", "white", "rose"}));
    EXPECT_EQ(wanderer.place(), home);
    EXPECT_EQ(wanderer.look(), kEast);
}

TEST(ThreeCorners, LeadElsewhereWhereTheOrderOfTwoWaysIsChanged) {
    const LoadedMap loaded = load_linked_map("three_corners");
    Wanderer ahead_then_right(*loaded.map, "rose", kMiddle, kEast), right_then_ahead = ahead_then_right;
    ahead_then_right.walk(kToTheNextRoom);
    ahead_then_right.walk(0, kToTheNextRoom);
    right_then_ahead.walk(0, kToTheNextRoom);
    right_then_ahead.walk(kToTheNextRoom);
    EXPECT_EQ(ahead_then_right.room(), "white");
    EXPECT_EQ(right_then_ahead.room(), "ochre");
}

/// Ticks are played, not traced: the player runs, and turns where the middle of a room is reached.
TEST(ThreeCorners, BringHomeThePlayerWhoRuns) {
    const LoadedMap loaded = load_linked_map("three_corners");
    const Map& map = *loaded.map;
    World world = *start_of(map);
    world.player = player_at(map, {sector_called(map, "rose"), kMiddle, 1.55, Angle::from_degrees(0)});
    std::vector<std::string> rooms{"rose"};
    constexpr int kTicksPerLeg = 240;  // far enough into the next room at full pace, and then some to stop
    for (int corner = 0; corner < 3; ++corner) {
        for (int tick = 0; tick < kTicksPerLeg; ++tick) {
            const Vec2 p = world.player.place.point;
            const bool is_there = rooms.back() != map[world.player.place.sector].name && p.y <= kMiddle.y &&
                                  map[world.player.place.sector].name.find('_') == std::string::npos;
            step(map, world, {.forward = static_cast<std::int8_t>(is_there ? 0 : 127)});
        }
        step(map, world, {.yaw_steps = 1 << 30});
        rooms.push_back(map[world.player.place.sector].name);
    }
    EXPECT_EQ(rooms, (std::vector<std::string>{"rose", "ochre", "white", "rose"}));
    EXPECT_EQ(world.player.yaw, Angle::from_degrees(0));
}

TEST(Ascent, NeverEnds) {
    const LoadedMap loaded = load_linked_map("ascent");
    Wanderer wanderer(*loaded.map, "landing_1", {-4.75, 4.75}, {0, -1});
    const Place start = wanderer.place();
    for (int round = 1; round <= 3; ++round) {
        for (int flight = 0; flight < 4; ++flight) {
            wanderer.walk(9.5);
            wanderer.turn_right();
        }
        EXPECT_EQ(wanderer.place(), start);
        EXPECT_EQ(wanderer.risen(), -8.0 * round);  // what the stairs gave, the link takes back
    }
}

TEST(NoReturn, LeadsOnAlsoThroughTheDoorByWhichOneCame) {
    const LoadedMap loaded = load_linked_map("no_return");
    Wanderer wanderer(*loaded.map, "blue", {0, 0}, {0, -1});
    std::vector<std::string> rooms;
    for (int door = 0; door < 4; ++door) {
        wanderer.walk(2 * 4.375);
        rooms.push_back(wanderer.room());
        wanderer.turn_right();  // right about turn, and back
        wanderer.turn_right();
    }
    EXPECT_EQ(rooms, (std::vector<std::string>{"green", "red", "yellow", "blue"}));
}

// hard case C6
TEST(Cells, BringHomeWhoWalksStraightOnPastSixOfThem) {
    const LoadedMap loaded = load_linked_map("cells");
    for (const Vec2 look : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}}) {
        Wanderer wanderer(*loaded.map, "cell_44", {24.5, 24.5}, look);
        const Place home = wanderer.place();
        wanderer.walk(6 * 5.25);
        EXPECT_EQ(wanderer.place(), home);
    }
}

TEST(Tunnels, AreThirtyMetresLongWhereTheBlockIsThree) {
    const LoadedMap loaded = load_linked_map("tunnels");
    Wanderer through(*loaded.map, "meadow", {-6, 2.5}, {0, -1}), single_step(*loaded.map, "meadow", {5, 7}, {0, -1});
    through.walk(1.375 + 15);
    EXPECT_EQ(through.room(), "bore_8");
    through.walk(15 + 1.375);
    EXPECT_EQ(through.place().point, (Vec2{-6, -2.5}));
    single_step.walk(1.375 + 1.375);
    EXPECT_EQ(single_step.place().point, (Vec2{5, -7}));
}

}  // namespace
}  // namespace enfilade::test
