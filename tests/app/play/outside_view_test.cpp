// The view from outside over the player's own.
#include "app/play/play_loop.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/map_builder.h"

namespace enfilade {
namespace {

constexpr std::uint32_t kOwnView = 0xFF123456;

class OutsideViewOfARoom : public ::testing::Test {
protected:
    OutsideViewOfARoom() {
        view_.sector = SectorId(0u);
        view_.eye = {2, 2};
        view_.eye_z = 1;
        frame_.resize(200, 100);
    }

    /// Draws over a view of one colour.
    const Frame& drawn() {
        std::ranges::fill(frame_.pixels, kOwnView);
        Overlay overlay(frame_, font_);
        outside_.draw(overlay, frame_, renderer_, at_rest(map_), view_, 1);
        return frame_;
    }

    std::uint32_t at(int x, int y) const { return frame_.pixels[std::size_t(y * frame_.width + x)]; }

    MapFile file_ = test::map_of({test::box_room("room", 0, 0, 8, 4)});
    Map map_ = test::built(file_);
    TextureSet textures_ = test::textures_for(file_);
    OutsideRenderer renderer_{map_, textures_};
    View view_;
    Frame frame_;
    Font font_;
    OutsideView outside_;
};

TEST_F(OutsideViewOfARoom, IsShownNowhereAtFirstAndAgainAfterThree) {
    EXPECT_EQ(std::ranges::count(drawn().pixels, kOwnView), 200 * 100);
    for (int i = 0; i < 3; ++i) outside_.show_next();
    EXPECT_EQ(std::ranges::count(drawn().pixels, kOwnView), 200 * 100);
}

TEST_F(OutsideViewOfARoom, TakesTheCornerOfThePlayersView) {
    outside_.show_next();
    drawn();
    EXPECT_EQ(at(119, 0), kOwnView);
    EXPECT_EQ(at(199, 40), kOwnView);
    for (int y = 0; y < 40; ++y)
        for (int x = 120; x < 200; ++x) ASSERT_NE(at(x, y), kOwnView) << x << ' ' << y;
}

TEST_F(OutsideViewOfARoom, LeavesTheCornerToThePlayersViewInFull) {
    outside_.show_next();
    outside_.show_next();
    drawn();
    EXPECT_EQ(std::ranges::count(frame_.pixels, kOwnView), 78 * 38) << "all of the corner but its rim";
    EXPECT_EQ(at(121, 1), kOwnView);
    EXPECT_EQ(at(198, 38), kOwnView);
}

TEST_F(OutsideViewOfARoom, ChangesItsSideAndItsZoom) {
    outside_.show_next();
    const Frame above = drawn();
    outside_.zoom(2);
    const Frame nearer = drawn();
    EXPECT_NE(nearer.pixels, above.pixels);
    outside_.zoom(-2);
    outside_.change_side();
    EXPECT_NE(drawn().pixels, above.pixels);
    outside_.change_side();
    EXPECT_EQ(drawn().pixels, above.pixels);
}

TEST_F(OutsideViewOfARoom, StopsZoomingBeforeNothingIsLeft) {
    outside_.show_next();
    for (const int way : {1, -1}) {
        for (int i = 0; i < 100; ++i) outside_.zoom(way);
        const Frame last = drawn();
        outside_.zoom(way);
        EXPECT_EQ(drawn().pixels, last.pixels);
    }
}

}  // namespace
}  // namespace enfilade
