// Pictures made smaller.
#include "render/outside/outside_renderer.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

Texture picture(std::uint32_t width, std::uint32_t height, std::vector<std::uint32_t> by_column) {
    Texture texture;
    texture.width = width;
    texture.height = height;
    texture.pixels = std::move(by_column);
    return texture;
}

constexpr TilePlace kStart = 0, kHalf = 1u << 31;

TEST(TexturePyramid, ShowsEveryTexelFromNearby) {
    const TexturePyramid pyramid(picture(2, 1, {0xFF0000FF, 0xFF00FF00}));
    EXPECT_EQ(pyramid.at(kStart, kStart, 0.1), 0xFF0000FFu);
    EXPECT_EQ(pyramid.at(kHalf, kStart, 1.9), 0xFF00FF00u);
}

TEST(TexturePyramid, MixesTexelsFromFarAway) {
    const TexturePyramid pyramid(picture(2, 2, {0xFF000010, 0xFF000020, 0xFF000030, 0xFF000040}));
    EXPECT_EQ(pyramid.at(kHalf, kStart, 2), 0xFF000028u);
    EXPECT_EQ(pyramid.at(kHalf, kStart, 1e9), 0xFF000028u);
}

TEST(TexturePyramid, LetsColoursCountAsMuchAsTheyCover) {
    const TexturePyramid pyramid(picture(2, 1, {0xFF0000C8, 0x00FFFFFF}));
    EXPECT_EQ(pyramid.at(kStart, kStart, 2), 0x800000C8u);
}

TEST(TexturePyramid, EndsWithOneTexelWhateverTheSize) {
    const TexturePyramid pyramid(picture(1, 5, std::vector<std::uint32_t>(5, 0xFF123456)));
    for (double far = 1; far < 1e6; far *= 2) EXPECT_EQ(pyramid.at(kHalf, 0xFFFFFFFF, far), 0xFF123456u);
}

}  // namespace
}  // namespace enfilade
