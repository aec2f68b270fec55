// Any moment of a world's past can be had again.
#include <gtest/gtest.h>

#include "world/game.h"
#include "world/step.h"

namespace enfilade {
namespace {

using namespace test;

/// A hall with a door that opens for who comes in, and a shuttle.
MapFile busy_rooms() {
    MapFile file = map_of({box_room("hall", 0, 0, 8, 4, 0, 3), box_room("gate", 8, 0, 9, 4, 0, 3),
                           box_room("room", 9, 0, 17, 4, 0.5, 3)});
    join_all(file);
    sector(file, "gate").triggers = {trigger_on(Activation::enter, TriggerAction::close_then_open)};
    sector(file, "room").triggers = {trigger_on(Activation::start, TriggerAction::shuttle)};
    for (const char* name : {"gate", "room"}) sector(file, name).triggers[0].wait = 0.25;
    ThingRecord gem;
    gem.position = {4, 2};
    gem.gives_key = "gem";
    file.things = {gem};
    place_player(file, "hall", {2, 2}, kEyeOnFloor);
    return file;
}

/// A timeline of 1000 ticks to and fro, and the hash of the world after each.
struct Played {
    Played() : map(built(busy_rooms())), timeline(*start_of(map)), hashes{hash(timeline.world())} {
        for (int i = 0; i < 1000; ++i) {
            timeline.play(map, i / 130 % 2 == 0 ? kForward : kBack);
            hashes.push_back(hash(timeline.world()));
        }
    }
    Map map;
    Timeline timeline;
    std::vector<std::uint64_t> hashes;
};

TEST(Timeline, GivesEveryMomentOfThePastAgain) {
    const Played played;
    EXPECT_GT(played.timeline.world().history.changes().size(), 3u);
    EXPECT_EQ(played.timeline.world().history.pickups().size(), 1u);
    for (std::size_t tick = 0; tick <= 1000; tick += 7)
        ASSERT_EQ(hash(played.timeline.after(played.map, tick)), played.hashes[tick]) << tick;
}

TEST(Timeline, GoesBackAndOnAgain) {
    Played played;
    const std::vector<TickInput> inputs(played.timeline.inputs().begin(), played.timeline.inputs().end());
    played.timeline.go_back(played.map, 333);
    EXPECT_EQ(played.timeline.inputs().size(), 333u);
    EXPECT_EQ(hash(played.timeline.world()), played.hashes[333]);
    for (std::size_t tick = 333; tick < 1000; ++tick) played.timeline.play(played.map, inputs[tick]);
    EXPECT_EQ(hash(played.timeline.world()), played.hashes[1000]);
}

TEST(Timeline, GoesBackToTheVeryBeginning) {
    Played played;
    played.timeline.go_back(played.map, 0);
    EXPECT_EQ(hash(played.timeline.world()), played.hashes[0]);
}

}  // namespace
}  // namespace enfilade
