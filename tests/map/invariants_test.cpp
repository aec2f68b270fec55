// Random nonsense in, a finding or a sound Map out: what a Map promises holds for every file that is accepted.
#include <gmock/gmock.h>

#include <cmath>

#include "base/hash.h"
#include "map/edge_sweep.h"
#include "math/predicates.h"
#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;

constexpr int kMaps = 10'000;

/// Corners of a lattice so small that rooms share edges, vertices and names by chance.
Vec2 lattice_point(Random& random) {
    return {static_cast<double>(random.below(4)), static_cast<double>(random.below(4))};
}

std::vector<Vec2> some_outline(Random& random) {
    if (random.below(4) != 0) {  // mostly boxes, or nothing would be accepted
        const Vec2 min = lattice_point(random);
        const double w = 1 + static_cast<double>(random.below(2)), h = 1 + static_cast<double>(random.below(2));
        return {min, {min.x + w, min.y}, {min.x + w, min.y + h}, {min.x, min.y + h}};
    }
    std::vector<Vec2> outline(2 + random.below(4));
    for (Vec2& v : outline) v = lattice_point(random);
    return outline;
}

std::string some_name(Random& random) { return std::string(1, static_cast<char>('a' + random.below(3))); }

WallRecord some_wall(Random& random) {
    WallRecord wall;
    wall.texture = spec("wall");
    switch (random.below(12)) {
        case 0: wall.next = some_name(random); break;
        case 1:
            wall.next = some_name(random);
            wall.via = some_name(random);
            break;
        case 2: wall.mirror = true; break;
        default: break;
    }
    if (random.below(3) == 0) wall.name = some_name(random);
    if (!wall.via.empty() && random.below(4) == 0) wall.rise = static_cast<double>(random.below(3)) - 1;
    return wall;
}

MapFile some_map(Random& random) {
    MapFile file = map_of({});
    file.format = static_cast<int>(random.below(2));
    for (std::uint64_t i = 1 + random.below(3); i > 0; --i) {
        SectorRecord s = room(std::string(1, static_cast<char>('a' + file.sectors.size())), some_outline(random));
        if (random.below(4) == 0) s.loops.push_back(loop_of(some_outline(random)));
        for (LoopRecord& loop : s.loops)
            for (WallRecord& wall : loop.walls) wall = some_wall(random);
        file.sectors.push_back(std::move(s));
    }
    place_player(file, some_name(random), lattice_point(random));
    return file;
}

void check_ring(const Map& map, WallId id) {
    const Wall& wall = map[id];
    ASSERT_NE(wall.a, wall.b);
    ASSERT_EQ(map[wall.next].a, wall.b);
    ASSERT_EQ(map[wall.next].previous, id);
    ASSERT_EQ(map[wall.next].sector, wall.sector);
}

void check_exit(const Map& map, WallId id) {
    const Wall& wall = map[id];
    if (wall.kind == WallKind::solid) {
        ASSERT_TRUE(wall.behind.is_none() && wall.exit.is_none() && wall.link == Wall::kNoLink);
        return;
    }
    ASSERT_TRUE(wall.behind && wall.exit);
    ASSERT_EQ(map[wall.exit].sector, wall.behind);
    const Rigid m = map.passage(wall);
    const Vec2 middle = m.apply((wall.a + wall.b) * 0.5), exit = (map[wall.exit].a + map[wall.exit].b) * 0.5;
    if (wall.link == Wall::kNoLink) {
        // In line with its exit, the other way round (longer in the tutorial dialect).
        ASSERT_EQ(corner(map[wall.exit].a, map[wall.exit].b, wall.a), 0);
        ASSERT_LT(dot(wall.b - wall.a, map[wall.exit].b - map[wall.exit].a), 0);
    } else {
        // Midpoint on midpoint: a turn of numbers below 8 m rounds by less than 2^-48 m.
        ASSERT_NEAR(middle.x, exit.x, 0x1p-48);
        ASSERT_NEAR(middle.y, exit.y, 0x1p-48);
    }
}

void check_shape(const Map& map, const Sector& sector) {
    const SweepFindings found = sweep_edges(std::span(map.walls).subspan(sector.first_wall, sector.wall_count));
    ASSERT_TRUE(found.clashes.empty());
    ASSERT_TRUE(found.wrong_sided.empty());
    ASSERT_GE(sector.ceiling.z, sector.floor.z);
}

TEST(BuildMap, KeepsItsPromisesForEveryFileItAccepts) {
    int accepted = 0, with_links = 0;
    for (int i = 0; i < kMaps; ++i) {
        Random random(static_cast<std::uint64_t>(i));
        const MapFile file = some_map(random);
        Findings findings;
        const auto map = build_map(file, textures_for(file), findings);
        ASSERT_EQ(map.has_value(), !has_errors(findings)) << i;
        if (!map) continue;
        ++accepted;
        with_links += !map->links.empty();
        SCOPED_TRACE(i);
        for (std::uint32_t w = 0; w < map->walls.size(); ++w) {
            ASSERT_NO_FATAL_FAILURE(check_ring(*map, WallId(w)));
            ASSERT_NO_FATAL_FAILURE(check_exit(*map, WallId(w)));
        }
        for (const Sector& sector : map->sectors) ASSERT_NO_FATAL_FAILURE(check_shape(*map, sector));
    }
    EXPECT_GT(accepted, kMaps / 50);
    EXPECT_GT(with_links, kMaps / 200);
}

}  // namespace
}  // namespace enfilade
