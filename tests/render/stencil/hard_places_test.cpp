// Where stencil renderers flash, leak or drown: eyes on portals, portals in portals, chains without end.
#include <gtest/gtest.h>

#include <cmath>

#include "hard_cases/scenes.h"
#include "math/vec.h"
#include "render/column/column_renderer.h"
#include "render/stencil/agreement.h"
#include "space/trace.h"
#include "support/looks.h"
#include "support/map_builder.h"

namespace enfilade::test {
namespace {

constexpr PictureSize kSize{96, 60};

struct Place {
    Map map;
    TextureSet textures;
    Sight sight;
    explicit Place(const MapFile& file) : map(built(file)), textures(textures_for(file)), sight(map, textures) {}
};

/// All around from a point that some sector holds, eighth by eighth.
Agreement all_around(Place& place, Vec2 eye, double height) {
    Agreement sum;
    const SectorId sector = locate(place.map, eye);
    if (!sector) return sum;  // on the outer side of an outer wall, under the tie rule
    for (std::uint32_t eighth = 0; eighth < 8; ++eighth) {
        View view;
        view.sector = sector;
        view.eye = eye;
        view.eye_z = place.map[sector].floor.z + height;
        view.forward = direction(Angle{eighth << 29});
        sum += place.sight.compare(view, kSize);
    }
    return sum;
}

/// Where an eye is, relative to a portal.
struct PlaceByPortal {
    double along;   ///< from a to b, 0..1
    double before;  ///< its line [m]
};

/// At every portal of the scene. There is a place for an eye at some of them.
void expect_agreement_at_portals(const NamedScene& scene, const std::vector<PlaceByPortal>& places) {
    Place place(scene.file());
    Agreement sum;
    for (const Wall& wall : place.map.walls) {
        if (wall.kind == WallKind::solid) continue;
        const Vec2 way = (wall.b - wall.a) * (1 / wall.length);
        for (const auto& [along, before] : places) {
            const Vec2 at = wall.a + (wall.b - wall.a) * along + right_of(way) * before;
            sum += all_around(place, snap_to_point_grid(at), 1.25);
        }
    }
    expect_agreement(sum);
}

class StencilHardPlace : public testing::TestWithParam<NamedScene> {};

// hard cases R4, G3
TEST_P(StencilHardPlace, OnAPortalsLine) { expect_agreement_at_portals(GetParam(), {{0.5, 0}}); }
// hard cases R3, G3, G5
TEST_P(StencilHardPlace, OnAPortalsEnds) { expect_agreement_at_portals(GetParam(), {{0, 0}, {1, 0}}); }
// hard case G2
TEST_P(StencilHardPlace, AHairBeforeAPortalsEnd) { expect_agreement_at_portals(GetParam(), {{1, 0x1p-16}}); }
// hard case G3
TEST_P(StencilHardPlace, OneGridStepBeforeAPortal) { expect_agreement_at_portals(GetParam(), {{0.5, kPointGrid}}); }
// hard cases R5, G2
TEST_P(StencilHardPlace, AHairBeforeAPortal) { expect_agreement_at_portals(GetParam(), {{0.25, 0x1p-16}}); }

/// In scenes with plain doorways: behind a link or a mirror is no room.
class StencilPlaceBehind : public testing::TestWithParam<NamedScene> {};

// hard case G5
TEST_P(StencilPlaceBehind, APortalsEndAHair) { expect_agreement_at_portals(GetParam(), {{1, -0x1p-16}}); }
// hard case G3
TEST_P(StencilPlaceBehind, APortalOneGridStep) { expect_agreement_at_portals(GetParam(), {{0.5, -kPointGrid}}); }
// hard case R5
TEST_P(StencilPlaceBehind, APortalAHair) { expect_agreement_at_portals(GetParam(), {{0.25, -0x1p-16}}); }

INSTANTIATE_TEST_SUITE_P(Linked, StencilHardPlace, testing::ValuesIn(linked_scenes()), name_of_scene);

const auto kWithDoorways =
    testing::Values(NamedScene{"OverlappingRooms", overlapping_rooms}, NamedScene{"CrookedRooms", crooked_rooms},
                    NamedScene{"OpenSteps", open_steps});
INSTANTIATE_TEST_SUITE_P(WithDoorways, StencilHardPlace, kWithDoorways, name_of_scene);
INSTANTIATE_TEST_SUITE_P(WithDoorways, StencilPlaceBehind, kWithDoorways, name_of_scene);

// hard case G6
TEST(StencilVanishingLine, LeavesNoPixelOutBesideIt) {
    // In column 10 alone one sees a wall that vanishes a 30th of a pixel beside the column's middle.
    MapFile file = map_of({room("near",
                                {{16.435546875, 12.18359375},
                                 {16.3203125, 8.12109375},
                                 {19.6572265625, 7.541015625},
                                 {19.2353515625, 11.4375}},
                                0.25, 2),
                           room("far",
                                {{19.9365234375, 19.6181640625},
                                 {12.763671875, 19.8310546875},
                                 {12.2958984375, 15.703125},
                                 {16.556640625, 16.32421875},
                                 {16.435546875, 12.18359375},
                                 {19.2353515625, 11.4375}},
                                0.25, 2)});
    join_all(file);
    Place place(file);
    View view;
    view.sector = SectorId(0u);
    view.eye = {16.3203125, 8.12109375};
    view.eye_z = 0.25;
    view.forward = direction(Angle::from_degrees(124.76430189795792));
    expect_agreement(place.sight.compare(view, {80, 50}));
}

/// A corridor that leads into itself, so that one looks along it for ever.
MapFile corridor(int max_depth) {
    MapFile file = map_of({box_room("hall", 0, 0, 2, 4, 0, 3)});
    cut_pillar(file.sectors[0], 0.5, 3, 1, 3.5);
    link(file, "hall", {2, 0}, {2, 4}, "hall", {0, 4}, {0, 0});
    file.render.max_depth = max_depth;
    return file;
}

// hard case R24
TEST(StencilCorridor, ShowsSixtyFourLevels) {
    Place place(corridor(64));
    const View view = look_from(place.map, {1, 1.25}, 1.5, 1);
    expect_agreement(place.sight.compare(view, {320, 200}));
    EXPECT_EQ(place.sight.counts().deepest, 64);
}

// hard case R23
TEST(StencilCorridor, EndsInTheRecursionColourWhereItIsCut) {
    Place place(corridor(3));
    const StencilPicture picture = place.sight.by_stencil(look_from(place.map, {1, 1.25}, 1.5, 0), {96, 60});
    const std::size_t middle = 30 * 96 + 48;
    EXPECT_EQ(picture.facts.ids[middle], kRecursionEnd);
    EXPECT_EQ(picture.frame.pixels[middle], 0xFFFF00FFu);
}

/// A bar across a clear picture.
Texture bar() {
    Texture texture = make_placeholder();
    texture.has_holes = true;
    for (std::size_t i = 0; i < texture.pixels.size(); ++i)
        texture.pixels[i] = i % texture.height / 8 == 5 ? 0xFF30C0F0u : 0;
    return texture;
}

/// A corridor of 3 cm, across which hangs a bar: so a thousand levels fill much of the picture. The stencil buffer
/// holds 255 of them, and whatever hangs in a level is drawn on the way back from those behind it.
// hard cases G1, G11
TEST(StencilCorridor, ShowsMoreLevelsThanTheStencilBufferHolds) {
    constexpr double kLength = 1.0 / 32;
    MapFile file = map_of({box_room("hall", 0, 0, kLength, 4, 0, 3)});
    link(file, "hall", {kLength, 0}, {kLength, 4}, "hall", {0, 4}, {0, 0});
    wall(file, "hall", {kLength, 0}, {kLength, 4}).middle = spec("bar");
    file.render.max_depth = 1024;
    const Map map = built(file);
    TextureSet textures = textures_for(file);
    textures.textures[textures.find("bar").index] = bar();
    Sight sight(map, textures);
    expect_agreement(sight.compare(look_from(map, {kLength / 2, 2}, 1.5, 0), {320, 200}));
    EXPECT_EQ(sight.counts().deepest, 1024);
}

// hard case G1
TEST(StencilCorridor, EndsBeyondTheLevelsOfTheStencilBufferToo) {
    Place place(corridor(300));
    const View view = look_from(place.map, {1, 1.25}, 1.5, 0);
    expect_agreement(place.sight.compare(view, {640, 400}));
    EXPECT_EQ(place.sight.counts().deepest, 300);
    const StencilPicture picture = place.sight.by_stencil(view, {640, 400});
    EXPECT_GT(std::count(picture.facts.ids.begin(), picture.facts.ids.end(), kRecursionEnd), 0);
}

// hard case G1
TEST(StencilCorridor, ComesBackToAHigherLevelAfterADeepOne) {
    Place place(corridor(600));
    const View view = look_from(place.map, {1, 1.25}, 1.5, 0);
    const auto shallow = [&] { return place.sight.by_stencil(view, {64, 40}).frame.pixels; };
    const auto before = shallow();
    place.sight.by_stencil(view, {1280, 800});
    EXPECT_EQ(shallow(), before);
}

TEST(StencilCorridor, CostsNoMoreOnceLevelsAreBelowAPixel) {
    const auto layers = [](int max_depth) {
        Place place(corridor(max_depth));
        place.sight.by_stencil(look_from(place.map, {1, 1.2345}, 1.5, 20), {64, 40});
        return place.sight.counts().layers;
    };
    EXPECT_EQ(layers(200), layers(1000));
}

/// Two pillars whose faces are doors into each other, and the room goes on behind them: at every level something has
/// been drawn where the next door is to be marked.
// hard cases R23, G7
TEST(StencilDoors, ThatFaceEachOtherBeforeAFarWallRepeatTheRoom) {
    MapFile file = map_of({box_room("hall", 0, 0, 12, 6, 0, 3)});
    cut_pillar(file.sectors[0], 2, 2, 3, 4);
    cut_pillar(file.sectors[0], 6, 2, 7, 4);
    link(file, "hall", {3, 4}, {3, 2}, "hall", {6, 2}, {6, 4});
    Place place(file);
    expect_agreement(place.sight.compare(look_from(place.map, {4.25, 2.75}, 1.5, 0), {320, 200}));
    EXPECT_GT(place.sight.counts().deepest, 20);
}

/// Four links in view, each of them leading to four more.
// hard case R24
TEST(StencilCrossing, IsDrawnOnceForEachViewportAndNotFourToTheSixteenth) {
    MapFile file = map_of({box_room("crossing", 0, 0, 8, 8, 0, 3)});
    link(file, "crossing", {8, 0}, {8, 8}, "crossing", {0, 8}, {0, 0});
    link(file, "crossing", {0, 0}, {8, 0}, "crossing", {8, 8}, {0, 8});
    file.render.max_depth = 16;
    Place place(file);
    const View view = look_from(place.map, {4, 4}, 1.5, 40);
    expect_agreement(place.sight.compare(view, {160, 100}));
    EXPECT_EQ(place.sight.counts().deepest, 16);
    ColumnRenderer column(place.map, place.textures);
    Frame frame;
    frame.resize(160, 100);
    column.render(frame, nullptr, place.sight.snapshot(), view);
    EXPECT_LE(double(place.sight.counts().layers), 1.05 * double(column.counts().viewports));
}

// hard cases R28, G8
TEST(StencilMirrors, FacingEachOtherRepeatTheRoom) {
    MapFile file = map_of({box_room("hall", 0, 0, 4, 6, 0, 3)});
    wall(file, "hall", {4, 0}, {4, 6}).mirror = true;
    wall(file, "hall", {0, 6}, {0, 0}).mirror = true;
    file.render.max_depth = 40;
    Place place(file);
    expect_agreement(place.sight.compare(look_from(place.map, {1.75, 2.5}, 1.5, 5), {320, 200}));
    EXPECT_EQ(place.sight.counts().deepest, 40);
}

/// A row of pixels goes so near the foot of the mirror that the graphics card decides on which side it is. It shows the
/// floor of the room all the same, never what would be beyond.
// hard case G5
TEST(StencilMirrors, EndTheFloorWhereTheyStand) {
    Place place(mirrors());
    View view =
        look_from(place.map, {4.5990477413870394, 0.37422175472602248}, 0.10850765961518795, 155.83646865561604);
    view.fov_degrees = 46.754364385527893;
    expect_agreement(place.sight.compare(view, {640, 400}));
}

}  // namespace
}  // namespace enfilade::test
