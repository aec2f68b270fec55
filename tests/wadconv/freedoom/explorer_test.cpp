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
