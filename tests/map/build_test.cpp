// From records to a Map: walls, portals, boxes and the player; and the names that a map has.
#include "map/load.h"

#include <gmock/gmock.h>

#include "map/draft.h"
#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;
using ::testing::IsEmpty;

/// The wall a -> b of a built map; none where there is none.
WallId wall_at(const Map& map, Vec2 a, Vec2 b) {
    for (std::size_t i = 0; i < map.walls.size(); ++i)
        if (map.walls[i].a == a && map.walls[i].b == b) return WallId(i);
    return {};
}

/// Two rooms side by side, 4 x 4 m each, with a doorway along all of x = 4.
MapFile two_rooms_and_player() {
    MapFile file = map_of({box_room("left", 0, 0, 4, 4), box_room("right", 4, 0, 8, 4)});
    join_all(file);
    place_player(file, "left", {1, 1});
    return file;
}

TEST(BuildMap, AcceptsTwoRoomsWithoutAWord) { EXPECT_EQ(text_of(findings_of(two_rooms_and_player())), ""); }

TEST(BuildMap, GivesEachSectorItsWallsInOrder) {
    const Map map = built(two_rooms_and_player());
    ASSERT_EQ(map.sectors.size(), 2u);
    EXPECT_EQ(map.sectors[1].first_wall, 4u);
    EXPECT_EQ(map.sectors[1].wall_count, 4u);
    for (const Wall& wall : map.walls) EXPECT_EQ(map[wall.next].a, wall.b);
}

TEST(BuildMap, ClosesEveryLoopIntoARing) {
    MapFile file = map_of({box_room("hall", 0, 0, 8, 8)});
    cut_pillar(file.sectors[0], 2, 2, 3, 3);
    const Map map = built(file);
    EXPECT_EQ(map.walls[3].next, WallId(0u));
    EXPECT_EQ(map.walls[7].next, WallId(4u));
    EXPECT_EQ(map.walls[4].previous, WallId(7u));
}

TEST(BuildMap, LetsNeighboursOpenIntoEachOther) {
    const Map map = built(two_rooms_and_player());
    const WallId there = wall_at(map, {4, 0}, {4, 4}), back = wall_at(map, {4, 4}, {4, 0});
    EXPECT_EQ(map[there].kind, WallKind::portal);
    EXPECT_EQ(map[there].behind, SectorId(1u));
    EXPECT_EQ(map[there].exit, back);
    EXPECT_EQ(map[back].exit, there);
    EXPECT_FALSE(map[there].one_way_exit || map[back].one_way_exit);
    EXPECT_TRUE(map.passage(map[there]).is_identity());
}

TEST(BuildMap, AllowsAPortalWhoseOtherSideIsSolid) {
    MapFile file = two_rooms_and_player();
    wall(file, "right", {4, 4}, {4, 0}).next.clear();
    const Map map = built(file);
    const WallId there = wall_at(map, {4, 0}, {4, 4});
    EXPECT_EQ(map[map[there].exit].kind, WallKind::solid);
    EXPECT_TRUE(map[map[there].exit].one_way_exit);
}

TEST(BuildMap, WarnsOfARoomThatOpensOntoASolidWall) {
    MapFile file = two_rooms_and_player();
    wall(file, "right", {4, 4}, {4, 0}).next.clear();
    EXPECT_THAT(text_of(findings_of(file)),
                ::testing::HasSubstr("warning: sector 'left' opens onto this edge (4, 4)-(4, 0) of sector 'right'"));
}

TEST(BuildMap, TakesAOneWayLinkForMeant) {
    MapFile file = two_rooms_and_player();
    wall(file, "right", {4, 4}, {4, 0}).next.clear();
    wall(file, "right", {4, 4}, {4, 0}).name = "back";
    wall(file, "left", {4, 0}, {4, 4}).via = "back";
    EXPECT_EQ(text_of(findings_of(file)), "");
}

TEST(BuildMap, RoundsVerticesToTheGridHalfToEven) {
    MapFile file = map_of({room("tiny", {{0x1p-11, 0}, {4, 0}, {4, 3 * 0x1p-11}, {0, 0.1 + 0.2}})});
    const Map map = built(file);
    EXPECT_EQ(map.walls[0].a, (Vec2{0, 0}));
    EXPECT_EQ(map.walls[2].a, (Vec2{4, 0x1p-9}));
    EXPECT_EQ(map.walls[3].a.y, 307 / 1024.0);
}

TEST(BuildMap, BoxesEachSector) {
    const Map map = built(map_of({room("tent", {{-3, 1}, {5, 2}, {0, 7}})}));
    EXPECT_EQ(map.sectors[0].min, (Vec2{-3, 1}));
    EXPECT_EQ(map.sectors[0].max, (Vec2{5, 7}));
}

TEST(BuildMap, StartsThePlayerWhereTheFileSays) {
    MapFile file = two_rooms_and_player();
    place_player(file, "right", {5.25, 1.5}, 1.7, 90);
    const Map map = built(file);
    ASSERT_TRUE(map.player);
    EXPECT_EQ(map.player->sector, SectorId(1u));
    EXPECT_EQ(map.player->position, (Vec2{5.25, 1.5}));
    EXPECT_EQ(map.player->eye_z, 1.7);
    EXPECT_EQ(map.player->yaw.steps, 0x40000000u);
}

TEST(BuildMap, PutsThePlayerOnThePointGrid) {
    MapFile file = two_rooms_and_player();
    place_player(file, "left", {1.0 / 3, 0x1p-33});
    const Map map = built(file);
    EXPECT_EQ(map.player->position.x * 0x1p32, 1431655765);
    EXPECT_EQ(map.player->position.y, 0);
}

TEST(BuildMap, RefusesWhatTheReaderRefused) {
    Findings findings{{{3, 1}, Severity::error, "unknown-key", "a finding of the reader"}};
    const MapFile file = two_rooms_and_player();
    EXPECT_FALSE(build_map(file, textures_for(file), findings));
    EXPECT_EQ(findings.size(), 1u);
}

// Finding names, the nearest ones, and those used twice.

NameIndex named_rooms() {
    return NameIndex(
        {{0, "hall", 0}, {0, "cellar", 1}, {1, "door", 7}, {0, "hall", 4}, {2, "door", 3}, {0, "hall", 2}});
}

TEST(NameIndex, FindsTheFirstOfAName) { EXPECT_EQ(named_rooms().find(0, "hall"), 0u); }

TEST(NameIndex, KeepsScopesApart) {
    EXPECT_EQ(named_rooms().find(1, "door"), 7u);
    EXPECT_EQ(named_rooms().find(2, "door"), 3u);
    EXPECT_FALSE(named_rooms().find(0, "door"));
}

TEST(NameIndex, TellsEveryFurtherUseOfAName) {
    EXPECT_THAT(named_rooms().duplicates(), ::testing::ElementsAre(::testing::Pair(0, 2), ::testing::Pair(0, 4)));
}

TEST(NameIndex, SuggestsTheNearestName) {
    EXPECT_EQ(named_rooms().suggestion(0, "celar"), "; did you mean 'cellar'?");
    EXPECT_EQ(named_rooms().suggestion(0, "attic"), "");
    EXPECT_EQ(named_rooms().suggestion(3, "door"), "");
}

TEST(NameIndex, StopsSuggestingWhenItHasCostTooMuch) {
    std::vector<std::string> texts;
    for (int i = 0; i < 1'000; ++i) texts.push_back("room" + std::to_string(i));
    std::vector<ScopedName> names;
    for (std::uint32_t i = 0; i < texts.size(); ++i) names.push_back({0, texts[i], i});
    const NameIndex index(std::move(names));
    EXPECT_NE(index.suggestion(0, "romm5"), "");
    for (int i = 0; i < 200; ++i) index.suggestion(0, "nothing like it");
    EXPECT_EQ(index.suggestion(0, "romm5"), "");
}

}  // namespace
}  // namespace enfilade
