// Panels drawn by the column renderer, against the reference: free, along walls, across each other's ends, before and
// behind things, through doorways, links and mirrors, with the eye in their plane and on their ends.
#include <gtest/gtest.h>

#include "math/vec.h"
#include "render/column/agreement.h"
#include "render/column/column_renderer.h"
#include "space/trace.h"
#include "support/furnish.h"

namespace enfilade {
namespace {

using namespace test;

TexturedMap world_of(const MapFile& file) {
    TexturedMap world(file);
    world.textures.textures[world.textures.find("lattice").index] = lattice();
    return world;
}

/// The palace with panels and things in its rooms and pictures in all its doorways.
MapFile furnished_palace(int things) {
    MapFile file = palace();
    scatter_panels(file, 150, 1);
    scatter_things(file, things, 2);
    int count = 0;
    for (SectorRecord& s : file.sectors)
        for (WallRecord& w : s.loops[0].walls)
            if (!w.next.empty()) {
                w.middle = spec("lattice");
                w.middle->offset_tx = {5.3 * count, 7.1 * (count++ % 9) - 20};
            }
    return file;
}

MapFile linked_rooms() {
    MapFile file = map_of({box_room("a", 0, 0, 5, 5, 0, 3), box_room("b", 20, 0, 26, 5, 1, 4),
                           room("c", {{40, 0}, {44, 3}, {41, 7}, {37, 4}}, -1, 2)});
    link(file, "a", {5, 0}, {5, 5}, "c", {44, 3}, {41, 7});
    link(file, "a", {0, 5}, {0, 0}, "b", {26, 0}, {26, 5});
    wall(file, "a", {0, 0}, {5, 0}).mirror = true;
    wall(file, "b", {26, 5}, {20, 5}).mirror = true;
    file.render.max_depth = 4;
    return file;
}

/// One room with a pillar and a handful of panels: joined at ends, along walls and on each other.
MapFile panelled_hall() {
    MapFile file = map_of({box_room("hall", 0, 0, 8, 8, 0, 3)});
    cut_pillar(sector(file, "hall"), 3, 3, 4, 5);
    sector(file, "hall").panels = {panel({1, 1}, {6, 2}), panel({6, 2}, {6, 6}),       panel({1, 1}, {1, 6}, 0, 3),
                                   panel({4, 4}, {6, 4}), panel({0, 2}, {0, 6}),       panel({3, 5}, {3, 8}),
                                   panel({1, 2}, {1, 4}), panel({5, 7}, {8, 8}, -1, 4)};
    // Two pictures on one line, one for each side.
    PanelRecord front = panel({7, 1}, {7, 5}), back = panel({7, 5}, {7, 1});
    front.one_sided = back.one_sided = true;
    back.texture = spec("cloth");
    for (const PanelRecord& one : {front, back}) sector(file, "hall").panels.push_back(one);
    return file;
}

TEST(PanelColumns, AgreeWithTheReferenceInAPalace) {
    MapFile file = palace();
    scatter_panels(file, 150, 1);
    expect_agreement(world_of(file), 21, 100);
}

TEST(PanelColumns, AgreeWithTheReferenceAmongThingsAndFences) {
    expect_agreement(world_of(furnished_palace(50)), 22, 100);
}

TEST(PanelColumns, AgreeWithTheReferenceThroughLinksAndInMirrors) {
    MapFile file = linked_rooms();
    scatter_panels(file, 60, 3);
    scatter_things(file, 12, 4);
    expect_agreement(world_of(file), 23, 100);
}

// A ray that leaves the room and comes back must not meet the panels of the first arm again: glass would be darker.
// hard case R24
TEST(PanelColumns, AgreeWithTheReferenceInARoomThatSeesItself) {
    MapFile file = map_of({room("horseshoe", {{0, 0}, {9, 0}, {9, 6}, {6, 6}, {6, 3}, {3, 3}, {3, 6}, {0, 6}}),
                           box_room("between", 3, 3, 6, 6, 0.25, 1.75)});
    join_all(file);
    scatter_panels(file, 80, 5);
    expect_agreement(world_of(file), 25, 100);
}

TEST(PanelColumns, AgreeWithTheReferenceInClassicLight) {
    MapFile file = furnished_palace(20);
    file.render.light = LightModel::classic;
    expect_agreement(world_of(file), 24, 40);
}

/// Draws the view and fails where the renderers differ.
void expect_same(const TexturedMap& world, const View& view) {
    ColumnComparison sum;
    Comparer(world).compare(view, 97, 61, sum);
    EXPECT_EQ(sum.not_once, 0u);
    EXPECT_EQ(sum.wrong_ids, 0u);
    EXPECT_EQ(sum.wrong_colors, 0u);
}

View view_from(const Map& map, Vec2 eye, double yaw_degrees, double eye_z) {
    View view;
    view.eye = snap_to_point_grid(eye);
    view.sector = locate(map, view.eye);
    view.eye_z = eye_z;
    view.forward = direction(Angle::from_degrees(yaw_degrees));
    return view;
}

// hard case R27
TEST(PanelColumns, AgreeWhereTheEyeIsInAPanelsPlane) {
    const TexturedMap world = world_of(panelled_hall());
    for (const Panel& panel : world.map.panels)
        for (const double along : {-0.25, 0.25, 0.5, 1.25})
            for (double yaw = 0; yaw < 360; yaw += 22.5) {
                const Vec2 eye = snap_to_point_grid(panel.a + (panel.b - panel.a) * along);
                if (!locate(world.map, eye)) continue;
                SCOPED_TRACE(testing::Message() << eye.x << ", " << eye.y << " yaw " << yaw);
                expect_same(world, view_from(world.map, eye, yaw, 1));
            }
}

TEST(PanelColumns, AgreeWhereTheEyeIsOnAPanelsEnd) {
    const TexturedMap world = world_of(panelled_hall());
    for (const Panel& panel : world.map.panels)
        for (const Vec2 end : {panel.a, panel.b})
            for (double yaw = 0; yaw < 360; yaw += 22.5) {
                if (!locate(world.map, end)) continue;
                SCOPED_TRACE(testing::Message() << end.x << ", " << end.y << " yaw " << yaw);
                expect_same(world, view_from(world.map, end, yaw, 0.9));
            }
}

/// What the pixel shows.
PixelSurface seen_at(const TexturedMap& world, const View& view, int x, int y) {
    Frame frame;
    FrameFacts facts;
    frame.resize(64, 64);
    reset(facts, 64, 64);
    ColumnRenderer(world.map, world.textures).render(frame, &facts, world.snapshot, view);
    return facts.ids[static_cast<std::size_t>(y * 64 + x)];
}

/// A room with an opaque panel across its middle, and a thing.
MapFile room_with(PanelRecord record, Vec2 thing_place) {
    MapFile file = map_of({box_room("room", 0, 0, 8, 8, 0, 4)});
    record.texture = spec("cloth");
    file.sectors[0].panels = {record};
    ThingRecord thing;
    thing.position = thing_place;
    thing.frames = {{"figure", 0, Vec2{32, 64}}};
    file.things = {thing};
    return file;
}

TEST(PanelColumns, ShowAOneSidedPanelFromOneSideOnly) {
    PanelRecord record = panel({4, 1}, {4, 7});
    record.one_sided = true;
    const TexturedMap world(room_with(record, {1, 7}));
    const PixelSurface id = panel_id(world.map, PanelId(0u));
    EXPECT_EQ(seen_at(world, view_from(world.map, {1, 4}, 0, 1), 32, 32), id);
    EXPECT_NE(seen_at(world, view_from(world.map, {7, 4}, 180, 1), 32, 32), id);
}

TEST(PanelColumns, ShowAPanelFromBothSides) {
    const TexturedMap world(room_with(panel({4, 1}, {4, 7}), {1, 7}));
    const PixelSurface id = panel_id(world.map, PanelId(0u));
    EXPECT_EQ(seen_at(world, view_from(world.map, {1, 4}, 0, 1), 32, 32), id);
    EXPECT_EQ(seen_at(world, view_from(world.map, {7, 4}, 180, 1), 32, 32), id);
}

TEST(PanelColumns, ShowWhatIsAboveAndBelowAPanel) {
    const TexturedMap world(room_with(panel({4, 1}, {4, 7}, 0.5, 1.5), {1, 7}));
    const View view = view_from(world.map, {2, 4}, 0, 1);  // 32 px focal length, 2 m away: 8 rows up and down
    const PixelSurface id = panel_id(world.map, PanelId(0u));
    EXPECT_NE(seen_at(world, view, 32, 23), id);
    EXPECT_EQ(seen_at(world, view, 32, 24), id);
    EXPECT_EQ(seen_at(world, view, 32, 39), id);
    EXPECT_NE(seen_at(world, view, 32, 40), id);
}

// The thing's picture is parallel to the picture plane, the panel slants through it.
TEST(PanelColumns, ShowAPanelBeforeAThingInOneColumnAndBehindItInAnother) {
    const TexturedMap world(room_with(panel({3, 1}, {5, 7}), {4, 4}));
    const View view = view_from(world.map, {1, 4}, 0, 1);
    EXPECT_EQ(seen_at(world, view, 28, 32), panel_id(world.map, PanelId(0u)));
    EXPECT_EQ(seen_at(world, view, 36, 32), thing_id(world.map, ThingId(0u)));
}

TEST(PanelColumns, ShowAThingThatStandsInAPanelsPlaneBeforeIt) {
    const TexturedMap world(room_with(panel({4, 1}, {4, 7}), {4, 4}));
    EXPECT_EQ(seen_at(world, view_from(world.map, {1, 4}, 0, 1), 32, 32), thing_id(world.map, ThingId(0u)));
    EXPECT_EQ(seen_at(world, view_from(world.map, {7, 4}, 180, 1), 32, 32), thing_id(world.map, ThingId(0u)));
}

// hard case I8
TEST(PanelColumns, DrawStripsThatEqualTheWholePicture) {
    expect_strips_equal_the_whole(world_of(furnished_palace(30)), 5, 20);
}

TEST(PanelColumns, AllocateNothingOnceTheViewHasBeenDrawn) {
    expect_no_allocations(world_of(furnished_palace(30)), 7, 20);
}

}  // namespace
}  // namespace enfilade
