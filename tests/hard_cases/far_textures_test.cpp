// Textures that repeat a hundred thousand times between the origin and where one stands.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hard_cases/world.h"
#include "render/reference/reference_renderer.h"
#include "support/looks.h"

namespace enfilade::test {
namespace {

constexpr double kTexel = 1 / 64.0;          ///< of the test pictures [tiles]
constexpr double kMostOff = 0.001 * kTexel;  ///< [tiles]
constexpr PictureSize kSize{320, 200};

struct Room {
    Vec2 corner;
    double tile_m;
};

/// 8 m x 6 m.
MapFile tiled_room(const Room& at) {
    MapFile file = map_of({box_room("room", at.corner.x, at.corner.y, at.corner.x + 8, at.corner.y + 6, 0, 3)});
    SectorRecord& sector = file.sectors[0];
    const Vec2 tile{at.tile_m, at.tile_m};
    for (FlatRecord* flat : {&sector.floor, &sector.ceiling}) flat->texture->tile_m = tile;
    for (WallRecord& wall : sector.loops[0].walls) wall.texture->tile_m = tile;
    return file;
}

/// The distance of two positions in a tile, the short way around [tiles].
double tile_distance(double a, long double b) {
    const auto d = static_cast<double>(std::fabs(a - (b - std::floor(b))));
    return std::min(d, 1 - d);
}

/// How far the texels of the floor are from where the rays meet it, worked out with 64 bits of mantissa [tiles].
double worst_on_floor(const FrameFacts& facts, const View& view, double tile_m) {
    const Projection projection(view, kSize.width, kSize.height);
    double worst = 0;
    for (std::size_t i = 0; i < facts.ids.size(); ++i) {
        if (facts.ids[i] != floor_id(SectorId(0u))) continue;
        const int x = static_cast<int>(i) % kSize.width, y = static_cast<int>(i) / kSize.width;
        const Vec2 ray = view.forward + right_of(view.forward) * projection.slope(x);
        const long double depth = -static_cast<long double>(view.eye_z) / projection.climb(y);
        worst = std::max({worst, tile_distance(facts.texels[i].u, (view.eye.x + depth * ray.x) / tile_m),
                          tile_distance(facts.texels[i].v, (view.eye.y + depth * ray.y) / tile_m)});
    }
    return worst;
}

class FarTextures : public testing::TestWithParam<Room> {};

// hard case R16
TEST_P(FarTextures, ShowTheirTexelsWithinAThousandthOfOneInBothExactRenderers) {
    const MadeWorld world(tiled_room(GetParam()));
    for (const double yaw : {0.0, 33.0, 90.0, 200.0}) {
        const View view = look_from(world.map, GetParam().corner + Vec2{2.37, 3.1}, 1.5, yaw);
        const Comparison result = world.compare_with_reference(view, kSize);
        ASSERT_TRUE(result.is_faultless()) << describe(result);
        Drawn reference = world.draw(view, kSize);
        const double by_columns = worst_on_floor(reference.facts, view, GetParam().tile_m);
        render_reference(reference.frame, &reference.facts, world.map, world.textures, world.snapshot, view);
        const double by_rays = worst_on_floor(reference.facts, view, GetParam().tile_m);
        note_deviation(std::max(by_columns, by_rays) / kTexel, "texels");
        ASSERT_LE(by_columns, kMostOff) << yaw;
        ASSERT_LE(by_rays, kMostOff) << yaw;
    }
}

// 16 m and 16 384 m are multiples of the tile, so the same texels lie in all rooms.
// hard case R16
TEST(FarTexturesOfWholeTiles, LookAsThoseNearTheOrigin) {
    const MadeWorld here(tiled_room({{16, 16}, 0.25}));
    for (const Vec2 corner : {Vec2{16384, 16384}, Vec2{-16384, 32752}, Vec2{32752, -32768}}) {
        const MadeWorld there(tiled_room({corner, 0.25}));
        for (const double yaw : {0.0, 33.0, 90.0, 200.0}) {
            const Vec2 in_room{2.375, 3.125};
            const Drawn near = here.draw(look_from(here.map, Vec2{16, 16} + in_room, 1.5, yaw), kSize);
            EXPECT_EQ(there.draw(look_from(there.map, corner + in_room, 1.5, yaw), kSize).frame.pixels,
                      near.frame.pixels);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Places, FarTextures,
                         testing::Values(Room{{0, 0}, 3}, Room{{30000, 0}, 3}, Room{{30000, -32000}, 0.75},
                                         Room{{32752, 32752}, 0.1}, Room{{-32768, -32768}, 0.1},
                                         Room{{-32768, 32752}, 1 / 3.0}));

}  // namespace
}  // namespace enfilade::test
