// Screenshots never overwrite one another.
#include "app/play/saved_game.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "formats/png.h"
#include "support/temp_dir.h"

namespace enfilade {
namespace {

Frame red_pixel() {
    Frame frame;
    frame.resize(1, 1);
    frame.pixels[0] = 0xFF0000FF;
    return frame;
}

TEST(Screenshot, TakesTheFirstNumberThatIsFree) {
    const testing::TempDir dir;
    EXPECT_EQ(save_screenshot(red_pixel(), dir.path()).value(), "enfilade-0001.png");
    EXPECT_EQ(save_screenshot(red_pixel(), dir.path()).value(), "enfilade-0002.png");
}

TEST(Screenshot, HoldsThePicture) {
    const testing::TempDir dir;
    const auto name = save_screenshot(red_pixel(), dir.path()).value();
    EXPECT_EQ(read_png(read_file(dir.path(name)).value()).value().pixels, red_pixel().pixels);
}

TEST(Screenshot, SaysWhyItCannotBeWritten) { EXPECT_FALSE(save_screenshot(red_pixel(), "/no/such/folder").ok()); }

}  // namespace
}  // namespace enfilade
