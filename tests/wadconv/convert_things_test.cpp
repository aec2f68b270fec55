// Doom's things as ours: where they stand, what they look like, for whom, and where the player starts.
#include <gmock/gmock.h>

#include "wadconv/converted.h"

namespace enfilade::wadconv {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// The only thing of a room, of that type.
ThingRecord thing_of(int type) {
    Level level;
    level.sector();
    level.box(0, 0, 128, 128, 0);
    level.thing(64, 64, type);
    return Converted(level).file.things.at(0);
}

TEST(ConvertThings, HoldUpWhatMovesIfTheyCanBeShotAndUntilTheyAreCrushed) {
    EXPECT_EQ(thing_of(3001).holds_up, HoldsUp::all_but_crushers);
    EXPECT_EQ(thing_of(2035).holds_up, HoldsUp::all_but_crushers);
    EXPECT_EQ(thing_of(48).holds_up, HoldsUp::nothing);
    EXPECT_EQ(thing_of(2012).holds_up, HoldsUp::all);  // solid things only
}

TEST(ConvertThings, TellWhatStandsWhere) {
    const Converted c(small_level());
    ASSERT_THAT(c.file.things, SizeIs(3));
    const ThingRecord& thing = c.file.things[1];
    EXPECT_EQ(thing.kind, "Zombieman");
    EXPECT_EQ(thing.sector, "s0");
    EXPECT_EQ(thing.position, (Vec2{6.25, -1.25}));
    EXPECT_EQ(thing.radius, 20 / 32.);
    EXPECT_EQ(thing.height, 56 / 32.);
    EXPECT_TRUE(thing.solid);
    EXPECT_FALSE(thing.hanging);
    EXPECT_EQ(thing.doom, (DoomRecord{3004, 0, 7}));
}

TEST(ConvertThings, AnimateThemIdly) {
    const ThingRecord zombie = Converted(small_level()).file.things[1];
    EXPECT_EQ(zombie.rotations, 8);
    ASSERT_THAT(zombie.frames, SizeIs(2));
    EXPECT_EQ(zombie.frames[0].texture, "sprites/possa");
    EXPECT_EQ(zombie.frames[0].seconds, 10 / 35.);
    EXPECT_EQ(zombie.frames[0].origin_tx, (Vec2{1, 3}));
    const ThingRecord barrel = Converted(small_level()).file.things[2];
    EXPECT_EQ(barrel.rotations, 1);
    EXPECT_EQ(barrel.frames[1].texture, "sprites/bar1b");
}

TEST(ConvertThings, TurnByEighthsRightWhereDoomTurnsLeft) {
    std::vector<double> yaws;
    for (int angle : {0, 45, 90, 180, 315, 359, 360, 65535}) {
        Level level = small_level();
        level.thing(32, 32, 3004, angle);
        yaws.push_back(Converted(level).file.things.back().yaw_degrees);
    }
    EXPECT_THAT(yaws, ElementsAre(0, 315, 270, 180, 45, 45, 0, 0));
}

TEST(ConvertThings, SayForWhichSkillsTheyStand) {
    Level level = small_level();
    for (int flags : {1, 2, 4, 6, 0, 23}) level.thing(32, 32, 3004, 0, flags);
    const Converted c(level);
    std::vector<int> skills;
    for (const ThingRecord& thing : c.file.things) skills.push_back(thing.skills);
    EXPECT_THAT(skills,
                ElementsAre(kAllSkills, kAllSkills, kAllSkills, 0b00011, 0b00100, 0b11000, 0b11100, 0, kAllSkills));
    EXPECT_FALSE(c.file.things[7].multiplayer);
    EXPECT_TRUE(c.file.things[8].multiplayer);
}

TEST(ConvertThings, KeepStartsAtEverySkill) {
    Level level = small_level();
    level.thing(32, 32, 11, 0, kMultiplayer);
    const ThingRecord start = Converted(level).file.things.back();
    EXPECT_EQ(start.skills, kAllSkills);
    EXPECT_FALSE(start.multiplayer);
}

TEST(ConvertThings, LeaveOutUnknownTypesAndThingsInTheVoid) {
    Level level = small_level();
    level.thing(32, 32, 32000);
    level.thing(1000, 1000, 3004);
    const Converted c(level);
    EXPECT_THAT(c.file.things, SizeIs(3));
    EXPECT_THAT(c.noted(Kind::unknown_thing), ElementsAre(3u));
    EXPECT_THAT(c.noted(Kind::thing_outside), ElementsAre(4u));
}

TEST(ConvertThings, KeepThoseWithoutSprite) {
    Level level = small_level();
    level.thing(32, 32, 68);
    const Converted c(level);
    EXPECT_EQ(c.file.things[3].kind, "Arachnotron");
    EXPECT_THAT(c.file.things[3].frames, IsEmpty());
    EXPECT_THAT(c.noted(Kind::missing_sprite), ElementsAre(3u));
}

TEST(ConvertThings, PutThePlayerOnItsStart) {
    const PlayerRecord player = *Converted(small_level()).file.player;
    EXPECT_EQ(player.sector, "s0");
    EXPECT_EQ(player.position, (Vec2{1, -1}));
    EXPECT_EQ(player.eye_z, 41 / 32.);
    EXPECT_EQ(player.yaw_degrees, 270);
}

TEST(ConvertThings, TakeTheLastOfSeveralStarts) {
    Level level = small_level();
    level.thing(280, 40, 1);
    EXPECT_EQ(Converted(level).file.player->sector, "s1");
}

TEST(ConvertThings, StartADeathmatchMapAtItsFirstStart) {
    Level level = small_level();
    level.map.things.clear();
    level.thing(280, 40, 11);
    level.thing(32, 32, 11);
    const Converted c(level);
    EXPECT_EQ(c.file.player->sector, "s1");
    EXPECT_THAT(c.noted(Kind::no_start), SizeIs(1));
}

}  // namespace
}  // namespace enfilade::wadconv
