// Sizes, distances and lights at the ends of their ranges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hard_cases/scenes.h"
#include "hard_cases/world.h"
#include "support/looks.h"

namespace enfilade::test {
namespace {

constexpr double kTexelOfTile = 1 / 64.0;  ///< of the test pictures [tiles], and of tiles of 1 m [m]

/// The distance of two positions in a tile, the short way around [tiles].
double short_way_around(double a, double b) {
    const double d = std::fabs(a - b);
    return std::min(d, 1 - d);
}

double fraction_of(long double x) { return static_cast<double>(x - std::floor(x)); }

// hard cases R11, W9
TEST(WallOf30Kilometres, ShowsItsTexelsWithinAHundredthOfOne) {
    const MadeWorld world(map_of({room("street", {{-15000, 0}, {15000, 0}, {15000, 200}, {-15000, 200}}, 0, 40)}));
    const PixelSurface wall =
        wall_id(world.map, wall_between(world.map, SectorId(0u), {-15000, 0}, {15000, 0}), WallPart::middle);
    for (double yaw : {-90.0, -60.0, -20.0, -3.0}) {
        const View view = look_from(world.map, {0.3, 100}, 1.7, yaw);
        const PictureSize size{1280, 9};
        const Drawn drawn = world.draw(view, size);
        const Projection projection(view, size.width, size.height);
        for (std::size_t i = 0; i < drawn.facts.ids.size(); ++i) {
            if (drawn.facts.ids[i] != wall) continue;
            const Vec2 ray = view.forward + right_of(view.forward) * projection.slope(static_cast<int>(i) % size.width);
            const long double x = view.eye.x - static_cast<long double>(view.eye.y) / ray.y * ray.x;
            ASSERT_LE(short_way_around(drawn.facts.texels[i].u, fraction_of(x + 15000)), 0.01 * kTexelOfTile)
                << yaw << ", " << i;
        }
        const Comparison result = world.compare_with_reference(view, size);
        ASSERT_TRUE(result.is_faultless()) << describe(result);
    }
}

struct Lens {
    double fov_degrees;
    PictureSize size;
};

class ExtremeLens : public testing::TestWithParam<Lens> {};

// hard case R12
TEST_P(ExtremeLens, ShowsWhatTheReferenceShows) {
    const MadeWorld world(stepped_rooms());
    Random random(12);
    for (int i = 0; i < 10; ++i) {
        View view = i % 2 ? random_pose(world.map, random) : lattice_pose(world.map, GetParam().size, random);
        view.fov_degrees = GetParam().fov_degrees;
        const Comparison result = world.compare_with_reference(view, GetParam().size);
        ASSERT_TRUE(result.is_faultless()) << describe(result);
    }
}

INSTANTIATE_TEST_SUITE_P(Lenses, ExtremeLens,
                         testing::Values(Lens{1, {320, 200}}, Lens{179, {320, 200}}, Lens{1, {1, 1}}, Lens{179, {1, 1}},
                                         Lens{90, {1, 200}}, Lens{90, {2, 200}}, Lens{90, {320, 1}}, Lens{1, {7680, 1}},
                                         Lens{179, {7680, 1}}, Lens{90, {7680, 8}}, Lens{179, {1, 2000}}));

/// A plain to the horizon, 30 km every way.
MapFile plain() { return map_of({box_room("plain", -30000, -30000, 30000, 30000, 0, 100)}); }

class Horizon : public testing::TestWithParam<int> {};  // the height of the picture

// hard case R13
TEST_P(Horizon, BelongsToOneSurface) {
    const MadeWorld world(plain());
    for (double eye_z : {0.0, 1.625, 41.0, 100.0}) {
        const Comparison result =
            world.compare_with_reference(look_from(world.map, {0.37, 0.41}, eye_z, 17), {64, GetParam()});
        EXPECT_TRUE(result.is_faultless()) << describe(result);
    }
}

// hard case R14
TEST_P(Horizon, KeepsTheFloorsTexelsNearItWithinAHundredthOfOne) {
    const MadeWorld world(plain());
    const View view = look_from(world.map, {1000.37, -777.21}, 33.28, 17);  // 21 km of floor to the last row above it
    const PictureSize size{640, GetParam()};
    const Drawn drawn = world.draw(view, size);
    const Projection projection(view, size.width, size.height);
    for (std::size_t i = 0; i < drawn.facts.ids.size(); ++i) {
        if (drawn.facts.ids[i] != floor_id(SectorId(0u))) continue;
        const int x = static_cast<int>(i) % size.width, y = static_cast<int>(i) / size.width;
        const Vec2 ray = view.forward + right_of(view.forward) * projection.slope(x);
        const long double depth = -static_cast<long double>(view.eye_z) / projection.climb(y);
        ASSERT_LE(short_way_around(drawn.facts.texels[i].u, fraction_of(view.eye.x + depth * ray.x)),
                  0.01 * kTexelOfTile)
            << i;
        ASSERT_LE(short_way_around(drawn.facts.texels[i].v, fraction_of(view.eye.y + depth * ray.y)),
                  0.01 * kTexelOfTile)
            << i;
    }
    const Comparison result = world.compare_with_reference(view, size);
    EXPECT_TRUE(result.is_faultless()) << describe(result);
}

// hard case R15
TEST_P(Horizon, MayLieTenPicturesAboveOrBelow) {
    const MadeWorld world(stepped_rooms());
    Random random(15);
    for (int i = 0; i < 20; ++i) {
        View view = random_pose(world.map, random);
        const Projection level(view, 64, GetParam());
        view.pitch_tangent = (i % 2 ? 10 : -10) * GetParam() / level.focal_y();
        const Comparison result = world.compare_with_reference(view, {64, GetParam()});
        ASSERT_TRUE(result.is_faultless()) << describe(result);
    }
}

INSTANTIATE_TEST_SUITE_P(EvenAndOdd, Horizon, testing::Values(200, 201));

// hard case R17
TEST(SliverOfAGridStep, IsDrawnOrCoversNoColumn) {
    const MadeWorld world(slivers());
    for (double y : {1.0, 4.0, 7.9})
        for (double yaw : {-80.0, 0.0, 80.0, 89.9}) {
            const Comparison result = world.compare_with_reference(look_from(world.map, {7.5, y}, 1, yaw), {320, 200});
            EXPECT_TRUE(result.is_faultless()) << describe(result);
        }
}

/// Three rooms in a row, the middle one a door.
MapFile rooms_with_a_door(double opening) {
    MapFile file = map_of({box_room("hall", 0, 0, 4, 4, 0, 3), box_room("door", 4, 1, 5, 3, 0, opening),
                           box_room("yard", 5, 0, 9, 4, 0, 2.5)});
    split_and_join(file);
    return file;
}

// hard case R18
TEST(DoorWithoutHeight, IsAWallFromBothSides) {
    const MadeWorld world(rooms_with_a_door(0));
    for (double x : {1.0, 8.0}) {
        const View view = look_from(world.map, {x, 2.01}, 1.5, x < 4 ? 0 : 180);
        const Comparison result = world.compare_with_reference(view, {320, 200});
        EXPECT_TRUE(result.is_faultless()) << describe(result);
        const Drawn drawn = world.draw(view, {320, 200});
        const PixelSurface seen = drawn.facts.ids[100 * 320 + 160];
        const Vec2 a{x < 4 ? 4.0 : 5.0, x < 4 ? 1.0 : 3.0}, b{a.x, x < 4 ? 3.0 : 1.0};
        const WallId step = wall_between(world.map, view.sector, a, b);
        EXPECT_EQ(seen, wall_id(world.map, step, WallPart::upper));
    }
}

// hard case R19
TEST(DoorOpenByAHair, IsLookedThroughOnlyWhereARowIsOpen) {
    MadeWorld world(rooms_with_a_door(0x1p-16));
    Random random(19);
    ColumnRenderer renderer(world.map, world.textures);
    Frame frame;
    frame.resize(160, 100);
    for (int i = 0; i < 50; ++i) {
        const View view = random_pose(world.map, random);
        const Comparison result = world.compare_with_reference(view, {160, 100});
        ASSERT_TRUE(result.is_faultless()) << describe(result);
        renderer.render(frame, nullptr, world.snapshot, view);
        for (const ViewportOutline& viewport : renderer.viewports()) {
            bool any_open = false;
            for (std::size_t k = 0; k < viewport.top.size(); ++k) any_open |= viewport.top[k] < viewport.bottom[k];
            ASSERT_TRUE(any_open || viewport.depth == 0);
        }
    }
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

class OddTexture : public testing::TestWithParam<PictureSize> {};

// hard cases R29, W12
TEST_P(OddTexture, IsDrawnAsTheReferenceDrawsItAtAnyOffset) {
    for (double offset : {0.0, -1e9, 12345.678}) {
        MapFile file = crooked_rooms();
        for (SectorRecord& s : file.sectors) {
            for (FlatRecord* flat : {&s.floor, &s.ceiling}) flat->texture->offset_tx = {offset, -offset};
            for (LoopRecord& loop : s.loops)
                for (WallRecord& w : loop.walls) w.texture->offset_tx = {offset, -offset};
        }
        MadeWorld world(file);
        for (Texture& texture : world.textures.textures) {
            const std::string name = texture.name;
            texture = picture_of_size(static_cast<std::uint32_t>(GetParam().width),
                                      static_cast<std::uint32_t>(GetParam().height));
            texture.name = name;
        }
        Random random(29);
        for (int i = 0; i < 8; ++i) {
            const Comparison result = world.compare_with_reference(random_pose(world.map, random), {160, 100});
            ASSERT_TRUE(result.is_faultless()) << describe(result);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, OddTexture,
                         testing::Values(PictureSize{1, 1}, PictureSize{3, 5}, PictureSize{127, 1}, PictureSize{64, 65},
                                         PictureSize{64, 127}, PictureSize{128, 65535}));

// hard case R30
TEST(LightOutOfRange, IsTheNearestInRange) {
    MadeWorld world(stepped_rooms());
    Random random(30);
    for (auto [outside, inside] : {std::pair{-1.0, 0.0}, std::pair{1.01, 1.0}, std::pair{256.0, 1.0}}) {
        const View view = random_pose(world.map, random);
        for (SectorSnapshot& sector : world.snapshot.sectors) sector.light = outside;
        const Drawn drawn = world.draw(view, {160, 100});
        for (SectorSnapshot& sector : world.snapshot.sectors) sector.light = inside;
        EXPECT_EQ(world.draw(view, {160, 100}).frame.pixels, drawn.frame.pixels) << outside;
    }
}

}  // namespace
}  // namespace enfilade::test
