#include "render/reference/reference_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/rooms.h"
#include "render/shade.h"

namespace enfilade {
namespace {

using test::look_from;
using test::Rooms;

/// Depths and places are sums and products of a few numbers below 100: errors stay below 1e-13 [m].
constexpr double kRounding = 1e-12;

struct Picture {
    Frame frame;
    FrameFacts facts;
    SurfaceId id(int x, int y) const { return facts.ids[at(x, y)]; }
    double depth(int x, int y) const { return facts.depths[at(x, y)]; }
    std::size_t at(int x, int y) const { return static_cast<std::size_t>(y * frame.width + x); }
};

Picture render(const Map& map, const View& view, int width = 64, int height = 48,
               const ReferenceOptions& options = {}) {
    Picture picture;
    picture.frame.resize(width, height);
    render_reference(picture.frame, &picture.facts, map, test::tile_textures(), at_rest(map), view, options);
    return picture;
}

/// A room of 8 m x 8 m around the origin, seen along +x from near its middle: worked out by hand. The eye is so placed
/// that no ray ends on the edge of a texel.
class BoxRoom : public testing::Test {
protected:
    static constexpr int kWidth = 60, kHeight = 40;
    static constexpr double kEyeX = 0.5078125, kEyeY = -0.2734375, kEyeZ = 1.23;

    BoxRoom() {
        box_ = rooms_.add_box(-4, -4, 4, 4);
        view_ = look_from(rooms_.map, {kEyeX, kEyeY}, kEyeZ, 0);
        picture_ = render(rooms_.map, view_, kWidth, kHeight);
    }

    double slope(int x) const { return (2 * x + 1 - kWidth) / static_cast<double>(kWidth); }
    double climb(int y) const { return (kHeight / 2.0 - y - 0.5) / (kWidth / 2.0); }
    /// Depth of the wall seen in column x: that at x = 4, or the one to the right or left.
    double wall_depth(int x) const {
        const double s = slope(x);
        const double side = s > 0 ? (4 - kEyeY) / s : (-4 - kEyeY) / s;
        return std::min(4 - kEyeX, side);
    }
    WallId wall_seen(int x) const {
        if (wall_depth(x) == 4 - kEyeX) return rooms_.wall(box_, {4, -4}, {4, 4});
        return slope(x) > 0 ? rooms_.wall(box_, {4, 4}, {-4, 4}) : rooms_.wall(box_, {-4, -4}, {4, -4});
    }
    double height_at_wall(int x, int y) const { return kEyeZ + climb(y) * wall_depth(x); }

    Rooms rooms_;
    SectorId box_;
    View view_;
    Picture picture_;
};

TEST_F(BoxRoom, ShowsTheSurfaceThatIsThere) {
    for (int x = 0; x < kWidth; ++x)
        for (int y = 0; y < kHeight; ++y) {
            const double h = height_at_wall(x, y);
            const SurfaceId expected = h >= 3  ? ceiling_id(box_)
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
            ASSERT_NEAR(picture_.depth(x, y), expected, kRounding) << x << ", " << y;
        }
}

TEST_F(BoxRoom, LaysTilesOfTheFloorFromTheOriginOfTheWorld) {
    for (int x = 0; x < kWidth; ++x)
        for (int y = 0; y < kHeight; ++y) {
            if (picture_.id(x, y) != floor_id(box_)) continue;
            const double z = -kEyeZ / climb(y);
            const TexelPosition texel = picture_.facts.texels[picture_.at(x, y)];
            ASSERT_FLOAT_EQ(texel.u, static_cast<float>(fraction(kEyeX + z))) << x << ", " << y;
            ASSERT_FLOAT_EQ(texel.v, static_cast<float>(fraction(kEyeY + slope(x) * z))) << x << ", " << y;
        }
}

TEST_F(BoxRoom, HangsWallTilesFromTheCeilingAndCountsThemFromTheWallsStart) {
    const SurfaceId ahead = wall_id(rooms_.map, rooms_.wall(box_, {4, -4}, {4, 4}), WallPart::middle);
    for (int x = 0; x < kWidth; ++x)
        for (int y = 0; y < kHeight; ++y) {
            if (picture_.id(x, y) != ahead) continue;
            const TexelPosition texel = picture_.facts.texels[picture_.at(x, y)];
            const double along = kEyeY + slope(x) * (4 - kEyeX) + 4;
            ASSERT_FLOAT_EQ(texel.u, static_cast<float>(fraction(along))) << x << ", " << y;
            ASSERT_FLOAT_EQ(texel.v, static_cast<float>(fraction(3 - height_at_wall(x, y)))) << x << ", " << y;
        }
}

TEST_F(BoxRoom, PaintsTheTexelInTheLightOfItsDepth) {
    const TextureSet textures = test::tile_textures();
    for (std::size_t i = 0; i < picture_.frame.pixels.size(); ++i) {
        const TexelPosition texel = picture_.facts.texels[i];
        const std::uint32_t painted = textures.textures[0].at(texel_index(texel.u, 4), texel_index(texel.v, 4));
        const Shade shade = shade_at(LightModel::smooth, 1, 1, picture_.facts.depths[i]);
        ASSERT_EQ(picture_.frame.pixels[i], shaded(painted, shade)) << i;
    }
}

TEST_F(BoxRoom, IsNowhereAmbiguous) {
    EXPECT_EQ(std::count(picture_.facts.ambiguous.begin(), picture_.facts.ambiguous.end(), 1), 0);
}

}  // namespace
}  // namespace enfilade
