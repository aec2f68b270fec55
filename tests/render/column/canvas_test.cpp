// From columns to rows.
#include "render/column/canvas.h"

#include <gtest/gtest.h>

namespace enfilade::column {
namespace {

TEST(Canvas, PutsEachPixelOfEachColumnInItsPlaceForAnySize) {
    for (int width : {1, 3, 4, 5, 16, 17, 37})
        for (int height : {1, 2, 4, 7, 16, 19, 50}) {
            Frame frame;
            frame.resize(width + 5, height);
            std::fill(frame.pixels.begin(), frame.pixels.end(), 0u);
            Canvas canvas;
            canvas.set(2, 2 + width, height);
            for (int x = 2; x < 2 + width; ++x)
                for (int y = 0; y < height; ++y)
                    canvas.run(x, y, y + 1).pixels[0] = static_cast<std::uint32_t>(1000 * x + y + 1);
            canvas.copy_to(frame);
            for (int x = 0; x < frame.width; ++x)
                for (int y = 0; y < height; ++y)
                    ASSERT_EQ(frame.pixels[static_cast<std::size_t>(y * frame.width + x)],
                              x >= 2 && x < 2 + width ? static_cast<std::uint32_t>(1000 * x + y + 1) : 0u)
                        << width << " x " << height << " at " << x << "," << y;
        }
}

/// All of it is drawn over: clearing what a wider strip has more than the one before would be in vain.
TEST(Canvas, ClearsNothingWhenItGrowsAgain) {
    Canvas canvas;
    canvas.set(0, 32, 50);
    canvas.column(31)[49] = 7;
    canvas.set(0, 16, 50);
    canvas.set(0, 32, 50);
    EXPECT_EQ(canvas.column(31)[49], 7u);
}

}  // namespace
}  // namespace enfilade::column
