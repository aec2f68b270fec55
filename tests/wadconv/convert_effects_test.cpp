// What Doom's lines and sectors do, as triggers, light effects and pictures that change.
#include <gmock/gmock.h>

#include "wadconv/converted.h"

namespace enfilade::wadconv {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// The doorway's line with a special and a tag, and the sector behind it with that tag.
struct Line : Doorway {
    explicit Line(int special, int tag = 7) {
        line().special = static_cast<std::uint16_t>(special);
        line().tag = static_cast<std::uint16_t>(tag);
        level.map.sectors[1].tag = 7;
    }

    /// All triggers on the wall in front of the line.
    std::vector<TriggerRecord> triggers(const std::string& map = "MAP01") const {
        const Converted c(level, {}, map);
        return c.wall("s0", 64, 64).triggers;
    }
    /// The one trigger there is.
    TriggerRecord trigger(const std::string& map = "MAP01") const {
        const std::vector<TriggerRecord> all = triggers(map);
        EXPECT_THAT(all, SizeIs(1));
        return all.empty() ? TriggerRecord{} : all.front();
    }
};

TEST(ConvertTriggers, MakeADoorOfTheSectorBehind) {
    const TriggerRecord door = Line(1).trigger();
    EXPECT_EQ(door.on, Activation::use);
    EXPECT_EQ(door.action, TriggerAction::door);
    EXPECT_THAT(door.targets, IsEmpty());
    EXPECT_EQ(door.speed, 2 * 35 / 32.);
    EXPECT_EQ(door.wait, 150 / 35.);
    EXPECT_FALSE(door.once);
}

TEST(ConvertTriggers, TurnADoorRoundOnlyFromTheDoorItself) {
    EXPECT_TRUE(Line(1).trigger().reverses);
    EXPECT_TRUE(Line(117).trigger().reverses);
    EXPECT_FALSE(Line(63).trigger().reverses);
    EXPECT_FALSE(Line(114).trigger().reverses);
}

TEST(ConvertTriggers, LockDoors) {
    EXPECT_EQ(Line(26).trigger().key, "blue");
    EXPECT_EQ(Line(27).trigger().key, "yellow");
    EXPECT_EQ(Line(28).trigger().key, "red");
}

TEST(ConvertTriggers, SlowDownWhatCrushesButNotTheFastOnes) {
    for (const int slow : {25, 44, 49, 72, 73, 141}) EXPECT_EQ(Line(slow).trigger().crush_speed, 35 / 32. / 8) << slow;
    for (const int fast : {6, 77, 55}) EXPECT_FALSE(Line(fast).trigger().crush_speed) << fast;
}

TEST(ConvertTriggers, CallALiftByItsTag) {
    const TriggerRecord lift = Line(88).trigger();
    EXPECT_EQ(lift.on, Activation::cross);
    EXPECT_EQ(lift.action, TriggerAction::lift);
    EXPECT_THAT(lift.targets, ElementsAre("tag 7"));
    EXPECT_EQ(lift.speed, 4 * 35 / 32.);
    EXPECT_EQ(lift.wait, 3);
}

TEST(ConvertTriggers, WorkOnceWhereTheLineDoes) {
    EXPECT_TRUE(Line(10).trigger().once);
    EXPECT_FALSE(Line(88).trigger().once);
}

TEST(ConvertTriggers, GoAwayWithTheirSpecial) {
    const Converted c(Line(88).level);
    EXPECT_FALSE(c.wall("s0", 64, 64).doom);
    EXPECT_THAT(c.report.lines_left, IsEmpty());
}

TEST(ConvertTriggers, AreUsedWhereDoomShoots) {
    const Line line(46);
    EXPECT_EQ(line.trigger().on, Activation::use);
    EXPECT_THAT(Converted(line.level).noted(Kind::shot_trigger), ElementsAre(2u));
}

// hard case W13
TEST(ConvertTriggers, NeedATagThatASectorHas) {
    const Line line(88, 8), untagged(88, 0);
    EXPECT_THAT(line.triggers(), IsEmpty());
    EXPECT_THAT(untagged.triggers(), IsEmpty());
    const Converted c(line.level);
    EXPECT_THAT(c.noted(Kind::aimless_trigger), ElementsAre(2u));
    EXPECT_EQ(c.report.lines_left.at(88), 1u);
}

TEST(ConvertTriggers, NeedALineThatCanBePassed) {
    Line line(1);
    line.line().flags = 0;
    EXPECT_THAT(line.triggers(), IsEmpty());
    EXPECT_THAT(Converted(line.level).noted(Kind::closed_trigger), ElementsAre(2u));
}

TEST(ConvertTriggers, MoveFloorsToWhatIsAround) {
    const TriggerRecord floor = Line(36).trigger();
    EXPECT_EQ(floor.action, TriggerAction::floor);
    EXPECT_EQ(floor.to, enfilade::HeightLevel::highest_floor);
    EXPECT_EQ(floor.by, 0.25);
}

TEST(ConvertTriggers, TakeThePictureOfTheSectorInFront) {
    const TriggerRecord floor = Line(22).trigger();
    EXPECT_EQ(floor.texture, "flats/floor0_1");
    EXPECT_TRUE(floor.heals);
}

TEST(ConvertTriggers, TakePictureAndNatureOfASectorAround) {
    Line line(37);  // s1 goes down from 16 to s0's 0
    EXPECT_THAT(line.trigger().targets, ElementsAre("s1"));
    EXPECT_EQ(line.trigger().texture, "flats/floor0_1");
    EXPECT_TRUE(line.trigger().heals);
    line.level.map.sectors[0].special = 5;
    EXPECT_FALSE(line.trigger().heals);
}

TEST(ConvertTriggers, RaiseByTheShortestTextureAround) {
    Line line(30);
    EXPECT_EQ(line.trigger().by, 4 / 32.);  // as high as WALL is here
}

TEST(ConvertTriggers, LeadOutOfTheLevel) {
    EXPECT_EQ(Line(52).trigger().action, TriggerAction::leave_map);
    EXPECT_THAT(Line(52).trigger().targets, ElementsAre("map02"));
    EXPECT_THAT(Line(124).trigger("E1M3").targets, ElementsAre("e1m9"));
    EXPECT_THAT(Line(52).trigger("E1M8").targets, IsEmpty());
}

TEST(ConvertTriggers, TeleportFromTheFrontOnly) {
    Line line(97);
    line.level.thing(96, 32, 14);
    const TriggerRecord teleport = line.trigger();
    EXPECT_THAT(teleport.targets, ElementsAre("exit of s1"));
    EXPECT_TRUE(teleport.one_way);
    EXPECT_EQ(Converted(line.level).file.things.back().name, "exit of s1");
}

TEST(ConvertTriggers, TeleportNowhereWithoutAnExit) {
    EXPECT_THAT(Converted(Line(97).level).noted(Kind::aimless_trigger), ElementsAre(2u));
}

TEST(ConvertTriggers, ChangeLight) {
    EXPECT_EQ(Line(13).trigger().light, 255 / 256.);
    EXPECT_EQ(Line(104).trigger().light_of, LightLevel::darkest);
    EXPECT_EQ(Line(17).trigger().effect.value().kind, LightKind::strobe);
}

/// Three sectors in a row behind the doorway, the first with the tag, all with the same floor.
struct Stairs : Line {
    explicit Stairs(int special) : Line(special) {
        for (int i = 0; i < 2; ++i) {
            level.sector(16, 128);
            const auto x = static_cast<std::int16_t>(128 + 64 * i), end = static_cast<std::int16_t>(x + 64);
            level.line({x, 64}, {end, 64}, 2 + i);
            level.line({end, 0}, {x, 0}, 2 + i);
            if (i == 0) level.line({end, 64}, {end, 0}, 2, 3);
        }
        level.line({256, 64}, {256, 0}, 3);
        Linedef& between = level.map.lines[5];
        between.flags = kTwoSided;
        between.left = static_cast<std::uint16_t>(level.side(2));
    }
};

TEST(ConvertTriggers, FindTheStairs) {
    const TriggerRecord stairs = Stairs(8).trigger();
    EXPECT_EQ(stairs.action, TriggerAction::stairs);
    EXPECT_THAT(stairs.targets, ElementsAre("s1", "s2", "s3"));
    EXPECT_EQ(stairs.step, 0.25);
    EXPECT_EQ(stairs.speed, 0.25 * 35 / 32);
}

TEST(ConvertTriggers, CountAStairOfTwoPartsOnce) {
    Stairs stairs(7);
    stairs.level.box(0, 256, 64, 320, 1);
    EXPECT_THAT(stairs.trigger().targets, SizeIs(Stairs(7).trigger().targets.size()));
}

TEST(ConvertTriggers, EndStairsWhereTheFloorLooksDifferent) {
    Stairs stairs(8);
    stairs.level.map.sectors[3].floor_flat = "F_SKY1";
    EXPECT_THAT(stairs.trigger().targets, ElementsAre("s1", "s2"));
}

TEST(ConvertTriggers, RaiseUnevenStairsToTheirHeights) {
    Stairs stairs(8);
    stairs.level.map.sectors[2].floor = 0;
    const std::vector<TriggerRecord> floors = stairs.triggers();
    ASSERT_THAT(floors, SizeIs(3));
    EXPECT_EQ(floors[1].z, (16 + 2 * 8) / 32.);
}

TEST(ConvertTriggers, SinkAPillarIntoItsRing) {
    Level level;
    level.sector(0);
    level.sector(8);
    level.sector(64);
    level.box(0, 0, 256, 256, 0);
    level.box(64, 64, 192, 192, 1, 0);
    level.box(96, 96, 160, 160, 2, 1);
    level.map.sectors[2].tag = 3;
    level.map.lines[0].special = 9;
    level.map.lines[0].tag = 3;
    const Converted c(level);
    const std::vector<TriggerRecord>& triggers = c.file.sectors[0].loops[0].walls[0].triggers;
    ASSERT_THAT(triggers, SizeIs(2));
    EXPECT_THAT(triggers[0].targets, ElementsAre("s2"));
    EXPECT_THAT(triggers[1].targets, ElementsAre("s1"));
    for (const TriggerRecord& trigger : triggers) EXPECT_EQ(trigger.like, "s0");
    EXPECT_EQ(triggers[1].texture, "flats/floor0_1");
}

/// The level with a lone line, 12, of that special, and its panels.
struct LoneLine {
    Level level = small_level();
    Linedef& line = level.map.lines[12];
    explicit LoneLine(int special, int flags = kTwoSided) {
        line.special = static_cast<std::uint16_t>(special);
        line.flags = static_cast<std::uint16_t>(flags);
        line.tag = level.map.sectors[1].tag = 7;
    }

    /// The triggers of each panel in the line's place.
    static std::vector<std::vector<TriggerRecord>> triggers(const Converted& c) {
        std::vector<std::vector<TriggerRecord>> all;
        for (const PanelRecord& panel : c.file.sectors[0].panels)
            if (panel.a.y == -6) all.push_back(panel.triggers);
        return all;
    }
    TriggerRecord trigger() const {
        const auto all = triggers(Converted(level));
        EXPECT_TRUE(all.size() == 1 && all[0].size() == 1);
        return all.empty() || all[0].empty() ? TriggerRecord{} : all[0][0];
    }
};

TEST(ConvertPanels, DoWhatTheirLineDoes) {
    const LoneLine lift(88);
    EXPECT_EQ(lift.trigger().on, Activation::cross);
    EXPECT_EQ(lift.trigger().action, TriggerAction::lift);
    EXPECT_THAT(lift.trigger().targets, ElementsAre("tag 7"));
    EXPECT_FALSE(lift.trigger().one_way);
    EXPECT_THAT(Converted(lift.level).report.lines_left, IsEmpty());
}

TEST(ConvertPanels, AreUsedFromTheirRightAndShotAtFromBothSides) {
    EXPECT_TRUE(LoneLine(62).trigger().one_way);
    EXPECT_FALSE(LoneLine(46).trigger().one_way);
}

TEST(ConvertPanels, ThatBlockAreNotPassed) {
    const Converted c(LoneLine(88, kTwoSided | kBlocking).level);
    EXPECT_THAT(LoneLine::triggers(c), ElementsAre(IsEmpty()));
    EXPECT_THAT(c.noted(Kind::closed_trigger), ElementsAre(12u));
    EXPECT_EQ(c.report.lines_left.at(88), 1u);
}

TEST(ConvertPanels, ThatBlockAreUsed) { EXPECT_EQ(LoneLine(62, kTwoSided | kBlocking).trigger().on, Activation::use); }

TEST(ConvertPanels, OfALineThatOnlyItsLeftShowsStillWorkFromItsRight) {
    LoneLine lever(62);
    lever.level.map.sides[lever.line.left].middle = "FENCE";
    const Converted c(lever.level);
    EXPECT_THAT(LoneLine::triggers(c), ElementsAre(SizeIs(1), IsEmpty()));
    EXPECT_EQ(c.file.sectors[0].panels[1].a, (Vec2{4, -6})) << "the one that works runs as the line does";
}

TEST(ConvertPanels, OfALineWithTwoPicturesWorkOnce) {
    LoneLine lift(88);
    lift.level.map.sides[lift.line.left].middle = lift.level.map.sides[lift.line.right].middle = "FENCE";
    lift.level.map.sides[lift.line.left].x_offset = 5;
    EXPECT_THAT(LoneLine::triggers(Converted(lift.level)), ElementsAre(SizeIs(1), IsEmpty()));
}

TEST(ConvertWalls, ScrollToTheLeft) {
    const Converted c(Line(48).level);
    EXPECT_EQ(c.wall("s0", 64, 64).scroll, (Vec2{-35 / 32., 0}));
    EXPECT_THAT(c.report.lines_left, IsEmpty());
}

/// Sector 1 of the doorway with that special; it is as bright as 160, its neighbour as 96.
SectorRecord sector_of(int special) {
    Doorway d;
    d.level.map.sectors[0].light = 96;
    d.level.map.sectors[1].light = 160;
    d.level.map.sectors[1].special = static_cast<std::uint16_t>(special);
    return Converted(d.level).file.sectors[1];
}

TEST(ConvertSectors, LetLightChange) {
    const LightEffectRecord strobe = sector_of(12).light_effect.value();
    EXPECT_EQ(strobe.kind, LightKind::strobe);
    EXPECT_EQ(strobe.dark, 96 / 256.);
    EXPECT_EQ(strobe.dark_s, 1);
    EXPECT_TRUE(strobe.in_step);
    const LightEffectRecord glow = sector_of(8).light_effect.value();
    EXPECT_EQ(glow.kind, LightKind::glow);
    EXPECT_EQ(glow.dark_s, (160 - 96) / 8 / 35.);
    EXPECT_EQ(sector_of(17).light_effect.value().kind, LightKind::fire);
    EXPECT_EQ(sector_of(1).light_effect.value().kind, LightKind::flicker);
    for (const int special : {1, 2, 8, 17}) EXPECT_TRUE(sector_of(special).light_effect.value().lasts) << special;
}

TEST(ConvertSectors, LetLightChangeAtDoomsTics) {
    EXPECT_EQ(sector_of(2).light_effect.value().clock_hz, 35);
    const LightEffectRecord flicker = sector_of(1).light_effect.value(), fire = sector_of(17).light_effect.value();
    EXPECT_EQ(flicker.clock_hz * flicker.dark_s, 66);
    EXPECT_EQ(flicker.clock_hz * flicker.bright_s, 9);
    EXPECT_EQ(fire.step, 16 / 256.);
    EXPECT_EQ(fire.dark, (96 + 16) / 256.);
}

TEST(ConvertSectors, LetOnlyStrobesGoDarkerThanWhatIsAround) {
    Doorway d;
    d.level.map.sectors[1].special = 3;
    EXPECT_EQ(Converted(d.level).file.sectors[1].light_effect.value().dark, 0);
    d.level.map.sectors[1].special = 8;
    EXPECT_FALSE(Converted(d.level).file.sectors[1].light_effect);
}

TEST(ConvertSectors, LetFloorsHurt) {
    EXPECT_EQ(sector_of(7).damage, 5);
    EXPECT_EQ(sector_of(5).damage, 11);
    EXPECT_EQ(sector_of(16).damage, 22);
    EXPECT_EQ(sector_of(4).damage, 22);
    EXPECT_EQ(sector_of(64).damage, 11);  // Boom's bits
}

TEST(ConvertSectors, LetDoorsMoveByThemselves) {
    const TriggerRecord close = sector_of(10).triggers.at(0);
    EXPECT_EQ(close.on, Activation::start);
    EXPECT_EQ(close.action, TriggerAction::close);
    EXPECT_EQ(close.after, 30);
    EXPECT_EQ(sector_of(14).triggers.at(0).after, 300);
}

TEST(ConvertSectors, KeepSpecialsWithoutWords) {
    EXPECT_EQ(sector_of(11).doom, (DoomRecord{11, 0, 0}));
    EXPECT_FALSE(sector_of(9).doom);
    EXPECT_TRUE(sector_of(9).secret);
}

TEST(ConvertThings, GiveKeysAndHealth) {
    Level level = small_level();
    level.thing(32, 32, 5);
    level.thing(32, 32, 38);
    level.thing(32, 32, 2012);
    const Converted c(level);
    EXPECT_EQ(c.file.things[3].gives_key, "blue");
    EXPECT_EQ(c.file.things[4].gives_key, "red");
    EXPECT_EQ(c.file.things[5].gives_health, 25);
}

}  // namespace
}  // namespace enfilade::wadconv
