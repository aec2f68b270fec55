// The table of what Doom's lines do.
#include "wadconv/workbench.h"

#include <gmock/gmock.h>

#include <set>

#include "wadconv/wad.h"

namespace enfilade::wadconv {
namespace {

// hard case W13
TEST(LineActions, HoldEveryTypeOfDoomThatIsAnAction) {
    // The others of 1 to 141: 48 scrolls, 125 and 126 are for monsters, 78 and 85 are Boom's.
    const std::set<int> none{48, 78, 85, 125, 126};
    for (int special = 1; special <= 141; ++special)
        EXPECT_EQ(line_action_of(special).has_value(), !none.contains(special)) << special;
    EXPECT_FALSE(line_action_of(0));
    EXPECT_FALSE(line_action_of(65535));
}

TEST(LineActions, KnowTheDoors) {
    const LineAction plain = line_action_of(1).value(), fast = line_action_of(118).value(),
                     locked = line_action_of(34).value();
    EXPECT_EQ(plain.how, How::push);
    EXPECT_EQ(plain.times, Times::again);
    EXPECT_EQ(plain.action, TriggerAction::door);
    EXPECT_EQ(plain.speed, 2);
    EXPECT_EQ(plain.wait, 150);
    EXPECT_EQ(fast.action, TriggerAction::open);
    EXPECT_EQ(fast.times, Times::once);
    EXPECT_EQ(fast.speed, 8);
    EXPECT_EQ(locked.key, DoorKey::yellow);
}

TEST(LineActions, KnowTheLifts) {
    const LineAction lift = line_action_of(62).value(), fast = line_action_of(120).value();
    EXPECT_EQ(lift.action, TriggerAction::lift);
    EXPECT_EQ(lift.speed, 4);
    EXPECT_EQ(lift.wait, 105);
    EXPECT_EQ(fast.how, How::cross);
    EXPECT_EQ(fast.speed, 8);
}

TEST(LineActions, KnowTheFloors) {
    const LineAction down = line_action_of(36).value(), crush = line_action_of(56).value();
    EXPECT_EQ(down.to, HeightLevel::highest_floor);
    EXPECT_EQ(down.by, 8);
    EXPECT_EQ(down.speed, 4);
    EXPECT_EQ(crush.to, HeightLevel::lowest_ceiling_or_own);
    EXPECT_EQ(crush.by, -8);
    EXPECT_TRUE(crush.crushes);
}

TEST(LineActions, DecodeGeneralizedDoors) {
    const LineAction door = line_action_of(15889).value();  // again, crossed, fast, opens and closes after 9 s
    EXPECT_EQ(door.how, How::cross);
    EXPECT_EQ(door.times, Times::again);
    EXPECT_EQ(door.action, TriggerAction::door);
    EXPECT_EQ(door.speed, 8);
    EXPECT_EQ(door.wait, 300);
}

TEST(LineActions, DecodeGeneralizedLifts) {
    const LineAction lift =
        line_action_of(13331).value();  // again, used, fast, to the lowest floor around for a second
    EXPECT_EQ(lift.how, How::use);
    EXPECT_EQ(lift.action, TriggerAction::lift);
    EXPECT_EQ(lift.speed, 8);
    EXPECT_EQ(lift.wait, 35);
    EXPECT_FALSE(line_action_of(13331 | 1 << 8));  // to the next lower floor
}

TEST(NextMap, FollowsTheEpisodes) {
    EXPECT_EQ(next_map("E1M1", false), "E1M2");
    EXPECT_EQ(next_map("E1M8", false), "");
    EXPECT_EQ(next_map("E1M3", true), "E1M9");
    EXPECT_EQ(next_map("E1M9", false), "E1M4");
    EXPECT_EQ(next_map("E2M9", false), "E2M6");
    EXPECT_EQ(next_map("E3M9", true), "E3M7");
    EXPECT_EQ(next_map("E9M9", false), "E9M3");
}

TEST(NextMap, FollowsTheNumbersOfDoomTwo) {
    EXPECT_EQ(next_map("MAP09", false), "MAP10");
    EXPECT_EQ(next_map("MAP15", true), "MAP31");
    EXPECT_EQ(next_map("MAP31", true), "MAP32");
    EXPECT_EQ(next_map("MAP31", false), "MAP16");
    EXPECT_EQ(next_map("MAP32", false), "MAP16");
    EXPECT_EQ(next_map("MAP30", false), "");
    EXPECT_EQ(next_map("MAP99", false), "");
}

}  // namespace
}  // namespace enfilade::wadconv
