// Things as a Map holds them: where they stand, what they look like, and which of them are solid.
#include <gmock/gmock.h>

#include <limits>

#include "support/generate_map.h"
#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kForEver = std::numeric_limits<double>::infinity();

ThingRecord thing_at(Vec2 position) {
    ThingRecord thing;
    thing.position = position;
    return thing;
}

/// Two rooms side by side: floors at 1 and 0 m, ceilings at 4 and 3 m.
MapFile rooms_with(std::vector<ThingRecord> things) {
    MapFile file = map_of({box_room("left", 0, 0, 4, 4, 1, 4), box_room("right", 4, 0, 8, 4, 0, 3)});
    join_all(file);
    file.things = std::move(things);
    return file;
}

SpriteFrameRecord frame(std::string texture, double seconds = 0) { return {std::move(texture), seconds, {}}; }

std::vector<double> frame_ends(const ThingRecord& thing) {
    const Map map = built(rooms_with({thing}));
    std::vector<double> ends;
    for (const SpriteFrame& f : map.sprites[0].frames) ends.push_back(f.until_s);
    return ends;
}

TEST(Things, AreInTheRoomThatContainsThem) {
    const Map map = built(rooms_with({thing_at({6, 1}), thing_at({1, 1})}));
    ASSERT_EQ(map.things.size(), 2u);
    EXPECT_EQ(map.things[0].sector, SectorId(1u));
    EXPECT_EQ(map.things[1].sector, SectorId(0u));
}

TEST(Things, OnTheLineBetweenRoomsAreInTheOneTheTieRuleSays) {
    const Map map = built(rooms_with({thing_at({4, 2})}));
    EXPECT_EQ(map.things[0].sector, SectorId(1u));  // p + (e, e^2) is to the right
}

TEST(Things, OutsideEveryRoomAreLeftOut) { EXPECT_THAT(built(rooms_with({thing_at({9, 9})})).things, IsEmpty()); }

TEST(Things, ArePutOntoTheGridOfMovingPoints) {
    const Map map = built(rooms_with({thing_at({1.1, 1.3})}));
    EXPECT_EQ(map.things[0].position, snap_to_point_grid(Vec2{1.1, 1.3}));
}

TEST(Things, StandOnTheFloorUnlessTheySayOtherwise) { EXPECT_EQ(built(rooms_with({thing_at({1, 1})})).things[0].z, 1); }

TEST(Things, HangUnderTheCeiling) {
    ThingRecord lamp = thing_at({1, 1});
    lamp.hanging = true;
    lamp.height = 0.5;
    EXPECT_EQ(built(rooms_with({lamp})).things[0].z, 3.5);
}

TEST(Things, MayFloat) {
    ThingRecord cloud = thing_at({1, 1});
    cloud.z = 2.25;
    const Map map = built(rooms_with({cloud}));
    EXPECT_EQ(map.things[0].z, 2.25);
    EXPECT_EQ(map.things[0].footing, Footing::fixed);
}

TEST(Things, ThatLookAlikeShareASprite) {
    std::vector<ThingRecord> things(3, thing_at({1, 1}));
    for (ThingRecord& thing : things) thing.frames = {frame("barrel")};
    things[2].size = 16;
    const Map map = built(rooms_with(things));
    EXPECT_EQ(map.sprites.size(), 2u);
    EXPECT_EQ(map.things[0].sprite, map.things[1].sprite);
}

TEST(Things, WithoutFramesAreInvisible) {
    EXPECT_TRUE(built(rooms_with({thing_at({1, 1})})).things[0].sprite.is_none());
}

TEST(Sprite, CountsTheEndsOfItsFramesFromItsStart) {
    ThingRecord torch = thing_at({1, 1});
    torch.frames = {frame("a", 0.25), frame("b", 0.5), frame("a", 0.25)};
    EXPECT_THAT(frame_ends(torch), ElementsAre(0.25, 0.75, 1));
}

TEST(Sprite, EndsWithTheFrameThatStays) {
    ThingRecord gate = thing_at({1, 1});
    gate.frames = {frame("a", 0.25), frame("b"), frame("c", 1)};
    EXPECT_THAT(frame_ends(gate), ElementsAre(0.25, kForEver));
}

TEST(Sprite, HasAPictureForEachEighthOfATurn) {
    ThingRecord statue = thing_at({1, 1});
    statue.rotations = 8;
    statue.frames = {frame("statue")};
    const MapFile file = rooms_with({statue});
    const TextureSet textures = textures_for(file);
    const Sprite sprite = built(file).sprites[0];
    for (int view = 0; view < 8; ++view)
        EXPECT_EQ(textures[sprite.frames[0].views[view]].name, "statue" + std::to_string(view + 1));
}

TEST(Sprite, ReachesAsFarAsItsWiderHalf) {
    ThingRecord flag = thing_at({1, 1});
    flag.frames = {{"flag", 0, Vec2{48, 0}}};  // the picture is 64 texels wide, 2 m
    EXPECT_EQ(built(rooms_with({flag})).sprites[0].reach_m, 1.5);
}

TEST(Sprite, WithoutAnOriginStandsOnTheBottomMiddleOfEachPicture) {
    ThingRecord statue = thing_at({1, 1});
    statue.rotations = 8;
    statue.frames = {frame("statue")};
    const MapFile file = rooms_with({statue});
    TextureSet textures = textures_for(file);
    Texture& from_behind = textures.textures[textures.find("statue5").index];
    from_behind.width = 32;
    from_behind.height = 96;
    Findings findings;
    const SpriteFrame shown = build_map(file, textures, findings)->sprites[0].frames[0];
    EXPECT_EQ(shown.origins_m[0], (Vec2{1, 2}));  // 64 texels each way, 32 a metre
    EXPECT_EQ(shown.origins_m[4], (Vec2{0.5, 3}));
    EXPECT_EQ(text_of(findings).find("thing-sunk"), std::string::npos);
}

TEST(Sprite, WithADashShowsNothing) {
    ThingRecord ghost = thing_at({1, 1});
    ghost.rotations = 8;
    ghost.frames = {frame("-")};
    const MapFile file = rooms_with({ghost});
    EXPECT_THAT(textures_for(file).textures, testing::SizeIs(3));  // the room's
    EXPECT_TRUE(built(file).sprites[0].frames[0].views[0].is_none());
}

TEST(SolidThings, AreListedByRoom) {
    std::vector<ThingRecord> things{thing_at({6, 1}), thing_at({1, 1}), thing_at({7, 1}), thing_at({2, 1})};
    for (ThingRecord& thing : things) thing.solid = true;
    things[3].solid = false;
    const Map map = built(rooms_with(things));
    EXPECT_THAT(map.solid_things, ElementsAre(ThingId(1u), ThingId(0u), ThingId(2u)));
    EXPECT_EQ(map.sectors[1].first_solid, 1u);
    EXPECT_EQ(map.sectors[1].solid_count, 2u);
}

ThingRecord solid_at(Vec2 position, double radius) {
    ThingRecord thing = thing_at(position);
    thing.solid = true;
    thing.radius = radius;
    return thing;
}

/// Which things are told for the sector of that number, each as often as it is.
std::vector<ThingId> near_of(const Map& map, std::size_t sector) {
    std::vector<ThingId> ids;
    for (const NearThing& near : map.near(SectorId(sector))) ids.push_back(near.thing);
    return ids;
}

TEST(SolidThings, AreToldForTheRoomsInWhichBodiesTouchThem) {
    const Map map = built(rooms_with({solid_at({6, 1}, 2 - 1.5 * kWidestBody), solid_at({6, 3}, 2)}));
    EXPECT_THAT(near_of(map, 0), ElementsAre(ThingId(1u)));
    EXPECT_THAT(near_of(map, 1), ElementsAre(ThingId(0u), ThingId(1u)));
}

TEST(SolidThings, AreNotToldThroughWalls) {
    MapFile file = map_of({box_room("left", 0, 0, 4, 4), box_room("right", 4, 0, 8, 4)});
    file.things = {solid_at({4.25, 2}, 3)};
    EXPECT_THAT(near_of(built(file), 0), IsEmpty());
}

TEST(SolidThings, AreToldForWhoStandsBeforeALinkToThem) {
    MapFile file = map_of({box_room("near", 0, 0, 4, 4), box_room("far", 100, 0, 104, 4)});
    link(file, "near", {4, 0}, {4, 4}, "far", {100, 0}, {104, 0});
    file.things = {solid_at({101, 0.5}, 0.5)};
    const Map map = built(file);
    ASSERT_THAT(near_of(map, 0), ElementsAre(ThingId(0u)));
    EXPECT_EQ(map.near(SectorId(0u))[0].passage.apply({3.5, 1}), (Vec2{103, -0.5}));
}

TEST(SolidThings, AreToldForWhoStandsBeforeAOneWayPortalToThem) {
    MapFile file = map_of({box_room("near", 0, 0, 4, 4), box_room("far", 100, 0, 104, 4)});
    file.sectors[0].loops[0].walls[1].next = "far";
    file.sectors[0].loops[0].walls[1].via = "way in";
    file.sectors[1].loops[0].walls[3].name = "way in";
    file.things = {solid_at({100.5, 2}, 0.5), solid_at({3.5, 2}, 0.5)};
    const Map map = built(file);
    EXPECT_THAT(near_of(map, 0), ElementsAre(ThingId(1u), ThingId(0u)));
    EXPECT_THAT(near_of(map, 1), ElementsAre(ThingId(0u)));
}

TEST(SolidThings, AmongAThousandRoomsAreToldOnceForEach) {
    MapFile file = fan_of_sectors(1000);
    file.things = {solid_at({1, 0.5}, 40), solid_at({-1000, 0.5}, 40)};
    const Map map = built(file);
    EXPECT_LE(map.near_things.size(), 2 * map.sectors.size());
    for (std::size_t i = 0; i < map.sectors.size(); ++i) EXPECT_LE(near_of(map, i).size(), 2u) << i;
    EXPECT_GE(map.near_things.size(), map.sectors.size());
}

// Whoever spends all there is leaves the others their own rooms, and takes no more time and memory.
TEST(SolidThings, OfAnyNumberTakeNoMoreThanTheyMay) {
    constexpr std::size_t kThings = 2000;
    MapFile file = fan_of_sectors(1000);
    for (std::size_t i = 0; i < kThings; ++i) file.things.push_back(solid_at({1, 0.0009765625 * double(i + 1)}, 40));
    const Map map = built(file);
    EXPECT_LT(map.near_things.size(), 200'000u);
    std::size_t told = 0;
    for (std::size_t i = 0; i < map.sectors.size(); ++i)
        for (const NearThing& near : map.near(SectorId(i))) told += map[near.thing].sector == SectorId(i);
    EXPECT_EQ(told, kThings);
}

TEST(TextureSet, HoldsThePicturesOfAllDirections) {
    ThingRecord statue = thing_at({1, 1});
    statue.rotations = 8;
    statue.frames = {frame("Statue")};
    const TextureSet textures = textures_for(rooms_with({statue}));
    EXPECT_TRUE(textures.find("statue8"));
    EXPECT_FALSE(textures.find("statue"));
}

}  // namespace
}  // namespace enfilade
