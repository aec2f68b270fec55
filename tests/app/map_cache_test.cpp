// Compiled maps on disk: kept in the user's folder, found again, and not without end.
#include "app/open_map.h"

#include <gmock/gmock.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>

#include "support/temp_dir.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

class MapCache : public ::testing::Test {
protected:
    MapCache() { ::setenv("XDG_CACHE_HOME", dir_.path("cache").c_str(), 1); }
    ~MapCache() override {
        ::unsetenv("XDG_CACHE_HOME");
        ::unsetenv("ENFILADE_MAP_CACHE");
    }

    std::vector<fs::path> files() const {
        std::vector<fs::path> found;
        std::error_code none;
        for (const auto& entry : fs::directory_iterator(dir_.path("cache/enfilade"), none))
            found.push_back(entry.path());
        return found;
    }

    test::TempDir dir_;
};

const Bytes kBytes{std::byte{1}, std::byte{2}};

TEST_F(MapCache, FindsWhatItKept) {
    const MapStore store = cache_of("maps/hall.toml");
    EXPECT_FALSE(store.find());
    store.keep(kBytes);
    ASSERT_TRUE(store.find());
    EXPECT_EQ(store.find().value(), kBytes);
    EXPECT_EQ(cache_of("maps/hall.toml").find().value(), kBytes);
    EXPECT_FALSE(cache_of("other/hall.toml").find());
}

TEST_F(MapCache, KeepsNothingWhereItIsOff) {
    ::setenv("ENFILADE_MAP_CACHE", "off", 1);
    EXPECT_FALSE(cache_of("maps/hall.toml").keep);
    EXPECT_FALSE(cache_of("maps/hall.toml").find());
}

TEST_F(MapCache, RemovesWhatWasWrittenLongestAgoOnceItIsTooMuch) {
    const fs::path folder = dir_.path("cache/enfilade");
    fs::create_directories(folder);
    const auto write_long_ago = [&](const std::string& name, int hours) {
        ASSERT_TRUE(write_file((folder / name).string(), std::string_view("x")).ok());
        fs::resize_file(folder / name, kMostCacheBytes / 2);  // takes no room on the disk
        fs::last_write_time(folder / name, fs::file_time_type::clock::now() - std::chrono::hours(hours));
    };
    write_long_ago("old.map", 3);
    write_long_ago("new.map", 1);
    write_long_ago("not-ours.txt", 9);
    cache_of("maps/hall.toml").keep(kBytes);
    EXPECT_FALSE(fs::exists(folder / "old.map"));
    EXPECT_TRUE(fs::exists(folder / "new.map"));
    EXPECT_TRUE(fs::exists(folder / "not-ours.txt"));
    EXPECT_TRUE(cache_of("maps/hall.toml").find());
    EXPECT_EQ(files().size(), 3u);
}

}  // namespace
}  // namespace enfilade
