// What a disc does not touch because a link or the exit of a one-way portal stands before it, and what it does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "space/reach.h"
#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const SectorId kYard(0u);

/// A yard with a slab whose east face, from (4, 7) to (4, 5), is a portal to a hall or the exit of one, and the
/// yard's west wall close behind the slab.
MapFile yard_with_slab() {
    SectorRecord yard = box_room("yard", 3.75, 0, 12, 12);
    cut_pillar(yard, 3.875, 5, 4, 7);
    return map_of({std::move(yard), room("hall", {{80, 0}, {90, 0}, {90, 5}, {90, 7}, {90, 12}, {80, 12}})});
}

MapFile yard_with_link() {
    MapFile file = yard_with_slab();
    link(file, "yard", {4, 7}, {4, 5}, "hall", {90, 5}, {90, 7});
    return file;
}

MapFile yard_with_exit() {
    MapFile file = yard_with_link();
    WallRecord& exit = wall(file, "yard", {4, 7}, {4, 5});
    exit.next.clear();
    exit.via.clear();
    return file;
}

bool touches(const Map& map, const Reach& found, Vec2 a, Vec2 b) {
    return std::any_of(found.walls.begin(), found.walls.end(),
                       [&](const ReachedWall& w) { return map[w.wall].a == a && map[w.wall].b == b; });
}

bool touches_west_wall(const Map& map, Vec2 p, double radius) {
    return touches(map, reach(map, {kYard, p}, radius), {3.75, 12}, {3.75, 0});
}

TEST(ReachPastScreens, FindsNothingBehindALink) {
    const Map map = built(yard_with_link());
    EXPECT_THAT(reach(map, {kYard, {4.125, 6}}, 0.75).walls, IsEmpty());
}

TEST(ReachPastScreens, FindsNothingBehindTheExitOfAOneWayPortalButTheExit) {
    const Map map = built(yard_with_exit());
    const Reach found = reach(map, {kYard, {4.125, 6}}, 0.75);
    ASSERT_THAT(found.walls, SizeIs(1));
    EXPECT_TRUE(map[found.walls[0].wall].one_way_exit);
}

TEST(ReachPastScreens, FindsWhatIsSeenPastTheirEnds) {
    for (const MapFile& file : {yard_with_link(), yard_with_exit()}) {
        const Map map = built(file);
        EXPECT_FALSE(touches_west_wall(map, {4.125, 6}, 2.5)) << "the look past the end at (4, 5) is 3.02 m long";
        EXPECT_TRUE(touches_west_wall(map, {4.125, 6}, 3.5));
        EXPECT_TRUE(touches_west_wall(map, {4.125, 4.5}, 0.5)) << "beside the slab";
    }
}

TEST(ReachPastScreens, FindsWhatStandsBeforeThem) {
    for (MapFile file : {yard_with_link(), yard_with_exit()}) {
        cut_pillar(file.sectors[0], 4.25, 5.75, 4.5, 6.25);
        const Map map = built(file);
        EXPECT_TRUE(touches(map, reach(map, {kYard, {4.75, 6}}, 1), {4.5, 6.25}, {4.5, 5.75}));
    }
}

TEST(ReachPastScreens, FindsAPanelBeforeThemAndNoneBehind) {
    for (MapFile file : {yard_with_link(), yard_with_exit()}) {
        for (const double x : {3.8125, 4.25}) {
            PanelRecord fence;
            fence.a = {x, 5.5};
            fence.b = {x, 6.5};
            fence.top = 1;
            fence.texture = spec("fence");
            fence.blocks = true;
            file.sectors[0].panels.push_back(fence);
        }
        const Map map = built(file);
        const Reach found = reach(map, {kYard, {4.5, 6}}, 0.75);
        const auto panels =
            std::count_if(found.walls.begin(), found.walls.end(), [](const ReachedWall& w) { return bool(w.panel); });
        EXPECT_EQ(panels, 1);
    }
}

TEST(ReachPastScreens, FindsTheJambsOfAnExit) {
    const Map map = built(yard_with_exit());
    const Reach found = reach(map, {kYard, {4.125, 5.25}}, 0.75);
    const auto jamb = std::find_if(found.walls.begin(), found.walls.end(), [&](const ReachedWall& w) {
        return !map[w.wall].one_way_exit && w.stretch.a == Vec2{4, 5} && w.stretch.b == Vec2{4, 5};
    });
    EXPECT_NE(jamb, found.walls.end()) << "the slab's north face shows its end only";
}

}  // namespace
}  // namespace enfilade
