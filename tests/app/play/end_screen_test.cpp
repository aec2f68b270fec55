// What is shown when a map lies behind one, and when one is hurt.

#include <gtest/gtest.h>

#include <algorithm>

#include "app/play/readout.h"
#include "support/map_builder.h"

namespace enfilade {
namespace {

TEST(EndScreen, CountsSectorsThatMoveAsOneAsOneSecret) {
    Map map = test::built(test::map_of(
        {test::box_room("a", 0, 0, 4, 4), test::box_room("b", 10, 0, 14, 4), test::box_room("c", 20, 0, 24, 4)}));
    EXPECT_EQ(count_of_secrets(map), 0u);
    for (Sector& sector : map.sectors) sector.secret = true;
    EXPECT_EQ(count_of_secrets(map), 3u);
    map.sectors[1].leader = SectorId(0u);
    EXPECT_EQ(count_of_secrets(map), 2u);
}

/// How many pixels are written on: neither the picture nor the shade over it.
long ink_of(const MapEnd& end) {
    Frame frame;
    frame.resize(640, 400);
    std::ranges::fill(frame.pixels, 0xFF000000);
    const Font font;
    Overlay overlay(frame, font);
    draw_end(overlay, end);
    return std::ranges::count_if(frame.pixels, [](std::uint32_t pixel) { return (pixel & 0xFFFFFF) != 0; });
}

TEST(EndScreen, TellsOfSecretsOnlyWhereThereAreAny) {
    MapEnd end{"A room", "", "", 61, 0, 0};
    const long without = ink_of(end);
    end.secrets = 3;
    EXPECT_GT(without, 500);
    EXPECT_GT(ink_of(end), without + 100);
}

std::uint32_t shade_of(double strength) {
    Frame frame;
    frame.resize(1, 1);
    frame.pixels[0] = 0xFF808080;
    const Font font;
    Overlay overlay(frame, font);
    draw_hurt(overlay, strength);
    return frame.pixels[0];
}

TEST(Hurt, TurnsThePictureRedAsMuchAsOneIsHurt) {
    EXPECT_EQ(shade_of(0), 0xFF808080u);
    EXPECT_EQ(shade_of(-1), 0xFF808080u);
    const std::uint32_t little = shade_of(0.3), much = shade_of(1);
    EXPECT_GT(little & 255, 0x80u);
    EXPECT_GT(much & 255, little & 255);
    EXPECT_LT(much >> 8 & 255, little >> 8 & 255);
}

}  // namespace
}  // namespace enfilade
