// Pictures in strips: how they are cut, and that nobody can tell from the picture.
#include "render/column/column_renderer.h"

#include <gmock/gmock.h>

#include "render/column/agreement.h"
#include "support/count_allocations.h"

namespace enfilade {
namespace {

using test::palace;
using test::random_view;
using test::TexturedMap;
using ::testing::ElementsAre;

std::vector<ColumnRange> strips_of(int width, std::size_t most) {
    std::vector<ColumnRange> strips;
    cut_into_strips(width, most, strips);
    return strips;
}

TEST(CutIntoStrips, MeetsWhereCacheLinesEnd) {
    EXPECT_THAT(strips_of(64, 4),
                ElementsAre(ColumnRange{0, 16}, ColumnRange{16, 32}, ColumnRange{32, 48}, ColumnRange{48, 64}));
    EXPECT_THAT(strips_of(60, 2), ElementsAre(ColumnRange{0, 32}, ColumnRange{32, 60}));
}

TEST(CutIntoStrips, MakesOneWhereThePictureIsNarrowOrNobodyShares) {
    EXPECT_THAT(strips_of(1, 8), ElementsAre(ColumnRange{0, 1}));
    EXPECT_THAT(strips_of(16, 8), ElementsAre(ColumnRange{0, 16}));
    EXPECT_THAT(strips_of(1280, 1), ElementsAre(ColumnRange{0, 1280}));
}

// hard case D5
TEST(CutIntoStrips, CoversEveryPictureOnceWithNoMoreThanAskedFor) {
    for (int width = 1; width <= 200; ++width)
        for (std::size_t most : {1u, 2u, 3u, 8u, 12u, 1000u}) {
            const std::vector<ColumnRange> strips = strips_of(width, most);
            ASSERT_LE(strips.size(), most);
            int next = 0;
            for (const ColumnRange& strip : strips) {
                ASSERT_EQ(strip.begin, next);
                ASSERT_LT(strip.begin, strip.end);
                ASSERT_EQ(strip.begin % kLinePixels, 0);
                next = strip.end;
            }
            ASSERT_EQ(next, width);
        }
}

// hard cases D5, I13
TEST(ColumnStrips, DrawTheSamePictureOnAnyNumberOfThreads) {
    const TexturedMap world(palace());
    Random random(6);
    for (int trial = 0; trial < 10; ++trial) {
        const View view = random_view(world.map, random);
        Frame one, many;
        one.resize(211, 97);
        many.resize(211, 97);
        ColumnStrips(world.map, world.textures, 1).render(one, nullptr, world.snapshot, view);
        for (std::size_t threads : {2u, 3u, 8u, 211u, 500u}) {
            ColumnStrips(world.map, world.textures, threads).render(many, nullptr, world.snapshot, view);
            ASSERT_EQ(one.pixels, many.pixels) << threads << " threads";
        }
    }
}

TEST(ColumnStrips, DrawFrameAfterFrameOfAnyWidth) {
    const TexturedMap world(palace());
    Random random(9);
    ColumnStrips shared(world.map, world.textures, 3), alone(world.map, world.textures, 1);
    for (int trial = 0; trial < 60; ++trial) {
        const View view = random_view(world.map, random);
        Frame one, many;
        const int width = 1 + static_cast<int>(random.below(300));
        for (Frame* frame : {&one, &many}) frame->resize(width, 60);
        alone.render(one, nullptr, world.snapshot, view);
        shared.render(many, nullptr, world.snapshot, view);
        ASSERT_EQ(one.pixels, many.pixels) << width << " columns";
    }
}

TEST(ColumnStrips, CutALargePictureForOneThreadTooAndDrawTheSame) {
    const TexturedMap world(palace());
    Random random(11);
    ColumnStrips strips(world.map, world.textures, 1);
    ColumnRenderer whole(world.map, world.textures);
    Frame one, many;
    for (Frame* frame : {&one, &many}) frame->resize(400, 800);
    for (int trial = 0; trial < 5; ++trial) {
        const View view = random_view(world.map, random);
        whole.render(one, nullptr, world.snapshot, view);
        strips.render(many, nullptr, world.snapshot, view);
        EXPECT_EQ(strips.viewports().size(), 3u);  // 1.25 MB in canvases of at most 512 KiB
        ASSERT_EQ(one.pixels, many.pixels) << "trial " << trial;
    }
    many.resize(320, 200);
    strips.render(many, nullptr, world.snapshot, random_view(world.map, random));
    EXPECT_EQ(strips.viewports().size(), 1u);
}

TEST(ColumnStrips, AllocateNothingOnceTheyHaveDrawnTheView) {
    const TexturedMap world(palace());
    Random random(10);
    ColumnStrips strips(world.map, world.textures, 1);
    Frame frame;
    frame.resize(320, 600);
    for (int trial = 0; trial < 20; ++trial) {
        const View view = random_view(world.map, random);
        strips.render(frame, nullptr, world.snapshot, view);
        const std::size_t before = test::allocations();
        strips.render(frame, nullptr, world.snapshot, view);
        EXPECT_EQ(test::allocations(), before) << "trial " << trial;
    }
}

}  // namespace
}  // namespace enfilade
