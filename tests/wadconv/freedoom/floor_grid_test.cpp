// Ways over floors: around what stands there, and not where a body does not fit.
#include "wadconv/freedoom/floor_grid.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "world/game.h"

namespace enfilade::test {
namespace {

/// A hall with what the test puts into it, and a niche behind its far wall.
MapFile hall() {
    MapFile file = map_of({box_room("hall", 0, 0, 8, 4, 0, 4), box_room("niche", 8, 1, 10, 3, 0, 4)});
    split_and_join(file);
    place_player(file, "hall", {1, 2}, kEyeOnFloor);
    return file;
}

/// The way from the player's start into the sector of that name.
std::vector<Vec2> way_into(const MapFile& file, const std::string& name) {
    const Game game(file);
    FloorGrid grid(game.map);
    const auto start = grid.point_near(body_of(game.map, game.player()));
    std::vector<Vec2> way;
    const auto is_wanted = [&](SectorId sector) { return game.map[sector].name == name; };
    for (const std::uint32_t point : grid.way_to(start.value(), is_wanted)) way.push_back(grid[point].place.point);
    return way;
}

TEST(FloorGrid, LeadsStraightWhereNothingStands) {
    const std::vector<Vec2> way = way_into(hall(), "niche");
    EXPECT_EQ(way.size(), 29u);  // from x = 1 to x = 8, a quarter of a metre each
}

TEST(FloorGrid, LeadsAroundAPillar) {
    MapFile file = hall();
    cut_pillar(sector(file, "hall"), 4, 0.5, 5, 3.125);
    const std::vector<Vec2> way = way_into(file, "niche");
    EXPECT_TRUE(std::ranges::any_of(way, [](Vec2 p) { return p.x >= 4 && p.x <= 5 && p.y == 3.5; }));
}

TEST(FloorGrid, LeadsAroundASolidThing) {
    MapFile file = hall();
    ThingRecord& barrel = file.things.emplace_back();
    barrel.position = {4, 2};
    barrel.solid = true;
    const std::vector<Vec2> way = way_into(file, "niche");
    ASSERT_FALSE(way.empty());
    for (const Vec2 p : way) EXPECT_GE(dot(p - Vec2{4, 2}, p - Vec2{4, 2}), 0.85 * 0.85);
}

TEST(FloorGrid, LeadsNowhereThroughAGapThatIsTooNarrow) {
    MapFile file = hall();
    cut_pillar(sector(file, "hall"), 4, 0.5, 5, 3.5);
    EXPECT_TRUE(way_into(file, "niche").empty());
}

TEST(FloorGrid, FindsSectorsThatAreNarrowerThanAStep) {
    MapFile file = map_of(
        {box_room("hall", 0, 0, 4.0625, 4), box_room("line", 4.0625, 0, 4.125, 4), box_room("end", 4.125, 0, 8, 4)});
    split_and_join(file);
    place_player(file, "hall", {2, 2}, kEyeOnFloor);
    EXPECT_FALSE(way_into(file, "line").empty());
}

TEST(FloorGrid, LeadsDownADropButNotUp) {
    MapFile file = map_of({box_room("ledge", 0, 0, 4, 4, 2, 6), box_room("pit", 4, 0, 8, 4, 0, 6)});
    split_and_join(file);
    place_player(file, "ledge", {2, 2}, 2 + kEyeOnFloor);
    EXPECT_FALSE(way_into(file, "pit").empty());
    file.player->sector = "pit";
    file.player->position = {6, 2};
    file.player->eye_z = kEyeOnFloor;
    EXPECT_TRUE(way_into(file, "ledge").empty());
}

TEST(FloorGrid, AvoidsDropsWhereAsked) {
    MapFile file = map_of({box_room("ledge", 0, 0, 4, 4, 2, 6), box_room("pit", 4, 0, 8, 4, 0, 6)});
    split_and_join(file);
    place_player(file, "ledge", {2, 2}, 2 + kEyeOnFloor);
    const Game game(file);
    FloorGrid grid(game.map);
    const std::uint32_t start = grid.point_near(body_of(game.map, game.player())).value();
    const auto is_pit = [&](SectorId sector) { return game.map[sector].name == "pit"; };
    EXPECT_TRUE(grid.way_to(start, is_pit, Drops::avoided).empty());
    EXPECT_FALSE(grid.way_to(start, is_pit, Drops::taken).empty());
}

TEST(FloorGrid, KnowsWhereOneHasToCrouch) {
    MapFile file = map_of({box_room("hall", 0, 0, 4, 4, 0, 4), box_room("low", 4, 0, 8, 4, 0, 1.25)});
    split_and_join(file);
    place_player(file, "hall", {2, 2}, kEyeOnFloor);
    const Game game(file);
    FloorGrid grid(game.map);
    const std::uint32_t start = grid.point_near(body_of(game.map, game.player())).value();
    const auto way = grid.way_to(start, [&](SectorId sector) { return game.map[sector].name == "low"; });
    EXPECT_FALSE(grid[way.front()].is_low());
    EXPECT_TRUE(grid[way.back()].is_low());
}

TEST(FloorGrid, ForgetsAStepThatIsClosed) {
    const Game game(hall());
    FloorGrid grid(game.map);
    const std::uint32_t start = grid.point_near(body_of(game.map, game.player())).value();
    const auto is_niche = [&](SectorId sector) { return game.map[sector].name == "niche"; };
    const auto before = grid.way_to(start, is_niche);
    grid.close(before[0], before[1]);
    EXPECT_NE(grid.way_to(start, is_niche)[1], before[1]);
}

}  // namespace
}  // namespace enfilade::test
