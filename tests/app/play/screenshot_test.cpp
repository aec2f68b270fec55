// Screenshots never overwrite one another.
#include "app/play/saved_game.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

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
    const test::TempDir dir;
    EXPECT_EQ(save_screenshot(red_pixel(), dir.path()).value(), "enfilade-0001.png");
    EXPECT_EQ(save_screenshot(red_pixel(), dir.path()).value(), "enfilade-0002.png");
}

TEST(Screenshot, HoldsThePicture) {
    const test::TempDir dir;
    const auto name = save_screenshot(red_pixel(), dir.path()).value();
    EXPECT_EQ(hash_of(frame_of(read_png(read_file(dir.path(name)).value()).value())), hash_of(red_pixel()));
}

TEST(Screenshot, SaysWhyItCannotBeWritten) { EXPECT_FALSE(save_screenshot(red_pixel(), "/no/such/folder").ok()); }

/// The environment of one test.
class Pictures : public ::testing::Test {
protected:
    Pictures() {
        unsetenv("XDG_PICTURES_DIR");
        unsetenv("XDG_CONFIG_HOME");
        setenv("HOME", home_.path().c_str(), 1);
    }
    ~Pictures() override {
        unsetenv("XDG_PICTURES_DIR");
        setenv("HOME", before_.c_str(), 1);
    }
    void make(const std::string& folder) const { std::filesystem::create_directories(home_.path(folder)); }

    test::TempDir home_;
    std::string before_ = std::getenv("HOME") ? std::getenv("HOME") : "";
};

TEST_F(Pictures, GoWhereOneIsWithoutAFolderForThem) { EXPECT_EQ(pictures_folder(), "."); }

TEST_F(Pictures, GoIntoTheUsersFolder) {
    make("Pictures");
    EXPECT_EQ(pictures_folder(), home_.path("Pictures"));
}

TEST_F(Pictures, GoWhereTheDesktopHasThem) {
    make("Pictures");
    make("Bilder");
    make(".config");
    (void)write_file(home_.path(".config/user-dirs.dirs"),
                     std::string_view("# names\nXDG_MUSIC_DIR=\"$HOME/Musik\"\nXDG_PICTURES_DIR=\"$HOME/Bilder\"\n"));
    EXPECT_EQ(pictures_folder(), home_.path("Bilder"));
    setenv("XDG_PICTURES_DIR", home_.path("Pictures").c_str(), 1);
    EXPECT_EQ(pictures_folder(), home_.path("Pictures"));
}

}  // namespace
}  // namespace enfilade
