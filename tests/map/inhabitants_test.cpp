// The player and the things: in the room they say, or reported; in the tutorial dialect, wherever they are.
#include <gmock/gmock.h>

#include "base/hash.h"
#include "map/sector_finder.h"
#include "support/generate_map.h"

namespace enfilade {
namespace {

using namespace test;
using ::testing::HasSubstr;

MapFile two_rooms() {
    MapFile file = map_of({box_room("left", 0, 0, 4, 4), box_room("right", 4, 0, 8, 4)});
    join_all(file);
    return file;
}

ThingRecord lamp_at(Vec2 position) {
    ThingRecord lamp;
    lamp.name = "lamp";
    lamp.position = position;
    return lamp;
}

TEST(Player, InTheWrongRoomIsToldTheRightOne) {
    MapFile file = two_rooms();
    place_player(file, "left", {6, 1});
    EXPECT_THAT(text_of(findings_of(file)), HasSubstr("error: the player's position (6, 1) is outside sector 'left'; "
                                                      "(6, 1) is in 'right' [player-outside]"));
}

// hard case C22
TEST(Player, OutsideOfAllRoomsIsToldToMove) {
    MapFile file = two_rooms();
    place_player(file, "left", {60, 1});
    EXPECT_THAT(text_of(findings_of(file)), HasSubstr("error: the player's position (60, 1) is outside sector 'left'; "
                                                      "no sector is there, so move the player into one"));
}

TEST(Player, OfATutorialMapStartsWhereHeStands) {
    MapFile file = two_rooms();
    file.format = 0;
    place_player(file, "left", {6, 1});
    const Map map = built(file);
    ASSERT_TRUE(map.player);
    EXPECT_EQ(map.player->sector, SectorId(1u));
}

TEST(Player, OfATutorialMapWithoutHisDefaultRoomStartsWhereHeStands) {
    MapFile file = two_rooms();
    file.format = 0;
    place_player(file, "main", {1, 1});
    EXPECT_EQ(built(file).player->sector, SectorId(0u));
}

TEST(Player, OfATutorialMapOutsideEveryRoomDoesNotStart) {
    MapFile file = two_rooms();
    file.format = 0;
    place_player(file, "left", {100, 100});
    EXPECT_FALSE(built(file).player);
}

// hard case C22
TEST(Player, MayStandOnTheLineBetweenRoomsInExactlyOne) {
    for (const char* name : {"left", "right"}) {
        MapFile file = two_rooms();
        place_player(file, name, {4, 2});
        EXPECT_EQ(has_errors(findings_of(file)), std::string(name) == "left");
    }
}

TEST(Player, InAClosedDoorIsNotToldToDuck) {
    MapFile file = map_of({box_room("door", 0, 0, 4, 4, 0, 0)});
    place_player(file, "door", {1, 1});
    EXPECT_EQ(text_of(findings_of(file)), "");
}

TEST(Thing, MayBeInAnyRoomThatContainsIt) {
    MapFile file = two_rooms();
    place_player(file, "left", {1, 1});
    file.things.push_back(lamp_at({6, 2}));
    EXPECT_EQ(text_of(findings_of(file)), "");
}

TEST(Thing, OutsideTheRoomItNamesIsReported) {
    MapFile file = two_rooms();
    file.things.push_back(lamp_at({6, 2}));
    file.things[0].sector = "left";
    EXPECT_THAT(text_of(findings_of(file)), HasSubstr("outside sector 'left'"));
}

TEST(SectorFinder, GivesTheLowestNumberWhereSectorsOverlap) {
    std::vector<SectorRecord> rooms;
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < 40; ++i) {  // each a little wider than the one before
        rooms.push_back(box_room("r" + std::to_string(i), -1.0 - i, -1.0 - i, 1.0 + i, 1.0 + i));
        all.push_back(39 - i);
    }
    const Map map = built(map_of(std::move(rooms)));
    const SectorFinder finder(map, all);
    for (std::uint32_t i = 0; i < 40; ++i) EXPECT_EQ(finder.around({i + 0.5, 0}), SectorId(i));
}

TEST(SectorFinder, AgreesWithLookingAtEverySector) {
    const Map map = built(grid_of_rooms(300));
    std::vector<std::uint32_t> all(map.sectors.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    const SectorFinder finder(map, all);
    Random random(3);
    for (int i = 0; i < 2'000; ++i) {
        // On a lattice of half metres, so that many points lie on edges and vertices.
        const Vec2 p{static_cast<double>(random.below(220)) / 2 - 2, static_cast<double>(random.below(220)) / 2 - 2};
        SectorId expected;
        for (std::size_t s = 0; s < map.sectors.size() && !expected; ++s)
            if (is_inside(map, SectorId(s), p)) expected = SectorId(s);
        ASSERT_EQ(finder.around(p), expected) << p.x << " " << p.y;
    }
}

TEST(PointLight, IsInTheRoomAroundItUnlessItNamesOne) {
    MapFile file = map_of({box_room("lower", 0, 0, 4, 4), box_room("upper", 0, 0, 4, 4, 5, 8)});
    file.lights.resize(2);
    for (PointLightRecord& light : file.lights) light.position = {1, 2};
    file.lights[0].z = 1;
    file.lights[1].z = 6;
    file.lights[1].sector = "upper";
    const Map map = built(file);
    ASSERT_EQ(map.lights.size(), 2u);
    EXPECT_EQ(map.lights[0].sector, SectorId(0u));
    EXPECT_EQ(map.lights[1].sector, SectorId(1u));
}

TEST(PointLights, AreRefusedOnceWhereTogetherTheyReachTooFar) {
    MapFile file = map_of({box_room("room", 0, 0, 4, 4)});
    file.lights.resize(5000);
    for (PointLightRecord& light : file.lights) {
        light.position = {1, 2};
        light.z = 1;
    }
    const Findings findings = findings_of(file);
    const auto is_it = [](const Finding& finding) { return finding.code == "too-many-lights"; };
    EXPECT_EQ(std::count_if(findings.begin(), findings.end(), is_it), 1);
    file.lights.resize(4000);
    EXPECT_FALSE(has_errors(findings_of(file)));
}

}  // namespace
}  // namespace enfilade
