// The explorer is worth something only if it explores.
#include "wadconv/freedoom/explorer.h"

#include <gtest/gtest.h>

#include "world/game.h"

namespace enfilade::test {
namespace {

/// Four rooms in a row: a step up, a low one to crouch through, one too high to climb into.
MapFile four_rooms() {
    MapFile file = map_of({box_room("start", 0, 0, 4, 4, 0, 4), box_room("step", 4, 0, 8, 4, 0.5, 4),
                           box_room("low", 8, 0, 12, 4, 0.5, 1.75), box_room("high", 12, 0, 16, 4, 2, 4)});
    split_and_join(file);
    place_player(file, "start", {2, 2}, kEyeOnFloor);
    return file;
}

TEST(Explorer, SeesAllThatCanBeReachedOnFoot) {
    Game game(four_rooms());
    Explorer explorer(game.map, 1);
    for (int i = 0; i < 2000; ++i) game.hold(explorer.next(game.world));
    EXPECT_EQ(ranges_text(explorer.visited()), "0-2");
}

TEST(Explorer, FindsItsWayAroundPillarsAndThings) {
    MapFile file = map_of({box_room("hall", 0, 0, 12, 4, 0, 4), box_room("niche", 12, 1.5, 14, 2.5, 0, 4)});
    cut_pillar(sector(file, "hall"), 4, 0.125, 5, 3);
    cut_pillar(sector(file, "hall"), 7, 1, 8, 3.875);
    ThingRecord& barrel = file.things.emplace_back();
    barrel.position = {10.5, 2};
    barrel.solid = true;
    split_and_join(file);
    place_player(file, "hall", {2, 2}, kEyeOnFloor);
    Game game(file);
    Explorer explorer(game.map, 1);
    for (int i = 0; i < 900; ++i) game.hold(explorer.next(game.world));
    EXPECT_EQ(ranges_text(explorer.visited()), "0-1");
}

TEST(Explorer, KnowsWhatIsInReachOfItsBody) {
    MapFile file = map_of({box_room("hall", 0, 0, 4, 4), box_room("wide", 4, 0, 8, 1), box_room("slit", 4, 2, 8, 2.5)});
    split_and_join(file);
    place_player(file, "hall", {2, 2}, kEyeOnFloor);
    const Game game(file);
    Explorer explorer(game.map, 1);
    EXPECT_EQ(ranges_text(explorer.in_reach(game.player())), "0-1");
}

TEST(WalkableFrom, KnowsStepsAndOpenings) {
    const Map map = built(four_rooms());
    EXPECT_EQ(ranges_text(walkable_from(map, map.player->sector)), "0-2");
}

TEST(RangesText, JoinsNeighbours) {
    EXPECT_EQ(ranges_text({true, true, true, false, true, false, true, true}), "0-2 4 6-7");
    EXPECT_EQ(ranges_text({}), "");
}

}  // namespace
}  // namespace enfilade::test
