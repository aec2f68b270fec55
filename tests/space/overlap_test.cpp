// Which rooms are bigger inside.
#include "space/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "space/mosaic.h"
#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;

TEST(OverlappingSectors, AreNoneWhereRoomsOnlyTouch) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const std::vector<char> overlaps = overlapping_sectors(lay_mosaic({.jitter = 0.9}, seed).map);
        EXPECT_EQ(std::count(overlaps.begin(), overlaps.end(), 1), 0) << "seed " << seed;
    }
}

/// A yard with doors into a house and into a hall that lies over the house.
MapFile bigger_inside() {
    MapFile file = map_of({box_room("house", 0, 0, 4, 4), box_room("hall", 1, 0, 9, 4), box_room("yard", -4, -4, 9, 0),
                           box_room("shed", 20, 0, 24, 4)});
    split(file);
    join(file, "yard", "house", {1, 0}, {0, 0});
    join(file, "yard", "hall", {9, 0}, {4, 0});
    return file;
}

TEST(OverlappingSectors, AreThoseThatDoorsJoin) {
    EXPECT_EQ(overlapping_sectors(built(bigger_inside())), (std::vector<char>{1, 1, 0, 0}));
}

TEST(OverlappingSectors, AreNotThoseThatNothingJoins) {
    const MapFile file = map_of({box_room("house", 0, 0, 4, 4), box_room("hall", 1, 0, 9, 4)});
    EXPECT_EQ(overlapping_sectors(built(file)), (std::vector<char>{0, 0}));
}

TEST(OverlappingSectors, AreNotThoseThatLinksJoin) {
    MapFile file = map_of({box_room("house", 0, 0, 4, 4), box_room("hall", 1, 0, 5, 4)});
    link(file, "house", {4, 0}, {4, 4}, "hall", {1, 4}, {1, 0});
    EXPECT_EQ(overlapping_sectors(built(file)), (std::vector<char>{0, 0}));
}

TEST(OverlappingSectors, AreBothOfTwoRoomsOfTheSameShape) {
    MapFile file = map_of({box_room("below", 0, 0, 4, 4), box_room("above", 0, 0, 4, 4), box_room("yard", -4, -4, 4, 0),
                           box_room("lane", -4, -8, 4, -4)});
    split(file);
    join(file, "yard", "below", {4, 0}, {0, 0});
    file.sectors[1].loops[0].walls[0].next = "yard";
    const Map map = built(file);
    const std::vector<char> overlaps = overlapping_sectors(map);
    EXPECT_EQ(overlaps[0] + overlaps[1], 2);
}

}  // namespace
}  // namespace enfilade
