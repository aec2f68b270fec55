// Pictures in strips: how they are cut, and that nobody can tell from the picture.
#include "render/column/column_renderer.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "render/column/agreement.h"
#include "support/count_allocations.h"

namespace enfilade {
namespace {

using test::palace;
using test::random_view;
using test::TexturedMap;
using ::testing::ElementsAre;

std::vector<Strip> strips_of(int width, std::size_t threads, int widest = 10'000) {
    std::vector<Strip> strips;
    cut_into_strips(width, threads, widest, strips);
    return strips;
}

TEST(CutIntoStrips, MeetsWhereCacheLinesEnd) {
    EXPECT_THAT(strips_of(64, 4),
                ElementsAre(Strip{{0, 16}, 0}, Strip{{16, 32}, 1}, Strip{{32, 48}, 2}, Strip{{48, 64}, 3}));
    EXPECT_THAT(strips_of(60, 1, 32), ElementsAre(Strip{{0, 32}, 0}, Strip{{32, 60}, 0}));
}

TEST(CutIntoStrips, MakesOneWhereThePictureIsNarrowOrNobodyShares) {
    EXPECT_THAT(strips_of(1, 1), ElementsAre(Strip{{0, 1}, 0}));
    EXPECT_THAT(strips_of(16, 8), ElementsAre(Strip{{0, 16}, 7}));
    EXPECT_THAT(strips_of(1280, 1), ElementsAre(Strip{{0, 1280}, 0}));
}

TEST(CutIntoStrips, MakesThemEvenForOneThread) {
    EXPECT_THAT(strips_of(400, 1, 160), ElementsAre(Strip{{0, 144}, 0}, Strip{{144, 272}, 0}, Strip{{272, 400}, 0}));
}

TEST(CutIntoStrips, MakesTheLastOfEachShareNarrowSoThatNobodyWaitsLong) {
    EXPECT_THAT(strips_of(640, 2, 96),
                ElementsAre(Strip{{0, 80}, 0}, Strip{{80, 160}, 0}, Strip{{160, 224}, 0}, Strip{{224, 256}, 0},
                            Strip{{256, 288}, 0}, Strip{{288, 304}, 0}, Strip{{304, 320}, 0}, Strip{{320, 400}, 1},
                            Strip{{400, 480}, 1}, Strip{{480, 544}, 1}, Strip{{544, 576}, 1}, Strip{{576, 608}, 1},
                            Strip{{608, 624}, 1}, Strip{{624, 640}, 1}));
}

// hard case D5
TEST(CutIntoStrips, CoversEveryPictureOnceInEvenSharesNoWiderThanAskedFor) {
    for (int width = 1; width <= 500; ++width)
        for (const std::size_t threads : {1u, 2u, 3u, 8u, 1000u})
            for (const int widest : {kLinePixels, 50, 10'000}) {
                int next = 0;
                std::vector<int> shares(threads);
                for (const Strip& strip : strips_of(width, threads, widest)) {
                    ASSERT_EQ(strip.columns.begin, next);
                    ASSERT_LT(strip.columns.begin, strip.columns.end);
                    ASSERT_EQ(strip.columns.begin % kLinePixels, 0);
                    next = strip.columns.end;
                    ASSERT_LE(next - strip.columns.begin, widest);
                    shares[strip.share] += next - strip.columns.begin;
                }
                ASSERT_EQ(next, width);
                ASSERT_LT(std::ranges::max(shares) - std::ranges::min(shares), 2 * kLinePixels);
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
