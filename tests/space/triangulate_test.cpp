// Sectors as triangles: they cover the sector, nothing twice, and meet corner to corner.
#include "space/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "math/predicates.h"
#include "space/mosaic.h"
#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;

struct Corners {
    Vec2 a, b, c;
};

std::vector<Corners> triangles_of(const Map& map, SectorId sector) {
    std::vector<Corners> corners;
    for (const Triangle& t : triangulate(map, sector)) corners.push_back({map[t[0]].a, map[t[1]].a, map[t[2]].a});
    return corners;
}

/// Twice the area. Exact: the maps of these tests are small enough for products of grid steps to fit a double.
double area_of(const Map& map, SectorId sector) {
    double sum = 0;
    const Sector& s = map[sector];
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i)
        sum += cross(map.walls[i].a, map.walls[i].b);
    return sum;
}

double area_of(const std::vector<Corners>& triangles) {
    double sum = 0;
    for (const Corners& t : triangles) sum += cross(t.b - t.a, t.c - t.a);
    return sum;
}

bool is_left(Vec2 a, Vec2 b, const Corners& t) {
    return corner(a, b, t.a) <= 0 && corner(a, b, t.b) <= 0 && corner(a, b, t.c) <= 0;
}

bool separates(const Corners& s, const Corners& t) {
    return is_left(s.a, s.b, t) || is_left(s.b, s.c, t) || is_left(s.c, s.a, t);
}

bool is_inside_edge(Vec2 p, Vec2 a, Vec2 b) { return corner(a, b, p) == 0 && dot(p - a, p - b) < 0; }

bool all_clockwise(const std::vector<Corners>& triangles) {
    return std::ranges::all_of(triangles, [](const Corners& t) { return corner(t.a, t.b, t.c) > 0; });
}

bool any_overlap(const std::vector<Corners>& triangles) {
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (!separates(triangles[i], triangles[j]) && !separates(triangles[j], triangles[i])) return true;
    return false;
}

bool any_vertex_inside_an_edge(const Map& map, SectorId sector, const std::vector<Corners>& triangles) {
    const Sector& s = map[sector];
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i)
        for (const Corners& t : triangles) {
            const Vec2 p = map.walls[i].a;
            if (is_inside_edge(p, t.a, t.b) || is_inside_edge(p, t.b, t.c) || is_inside_edge(p, t.c, t.a)) return true;
        }
    return false;
}

void expect_sound(const Map& map) {
    for (std::size_t i = 0; i < map.sectors.size(); ++i) {
        const SectorId sector(i);
        const std::vector<Corners> triangles = triangles_of(map, sector);
        EXPECT_EQ(area_of(triangles), area_of(map, sector)) << map.sectors[i].name;
        EXPECT_TRUE(all_clockwise(triangles)) << map.sectors[i].name;
        EXPECT_FALSE(any_overlap(triangles)) << map.sectors[i].name;
        EXPECT_FALSE(any_vertex_inside_an_edge(map, sector, triangles)) << map.sectors[i].name;
    }
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

TEST(Triangulate, TakesSeveralOutlines) {
    MapFile file = map_of({box_room("ring", 0, 0, 8, 8)});
    cut_pillar(file.sectors[0], 1, 1, 7, 7);
    file.sectors[0].loops.push_back(loop_of({{2, 2}, {6, 2}, {6, 6}, {2, 6}}));
    expect_sound(built(file));
}

TEST(Triangulate, TakesRandomMosaics) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        expect_sound(
            lay_mosaic({.columns = 10, .rows = 10, .jitter = seed % 2 ? 0.9 : 0.0, .labels = 3, .solid = 0.2}, seed)
                .map);
    }
}

}  // namespace
}  // namespace enfilade
