// Free-standing panels as the column renderer draws them: among things and fences, across each other's ends, through
// doorways, links and mirrors, with the eye in their plane.
#include <gtest/gtest.h>

#include "hard_cases/scenes.h"
#include "math/vec.h"
#include "render/stencil/agreement.h"
#include "space/trace.h"
#include "support/furnish.h"
#include "support/looks.h"
#include "support/map_builder.h"

namespace enfilade::test {
namespace {

/// What is behind glass has edges of texels, too, which are not noted for pixels that show the glass.
constexpr double kBehindGlass = 2e-5;

struct Furnished {
    Map map;
    TextureSet textures;
    explicit Furnished(const MapFile& file) : map(built(file)), textures(textures_for(file)) {
        for (Texture& texture : textures.textures)
            if (texture.name == "lattice") texture = lattice();
    }
};

class StencilPanels : public testing::TestWithParam<NamedScene> {};

TEST_P(StencilPanels, LookAsInTheColumnRenderer) {
    MapFile file = GetParam().file();
    scatter_panels(file, 80, 1);
    const Furnished world(file);
    expect_agreement(Sight(world.map, world.textures).compare_poses(8, {160, 100}, 3), kBehindGlass);
}

TEST_P(StencilPanels, LookAsInTheColumnRendererAmongThingsAndFences) {
    MapFile file = GetParam().file();
    for (SectorRecord& sector : file.sectors)
        for (LoopRecord& loop : sector.loops)
            for (WallRecord& wall : loop.walls)
                if (!wall.next.empty()) wall.middle = spec("lattice");
    scatter_panels(file, 80, 1);
    scatter_things(file, 20, 2);
    const Furnished world(file);
    expect_agreement(Sight(world.map, world.textures).compare_poses(6, {160, 100}, 4), kBehindGlass);
}

INSTANTIATE_TEST_SUITE_P(Scenes, StencilPanels,
                         testing::Values(NamedScene{"SteppedRooms", stepped_rooms},
                                         NamedScene{"CrookedRooms", crooked_rooms},
                                         NamedScene{"OverlappingRooms", overlapping_rooms},
                                         NamedScene{"LinkedRooms", linked_rooms}, NamedScene{"Mirrors", mirrors}),
                         name_of_scene);

/// One room with a pillar and panels: joined at ends, along walls and on each other.
MapFile panelled_hall() {
    MapFile file = map_of({box_room("hall", 0, 0, 8, 8, 0, 3)});
    cut_pillar(sector(file, "hall"), 3, 3, 4, 5);
    sector(file, "hall").panels = {panel({1, 1}, {6, 2}), panel({6, 2}, {6, 6}),       panel({1, 1}, {1, 6}, 0, 3),
                                   panel({4, 4}, {6, 4}), panel({0, 2}, {0, 6}),       panel({3, 5}, {3, 8}),
                                   panel({1, 2}, {1, 4}), panel({5, 7}, {8, 8}, -1, 4)};
    return file;
}

// hard case R27
TEST(StencilPanel, LooksAsInTheColumnRendererToAnEyeInItsPlane) {
    const Furnished world(panelled_hall());
    Sight sight(world.map, world.textures);
    Agreement sum;
    for (const Panel& panel : world.map.panels)
        for (const double along : {0.0, 0.25, 1.0, 1.25})
            for (double yaw = 0; yaw < 360; yaw += 45) {
                const Vec2 eye = snap_to_point_grid(panel.a + (panel.b - panel.a) * along);
                if (locate(world.map, eye)) sum += sight.compare(look_from(world.map, eye, 1, yaw), {97, 61});
            }
    expect_agreement(sum, kBehindGlass);
}

/// A platform before a lower hall whose side arm reaches back beside it. One line holds the doorway between them, a
/// wall of the hall, and the mouth of the arm; and a panel of the hall runs along all three.
MapFile hall_below_platform() {
    MapFile file = map_of({box_room("platform", 0, 0, 4, 4, 1, 3),
                           room("hall", {{4, 0}, {10, 0}, {10, 8}, {0, 8}, {0, 5}, {4, 5}}, 0, 4)});
    split_and_join(file);
    sector(file, "hall").panels = {panel({4, 1}, {4, 7}, 0, 1.5)};
    return file;
}

constexpr Vec2 kAroundTheLine[] = {{2, 2}, {3.875, 1.5}, {4, 2}, {4.25, 4.5}, {6, 1}, {2, 6.5}, {4, 7.5}};

// hard case G11
TEST(StencilPanel, InADoorwayIsHiddenByTheFloorBeforeIt) {
    const Furnished world(hall_below_platform());
    Sight sight(world.map, world.textures);
    Agreement sum;
    for (const Vec2 eye : kAroundTheLine)
        for (double yaw = 0; yaw < 360; yaw += 30) sum += sight.compare(look_from(world.map, eye, 2.25, yaw), {97, 61});
    expect_agreement(sum, kBehindGlass);
}

TEST(StencilPanel, InADoorwayIsHiddenByTheFloorBeforeItInTiltedPicturesToo) {
    const Furnished world(hall_below_platform());
    Sight sight(world.map, world.textures);
    Agreement sum;
    for (const Vec2 eye : kAroundTheLine)
        for (double yaw = 0; yaw < 360; yaw += 60) {
            View view = look_from(world.map, eye, 2.25, yaw + 0.5);
            view.tilt = Tilt{direction(Angle::from_degrees(-40)), direction(Angle::from_degrees(10))};
            sum += sight.compare(view, {97, 61});
        }
    expect_agreement(sum, kBehindGlass);
}

/// The thing's picture is parallel to the picture plane, the panel slants through it.
TEST(StencilPanel, IsBeforeAThingInOneColumnAndBehindItInAnother) {
    MapFile file = map_of({box_room("room", 0, 0, 8, 8, 0, 4)});
    PanelRecord slanting = panel({3, 1}, {5, 7});
    slanting.texture = spec("cloth");
    file.sectors[0].panels = {slanting};
    ThingRecord thing;
    thing.position = {4, 4};
    thing.frames = {{"figure", 0, Vec2{32, 64}}};
    file.things = {thing};
    const Furnished world(file);
    Sight sight(world.map, world.textures);
    const StencilPicture picture = sight.by_stencil(look_from(world.map, {1, 4}, 1, 0), {64, 64});
    EXPECT_EQ(picture.facts.ids[32 * 64 + 28], panel_id(world.map, PanelId(0u)));
    EXPECT_EQ(picture.facts.ids[32 * 64 + 36], thing_id(world.map, ThingId(0u)));
}

}  // namespace
}  // namespace enfilade::test
