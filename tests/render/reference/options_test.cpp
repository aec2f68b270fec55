// What does and does not change the reference's picture: threads, samples, facts.
#include <gtest/gtest.h>

#include <algorithm>

#include "render/reference/picture.h"
#include "support/looks.h"

namespace enfilade::test {
namespace {

class ReferenceOptionsTest : public testing::Test {
protected:
    static MapFile rooms_with_a_step() {
        MapFile file = map_of({box_room("near", 0, 0, 4, 4, 0, 3), box_room("far", 4, 0, 8, 4, 0.5, 2)});
        join_all(file);
        return file;
    }
    const Rooms rooms_{rooms_with_a_step()};
    const View view_ = look_from(rooms_.map, {1.3, 1.7}, 1.4, 20);
    const Picture plain_ = rooms_.look(view_, 48, 32);
};

// hard case I13
TEST_F(ReferenceOptionsTest, ThreadsDoNotChangeThePicture) {
    EXPECT_EQ(rooms_.look(view_, 48, 32, {1, 3}).frame.pixels, plain_.frame.pixels);
    EXPECT_EQ(rooms_.look(view_, 48, 32, {2, 1}).frame.pixels, rooms_.look(view_, 48, 32, {2, 3}).frame.pixels);
}

TEST_F(ReferenceOptionsTest, FactsDoNotChangeThePicture) {
    for (int samples : {1, 2}) {
        Frame frame;
        frame.resize(48, 32);
        render_reference(frame, nullptr, rooms_.map, rooms_.textures, at_rest(rooms_.map), view_, {samples, 1});
        EXPECT_EQ(frame.pixels, rooms_.look(view_, 48, 32, {samples, 1}).frame.pixels) << samples;
    }
}

TEST_F(ReferenceOptionsTest, SamplesDoNotChangeTheFacts) {
    const Picture fine = rooms_.look(view_, 48, 32, {3, 1});
    EXPECT_EQ(fine.facts.ids, plain_.facts.ids);
    EXPECT_EQ(fine.facts.depths, plain_.facts.depths);
}

TEST_F(ReferenceOptionsTest, SamplesAreMixedToAColorBetweenThem) {
    const Picture mixed = rooms_.look(view_, 48, 32, {2, 1}), samples = rooms_.look(view_, 96, 64);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 48; ++x)
            for (int shift : {0, 8, 16}) {
                const auto channel = [&](const Picture& p, int px, int py) {
                    return p.frame.pixels[p.at(px, py)] >> shift & 0xFF;
                };
                const auto [low, high] =
                    std::minmax({channel(samples, 2 * x, 2 * y), channel(samples, 2 * x + 1, 2 * y),
                                 channel(samples, 2 * x, 2 * y + 1), channel(samples, 2 * x + 1, 2 * y + 1)});
                ASSERT_GE(channel(mixed, x, y), low) << x << ", " << y;
                ASSERT_LE(channel(mixed, x, y), high) << x << ", " << y;
            }
}

TEST(Samples, OfBlackAndWhiteMixToTheGreyOfHalfTheLight) {
    MapFile file = map_of({box_room("room", 0, 0, 4, 4)});
    TextureSet textures = textures_for(file);
    const Map map = built(file);
    for (Texture& t : textures.textures)
        t.pixels.assign(t.pixels.size(), t.name == "ceiling" ? 0xFF000000u : 0xFFFFFFFFu);
    Frame frame;
    frame.resize(1, 1);
    // Two rays up to the black ceiling and two down to the white floor, 256 / 256 bright.
    render_reference(frame, nullptr, map, textures, at_rest(map), look_from(map, {2, 2}, 1, 0), {2, 1});
    EXPECT_EQ(frame.pixels[0], 0xFFBCBCBCu);  // 188: sRGB of linear 1/2
}

}  // namespace
}  // namespace enfilade::test
