// Sounds of a map: who makes them.
#include <gmock/gmock.h>

#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;

SoundRecord sound_of(std::string name, double reach) {
    SoundRecord record;
    record.file = name + ".wav";
    record.name = std::move(name);
    record.reach = reach;
    return record;
}

ThingRecord sounding_thing_at(Vec2 position, std::string sound) {
    ThingRecord thing;
    thing.position = position;
    thing.sound = std::move(sound);
    return thing;
}

TriggerRecord heard_trigger(Activation on, std::string sound) {
    TriggerRecord trigger;
    trigger.on = on;
    trigger.action = TriggerAction::sound;
    trigger.sound = std::move(sound);
    return trigger;
}

/// Two rooms side by side that know the sounds "hum" and "click".
MapFile two_sounding_rooms() {
    MapFile file = map_of({box_room("left", 0, 0, 4, 4), box_room("right", 4, 0, 8, 4)});
    join_all(file);
    file.sounds = {sound_of("hum", 10), sound_of("click", 25)};
    return file;
}

TEST(Sounds, ReachAsFarAsTheFarthestOfThem) { EXPECT_EQ(built(two_sounding_rooms()).farthest_sound_m, 25); }

TEST(Sounds, OfAMapWithoutThemReachNowhere) {
    EXPECT_EQ(built(map_of({box_room("a", 0, 0, 4, 4)})).farthest_sound_m, 0);
}

TEST(Sounds, AreFoundByThings) {
    MapFile file = two_sounding_rooms();
    file.things = {sounding_thing_at({1, 1}, "click")};
    EXPECT_EQ(built(file).things[0].sound, SoundId(1u));
}

TEST(Sounds, ListTheThingsThatAreHeardBySector) {
    MapFile file = two_sounding_rooms();
    file.things = {sounding_thing_at({5, 1}, "hum"), sounding_thing_at({1, 1}, "hum"), sounding_thing_at({2, 1}, ""),
                   sounding_thing_at({3, 1}, "click")};
    EXPECT_THAT(built(file).sounding_things, testing::ElementsAre(ThingId(1u), ThingId(3u), ThingId(0u)));
}

TEST(Sounds, AreFoundBySectors) {
    MapFile file = two_sounding_rooms();
    sector(file, "right").move_sound = "hum";
    sector(file, "right").stop_sound = "click";
    const Map map = built(file);
    EXPECT_EQ(map.sectors[1].up_sound, SoundId(0u));
    EXPECT_EQ(map.sectors[1].down_sound, SoundId(0u));
    EXPECT_EQ(map.sectors[1].stop_sound, SoundId(1u));
    EXPECT_EQ(map.sectors[0].up_sound, SoundId());
}

TEST(Sounds, OfSectorsMayDifferOnTheWayDown) {
    MapFile file = two_sounding_rooms();
    sector(file, "right").move_sound = "hum";
    sector(file, "right").down_sound = "click";
    const Map map = built(file);
    EXPECT_EQ(map.sectors[1].up_sound, SoundId(0u));
    EXPECT_EQ(map.sectors[1].down_sound, SoundId(1u));
}

TEST(Sounds, OfTriggersAreHeardFromWhatTheyAreOn) {
    MapFile file = two_sounding_rooms();
    file.things = {sounding_thing_at({1, 1}, "")};
    file.things[0].triggers = {heard_trigger(Activation::touch, "hum")};
    sector(file, "right").triggers = {heard_trigger(Activation::enter, "hum")};
    wall(file, "left", {0, 0}, {4, 0}).triggers = {heard_trigger(Activation::use, "click")};
    PanelRecord panel;
    panel.a = {1, 1};
    panel.b = {2, 1};
    panel.texture = spec("-");
    panel.triggers = {heard_trigger(Activation::use, "click")};
    sector(file, "left").panels = {panel};
    const Map map = built(file);
    ASSERT_EQ(map.triggers.size(), 4u);
    EXPECT_EQ(map.triggers[0].on_sector, SectorId(1u));
    EXPECT_EQ(map.triggers[1].on_wall, WallId(0u));
    EXPECT_EQ(map.triggers[2].on_panel, PanelId(0u));
    EXPECT_EQ(map.triggers[3].on_thing, ThingId(0u));
}

TEST(Sounds, OnlyHeardTriggersNeedNoTarget) {
    MapFile file = two_sounding_rooms();
    wall(file, "left", {0, 0}, {4, 0}).triggers = {heard_trigger(Activation::use, "click")};
    EXPECT_FALSE(has_errors(findings_of(file))) << text_of(findings_of(file));
}

}  // namespace
}  // namespace enfilade
