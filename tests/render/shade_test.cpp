// The shading rules: light, texels, sky.
#include "render/shade.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/hash.h"
#include "render/sprite.h"

namespace enfilade {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class ShadeAt : public testing::TestWithParam<LightModel> {
protected:
    static Shade shade(double light, double depth, double contrast = 1) {
        return shade_at(GetParam(), light, contrast, depth);
    }
};

// hard case R30
TEST_P(ShadeAt, NeverGrowsWithDepth) {
    for (double light : {0.0, 0.2, 0.5, 0.9, 1.0})
        for (double depth = 0; depth < 200; depth += 0.25)
            ASSERT_GE(shade(light, depth), shade(light, depth + 0.25)) << depth;
}

// hard case R30
TEST_P(ShadeAt, NeverShrinksWithLight) {
    for (double depth : {0.0, 0.3, 2.0, 17.0, 400.0})
        for (int light = 0; light < 256; ++light)
            ASSERT_LE(shade(light / 255.0, depth), shade((light + 1) / 255.0, depth)) << light;
}

// hard case R30
TEST_P(ShadeAt, ClampsLightToItsRange) {
    for (double depth : {0.0, 3.0, 1e30, kInfinity})
        for (double contrast : {0.8, 1.0}) {
            EXPECT_EQ(shade(-1, depth, contrast), shade(0, depth, contrast)) << depth;
            EXPECT_EQ(shade(2, depth, contrast), shade(1, depth, contrast)) << depth;
        }
}

TEST_P(ShadeAt, StaysBetweenBlackAndAsPainted) {
    for (double light : {-1.0, 0.0, 1.0, 2.0})
        for (double depth : {0.0, 1e-300, 1.0, 1e30, kInfinity})
            for (double contrast : {0.8, 1.0, 1.2})
                EXPECT_LE(shade(light, depth, contrast), 256u) << light << " " << depth;
}

TEST_P(ShadeAt, IsAsPaintedInFullLightNearby) { EXPECT_EQ(shade(1, 0), 256u); }

TEST_P(ShadeAt, IsDarkerOnWallsOfLessContrast) { EXPECT_LT(shade(0.5, 4, 0.8), shade(0.5, 4)); }

INSTANTIATE_TEST_SUITE_P(Models, ShadeAt, testing::Values(LightModel::smooth, LightModel::classic),
                         [](const auto& model) { return model.param == LightModel::smooth ? "Smooth" : "Classic"; });

TEST(ShadeAtClassic, IsOneWithinARoundingOfTheEdgeBetweenTwoLevels) {
    for (double level = 1; level < 23; ++level) {
        const double edge = 40 / level;
        const Shade there = shade_at(LightModel::classic, 0.5, 1, edge);
        EXPECT_EQ(shade_at(LightModel::classic, 0.5, 1, edge * (1 + 0x1p-48)), there) << level;
        EXPECT_EQ(shade_at(LightModel::classic, 0.5, 1, edge * (1 - 0x1p-48)), there) << level;
        EXPECT_LT(shade_at(LightModel::classic, 0.5, 1, edge * (1 + 0x1p-24)), there) << level;
    }
}

TEST(ShadeAtSmooth, DoesNotFallOffInFullLight) { EXPECT_EQ(shade_at(LightModel::smooth, 1, 1, kInfinity), 256u); }

TEST(ShadeAtSmooth, HalvesHalfLightAtNineMetres) {
    EXPECT_EQ(shade_at(LightModel::smooth, 0.5, 1, 0), 128u);
    EXPECT_EQ(shade_at(LightModel::smooth, 0.5, 1, 9), 64u);
}

TEST(ShadeAtSmooth, IsBlackInNoLight) { EXPECT_EQ(shade_at(LightModel::smooth, 0, 1, 0), 0u); }

TEST(FogPart, HidesHalfAtItsReach) { EXPECT_EQ(fog_part_at(7, 7), 128u); }

TEST(FogPart, HidesNothingBeforeTheEyeAndAllAtInfinity) {
    EXPECT_EQ(fog_part_at(7, 0), 0u);
    EXPECT_EQ(fog_part_at(7, kInfinity), 256u);
}

TEST(FogPart, IsNotThereWithoutReach) { EXPECT_EQ(fog_part_at(0, kInfinity), 0u); }

TEST(FogPart, NeverShrinksWithDepth) {
    for (double depth = 0; depth < 200; depth += 0.25)
        ASSERT_LE(fog_part_at(9, depth), fog_part_at(9, depth + 0.25)) << depth;
}

TEST(FogPart, GrowsByTheStepAndIsTheNearestOfThem) {
    for (double depth = 0; depth < 200; depth += 0.25) {
        const FogPart fine = fog_part_at(9, depth), banded = fog_part_at(9, depth, 8);
        ASSERT_EQ(banded % 8, 0u);
        ASSERT_LE(banded, fine + 4);
        ASSERT_LT(fine, banded + 4);
    }
    EXPECT_EQ(fog_part_at(9, kInfinity, 8), 256u);
}

TEST(Fogged, GoesFromTheColourToTheFogs) {
    EXPECT_EQ(fogged(0x80123456, 0xFFABCDEF, 0), 0x80123456u);
    EXPECT_EQ(fogged(0x80123456, 0xFFABCDEF, 256), 0x80ABCDEFu);
    EXPECT_EQ(fogged(0xFF000000, 0xFFFFFFFF, 128), 0xFF7F7F7Fu);
}

/// Worked out from Doom's formulas: level = 60 - 2 [32 light] - min([40 / depth], 23), of 32, each 8 / 256 darker.
struct ClassicLevel {
    double light;
    double depth;
    int level;
};

class ShadeAtClassic : public testing::TestWithParam<ClassicLevel> {};

TEST_P(ShadeAtClassic, IsDoomsLevel) {
    const auto [light, depth, level] = GetParam();
    EXPECT_EQ(shade_at(LightModel::classic, light, 1, depth), static_cast<Shade>(256 - 8 * level))
        << light << " " << depth;
}

INSTANTIATE_TEST_SUITE_P(Table, ShadeAtClassic,
                         testing::Values(ClassicLevel{1, 1, 0}, ClassicLevel{1, 1000, 0},  // light 31 of 31: as painted
                                         ClassicLevel{0.8, 40, 9},
                                         ClassicLevel{0.8, 10, 6},  // 25: 60 - 50 - 40 / depth
                                         ClassicLevel{0.8, 5, 2}, ClassicLevel{0.8, 3, 0}, ClassicLevel{0.4, 40, 31},
                                         ClassicLevel{0.4, 2, 16},  // 12: 60 - 24 = 36
                                         ClassicLevel{0.25, 1, 21},
                                         ClassicLevel{0.25, 0.1, 21},  // at most 23 are won back
                                         ClassicLevel{0, 2, 31}, ClassicLevel{0, 1e30, 31}));  // 0: 60, never below 31

TEST(Shaded, KeepsColorsAsPaintedAtTheTop) { EXPECT_EQ(shaded(0xFF123456u, 256), 0xFF123456u); }

TEST(Shaded, IsOpaqueBlackAtZero) { EXPECT_EQ(shaded(0x80FFFFFFu, 0), 0xFF000000u); }

TEST(Shaded, ScalesEachChannelByItself) { EXPECT_EQ(shaded(0xFFFF8001u, 128), 0xFF7F4000u); }

TEST(Fraction, IsThePartAfterThePointAlsoOfNegativeNumbers) {
    EXPECT_EQ(fraction(3.25), 0.25);
    EXPECT_EQ(fraction(-0.25), 0.75);
    EXPECT_EQ(fraction(-3), 0);
}

TEST(Fraction, IsBelowOneForTheSmallestStepBelowZero) {
    EXPECT_EQ(fraction(-1e-300), 0);  // 1 - 1e-300 rounds to 1, which is the next tile's 0
}

TEST(PlaceOnTile, IsTheNearestStep) {
    for (const TilePlace step : {0u, 1u, 12345u, 0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu})
        for (const double off : {-0.49, -1e-9, 0.0, 1e-9, 0.49})
            EXPECT_EQ(place_on_tile((step + off) * 0x1p-32), step) << off;
}

TEST(PlaceOnTile, IsTheSameOnEveryTile) {
    for (const double tile : {-0x1p19, -77777.0, -1.0, 0.0, 3.0, 0x1p18, 0x1p19, 0x1p30, -0x1p40})
        for (const double part : {0.0, 0.25, 0.625}) EXPECT_EQ(place_on_tile(tile + part), part * 0x1p32) << tile;
}

TEST(PlaceOnTile, BeginsAgainWhereATileEnds) {
    EXPECT_EQ(place_on_tile(std::nextafter(1.0, 0.0)), 0u);
    EXPECT_EQ(place_on_tile(-1e-300), 0u);
    EXPECT_EQ(place_on_tile(1 - 0x1p-32), 0xFFFFFFFFu);
}

TEST(PlaceOnTile, IsThatOfTheCheaperFunctionNearby) {
    Random random(5);
    for (int i = 0; i < 100000; ++i) {
        const double tiles = random.uniform(-kNearTiles, kNearTiles);
        ASSERT_EQ(place_on_tile(tiles), place_on_near_tile(tiles)) << tiles;
    }
}

TEST(PlaceOnPicture, EndsWithTheLastStep) {
    EXPECT_EQ(place_on_picture(1), 0xFFFFFFFFu);
    EXPECT_EQ(place_on_picture(std::nextafter(1.0, 0.0)), 0xFFFFFFFFu);
    EXPECT_EQ(place_on_picture(0.5), 0x80000000u);
    EXPECT_EQ(place_on_picture(-1e-12), 0u);
}

// hard case R29
TEST(TexelOf, IsInTheTextureForAnySizeAndPlace) {
    for (std::uint32_t size : {1u, 3u, 5u, 128u, 65535u})
        for (TilePlace place : {0u, 1u, 0x80000000u, 0xFFFFFFFFu}) EXPECT_LT(texel_of(place, size), size) << place;
}

TEST(TexelOf, CutsTheTileIntoEqualParts) {
    EXPECT_EQ(texel_of(place_on_tile(0.24), 4), 0u);
    EXPECT_EQ(texel_of(place_on_tile(0.25), 4), 1u);
    EXPECT_EQ(texel_of(place_on_tile(0.75), 4), 3u);
}

TEST(SkyTexel, WrapsAroundAsOftenAsTheTileSays) {
    EXPECT_EQ(sky_texel({4, 1}, {}, 0.25, 0, SkyRows::round).u, 0);
    EXPECT_EQ(sky_texel({4, 1}, {}, 0.125, 0, SkyRows::round).u, 0.5);
}

TEST(SkyTexel, StandsOnTheHorizonWithItsFoot) { EXPECT_EQ(sky_texel({1, 1}, {}, 0, 0, SkyRows::round).v, 1); }

TEST(SkyTexel, HasItsTopAtTheTangentOfItsHeight) { EXPECT_EQ(sky_texel({1, 2.5}, {}, 0, 2.5, SkyRows::round).v, 0); }

TEST(SkyTexel, GoesOnWithItsLastRowsAboveAndBelow) {
    EXPECT_EQ(sky_texel({1, 1}, {}, 0, 50, SkyRows::round).v, 0);
    EXPECT_EQ(sky_texel({1, 1}, {}, 0, -50, SkyRows::round).v, 1);
}

TEST(SkyTexel, BeginsAgainBelowWhereRowsAreStraight) {
    EXPECT_EQ(sky_texel({1, 1}, {}, 0, 50, SkyRows::straight).v, 0);
    EXPECT_EQ(sky_texel({1, 1}, {}, 0, 0.25, SkyRows::straight).v, 0.75);
    EXPECT_EQ(sky_texel({1, 1}, {}, 0, 0, SkyRows::straight).v, 0);
    EXPECT_EQ(sky_texel({1, 1}, {}, 0, -50.25, SkyRows::straight).v, 0.25);
    EXPECT_EQ(place_on_sky(51.25, last_of_sky(SkyRows::straight)), place_on_tile(0.25));
    EXPECT_EQ(place_on_sky(51.25, last_of_sky(SkyRows::round)), place_on_picture(1));
}

TEST(SkyTexel, MovesByItsOffset) {
    const SkyTexel moved = sky_texel({1, 1}, {0.25, 0.125}, 0.5, 0.25, SkyRows::round);
    EXPECT_EQ(moved.u, 0.25);
    EXPECT_EQ(moved.v, 0.625);
}

TEST(Panel, ScrollsAlongItselfAndUp) {
    Panel panel;
    panel.surface = {TextureId(), {2, 4}, {0.75, 0.125}, Peg::ceiling, {1, -0.5}};
    Snapshot snapshot;
    EXPECT_EQ(picture_now(snapshot, panel).offset_tiles, (Vec2{0.75, 0.125}));
    snapshot.time_s = 3;  // 3 m along and 1.5 m down
    EXPECT_EQ(picture_now(snapshot, panel).offset_tiles, (Vec2{0.25, 0.5}));
}

TEST(FlatLayer, TurnsOverASkyByItsOwnSpeed) {
    Map map;
    map.flat_layers = {{}, {TextureId(), {4, 1}, {0.75, 0.125}, Peg::ceiling, {9, 0}}};
    FlatNow sky;
    sky.sky = true;
    sky.layer_count = 2;
    Snapshot snapshot;
    snapshot.time_s = 30;  // three quarters of a turn: three of the four wraps
    EXPECT_EQ(layer_now(map, snapshot, sky, 1).offset_tiles, (Vec2{0.75, 0.125}));
    snapshot.time_s = 5;  // half a wrap
    EXPECT_EQ(layer_now(map, snapshot, sky, 1).offset_tiles, (Vec2{0.25, 0.125}));
}

TEST(FlatLayer, ScrollsOverAFloorByItsOwnSpeed) {
    Map map;
    map.flat_layers = {{TextureId(), {4, 2}, {0.75, 0.125}, Peg::ceiling, {3, -1}}};
    FlatNow floor;
    floor.layer_count = 1;
    Snapshot snapshot;
    snapshot.time_s = 2;  // 6 m along x, a tile and a half, and 2 m back along y
    EXPECT_EQ(layer_now(map, snapshot, floor, 0).offset_tiles, (Vec2{0.25, 0.125}));
    snapshot.time_s = 0.5;
    EXPECT_EQ(layer_now(map, snapshot, floor, 0).offset_tiles, (Vec2{0.125, 0.875}));
}

TEST(ColorTable, HasALevelForEveryThirtySecondOfAShade) {
    Texture picture;
    picture.width = 2;
    picture.height = ColorTable::kLevels + 1;
    for (std::uint32_t x = 0; x < 2; ++x)
        for (std::uint32_t y = 0; y < picture.height; ++y) picture.pixels.push_back(0xFF000000u | x << 8 | y);
    const ColorTable table = ColorTable::read(picture).value();
    EXPECT_EQ(darkened_colors(table, 256)[0], 0xFF000001u);
    EXPECT_EQ(darkened_colors(table, 249)[0], 0xFF000001u);
    EXPECT_EQ(darkened_colors(table, 248)[1], 0xFF000102u);
    EXPECT_EQ(darkened_colors(table, 8)[0], 0xFF000020u);
    EXPECT_EQ(darkened_colors(table, 0)[0], 0xFF000020u);
}

TEST(ColorTable, AddsTheLightOfLampsToWhatWasLookedUp) {
    const LightCell light = light_cell(64 * kLightSteps, 0, 500 * kLightSteps);
    EXPECT_EQ(lit_above(0xFF102030u, 0xFF8080C0u, 128, 0), 0xFF102030u);
    EXPECT_EQ(lit_above(0xFF102030u, 0xFF8080C0u, 128, light),
              0xFF102030u + (0xC0u * 64 >> 8) + (0x80u * 384 >> 8 << 16));
    EXPECT_EQ(lit_above(0xFFFFFFFFu, 0xFF8080C0u, 128, light), 0xFFFFFFFFu);
}

}  // namespace
}  // namespace enfilade
