// What is heard, how loud, and from which side: of things, of what moves, and of triggers.
#include "world/voices.h"

#include <gmock/gmock.h>

#include "world/game.h"

namespace enfilade {
namespace {

using namespace test;
using testing::IsEmpty;
using testing::SizeIs;

/// Sums of a few square roots.
constexpr double kRounding = 1e-9;

/// Half a metre of walls hides nothing: reach of the sounds here [m].
constexpr double kReach = 20;

constexpr double kClickSeconds = 0.5, kHumSeconds = 2;
constexpr std::array kLengths{kClickSeconds, kHumSeconds, kHumSeconds};

/// Every map here knows "click", which plays once, "hum", which loops, and "rumble", which plays once.
void add_sounds(MapFile& file) {
    file.sounds = {{"click", "click.wav", 1, kReach, false, {}},
                   {"hum", "hum.wav", 0.5, kReach, true, {}},
                   {"rumble", "rumble.wav", 1, kReach, false, {}}};
}

ThingRecord humming(Vec2 position) {
    ThingRecord thing;
    thing.position = position;
    thing.sound = "hum";
    return thing;
}

double hum_after(double way_m) { return 0.5 * (1 - way_m / kReach) * (1 - way_m / kReach); }

/// A game and an ear in it.
struct Heard {
    explicit Heard(MapFile file) : game(with_sounds(std::move(file))), hearing(game.map) {}

    static MapFile with_sounds(MapFile file) {
        add_sounds(file);
        return file;
    }

    std::vector<Voice> at(double tick, const Place& ear, Angle yaw = {}) {
        return voices_at({game.map, game.world.history, tick}, hearing, {ear, yaw}, kLengths);
    }
    std::vector<Voice> now(const Place& ear, Angle yaw = {}) {
        return at(static_cast<double>(game.world.tick), ear, yaw);
    }
    /// As the player hears it.
    std::vector<Voice> now() { return now(game.player().place, game.player().yaw); }

    Game game;
    Hearing hearing;
};

MapFile hall_with_hum(Vec2 thing) {
    MapFile file = map_of({box_room("hall", 0, 0, 16, 16)});
    file.things = {humming(thing)};
    place_player(file, "hall", {8, 8}, kEyeOnFloor);
    return file;
}

TEST(Voices, OfAThingFadeWithTheSquareOfWhatIsLeftOfTheReach) {
    Heard heard(hall_with_hum({13, 8}));
    ASSERT_THAT(heard.now(), SizeIs(1));
    EXPECT_NEAR(heard.now()[0].level, hum_after(5), kRounding);
    EXPECT_TRUE(heard.now()[0].loops);
}

TEST(Voices, ComeFromTheSideTheHeadIsTurnedTo) {
    Heard heard(hall_with_hum({13, 8}));
    const Place ear{SectorId(0u), {8, 8}};
    EXPECT_NEAR(heard.now(ear, Angle::from_degrees(0))[0].side, 0, kRounding);
    EXPECT_NEAR(heard.now(ear, Angle::from_degrees(90))[0].side, -1, kRounding);
    EXPECT_NEAR(heard.now(ear, Angle::from_degrees(-90))[0].side, 1, kRounding);
    EXPECT_NEAR(heard.now(ear, Angle::from_degrees(-30))[0].side, 0.5, kRounding);
}

TEST(Voices, MoveIntoTheMiddleOfTheHead) {
    Heard heard(hall_with_hum({8, 8.25}));
    EXPECT_NEAR(heard.now()[0].side, 0.25 / kAroundHead, kRounding);
}

TEST(Voices, EndWhereTheirReachEnds) {
    MapFile file = hall_with_hum({13, 8});
    file.sounds.clear();
    Heard heard(file);
    heard.game.map.sounds[1].reach_m = 5;
    EXPECT_THAT(heard.now(), IsEmpty());
}

TEST(Voices, AreNotThereInASilentMap) {
    MapFile file = map_of({box_room("hall", 0, 0, 16, 16)});
    place_player(file, "hall", {8, 8}, kEyeOnFloor);
    Game game(file);
    Hearing hearing(game.map);
    EXPECT_THAT(voices_at(now(game.map, game.world), hearing, {game.player().place, {}}, {}), IsEmpty());
}

TEST(Voices, AreOnlyListenedForWhereSomethingSounds) {
    Heard heard(hall_with_hum({13, 8}));
    heard.game.map.sounding_things.clear();
    heard.now();
    EXPECT_THAT(heard.hearing.sectors(), IsEmpty());
}

TEST(Voices, GoRoundCorners) {
    MapFile file = map_of({room("bend", {{0, 0}, {8, 0}, {8, 2}, {2, 2}, {2, 8}, {0, 8}})});
    file.things = {humming({6, 1})};
    place_player(file, "bend", {1, 5}, kEyeOnFloor);
    Heard heard(file);
    // From (1, 5) to the corner (2, 2), where it seems to come from, and on to (6, 1).
    const Voice voice = heard.now({SectorId(0u), {1, 5}}, Angle::from_degrees(-90))[0];
    EXPECT_NEAR(voice.level, hum_after(std::sqrt(10) + std::sqrt(17)), kRounding);
    EXPECT_NEAR(voice.side, 1 / std::sqrt(10), kRounding);
}

/// A hall, a closed door of 1 m with sounds, and a room behind it that hums. The player stands at (6.5, 2).
MapFile hall_door_room() {
    MapFile file = map_of(
        {box_room("hall", 0, 0, 8, 4, 0, 3), box_room("door", 8, 0, 9, 4, 0, 0), box_room("room", 9, 0, 17, 4, 0, 3)});
    join_all(file);
    place_player(file, "hall", {6.5, 2}, kEyeOnFloor);
    TriggerRecord opens = trigger_on(Activation::use, TriggerAction::door);
    opens.wait = 1;
    sector(file, "door").triggers = {opens};
    return file;
}

constexpr int kDoorTicks = 87;  ///< 2.875 m at 2 m/s
constexpr int kWaitTicks = 60;

TEST(Voices, DoNotComeThroughAClosedDoor) {
    MapFile file = hall_door_room();
    file.things = {humming({11, 2})};
    Heard heard(file);
    EXPECT_THAT(heard.now(), IsEmpty());
}

TEST(Voices, ComeThroughADoorAsSoonAsItOpens) {
    MapFile file = hall_door_room();
    file.things = {humming({11, 2})};
    Heard heard(file);
    heard.game.hold(kUse, 2);
    ASSERT_THAT(heard.now(), SizeIs(1));
    EXPECT_NEAR(heard.now()[0].level, hum_after(11 - heard.game.point().x), kRounding);
}

TEST(Voices, ComeThroughALink) {
    MapFile file = map_of({box_room("hall", 0, 0, 8, 4), box_room("far", 100, 100, 104, 108)});
    // Out of the hall's east wall one comes in through the north wall of the other room.
    link(file, "hall", {8, 0}, {8, 4}, "far", {100, 100}, {104, 100});
    file.things = {humming({102, 103})};
    place_player(file, "hall", {6, 2}, kEyeOnFloor);
    Heard heard(file);
    const Voice voice = heard.now({SectorId(0u), {6, 2}}, Angle::from_degrees(-90))[0];
    EXPECT_NEAR(voice.level, hum_after(5), kRounding);
    EXPECT_NEAR(voice.side, 1, kRounding);
}

TEST(Voices, OfThingsEndWhenTheyAreTaken) {
    MapFile file = hall_with_hum({8, 8});
    file.things[0].gives_key = "red";
    Heard heard(file);
    heard.game.hold(kNoKeys);
    EXPECT_THAT(heard.now(), IsEmpty());
}

TEST(Voices, OfADoorBeginWhenItSetsOff) {
    MapFile file = hall_door_room();
    sector(file, "door").move_sound = "rumble";
    Heard heard(file);
    EXPECT_THAT(heard.now(), IsEmpty());
    heard.game.hold(kUse);
    ASSERT_THAT(heard.now(), SizeIs(1));
    EXPECT_EQ(heard.now()[0].maker, Maker::start);
    EXPECT_EQ(heard.now()[0].since, 0);
    // The closed door is 1.5 m away, straight ahead.
    EXPECT_NEAR(heard.now()[0].level, loudness(1.5, kReach), kRounding);
    EXPECT_NEAR(heard.now()[0].side, 0, kRounding);
}

TEST(Voices, ThatPlayOnceEndWithTheirLength) {
    MapFile file = hall_door_room();
    sector(file, "door").move_sound = "click";
    Heard heard(file);
    heard.game.hold(kUse);
    const Place ear = heard.game.player().place;
    EXPECT_THAT(heard.at(kClickSeconds * kTickRate - 1, ear), SizeIs(1));
    EXPECT_THAT(heard.at(kClickSeconds * kTickRate, ear), IsEmpty());
}

TEST(Voices, AfterASilenceAreNotHeardFromWhereTheEarWasBefore) {
    MapFile file = hall_door_room();
    sector(file, "door").move_sound = "click";
    Heard heard(file);
    heard.game.hold(kUse);
    const Place near = heard.game.player().place, far{near.sector, {0.5, 2}};
    const double sounding = 1, silent = kClickSeconds * kTickRate;
    const auto first_slice = [&](double tick, const Place& ear) {
        return voices_at({heard.game.map, heard.game.world.history, tick}, heard.hearing, {ear, {}}, kLengths, 1);
    };
    EXPECT_THAT(heard.at(sounding, near), SizeIs(1));
    EXPECT_THAT(first_slice(sounding, far), SizeIs(1));  // as it was heard before
    EXPECT_THAT(first_slice(silent, far), IsEmpty());
    EXPECT_THAT(first_slice(sounding, far), IsEmpty());
    EXPECT_THAT(heard.at(sounding, far), SizeIs(1));
}

TEST(Voices, ThatLoopGoOnForAsLongAsTheDoorMoves) {
    MapFile file = hall_door_room();
    sector(file, "door").move_sound = "hum";
    Heard heard(file);
    heard.game.hold(kUse);
    heard.game.hold(kNoKeys, 400);
    const Place ear = heard.game.player().place;
    EXPECT_THAT(heard.at(kDoorTicks - 1, ear), SizeIs(1));
    EXPECT_THAT(heard.at(kDoorTicks, ear), IsEmpty());
    EXPECT_THAT(heard.at(kDoorTicks + kWaitTicks - 1, ear), IsEmpty());
    EXPECT_THAT(heard.at(kDoorTicks + kWaitTicks, ear), SizeIs(1));
    EXPECT_THAT(heard.at(kDoorTicks + kWaitTicks + kDoorTicks, ear), IsEmpty());
}

TEST(Voices, OfADoorMayDifferOnItsWayDown) {
    MapFile file = hall_door_room();
    sector(file, "door").move_sound = "rumble";
    sector(file, "door").down_sound = "hum";
    Heard heard(file);
    heard.game.hold(kUse);
    heard.game.hold(kNoKeys, 400);
    const Place ear = heard.game.player().place;
    ASSERT_THAT(heard.at(kDoorTicks - 1, ear), SizeIs(1));
    EXPECT_EQ(heard.at(kDoorTicks - 1, ear)[0].sound, SoundId(2u));
    ASSERT_THAT(heard.at(2 * kDoorTicks + kWaitTicks - 1, ear), SizeIs(1));
    EXPECT_EQ(heard.at(2 * kDoorTicks + kWaitTicks - 1, ear)[0].sound, SoundId(1u));
}

TEST(Voices, OfADoorEndWhenItArrives) {
    MapFile file = hall_door_room();
    sector(file, "door").stop_sound = "click";
    Heard heard(file);
    heard.game.hold(kUse);
    const Place ear = heard.game.player().place;
    EXPECT_THAT(heard.at(kDoorTicks - 1, ear), IsEmpty());
    ASSERT_THAT(heard.at(kDoorTicks, ear), SizeIs(1));
    EXPECT_EQ(heard.at(kDoorTicks, ear)[0].maker, Maker::stop);
    EXPECT_EQ(heard.at(kDoorTicks, ear)[0].since, kDoorTicks);
}

TEST(Voices, OfADoorThatTurnsRoundDoNotSayThatItArrived) {
    MapFile file = hall_door_room();
    sector(file, "door").stop_sound = "click";
    Heard heard(file);
    heard.game.hold(kUse);
    heard.game.hold(kNoKeys, 30);
    heard.game.hold(kUse);
    EXPECT_THAT(heard.now(), IsEmpty());
}

TEST(Voices, OfASwitchComeFromItsWall) {
    MapFile file = map_of({box_room("hall", 0, 0, 8, 4)});
    TriggerRecord click = trigger_on(Activation::use, TriggerAction::sound);
    click.sound = "click";
    wall(file, "hall", {8, 0}, {8, 4}).triggers = {click};
    place_player(file, "hall", {7, 2}, kEyeOnFloor);
    Heard heard(file);
    heard.game.hold(kNoKeys, 3);
    heard.game.hold(kUse);
    ASSERT_THAT(heard.now(), SizeIs(1));
    EXPECT_EQ(heard.now()[0].maker, Maker::trigger);
    EXPECT_EQ(heard.now()[0].since, 3);
    EXPECT_NEAR(heard.now()[0].level, loudness(1, kReach), kRounding);
    EXPECT_THAT(heard.at(3 + kClickSeconds * kTickRate, heard.game.player().place), IsEmpty());
}

TEST(Voices, OfAPanelComeFromItsMiddle) {
    MapFile file = map_of({box_room("hall", 0, 0, 8, 4)});
    TriggerRecord click = trigger_on(Activation::use, TriggerAction::sound);
    click.sound = "click";
    PanelRecord lever;
    lever.a = {7.5, 0.5};
    lever.b = {7.5, 3.5};
    lever.texture = spec("-");
    lever.triggers = {click};
    file.sectors[0].panels = {lever};
    place_player(file, "hall", {6.5, 2}, kEyeOnFloor);
    Heard heard(file);
    heard.game.hold(kUse);
    ASSERT_THAT(heard.now(), SizeIs(1));
    EXPECT_NEAR(heard.now()[0].level, loudness(1, kReach), kRounding);
    EXPECT_NEAR(heard.now({SectorId(0u), {7.5, 3}})[0].level, loudness(1, kReach), kRounding);
}

TEST(Voices, OfAnyMomentAreWhatTheyWereWhenItCame) {
    MapFile file = hall_door_room();
    sector(file, "door").move_sound = "rumble";
    sector(file, "door").stop_sound = "click";
    sector(file, "door").triggers[0].sound = "click";
    file.things = {humming({11, 2}), humming({1, 1})};
    Heard heard(file);
    const Place ear = heard.game.player().place;
    // What is used in a tick happens at its beginning, but is not known before its end.
    const auto is_used = [](int tick) { return tick == 10 || tick == 50 || tick == 220; };
    std::vector<std::vector<Voice>> then;
    for (int i = 0; i < 300; ++i) {
        then.push_back(heard.now(ear));
        heard.game.hold(is_used(i) ? kUse : kNoKeys);
    }
    for (std::size_t i = 0; i < then.size(); ++i) {
        if (is_used(int(i))) continue;
        const std::vector<Voice> again = heard.at(static_cast<double>(i), ear);
        ASSERT_EQ(again.size(), then[i].size()) << i;
        for (std::size_t v = 0; v < again.size(); ++v) {
            EXPECT_TRUE(again[v].is_same(then[i][v])) << i;
            EXPECT_EQ(again[v].level, then[i][v].level) << i;
        }
    }
}

TEST(Voices, AreTheLoudestOfMany) {
    MapFile file = hall_with_hum({9, 8});
    for (int i = 0; i < 50; ++i) file.things.push_back(humming({9 + i * 0.125, 8}));
    Heard heard(file);
    ASSERT_THAT(heard.now(), SizeIs(kMostVoices));
    EXPECT_NEAR(heard.now().back().level, hum_after(1 + 30 * 0.125), kRounding);
}

}  // namespace
}  // namespace enfilade
