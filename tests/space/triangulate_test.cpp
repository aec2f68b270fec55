// Sectors as triangles: they cover the sector, nothing twice, and meet corner to corner, whatever the sector is.
#include "space/triangulate.h"

#include <gtest/gtest.h>

#include "space/mosaic.h"
#include "space/triangle_faults.h"
#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;

void expect_sound(const Map& map) {
    for (std::size_t i = 0; i < map.sectors.size(); ++i)
        EXPECT_EQ(triangle_fault(map, SectorId(i), triangulate(map, SectorId(i))), "") << map.sectors[i].name;
}

TEST(Triangulate, CutsABoxInTwo) {
    const Map map = built(map_of({box_room("box", 0, 0, 4, 2)}));
    EXPECT_EQ(triangulate(map, SectorId(0u)).size(), 2u);
    expect_sound(map);
}

TEST(Triangulate, CutsRoomsOfAnyShape) {
    expect_sound(built(map_of(
        {room("u", {{0, 0}, {8, 0}, {8, 8}, {6, 8}, {6, 4}, {2, 4}, {2, 8}, {0, 8}}), room("spiral", {{20, 0},
                                                                                                      {40, 0},
                                                                                                      {40, 20},
                                                                                                      {24, 20},
                                                                                                      {24, 8},
                                                                                                      {32, 8},
                                                                                                      {32, 12},
                                                                                                      {28, 12},
                                                                                                      {28, 16},
                                                                                                      {36, 16},
                                                                                                      {36, 4},
                                                                                                      {20, 4}})})));
}

TEST(Triangulate, KeepsVerticesOnStraightWalls) {
    expect_sound(
        built(map_of({room("box", {{0, 0}, {1, 0}, {2, 0}, {4, 0}, {4, 1}, {4, 2}, {2, 2}, {0, 2}, {0, 1}})})));
}

TEST(Triangulate, LeavesHolesOut) {
    MapFile file = map_of({box_room("hall", 0, 0, 16, 12)});
    for (double x = 1; x < 15; x += 3)
        for (double y = 1; y < 9; y += 3) cut_pillar(file.sectors[0], x, y, x + 1, y + 2);
    expect_sound(built(file));
}

// hard case T8
TEST(Triangulate, TakesHolesThatTouchInVertices) {
    MapFile file = map_of({box_room("hall", 0, 0, 12, 8)});
    for (const std::vector<Vec2>& hole : {std::vector<Vec2>{{6, 4}, {4, 3}, {4, 5}},
                                          {{6, 4}, {8, 6}, {8, 4.5}},
                                          {{6, 4}, {5, 6}, {7, 6}},
                                          {{6, 4}, {7, 2}, {5, 2}},
                                          {{8, 6}, {8, 7}, {9, 7}}})
        file.sectors[0].loops.push_back(loop_of(hole));
    expect_sound(built(file));
}

TEST(Triangulate, TakesHolesThatTouchTheOutline) {
    MapFile file = map_of({room("hall", {{0, 0}, {6, 0}, {12, 0}, {12, 8}, {0, 8}, {0, 4}})});
    file.sectors[0].loops.push_back(loop_of({{6, 0}, {5, 3}, {7, 3}}));
    file.sectors[0].loops.push_back(loop_of({{0, 4}, {2, 5}, {2, 3}}));
    expect_sound(built(file));
}

/// A sector of solid walls [m].
Map sector_of(const std::vector<std::vector<Vec2>>& loops) {
    MapFile file = map_of({room("sector", loops.front())});
    for (std::size_t i = 1; i < loops.size(); ++i) file.sectors[0].loops.push_back(loop_of(loops[i]));
    return built(file);
}

// hard case T8
TEST(Triangulate, TakesHolesThatTouchTheOutlineInAnyOfTheirCorners) {
    expect_sound(sector_of({{{15, 0}, {6, 4}, {3, 4}, {0, 1}}, {{15, 0}, {4, 3}, {12, 1}}}));
    expect_sound(sector_of({{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{8, 0}, {6, 4}, {5, 7}}}));
    const auto grid = [](std::vector<Vec2> steps) {
        for (Vec2& v : steps) v = v * 0x1p-10;
        return steps;
    };
    expect_sound(
        sector_of({grid({{0, 3892}, {33548, 0}, {43258, 2428}}), grid({{43258, 2428}, {33547, 1}, {36456, 1021}})}));
    expect_sound(
        sector_of({grid({{0, 1806}, {1093, 0}, {2078, 2136}}), grid({{2078, 2136}, {646, 1861}, {1363, 1999}})}));
}

// hard case T8
TEST(Triangulate, TakesHolesThatTouchTheOutlineInAllTheirCorners) {
    expect_sound(sector_of(
        {{{0, 0}, {4, 0}, {8, 0}, {8, 4}, {8, 8}, {4, 8}, {0, 8}, {0, 4}}, {{4, 0}, {0, 4}, {4, 8}, {8, 4}}}));
}

// hard case T8
TEST(Triangulate, TakesChainsOfHolesFromWallToWall) {
    expect_sound(sector_of({{{0, 0}, {8, 0}, {8, 4}, {8, 8}, {0, 8}, {0, 4}},
                            {{0, 4}, {1, 6}, {2, 4}},
                            {{2, 4}, {3, 2}, {1, 2}},
                            {{2, 4}, {4, 6}, {6, 4}, {4, 3}},
                            {{6, 4}, {7, 5}, {8, 4}}}));
}

// hard case T8
TEST(Triangulate, TakesLoopsThatPassThroughThemselves) {
    expect_sound(sector_of({{{0, 0}, {8, 0}, {4, 4}, {8, 8}, {0, 8}, {4, 4}}}));
    expect_sound(sector_of({{{0, 0}, {4, 0}, {2, 4}, {6, 4}, {4, 0}, {8, 0}, {8, 8}, {0, 8}}}));
}

TEST(Triangulate, TakesWallsBackToBack) {
    expect_sound(sector_of({{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{2, 2}, {4, 4}, {4, 6}, {4, 4}}}));
    expect_sound(sector_of({{{0, 0}, {8, 0}, {4, 4}, {8, 0}, {8, 8}, {0, 8}}}));
    expect_sound(sector_of({{{0, 0}, {8, 0}, {0, 8}}, {{8, 0}, {8, 8}, {0, 8}}}));
}

/// Points around (0, 0), clockwise and all at different angles: some to the right, then some to the left.
std::vector<Vec2> spokes(int count) {
    std::vector<Vec2> points;
    for (int i = 0; i < count / 2; ++i) points.push_back({64, double(2 * i + 1 - count / 2)});
    for (int i = 0; i < count / 2; ++i) points.push_back({-64, double(count / 2 - 2 * i - 1)});
    return points;
}

constexpr int kBlades = 100;

TEST(Triangulate, TakesAHundredOutlinesAroundAVertex) {
    const std::vector<Vec2> ends = spokes(2 * kBlades);
    std::vector<std::vector<Vec2>> loops;
    for (std::size_t i = 0; i < ends.size(); i += 2) loops.push_back({{0, 0}, ends[i], ends[i + 1]});
    expect_sound(sector_of(loops));
}

TEST(Triangulate, TakesAHundredHolesAroundAVertex) {
    const std::vector<Vec2> ends = spokes(2 * kBlades);
    std::vector<std::vector<Vec2>> loops{{{-200, -200}, {200, -200}, {200, 200}, {-200, 200}}};
    for (std::size_t i = 0; i < ends.size(); i += 2) loops.push_back({{0, 0}, ends[i + 1], ends[i]});
    expect_sound(sector_of(loops));
}

// hard case R22
TEST(Triangulate, TakesSeveralOutlines) {
    MapFile file = map_of({box_room("ring", 0, 0, 8, 8)});
    cut_pillar(file.sectors[0], 1, 1, 7, 7);
    file.sectors[0].loops.push_back(loop_of({{2, 2}, {6, 2}, {6, 6}, {2, 6}}));
    expect_sound(built(file));
}

TEST(Triangulate, TakesMosaics) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        expect_sound(
            lay_mosaic({.columns = 10, .rows = 10, .jitter = seed % 2 ? 0.9 : 0.0, .labels = 3, .solid = 0.2}, seed)
                .map);
    }
}

}  // namespace
}  // namespace enfilade
