// How far the light of lamps in pictures is from the truth.
#include "app/accuracy/errors.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "app/accuracy/experiment.h"
#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;

constexpr int kLitWidth = 128, kLitHeight = 80;

OpenMap open(const MapFile& file) { return {built(file), textures_for(file)}; }

/// A hall with pillars and a lamp, or none.
MapFile hall(bool is_lit) {
    MapFile file = map_of({box_room("hall", 0, 0, 9.3125, 8, 0, 3)});
    for (const Vec2 at : {Vec2{2.4375, 2.8125}, Vec2{5.5625, 1.1875}, Vec2{6.3125, 5.4375}})
        cut_pillar(file.sectors[0], at.x, at.y, at.x + 1.0625, at.y + 0.8125);
    PointLightRecord lamp;
    lamp.position = {4.3, 4.6};
    lamp.z = 1.4;
    lamp.reach = 9;
    if (is_lit) file.lights = {lamp};
    return file;
}

LightErrors errors_of(const OpenMap& map, const Dials& dials) {
    const auto errors = measure_light(map, poses_in(map.map, PoseKind::random, 8, 5), kLitWidth, kLitHeight, dials);
    EXPECT_TRUE(errors.ok());
    return errors.value();
}

LightErrors errors_of(const OpenMap& map, int points_per_m) {
    const LightErrors errors = errors_of(map, Dials{.light_grid = points_per_m});
    std::printf("light_grid=%d: %llu pixels, %.2f %% off by more than 1/255, %.4f/255 in the mean, at most %d/255\n",
                points_per_m, static_cast<unsigned long long>(errors.pixels), 100 * errors.share_off(), errors.mean(),
                errors.largest);
    return errors;
}

TEST(LightError, IsNoneWhereThereIsNoLamp) {
    const LightErrors errors = errors_of(open(hall(false)), 4);
    EXPECT_GT(errors.pixels, 8u * kLitWidth * kLitHeight * 9 / 10);
    EXPECT_EQ(errors.lit, 0u);
    EXPECT_EQ(errors.off, 0u);
    EXPECT_EQ(errors.largest, 0);
}

TEST(LightError, FallsWithFinerGrids) {
    const OpenMap map = open(hall(true));
    LightErrors coarser = errors_of(map, 1);
    EXPECT_GT(coarser.lit, coarser.pixels / 4);
    EXPECT_GT(coarser.share_off(), 0.2);
    for (const int points_per_m : {2, 4, 8, 16, 64}) {
        const LightErrors finer = errors_of(map, points_per_m);
        EXPECT_LT(finer.mean(), coarser.mean()) << points_per_m;
        EXPECT_LT(finer.share_off(), coarser.share_off()) << points_per_m;
        EXPECT_GT(finer.off, 0u) << "shadows have edges";
        coarser = finer;
    }
    EXPECT_LT(coarser.share_off(), 0.03);
}

// What rooms and pictures look like is nobody's business here: the same hall, painted and lit by its own light.
TEST(LightError, IsAboutLampsAlone) {
    MapFile file = hall(true);
    const LightErrors plain = errors_of(open(file), 4);
    file.sectors[0].light = 0.125;
    file.render.light = LightModel::classic;
    file.render.fog_reach = 3;
    const LightErrors other = errors_of(open(file), Dials{.light = LightSteps::bands});
    EXPECT_EQ(other.pixels, plain.pixels);
    EXPECT_EQ(other.off, plain.off);
    EXPECT_EQ(other.sum, plain.sum);
}

TEST(LightError, IsThereInTheShippedMapsWithLamps) {
    auto map = open_map(ENFILADE_SOURCE_DIR "/maps/effects.toml", {}, {});
    ASSERT_TRUE(map);
    const LightErrors usual = errors_of(*map, 4), fine = errors_of(*map, 32);
    EXPECT_GT(usual.lit, 0u);
    EXPECT_LT(fine.mean(), usual.mean());
}

}  // namespace
}  // namespace enfilade
