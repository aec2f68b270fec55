// In which sectors things are to be seen.
#include "space/reach.h"

#include <gmock/gmock.h>

#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A thing with a picture 2 m wide, in its middle.
ThingRecord tree_at(Vec2 position) {
    ThingRecord thing;
    thing.position = position;
    thing.frames = {{"tree", 0, Vec2{32, 64}}};
    return thing;
}

MapFile two_rooms(std::vector<ThingRecord> things) {
    MapFile file = map_of({box_room("west", 0, 0, 4, 4), box_room("east", 4, 0, 8, 4)});
    join_all(file);
    file.things = std::move(things);
    return file;
}

std::vector<std::uint32_t> things_in(const Presences& presences, std::uint32_t sector) {
    std::vector<std::uint32_t> things;
    for (const Presence& presence : presences.in(SectorId(sector))) things.push_back(presence.thing.index);
    return things;
}

TEST(Presences, AreNoneWhereNothingHasAPicture) {
    ThingRecord marker = tree_at({1, 1});
    marker.frames.clear();
    const Presences presences = presences_of(built(two_rooms({marker})));
    EXPECT_THAT(presences.first, IsEmpty());
    EXPECT_THAT(things_in(presences, 0), IsEmpty());
}

TEST(Presences, OfAThingInTheMiddleOfARoomAreThereOnly) {
    const Presences presences = presences_of(built(two_rooms({tree_at({2, 2})})));
    EXPECT_THAT(things_in(presences, 0), ElementsAre(0u));
    EXPECT_THAT(things_in(presences, 1), IsEmpty());
}

TEST(Presences, OfAThingNearADoorwayAreOnBothSides) {
    const Presences presences = presences_of(built(two_rooms({tree_at({1, 1}), tree_at({3.5, 2}), tree_at({4, 2})})));
    EXPECT_THAT(things_in(presences, 0), ElementsAre(0u, 1u, 2u));
    EXPECT_THAT(things_in(presences, 1), ElementsAre(1u, 2u));
}

TEST(Presences, DoNotGoThroughWalls) {
    MapFile file = map_of({box_room("west", 0, 0, 4, 4), box_room("east", 4, 0, 8, 4)});
    file.things = {tree_at({3.5, 2})};
    EXPECT_THAT(things_in(presences_of(built(file)), 1), IsEmpty());
}

TEST(Presences, BehindALinkAreWhereTheLinkPutsThem) {
    MapFile file = map_of({box_room("here", 0, 0, 4, 4), box_room("there", 100, 0, 104, 4, 7, 9)});
    link(file, "here", {4, 0}, {4, 4}, "there", {104, 4}, {100, 4});
    file.things = {tree_at({3.5, 1})};
    const Presences presences = presences_of(built(file));
    ASSERT_THAT(things_in(presences, 1), ElementsAre(0u));
    const Presence& beyond = presences.in(SectorId(1u))[0];
    EXPECT_EQ(beyond.position, (Vec2{101, 4.5}));  // half a metre before the wall one comes out of
    EXPECT_EQ(beyond.passage.rise, 7);
}

TEST(Presences, ThroughTwoDoorsSideBySideAreOne) {
    MapFile file = map_of({room("west", {{0, 0}, {4, 0}, {4, 2}, {4, 4}, {0, 4}}),
                           room("east", {{4, 0}, {8, 0}, {8, 4}, {4, 4}, {4, 2}})});
    join_all(file);
    file.things = {tree_at({3.5, 2})};
    EXPECT_THAT(things_in(presences_of(built(file)), 1), ElementsAre(0u));
}

TEST(Presences, ThroughTwoLinksThatLeadApartAreTwo) {
    MapFile file = map_of({room("corner", {{0, 0}, {4, 0}, {4, 4}, {0, 4}}),
                           room("hall", {{100, 0}, {104, 0}, {110, 0}, {110, 10}, {100, 10}, {100, 4}})});
    link(file, "corner", {4, 0}, {4, 4}, "hall", {100, 4}, {100, 0});
    link(file, "corner", {0, 0}, {4, 0}, "hall", {100, 0}, {104, 0});
    file.things = {tree_at({3.5, 0.5})};
    EXPECT_THAT(things_in(presences_of(built(file)), 1), ElementsAre(0u, 0u));
}

TEST(Presences, OfPicturesWiderThanHundredsOfRoomsAreLookedForOnlySoLong) {
    std::vector<SectorRecord> rooms;
    for (int i = 0; i < 600; ++i)
        rooms.push_back(box_room("room" + std::to_string(i), i * 0.0625, 0, (i + 1) * 0.0625, 16));
    MapFile file = map_of(std::move(rooms));
    split_and_join(file);
    for (int i = 0; i < 1000; ++i) {
        file.things.push_back(tree_at({18.75, 8}));
        file.things.back().size = 1;  // the picture is as wide as all rooms
    }
    const Presences presences = presences_of(built(file));
    EXPECT_GT(presences.all.size(), 100'000u);  // the first ones are everywhere
    EXPECT_THAT(things_in(presences, 300), ::testing::Contains(999u));
    EXPECT_THAT(things_in(presences, 0), ::testing::Not(::testing::Contains(999u)));
    EXPECT_LE(presences.steps, kMostPresenceSteps + (std::size_t{1} << 20));
}

}  // namespace
}  // namespace enfilade
