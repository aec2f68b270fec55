// The reference renderer in one room, against a solution worked out by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/reference/picture.h"
#include "render/shade.h"
#include "support/looks.h"

namespace enfilade::test {
namespace {

/// Depths and places are sums and products of a few numbers below 100: errors stay below 1e-13 [m].
constexpr double kBoxRounding = 1e-12;

/// A room of 8 m x 8 m around the origin and 3 m high, seen along +x from near its middle. The eye is so placed that no
/// ray ends on the edge of a texel.
class BoxRoom : public testing::Test {
protected:
    static constexpr int kWidth = 60, kHeight = 40;
    static constexpr double kEyeX = 0.5078125, kEyeY = -0.2734375, kEyeZ = 1.23;

    double slope(int x) const { return (2 * x + 1 - kWidth) / static_cast<double>(kWidth); }
    double climb(int y) const { return (kHeight / 2.0 - y - 0.5) / (kWidth / 2.0); }
    /// Depth of the wall seen in column x: that at x = 4, or the one to the right or left.
    double wall_depth(int x) const {
        const double s = slope(x);
        const double side = s > 0 ? (4 - kEyeY) / s : (-4 - kEyeY) / s;
        return std::min(4 - kEyeX, side);
    }
    WallId wall_seen(int x) const {
        if (wall_depth(x) == 4 - kEyeX) return ahead_;
        return slope(x) > 0 ? wall_between(rooms_.map, box_, {4, 4}, {-4, 4})
                            : wall_between(rooms_.map, box_, {-4, -4}, {4, -4});
    }
    double height_at_wall(int x, int y) const { return kEyeZ + climb(y) * wall_depth(x); }
    bool shows_wall_ahead(int x, int y) const {
        return picture_.id(x, y) == wall_id(rooms_.map, ahead_, WallPart::middle);
    }

    const Rooms rooms_{map_of({box_room("box", -4, -4, 4, 4, 0, 3)})};
    const SectorId box_{0u};
    const WallId ahead_ = wall_between(rooms_.map, box_, {4, -4}, {4, 4});
    const Picture picture_ = rooms_.look(look_from(rooms_.map, {kEyeX, kEyeY}, kEyeZ, 0), kWidth, kHeight);
};

TEST_F(BoxRoom, ShowsTheSurfaceThatIsThere) {
    for (int x = 0; x < kWidth; ++x)
        for (int y = 0; y < kHeight; ++y) {
            const double h = height_at_wall(x, y);
            const PixelSurface expected = h >= 3  ? ceiling_id(box_)
                                          : h < 0 ? floor_id(box_)
                                                  : wall_id(rooms_.map, wall_seen(x), WallPart::middle);
            ASSERT_EQ(picture_.id(x, y), expected) << x << ", " << y;
        }
}

TEST_F(BoxRoom, KnowsTheDepthOfEveryPixel) {
    for (int x = 0; x < kWidth; ++x)
        for (int y = 0; y < kHeight; ++y) {
            const double h = height_at_wall(x, y);
            const double expected = h >= 3 ? (3 - kEyeZ) / climb(y) : h < 0 ? -kEyeZ / climb(y) : wall_depth(x);
            ASSERT_NEAR(picture_.depth(x, y), expected, kBoxRounding) << x << ", " << y;
        }
}

TEST_F(BoxRoom, LaysTilesOfTheFloorFromTheOriginOfTheWorld) {
    for (int x = 0; x < kWidth; ++x)
        for (int y = 0; y < kHeight; ++y) {
            if (picture_.id(x, y) != floor_id(box_)) continue;
            const double z = -kEyeZ / climb(y);
            ASSERT_NEAR(picture_.texel(x, y).u, fraction(kEyeX + z), kBoxRounding) << x << ", " << y;
            ASSERT_NEAR(picture_.texel(x, y).v, fraction(kEyeY + slope(x) * z), kBoxRounding) << x << ", " << y;
        }
}

TEST_F(BoxRoom, CountsWallTilesFromTheWallsStart) {
    for (int x = 0; x < kWidth; ++x)
        for (int y = 0; y < kHeight; ++y) {
            if (!shows_wall_ahead(x, y)) continue;
            const double along = kEyeY + slope(x) * (4 - kEyeX) + 4;
            ASSERT_NEAR(picture_.texel(x, y).u, fraction(along), kBoxRounding) << x << ", " << y;
        }
}

TEST_F(BoxRoom, HangsWallTilesFromTheCeiling) {
    for (int x = 0; x < kWidth; ++x)
        for (int y = 0; y < kHeight; ++y) {
            if (!shows_wall_ahead(x, y)) continue;
            ASSERT_NEAR(picture_.texel(x, y).v, fraction(3 - height_at_wall(x, y)), kBoxRounding) << x << ", " << y;
        }
}

TEST_F(BoxRoom, PaintsTheTexelInTheLightOfItsDepth) {
    for (std::size_t i = 0; i < picture_.frame.pixels.size(); ++i) {
        const TexelPosition texel = picture_.facts.texels[i];
        const PixelSurface id = picture_.facts.ids[i];
        const bool is_wall = id > ceiling_id(box_);
        const double contrast = is_wall ? rooms_.map.walls[(id - 3) / 3].contrast : 1;
        const char* const name = is_wall ? "wall" : id == floor_id(box_) ? "floor" : "ceiling";
        const Texture& texture = rooms_.textures[rooms_.textures.find(name)];
        const std::uint32_t painted =
            texture.at(texel_of(place_on_tile(texel.u), 64), texel_of(place_on_tile(texel.v), 64));
        const Shade shade = shade_at(LightModel::smooth, 1, contrast, picture_.facts.depths[i]);
        ASSERT_EQ(picture_.frame.pixels[i], shaded(painted, shade)) << i;
    }
}

// hard case I1
TEST_F(BoxRoom, CountsOneWriteForEachPixel) {
    const auto pixels = static_cast<std::ptrdiff_t>(picture_.facts.writes.size());
    EXPECT_EQ(std::count(picture_.facts.writes.begin(), picture_.facts.writes.end(), 1), pixels);
}

}  // namespace
}  // namespace enfilade::test
