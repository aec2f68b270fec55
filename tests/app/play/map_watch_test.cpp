// Noticing that a map was saved.
#include "app/play/game.h"

#include <gtest/gtest.h>

#include <chrono>

#include "support/temp_dir.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

class MapWatchOnAFile : public ::testing::Test {
protected:
    MapWatchOnAFile() { save("map.toml"); }

    void save(const std::string& name) { ASSERT_TRUE(write_file(dir_.path(name), std::string_view("text")).ok()); }
    void read(const std::string& name) { (void)watch_.start_reading()(dir_.path(name)).ok(); }

    test::TempDir dir_;
    MapWatch watch_;
};

TEST_F(MapWatchOnAFile, SeesNothingWhereNothingChanged) {
    read("map.toml");
    EXPECT_FALSE(watch_.changed());
}

TEST_F(MapWatchOnAFile, SeesThatAFileWasSaved) {
    read("map.toml");
    fs::last_write_time(dir_.path("map.toml"), fs::last_write_time(dir_.path("map.toml")) + std::chrono::seconds(2));
    EXPECT_TRUE(watch_.changed());
}

TEST_F(MapWatchOnAFile, SeesThatAFileIsGone) {
    read("map.toml");
    fs::remove(dir_.path("map.toml"));
    EXPECT_TRUE(watch_.changed());
}

TEST_F(MapWatchOnAFile, SeesThatAMissingPictureAppeared) {
    read("textures/brick.png");
    ASSERT_FALSE(watch_.changed());
    fs::create_directory(dir_.path("textures"));
    save("textures/brick.png");
    EXPECT_TRUE(watch_.changed());
}

TEST_F(MapWatchOnAFile, ForgetsWhatWasReadBefore) {
    read("map.toml");
    save("other.toml");
    read("other.toml");
    fs::remove(dir_.path("map.toml"));
    EXPECT_FALSE(watch_.changed());
}

}  // namespace
}  // namespace enfilade
