// Tilted pictures, true pitch and roll, as the reference shows them: rooms, links, mirrors, and all that stands in
// them; straight up and down; upside down.
#include <gtest/gtest.h>

#include "hard_cases/scenes.h"
#include "math/vec.h"
#include "render/stencil/agreement.h"
#include "support/furnish.h"
#include "support/looks.h"
#include "support/map_builder.h"

namespace enfilade::test {
namespace {

constexpr PictureSize kTiltedSize{96, 60};

Tilt tilt_of(double pitch_degrees, double roll_degrees) {
    return {direction(Angle::from_degrees(pitch_degrees)), direction(Angle::from_degrees(roll_degrees))};
}

View any_tilted_view(const Map& map, Random& random) {
    View view = random_pose(map, random);
    view.pitch_tangent = 0;
    view.tilt = tilt_of(random.uniform(-90, 90), random.uniform(-180, 180));
    return view;
}

Agreement compare_tilted(const MapFile& file, int count, std::uint64_t seed) {
    const Map map = built(file);
    TextureSet textures = textures_for(file);
    for (Texture& texture : textures.textures)
        if (texture.name == "lattice") texture = lattice();
    Sight sight(map, textures);
    Random random(seed);
    Agreement sum;
    for (int i = 0; i < count; ++i) sum += sight.compare(any_tilted_view(map, random), kTiltedSize);
    return sum;
}

class TiltedStencil : public testing::TestWithParam<NamedScene> {};

TEST_P(TiltedStencil, LooksAsInTheReference) { expect_agreement(compare_tilted(GetParam().file(), 12, 1)); }

/// With a fence in every doorway, panels and things.
MapFile furnished(MapFile file) {
    for (SectorRecord& sector : file.sectors)
        for (LoopRecord& loop : sector.loops)
            for (WallRecord& wall : loop.walls)
                if (!wall.next.empty()) wall.middle = spec("lattice");
    scatter_panels(file, 60, 1);
    scatter_things(file, 20, 2);
    return file;
}

TEST_P(TiltedStencil, ShowsThingsPanelsAndFencesAsInTheReference) {
    expect_agreement(compare_tilted(furnished(GetParam().file()), 8, 3));
}

INSTANTIATE_TEST_SUITE_P(Scenes, TiltedStencil,
                         testing::Values(NamedScene{"SteppedRooms", stepped_rooms}, NamedScene{"OpenSteps", open_steps},
                                         NamedScene{"CrookedRooms", crooked_rooms},
                                         NamedScene{"OverlappingRooms", overlapping_rooms},
                                         NamedScene{"LinkedRooms", linked_rooms}, NamedScene{"Mirrors", mirrors}),
                         name_of_scene);

TEST(TiltedView, LooksSteeplyUpAndDownAsInTheReference) {
    const Map map = built(linked_rooms());
    const TextureSet textures = textures_for(linked_rooms());
    Sight sight(map, textures);
    Agreement sum;
    for (const double pitch : {-90.0, -89.0, -75.0, -60.0, 60.0, 75.0, 89.0, 90.0})
        for (const double roll : {0.0, 30.0, 180.0}) {
            View view = look_from(map, {10.3, 12.1}, 1.5, 30);
            view.tilt = tilt_of(pitch, roll);
            sum += sight.compare(view, kTiltedSize);
        }
    expect_agreement(sum);
}

/// In the courtyard with fences, panels and things.
Agreement compare_in_courtyard(Vec2 eye, double eye_z, double yaw_degrees, double fov_degrees, const Tilt& tilt) {
    const MapFile file = furnished(open_steps());
    const Map map = built(file);
    TextureSet textures = textures_for(file);
    textures.textures[textures.find("lattice").index] = lattice();
    Sight sight(map, textures);
    View view = look_from(map, snap_to_point_grid(eye), 0, yaw_degrees);
    view.eye_z = eye_z;
    view.fov_degrees = fov_degrees;
    view.tilt = tilt;
    return sight.compare(view, kTiltedSize);
}

/// The part of the thing that is in the room behind ends in the doorway, where a panel begins: the panel is before it.
TEST(TiltedView, ShowsThePanelOfADoorwayThatAThingStandsIn) {
    expect_agreement(compare_in_courtyard({5.5915323111694306, 4.2423060711007565}, 1.8613430701684204,
                                          196.91762038506567, 73.792947225955274,
                                          tilt_of(41.586541431024671, 134.03163428418338)));
}

/// A thing ends by a corner of a building, a hair to the wrong side of one of its walls, between it and the next.
TEST(TiltedView, ShowsTheWallsOfACornerThatAThingEndsBy) {
    expect_agreement(compare_in_courtyard({2.720480349380523, 4.3697384933475405}, 3.8427779968631577,
                                          325.52340533584356, 74.655955282866969,
                                          tilt_of(21.876024138182402, 110.81885467283428)));
    expect_agreement(compare_in_courtyard({0.96230322425253689, 7.8042150770779699}, 5.3697738238341319,
                                          331.11586687155068, 91.7857939547238,
                                          tilt_of(-63.36116717197001, 3.9586231671273708)));
}

/// The picture of an eye that does not tilt its head is the one whose horizon is not shifted.
TEST(TiltedView, IsTheUprightOneWhereItIsTiltedByNothing) {
    const Map map = built(linked_rooms());
    const TextureSet textures = textures_for(linked_rooms());
    Sight sight(map, textures);
    View view = look_from(map, {10.3, 12.1}, 1.5, 30);
    const StencilPicture upright = sight.by_stencil(view, kTiltedSize);
    view.tilt = Tilt{};
    const StencilPicture tilted = sight.by_stencil(view, kTiltedSize);
    std::size_t differ = 0;
    for (std::size_t i = 0; i < upright.facts.ids.size(); ++i) differ += upright.facts.ids[i] != tilted.facts.ids[i];
    EXPECT_LE(differ, upright.facts.ids.size() / 1000);
}

}  // namespace
}  // namespace enfilade::test
