// Panels: which may stand where, and what becomes of them in the map.
#include <gmock/gmock.h>

#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;

PanelRecord panel(Vec2 a, Vec2 b) {
    PanelRecord record;
    record.a = a;
    record.b = b;
    record.top = 1;
    record.texture = spec("brick");
    return record;
}

/// A hall of 8 x 8 m with a pillar like a diamond, (3, 4) to (5, 4).
MapFile hall_with(std::vector<PanelRecord> panels) {
    MapFile file = map_of({box_room("hall", 0, 0, 8, 8)});
    file.sectors[0].loops.push_back(loop_of({{3, 4}, {4, 5}, {5, 4}, {4, 3}}));
    file.sectors[0].panels = std::move(panels);
    place_player(file, "hall", {1, 1});
    return file;
}

std::string complaints(std::vector<PanelRecord> panels) { return text_of(findings_of(hall_with(std::move(panels)))); }

TEST(Panels, StandAnywhereInsideWithoutAWord) { EXPECT_EQ(complaints({panel({1, 1}, {7, 2})}), ""); }

TEST(Panels, MayTouchWallsAndCornersWithTheirEnds) {
    EXPECT_EQ(complaints({panel({0, 2}, {8, 1}), panel({0, 8}, {3, 4}), panel({8, 8}, {4.5, 4.5})}), "");
}

TEST(Panels, MayPassACorner) { EXPECT_EQ(complaints({panel({0, 3}, {8, 3}), panel({5, 3.5}, {5, 8})}), ""); }

TEST(Panels, MayLieAlongAWall) { EXPECT_EQ(complaints({panel({2, 0}, {6, 0}), panel({3, 4}, {4, 3})}), ""); }

TEST(Panels, MayTouchAndCoverEachOther) {
    EXPECT_EQ(complaints({panel({1, 1}, {7, 1}), panel({2, 1}, {5, 1}), panel({4, 1}, {4, 2}), panel({4, 2}, {6, 2})}),
              "");
}

TEST(Panels, DoNotLeaveTheSectorAtItsVertices) {
    EXPECT_THAT(complaints({panel({0, 4}, {8, 4})}), testing::HasSubstr("is not inside sector 'hall'"));
}

TEST(Panels, DoNotLeaveTheSectorByOneStepOfTheGrid) {
    EXPECT_EQ(complaints({panel({1, 1}, {8, 2})}), "");
    EXPECT_THAT(complaints({panel({1, 1}, {8 + 0x1p-10, 2})}), testing::HasSubstr("crosses the edge (8, 0)-(8, 8)"));
}

TEST(Panels, AreInTheMapBySector) {
    MapFile file = map_of({box_room("a", 0, 0, 4, 4), box_room("b", 8, 0, 12, 4), box_room("c", 16, 0, 20, 4)});
    file.sectors[0].panels = {panel({1, 1}, {2, 1})};
    file.sectors[2].panels = {panel({17, 1}, {18, 1}), panel({17, 2}, {18, 2})};
    const Map map = built(file);
    ASSERT_EQ(map.panels.size(), 3u);
    EXPECT_EQ(map.sectors[1].panel_count, 0u);
    EXPECT_EQ(map.sectors[2].first_panel, 1u);
    EXPECT_EQ(map.sectors[2].panel_count, 2u);
    EXPECT_EQ(map.panels[2].sector, SectorId(2u));
}

TEST(Panels, LieOnTheVertexGrid) {
    const Map map = built(hall_with({panel({1.0001, 1}, {4.0001, 4.9999 - 4})}));
    EXPECT_EQ(map.panels[0].a, (Vec2{1, 1}));
    EXPECT_EQ(map.panels[0].b, (Vec2{4, 1}));
    EXPECT_EQ(map.panels[0].length, 3);
}

TEST(Panels, AreLitLikeAWallOfTheirDirection) {
    const Map map = built(hall_with({panel({1, 1}, {2, 1}), panel({1, 2}, {1, 3})}));
    EXPECT_EQ(map.panels[0].contrast, map.walls[0].contrast);
    EXPECT_EQ(map.panels[1].contrast, map.walls[1].contrast);
}

TEST(Panels, TakeTheirTileFromTheTexelsPerMetre) {
    PanelRecord record = panel({1, 1}, {2, 1});
    record.size = 32;
    EXPECT_EQ(built(hall_with({record})).panels[0].surface.tile_m, (Vec2{2, 2}));
}

TEST(Panels, WithoutAPictureAreKeptSilently) {
    PanelRecord record = panel({1, 1}, {2, 1});
    record.texture = spec("-");
    EXPECT_EQ(complaints({record}), "");
    EXPECT_FALSE(built(hall_with({record})).panels[0].surface.texture);
}

TEST(Panels, AreCountedWhereTheyAreMoreThanToBeLookedAt) {
    PanelRecord fence = panel({1, 1}, {2, 1}), line = panel({1, 2}, {2, 2});
    fence.blocks = true;
    line.triggers.emplace_back();
    const Map map = built(hall_with({panel({6, 6}, {7, 6}), fence, line}));
    EXPECT_EQ(map.sectors[0].active_panels, 2u);
    EXPECT_FALSE(map.panels[0].is_active());
    EXPECT_TRUE(map.panels[1].is_active() && map.panels[1].blocks);
    EXPECT_TRUE(map.panels[2].is_active() && !map.panels[2].blocks);
}

TEST(Panels, HaveTriggersAboutTheSectorTheyStandIn) {
    PanelRecord line = panel({1, 2}, {2, 2});
    line.triggers.emplace_back();
    const Map map = built(hall_with({panel({6, 6}, {7, 6}), line}));
    ASSERT_EQ(map.panels[1].triggers.count, 1u);
    EXPECT_THAT(map.targets_of(map.triggers[map.panels[1].triggers.first]), testing::ElementsAre(SectorId(0u)));
}

TEST(Panels, ThatBlockCannotBePassed) {
    PanelRecord fence = panel({1, 1}, {2, 1});
    fence.blocks = true;
    fence.triggers.emplace_back();
    EXPECT_EQ(complaints({fence}), "");
    fence.triggers[0].on = Activation::cross;
    EXPECT_THAT(complaints({fence}), testing::HasSubstr("a panel that blocks cannot have a trigger on 'cross'"));
}

TEST(Panels, HaveTriggersWhosePicturesAreLoaded) {
    PanelRecord line = panel({1, 2}, {2, 2});
    line.triggers.emplace_back().texture = "lava";
    const MapFile file = hall_with({line});
    EXPECT_TRUE(textures_for(file).find("lava"));
}

// 20 000 panels would be compared 400 000 000 times.
TEST(Panels, AreRefusedWhereTheyAreTooManyToCompare) {
    std::vector<PanelRecord> many(20'000, panel({1, 1}, {2, 1}));
    EXPECT_THAT(complaints(std::move(many)), testing::HasSubstr("too many"));
}

}  // namespace
}  // namespace enfilade
