// Point location against an oracle that only asks about convex cells.
#include "space/trace.h"

#include <gtest/gtest.h>

#include "base/hash.h"
#include "math/vec.h"
#include "space/mosaic.h"
#include "support/map_builder.h"

namespace enfilade {
namespace {

using test::lay_mosaic;
using test::Mosaic;

TEST(Contains, AgreesWithTheCellsAtRandomPoints) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Mosaic mosaic = lay_mosaic({.jitter = 0.9, .solid = 0.2}, seed);
        Random random(seed);
        for (int i = 0; i < 500; ++i) {
            const Vec2 p = snap_to_point_grid({random.uniform(-2, 34), random.uniform(-2, 34)});
            const SectorId expected = mosaic.sector_at(p);
            for (std::size_t s = 0; s < mosaic.map.sectors.size(); ++s)
                ASSERT_EQ(contains(mosaic.map, SectorId(s), p), expected == SectorId(s)) << "seed " << seed;
        }
    }
}

// hard cases C1, C22
TEST(Contains, AgreesWithTheCellsOnEveryCornerAndLine) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Mosaic mosaic = lay_mosaic({.solid = 0.2}, seed);
        for (int x = -2; x <= 34; ++x)
            for (int y = -2; y <= 34; ++y) {
                const Vec2 p{double(x), double(y)};
                for (std::size_t s = 0; s < mosaic.map.sectors.size(); ++s)
                    ASSERT_EQ(contains(mosaic.map, SectorId(s), p), mosaic.sector_at(p) == SectorId(s))
                        << "seed " << seed << " at " << x << "," << y;
            }
    }
}

// hard case C1
TEST(Contains, PutsACornerWhereFourSectorsMeetIntoExactlyOne) {
    const Mosaic mosaic = lay_mosaic({.columns = 12, .rows = 12, .jitter = 0.9, .labels = 30}, 5);
    for (int column = 1; column < 12; ++column)
        for (int row = 1; row < 12; ++row) {
            int count = 0;
            for (std::size_t s = 0; s < mosaic.map.sectors.size(); ++s)
                count += contains(mosaic.map, SectorId(s), mosaic.corner(column, row));
            ASSERT_EQ(count, 1) << column << "," << row;
        }
}

TEST(Locate, FindsNoSectorInRockAndOutside) {
    const Mosaic mosaic = lay_mosaic({.solid = 0.5}, 1);
    for (double x = -1; x < 34; x += 1.5)
        for (double y = -1; y < 34; y += 1.5) EXPECT_EQ(locate(mosaic.map, {x, y}), mosaic.sector_at({x, y}));
}

TEST(LocateNear, FindsEachPlaceFromAnywhereWhereNoSectorsOverlap) {
    const Mosaic mosaic = lay_mosaic({}, 2);
    for (double x = -1; x < 34; x += 2.5)
        for (double y = -1; y < 34; y += 2.5)
            for (std::size_t near = 0; near < mosaic.map.sectors.size(); near += 7)
                EXPECT_EQ(locate_near(mosaic.map, SectorId(near), {x, y}), mosaic.sector_at({x, y}));
}

/// A cellar over which everything lies, a room in it that opens into another one, and one far away behind a link.
TEST(LocateNear, PrefersTheSectorItselfThenItsNeighboursButNotBehindLinks) {
    MapFile file = test::map_of({test::box_room("cellar", 0, 0, 20, 20), test::box_room("room", 2, 2, 6, 6),
                                 test::box_room("next", 6, 2, 10, 6), test::box_room("away", 12, 12, 16, 16)});
    test::join(file, "room", "next", {6, 2}, {6, 6});
    test::link(file, "room", {6, 6}, {2, 6}, "away", {12, 12}, {16, 12});
    const Map map = test::built(file);
    const SectorId cellar(0u), room(1u), next(2u);
    EXPECT_EQ(locate_near(map, room, {4, 4}), room);
    EXPECT_EQ(locate_near(map, cellar, {4, 4}), cellar);
    EXPECT_EQ(locate_near(map, room, {8, 4}), next);
    EXPECT_EQ(locate_near(map, room, {14, 14}), cellar);
    EXPECT_FALSE(locate_near(map, room, {30, 30}));
}

// hard case T4
TEST(Locate, IsExactAtTheEdgeOfTheWorld) {
    const Mosaic mosaic = lay_mosaic({.columns = 2, .rows = 2, .origin = {32760, -32768}, .labels = 9}, 3);
    const double step = kPointGrid;
    const Vec2 middle{32764, -32764};
    EXPECT_EQ(locate(mosaic.map, middle), mosaic.cells[3].sector);
    EXPECT_EQ(locate(mosaic.map, {middle.x - step, middle.y}), mosaic.cells[2].sector);
    EXPECT_EQ(locate(mosaic.map, {middle.x, middle.y - step}), mosaic.cells[1].sector);
}

}  // namespace
}  // namespace enfilade
