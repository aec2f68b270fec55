// Viewports and their pool.
#include "render/column/viewport.h"

#include <gtest/gtest.h>

#include "support/count_allocations.h"

namespace enfilade::column {
namespace {

TEST(Viewport, TrimsClosedColumnsAtBothEndsAndKeepsThoseBetween) {
    ViewportPool pool;
    Viewport& v = pool.take(10, 20);
    v.rows_at(13) = {1, 5};
    v.rows_at(17) = {2, 3};
    v.boundary_at(17) = 0.5;
    ASSERT_TRUE(v.trim());
    EXPECT_EQ(v.begin, 13);
    EXPECT_EQ(v.end, 18);
    EXPECT_EQ(v.rows_at(13).bottom, 5);
    EXPECT_TRUE(v.rows_at(15).is_closed());
    EXPECT_EQ(v.rows_at(17).top, 2);
    EXPECT_EQ(v.boundary_at(17), 0.5);
}

TEST(Viewport, IsGoneWhenEveryColumnIsClosed) {
    ViewportPool pool;
    EXPECT_FALSE(pool.take(0, 7).trim());
}

TEST(ViewportPool, HandsOutClosedViewportsAlsoTheSecondTime) {
    ViewportPool pool;
    Viewport& first = pool.take(0, 4);
    first.rows_at(2) = {0, 9};
    first.boundary_at(2) = 3;
    pool.take_all_back();
    Viewport& again = pool.take(0, 4);
    for (int x = 0; x < 4; ++x) {
        EXPECT_TRUE(again.rows_at(x).is_closed());
        EXPECT_EQ(again.boundary_at(x), 0);
    }
}

TEST(ViewportPool, KeepsViewportsInTheirPlaceWhenItGrows) {
    ViewportPool pool;
    Viewport* first = &pool.take(0, 8);
    for (int i = 0; i < 5000; ++i) pool.take(0, 8);
    EXPECT_EQ(&pool[0], first);
    EXPECT_EQ(pool.used(), 5001u);
}

TEST(ViewportPool, AllocatesNothingOnceItHasSeenTheHardestFrame) {
    ViewportPool pool;
    const auto frame = [&] {
        pool.take_all_back();
        for (int i = 0; i < 100; ++i) pool.take(0, 320);
    };
    frame();
    const std::size_t before = test::allocations();
    frame();
    EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace enfilade::column
