// The ways of sampling: the column renderer against the reference, which does each in its own way.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "formats/words.h"
#include "render/column/agreement.h"
#include "render/reference/reference_renderer.h"
#include "support/furnish.h"

namespace enfilade {
namespace {

using namespace test;

constexpr int kSampledWidth = 160, kSampledHeight = 100;

/// Every texel differs from its neighbours, as on nothing that is painted: what is blended wrongly shows.
void paint_noise(TextureSet& textures) {
    Random random(11);
    for (Texture& texture : textures.textures)
        for (std::uint32_t& pixel : texture.pixels)
            pixel = (pixel & 0xFF000000u) | static_cast<std::uint32_t>(random.below(1 << 24));
}

/// Lamps, fog, layers and panels, so that all paths of drawing are gone; no edge of light is sharp.
MapFile lit_palace() {
    MapFile file = palace();
    scatter_lights(file, 12, 5);
    scatter_panels(file, 12, 6);
    file.render.fog_color = 0x4080C0;
    file.render.fog_reach = 12;
    for (SectorRecord& sector : file.sectors) {
        sector.floor.layers = {{TextureSpec{"lattice", Vec2{1.7, 2.3}, {3.3, 1.7}, {}}, 0, {-0.9, 0.4}, {}}};
        for (WallRecord& wall : sector.loops[0].walls)
            if (!wall.next.empty()) wall.middle = spec("lattice");
    }
    return file;
}

/// The texels of each picture in any order.
void shuffle(TextureSet& textures) {
    Random random(12);
    for (Texture& texture : textures.textures)
        for (std::size_t i = texture.pixels.size(); i > 1; --i) {
            const std::size_t other = random.below(i);
            std::swap(texture.pixels[i - 1], texture.pixels[other]);
            if (!texture.numbers.empty()) std::swap(texture.numbers[i - 1], texture.numbers[other]);
        }
}

int channels_apart(std::uint32_t a, std::uint32_t b) {
    int most = 0;
    for (const int shift : {0, 8, 16}) most = std::max(most, std::abs(int(a >> shift & 0xFF) - int(b >> shift & 0xFF)));
    return most;
}

struct SamplingComparison {
    std::size_t pixels = 0, different = 0;
    int largest = 0;
    std::size_t blended = 0;  ///< differ from the nearest texel's
};

void compare(const TexturedMap& world, const View& view, Sampling sampling, LightGrids& lights, ColumnStrips& columns,
             SamplingComparison& sum) {
    Frame a, b, nearest;
    FrameFacts facts;
    for (Frame* frame : {&a, &b, &nearest}) frame->resize(kSampledWidth, kSampledHeight);
    reset(facts, kSampledWidth, kSampledHeight);
    columns.render(a, nullptr, world.snapshot, view);
    render_reference(b, &facts, world.map, world.textures, world.snapshot, view,
                     {.lights = &lights, .sampling = sampling});
    render_reference(nearest, nullptr, world.map, world.textures, world.snapshot, view, {.lights = &lights});
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const int difference = channels_apart(a.pixels[i], b.pixels[i]);
        ++sum.pixels;
        sum.different += difference != 0;
        sum.largest = std::max(sum.largest, difference);
        sum.blended += a.pixels[i] != nearest.pixels[i];
    }
}

constexpr Sampling kWays[] = {Sampling::mip, Sampling::bilinear, Sampling::trilinear};

/// Steps of 1/256 are taken from places and sizes that are rounded by one rule, so nothing is to differ but the light
/// of lamps, for whose grid there is none: a channel, by one, in so few pixels where texels are not blended, either.
void expect_same_sampling(const TexturedMap& world, std::uint64_t seed, double lift = 0) {
    LightGrids lights(world.map);
    const bool is_lit = lights.where_lit() != nullptr;
    for (const Sampling sampling : kWays) {
        Random random(seed);
        Dials dials;
        dials.sampling = sampling;
        ColumnStrips columns(world.map, world.textures, 1, dials);
        SamplingComparison sum;
        for (int trial = 0; trial < 40; ++trial) {
            View view = random_view(world.map, random);
            view.eye_z += lift;
            compare(world, view, sampling, lights, columns, sum);
        }
        EXPECT_LE(sum.largest, is_lit ? 1 : 0) << to_word(sampling);
        EXPECT_LE(sum.different, sum.pixels / 20'000) << to_word(sampling);
        EXPECT_GE(sum.blended * 20, sum.pixels) << to_word(sampling);
        std::printf("%s: %zu of %zu pixels differ, by at most %d; %zu are not the nearest texel's\n",
                    std::string(to_word(sampling)).c_str(), sum.different, sum.pixels, sum.largest, sum.blended);
    }
}

TEST(Sampling, IsTheReferencesInEveryWay) {
    TexturedMap world(palace());
    paint_noise(world.textures);
    expect_same_sampling(world, 1);
}

TEST(Sampling, IsTheReferencesUnderLampsInFogAndBehindFences) {
    TexturedMap world(lit_palace());
    paint_noise(world.textures);
    world.textures.textures[world.textures.find("lattice").index] = lattice();
    expect_same_sampling(world, 2);
}

TEST(Sampling, IsTheReferencesByAColorTable) {
    MapFile file = palace();
    file.render.light = LightModel::classic;
    TexturedMap dark(file), lit(lit_palace());
    for (TexturedMap* world : {&dark, &lit}) {
        paint_by_table(world->textures);
        const Texture& first = world->textures.textures.front();
        for (Texture& texture : world->textures.textures)  // every other one goes by the table now
            if (world == &lit && texture.numbers.empty() && texture.pixels.size() == first.pixels.size()) {
                texture.pixels = first.pixels;
                texture.numbers = first.numbers;
            }
        shuffle(world->textures);
        expect_same_sampling(*world, 3);
    }
}

TEST(Sampling, IsTheReferencesThroughLinksAndInMirrors) {
    MapFile file = map_of({box_room("a", 0, 0, 5, 5, 0, 3), box_room("b", 20, 0, 26, 5, 1, 4),
                           room("c", {{40, 0}, {44, 3}, {41, 7}, {37, 4}}, -1, 2)});
    link(file, "a", {5, 0}, {5, 5}, "c", {44, 3}, {41, 7});
    link(file, "a", {0, 5}, {0, 0}, "b", {26, 0}, {26, 5});
    wall(file, "a", {0, 0}, {5, 0}).mirror = true;
    wall(file, "b", {26, 5}, {20, 5}).mirror = true;
    file.render.max_depth = 4;
    for (SectorRecord& sector : file.sectors) sector.floor.texture->tile_m = Vec2{2, 0.75};  // ways of different weight
    TexturedMap world(file);
    paint_noise(world.textures);
    expect_same_sampling(world, 6);
}

TEST(Sampling, IsTheReferencesWhereFlatsAreSeenFromTheWrongSide) {
    TexturedMap world(palace());
    paint_noise(world.textures);
    expect_same_sampling(world, 7, 3);
    expect_same_sampling(world, 8, -3);
}

TEST(Sampling, IsTheReferencesWherePicturesHaveHoles) {
    TexturedMap world(palace());
    paint_noise(world.textures);
    for (const char* name : {"wall", "floor"}) {
        Texture& texture = world.textures.textures[world.textures.find(name).index];
        texture.pixels[5] &= 0x00FFFFFFu;
        texture.has_holes = true;
    }
    expect_same_sampling(world, 4);
}

TEST(Sampling, LeavesOneColorAsItIs) {
    TexturedMap world(palace());
    for (Texture& texture : world.textures.textures) std::ranges::fill(texture.pixels, 0xFF4080C0u);
    Random random(4);
    for (int trial = 0; trial < 10; ++trial) {
        const View view = random_view(world.map, random);
        Frame frames[3];
        const Sampling ways[] = {Sampling::nearest, Sampling::bilinear, Sampling::trilinear};
        for (int i = 0; i < 3; ++i) {
            Dials dials;
            dials.sampling = ways[i];
            frames[i].resize(kSampledWidth, kSampledHeight);
            ColumnStrips(world.map, world.textures, 1, dials).render(frames[i], nullptr, world.snapshot, view);
        }
        ASSERT_EQ(frames[1].pixels, frames[0].pixels) << trial;
        ASSERT_EQ(frames[2].pixels, frames[0].pixels) << trial;
    }
}

/// The floor of the first room, seen from `height` over it by an eye that looks down. Returns how many pixels look
/// beside the eye: their rays are followed along another course than the view's.
std::size_t expect_floor_by_the_view(const TexturedMap& world, const MipChains& mips, double height, double yaw) {
    View view;
    view.sector = SectorId(0u);
    view.eye = snap_to_point_grid({17.3, 21.1});
    view.eye_z = height;
    view.forward = direction(Angle::from_degrees(yaw));
    view.fov_degrees = 120;
    view.tilt = Tilt{direction(Angle::from_degrees(-60)), {1, 0}};
    Frame frame;
    FrameFacts facts;
    frame.resize(kSampledWidth, kSampledHeight);
    reset(facts, kSampledWidth, kSampledHeight);
    render_reference(frame, &facts, world.map, world.textures, world.snapshot, view,
                     {.sampling = Sampling::mip, .mips = &mips});
    const Surface& surface = world.map[world.map[SectorId(0u)].floor.surface];
    const Texture& floor = world.textures[surface.texture];
    const double slope_per_column = 2 * std::sqrt(3.0) / kSampledWidth, focal_y = 1 / slope_per_column;
    const Vec2 right = right_of(view.forward);
    std::size_t beside = 0;
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        if (facts.ids[i] != floor_id(SectorId(0u))) continue;
        const double depth = facts.depths[i], across = depth * slope_per_column;
        const double down = depth * depth / height / focal_y;
        const double x = std::max(std::fabs(right.x) * across, std::fabs(view.forward.x) * down);
        const double y = std::max(std::fabs(right.y) * across, std::fabs(view.forward.y) * down);
        const double size = std::max(x / surface.tile_m.x * floor.width, y / surface.tile_m.y * floor.height);
        if (mip_level(size * (1 - 1e-6)) != mip_level(size * (1 + 1e-6))) continue;
        const Texture& level = mips.at(floor, mip_level(size));
        const std::uint32_t u = texel_of(place_on_tile(facts.texels[i].u), level.width);
        const std::uint32_t v = texel_of(place_on_tile(facts.texels[i].v), level.height);
        EXPECT_EQ(frame.pixels[i], level.at(u, v)) << "pixel " << i;
        if (testing::Test::HasFailure()) break;
        const Ray ray =
            Projection(view, kSampledWidth, kSampledHeight).ray(int(i) % kSampledWidth, int(i) / kSampledWidth);
        beside += ray.ahead < 0 && std::fabs(ray.right) > -ray.ahead;
    }
    return beside;
}

TEST(Sampling, OfATiltedPictureGoesByTheViewAndNotByTheCourse) {
    MapFile file = map_of({box_room("a", 0, 0, 40, 40, 0, 60)});
    file.sectors[0].floor.texture->tile_m = Vec2{8, 0.5};
    file.sectors[0].unlit = true;
    file.sectors[0].light = 1;
    TexturedMap world(file);
    paint_noise(world.textures);
    const MipChains mips(world.textures);
    std::size_t beside = 0;
    for (const double height : {4.0, 5.1, 6.3, 7.7, 9.0, 11.4})
        for (const double yaw : {20.0, 75.0}) beside += expect_floor_by_the_view(world, mips, height, yaw);
    EXPECT_GT(beside, 5000u);
}

// A tilted picture that is not tilted is the same picture.
TEST(Sampling, OfATiltedPictureChoosesTheSameSmallerOnes) {
    TexturedMap world(palace());
    paint_noise(world.textures);
    Random random(6);
    for (int trial = 0; trial < 6; ++trial) {
        View level = random_view(world.map, random);
        level.pitch_tangent = 0;
        View tilted = level;
        tilted.tilt = Tilt{};
        Frame a, b;
        FrameFacts facts;
        for (Frame* frame : {&a, &b}) frame->resize(kSampledWidth, kSampledHeight);
        reset(facts, kSampledWidth, kSampledHeight);
        const ReferenceOptions trilinear{.sampling = Sampling::trilinear};
        render_reference(a, &facts, world.map, world.textures, world.snapshot, level, trilinear);
        render_reference(b, nullptr, world.map, world.textures, world.snapshot, tilted, trilinear);
        for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            if (std::isinf(facts.depths[i])) continue;
            ASSERT_LE(channels_apart(a.pixels[i], b.pixels[i]), 1) << trial << ", pixel " << i;
        }
    }
}

}  // namespace
}  // namespace enfilade
