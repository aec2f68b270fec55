// The stencil renderer at the ends of its ranges: lenses, sizes, horizons, far places, odd pictures, ties on pixels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hard_cases/scenes.h"
#include "math/vec.h"
#include "render/stencil/agreement.h"
#include "space/trace.h"
#include "support/looks.h"
#include "support/map_builder.h"

namespace enfilade::test {
namespace {

/// A map, its pictures and both renderers.
struct Stage {
    Map map;
    TextureSet textures;
    Sight sight;
    explicit Stage(const MapFile& file) : map(built(file)), textures(textures_for(file)), sight(map, textures) {}
};

/// In small pictures most pixels are at edges: only what is away from them tells.
void expect_no_fault(const Agreement& agreement) {
    EXPECT_GT(agreement.pixels, 0u);
    EXPECT_EQ(agreement.undrawn + agreement.elsewhere + agreement.wrong_color, 0u) << describe(agreement);
}

/// A hall of 30 km, 5 m wide, slanted.
MapFile long_hall() {
    return map_of({room("hall", {{-12000, -9000}, {-11997, -9004}, {12003, 8996}, {12000, 9000}}, 0, 3)});
}

/// Floats that count from a wall's end lose the texels before the eye.
// hard case R16
TEST(StencilLongWalls, ShowTheirTexelsWhereverOneStandsBesideThem) {
    Stage stage(long_hall());
    Random random(16);
    Agreement sum;
    for (int i = 0; i < 40; ++i) {
        const double along = random.uniform(0.001, 0.999), across = std::pow(10, random.uniform(-4, -0.05));
        const Vec2 eye{-12000 + 24000 * along + 3 * across, -9000 + 18000 * along - 4 * across};
        View view = look_from(stage.map, snap_to_point_grid(eye), 1.5, random.uniform(0, 360));
        if (i % 4 == 3) view.tilt = Tilt{};
        sum += stage.sight.compare(view, {160, 100});
    }
    expect_no_fault(sum);
}

struct Lens {
    double fov_degrees;
    PictureSize size;
};

class StencilLens : public testing::TestWithParam<Lens> {};

// hard case R12
TEST_P(StencilLens, ShowsWhatTheColumnRendererShows) {
    Stage stage(stepped_rooms());
    Random random(12);
    Agreement sum;
    for (int i = 0; i < 6; ++i) {
        View view = i % 2 ? random_pose(stage.map, random) : lattice_pose(stage.map, GetParam().size, random);
        view.fov_degrees = GetParam().fov_degrees;
        sum += stage.sight.compare(view, GetParam().size);
    }
    expect_no_fault(sum);
}

INSTANTIATE_TEST_SUITE_P(Lenses, StencilLens,
                         testing::Values(Lens{1, {160, 100}}, Lens{179, {160, 100}}, Lens{1, {1, 1}}, Lens{179, {1, 1}},
                                         Lens{90, {1, 100}}, Lens{90, {2, 100}}, Lens{90, {320, 1}},
                                         Lens{90, {2048, 4}}));

// Rows are read from the graphics card at widths that are no multiple of four bytes or pixels.
// hard case G12
TEST(StencilSizes, OfAnyWidthAreReadBackWhole) {
    Stage stage(linked_rooms());
    Random random(13);
    Agreement sum;
    for (int width = 1; width <= 19; ++width)
        for (const int height : {1, 2, 7}) sum += stage.sight.compare(random_pose(stage.map, random), {width, height});
    expect_no_fault(sum);
}

class StencilHorizon : public testing::TestWithParam<int> {};  // the height of the picture

// hard cases R13, R15
TEST_P(StencilHorizon, MayBeOnARowAndTenPicturesAboveOrBelow) {
    Stage stage(stepped_rooms());
    Random random(15);
    Agreement sum;
    for (int i = 0; i < 20; ++i) {
        View view = random_pose(stage.map, random);
        const Projection level(view, 64, GetParam());
        view.pitch_tangent = (i % 3 - 1) * 10 * GetParam() / level.focal_y();
        sum += stage.sight.compare(view, {64, GetParam()});
    }
    expect_no_fault(sum);
}

INSTANTIATE_TEST_SUITE_P(EvenAndOdd, StencilHorizon, testing::Values(80, 81));

/// A room with tiles of that size.
MapFile tiled_room(Vec2 corner, double tile_m) {
    MapFile file = map_of({box_room("room", corner.x, corner.y, corner.x + 8, corner.y + 6, 0, 3)});
    SectorRecord& sector = file.sectors[0];
    for (FlatRecord* flat : {&sector.floor, &sector.ceiling}) flat->texture->tile_m = Vec2{tile_m, tile_m};
    for (WallRecord& wall : sector.loops[0].walls) wall.texture->tile_m = Vec2{tile_m, tile_m};
    return file;
}

// hard case R16
TEST(StencilTextures, LieAtTheEdgeOfTheWorldAsInTheColumnRenderer) {
    Agreement sum;
    for (const Vec2 corner : {Vec2{30000, -32000}, Vec2{32752, 32752}, Vec2{-32768, -32768}})
        for (const double tile_m : {3.0, 0.75, 0.25}) {
            Stage stage(tiled_room(corner, tile_m));
            for (const double yaw : {0.0, 33.0, 200.0})
                sum += stage.sight.compare(look_from(stage.map, corner + Vec2{2.37, 3.1}, 1.5, yaw), {160, 100});
        }
    expect_agreement(sum);
}

Texture picture_of_size(std::uint32_t width, std::uint32_t height) {
    Texture texture;
    texture.width = width;
    texture.height = height;
    texture.pixels.resize(std::size_t{width} * height);
    Random random(29);
    for (std::uint32_t& pixel : texture.pixels) pixel = 0xFF000000u | static_cast<std::uint32_t>(random.bits());
    return texture;
}

// hard cases R29, W12
TEST(StencilTextures, OfAnySizeAreDrawnAsByTheColumnRenderer) {
    Agreement sum;
    for (const PictureSize size :
         {PictureSize{1, 1}, PictureSize{3, 5}, PictureSize{127, 1}, PictureSize{64, 65}, PictureSize{64, 127}}) {
        const MapFile file = crooked_rooms();
        const Map map = built(file);
        TextureSet textures = textures_for(file);
        for (Texture& texture : textures.textures) {
            const std::string name = texture.name;
            texture = picture_of_size(static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height));
            texture.name = name;
        }
        sum += Sight(map, textures).compare_random_poses(6, {160, 100}, 29);
    }
    expect_no_fault(sum);
}

// The doors of "hub" meet in (29, 29) and (0, 29) and lead elsewhere, by different turns. From z = width / 64 away a
// vertex that is aside by an odd number of 64ths is on a pixel's centre.
// hard cases R26, G9
TEST(StencilDoors, ThatShareAVertexOnAPixelsCentreAreInOneMaskEach) {
    Stage stage(linked_rooms());
    Agreement sum;
    for (const Vec2 vertex : {Vec2{29, 29}, Vec2{0, 29}})
        for (std::uint32_t quarter = 0; quarter < 4; ++quarter)
            for (int column = 1; column < 64; column += 4) {
                View view;
                view.sector = SectorId(0u);
                view.forward = direction(Angle{quarter << 30});
                view.eye = vertex - view.forward - right_of(view.forward) * ((2 * column + 1 - 64) / 64.0);
                view.eye_z = 1.25;
                if (contains(stage.map, view.sector, view.eye)) sum += stage.sight.compare(view, {64, 40});
            }
    expect_no_fault(sum);
}

/// A hall along whose sides lie niches of other widths than those across, with floors and ceilings at many heights: so
/// every long edge of the hall's flats meets many corners of others.
MapFile hall_of_niches() {
    MapFile file = map_of({box_room("hall", 0, 0, 30, 6, 0, 4)});
    for (int i = 0; i < 30; ++i)
        file.sectors.push_back(box_room("north_" + std::to_string(i), i, -2, i + 1, 0, i % 5 / 8.0, 4 - i % 3 / 4.0));
    for (int i = 0; i < 20; ++i)
        file.sectors.push_back(
            box_room("south_" + std::to_string(i), 1.5 * i, 6, 1.5 * i + 1.5, 8, i % 4 / 8.0, 3.5 + i % 5 / 16.0));
    split_and_join(file);
    return file;
}

// hard case G6
TEST(StencilJunctions, OfOneEdgeWithManyCornersLeaveNoPixelOut) {
    Stage stage(hall_of_niches());
    expect_agreement(stage.sight.compare_poses(60, {160, 100}, 6));
}

// Through a door turned by 3, 4, 5 into a plain of 60 km: what is at its end is seen.
// hard case G10
TEST(StencilWorld, IsSeenToItsFarEndThroughATurnedLink) {
    MapFile file = map_of(
        {room("porch", {{-32000, -32000}, {-31992, -32000}, {-31992, -31990}, {-32000, -31990}}),
         room("plain", {{-30000, -30000}, {30000, -30000}, {30000, 30000}, {-30000, 30000}, {-29994, 8}, {-30000, 0}},
              0, 4000)});
    link(file, "porch", {-31992, -32000}, {-31992, -31990}, "plain", {-29994, 8}, {-30000, 0});
    Stage stage(file);
    const View view = look_from(stage.map, {-31996, -31995}, 1, 0);
    expect_agreement(stage.sight.compare(view, {320, 200}));
    const StencilPicture seen = stage.sight.by_stencil(view, {320, 200});
    EXPECT_GT(*std::max_element(seen.facts.depths.begin(), seen.facts.depths.end()), 30000);
}

// hard cases G13, I14
TEST(StencilFacts, AreNumbersWhereverOneStands) {
    for (const NamedScene& scene : linked_scenes()) {
        Stage stage(scene.file());
        Random random(14);
        for (int i = 0; i < 40; ++i) {
            const FrameFacts facts = stage.sight.by_stencil(lattice_pose(stage.map, {64, 40}, random), {64, 40}).facts;
            for (std::size_t k = 0; k < facts.depths.size(); ++k) {
                ASSERT_FALSE(std::isnan(facts.depths[k])) << scene.name;
                ASSERT_GE(facts.depths[k], 0) << scene.name;
                ASSERT_TRUE(std::isfinite(facts.texels[k].u) && std::isfinite(facts.texels[k].v)) << scene.name;
            }
        }
    }
}

/// Pieces of a straight corridor that lie anywhere, each linked to the next and the last to the first.
MapFile corridor_in_pieces() {
    struct Piece {
        Vec2 turn, corner;
        Vec2 at(double x, double y) const { return corner + turn * x + right_of(turn) * y; }
    };
    const Piece pieces[] = {{{1, 0}, {0, 0}}, {{0.8, 0.6}, {40, 7}}, {{0, -1}, {-13, 60}}, {{-0.6, 0.8}, {25, -30}}};
    constexpr double kLength = 1.25, kWidth = 2.5;
    MapFile file = map_of({});
    for (const Piece& p : pieces)
        file.sectors.push_back(room(std::to_string(file.sectors.size()),
                                    {p.at(0, 0), p.at(kLength, 0), p.at(kLength, kWidth), p.at(0, kWidth)}, 0, 3));
    for (std::size_t i = 0; i < 4; ++i) {
        const Piece &p = pieces[i], &next = pieces[(i + 1) % 4];
        link(file, std::to_string(i), p.at(kLength, 0), p.at(kLength, kWidth), std::to_string((i + 1) % 4),
             next.at(0, kWidth), next.at(0, 0));
    }
    file.render.max_depth = 128;
    return file;
}

// hard case R25
TEST(StencilCorridor, OfTurnedPiecesIsStraightFor128Links) {
    Stage stage(corridor_in_pieces());
    View view = look_from(stage.map, {0.25, 1.125}, 1.5, 0);
    view.fov_degrees = 12;
    expect_agreement(stage.sight.compare(view, {320, 200}));
    EXPECT_EQ(stage.sight.counts().deepest, 128);
}

// hard cases R19, W11
TEST(StencilDoor, IsDrawnRightAtEveryHeightFromShutOn) {
    MapFile file = map_of({box_room("hall", 0, 0, 4, 4, 0, 3), box_room("door", 4, 1, 5, 3, 0, 0),
                           box_room("yard", 5, 0, 9, 4, -0.25, 2.5)});
    split_and_join(file);
    Stage stage(file);
    Agreement sum;
    for (const double open : {0.0, 0x1p-32, 0x1p-16, 0x1p-6, 0.05, 0.3, 1.0, 1.7, 2.5, 2.9}) {
        stage.sight.snapshot().sectors[1].ceiling_z = open;
        for (const auto& [x, yaw] : {std::pair{1.0, 0.0}, {3.5, 10.0}, {4.5, 33.0}, {8.0, 180.0}})
            sum += stage.sight.compare(look_from(stage.map, {x, 2.01}, 1.5, yaw), {160, 100});
    }
    expect_agreement(sum);
}

// hard case G14
TEST(StencilPoses, AThousandShowWhatTheColumnRendererShows) {
    Agreement sum;
    std::uint64_t seed = 0;
    for (const auto& scenes : {plain_scenes(), linked_scenes()})
        for (const NamedScene& scene : scenes) sum += Stage(scene.file()).sight.compare_poses(50, {96, 60}, ++seed);
    expect_agreement(sum);
}

}  // namespace
}  // namespace enfilade::test
