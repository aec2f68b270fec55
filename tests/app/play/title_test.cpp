// The maps that the title screen lists, and how one chooses among them.
#include "app/play/title.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "base/files.h"
#include "formats/map_toml.h"
#include "support/map_builder.h"
#include "support/temp_dir.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

class Maps : public ::testing::Test {
protected:
    Maps() {
        setenv("XDG_DATA_HOME", home_.path("data").c_str(), 1);
        setenv("XDG_CACHE_HOME", home_.path("cache").c_str(), 1);
        setenv("DOOMWADDIR", home_.path("wads").c_str(), 1);
        setenv("ENFILADE_SHARE", ENFILADE_SOURCE_DIR, 1);  // where maps/ is, wherever the test program lies
    }
    ~Maps() override {
        for (const char* name : {"XDG_DATA_HOME", "XDG_CACHE_HOME", "DOOMWADDIR", "ENFILADE_SHARE"}) unsetenv(name);
    }

    std::string write(const std::string& path, const std::string& text) const {
        fs::create_directories(fs::path(home_.path(path)).parent_path());
        EXPECT_TRUE(write_file(home_.path(path), std::string_view(text)).ok());
        return home_.path(path);
    }
    std::string write_room(const std::string& path) const {
        MapFile file = test::map_of({test::box_room("room", 0, 0, 8, 4, 0, 3)});
        file.name = "A room";
        test::place_player(file, "room", {2, 2}, 1.55);
        return write(path, write_map(file));
    }
    /// The listed maps of that origin below the test's folder.
    std::vector<ListedMap> found(MapOrigin origin) const {
        std::vector<ListedMap> maps = find_maps();
        std::erase_if(maps, [&](const ListedMap& map) {
            return map.origin != origin || (origin != MapOrigin::shipped && !map.path.starts_with(home_.path()));
        });
        return maps;
    }
    static Frame wait_for(MapPictures& pictures, const std::string& path) {
        for (int i = 0; i < 500; ++i) {
            if (auto picture = pictures.find(path)) return *picture;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        ADD_FAILURE() << "no picture came";
        return {};
    }

    test::TempDir home_;
};

TEST_F(Maps, BeginWithTheTour) {
    const auto shipped = found(MapOrigin::shipped);
    ASSERT_GT(shipped.size(), 10u);
    EXPECT_EQ(shipped[0].name, "Enfilade");
}

TEST_F(Maps, AreTheUsersOwnByTheirNames) {
    write_room("data/enfilade/maps/mine.toml");
    write("data/enfilade/maps/nameless.toml", "format = 1\n[player]\n");
    const auto own = found(MapOrigin::own);
    ASSERT_EQ(own.size(), 2u);
    EXPECT_EQ(own[0].name, "A room");
    EXPECT_EQ(own[1].name, "nameless");
}

TEST_F(Maps, AreListedAtOnceWhateverLiesAmongThem) {
    write_room("data/enfilade/maps/mine.toml");
    const std::string folder = home_.path("data/enfilade/maps/");
    ASSERT_EQ(::mkfifo((folder + "pipe.toml").c_str(), 0600), 0);
    fs::create_symlink("/dev/zero", folder + "zero.toml");
    write("data/enfilade/maps/endless.toml", "");
    fs::resize_file(folder + "endless.toml", std::uintmax_t{30} << 30);  // a line of 30 GiB
    std::vector<std::string> names;
    for (const ListedMap& map : found(MapOrigin::own)) names.push_back(map.name);
    EXPECT_THAT(names, ::testing::UnorderedElementsAre("A room", "endless", "pipe", "zero"));
}

TEST_F(Maps, AreLevelsThatWereConvertedAndWadsThatAreInstalled) {
    write_room("cache/enfilade/converted/doomed-0123/map01.toml");
    write("cache/enfilade/converted/doomed-0123/made-by-enfilade", "name: doomed\n");
    write_room("cache/enfilade/converted/yours/map01.toml");
    for (const char* wad : {"doomed", "other"}) write("wads/" + std::string(wad) + ".wad", "PWAD");
    const auto levels = found(MapOrigin::converted);
    ASSERT_EQ(levels.size(), 1u);
    EXPECT_EQ(levels[0].name, "doomed A room");
    const auto wads = found(MapOrigin::wad);
    ASSERT_EQ(wads.size(), 2u);
    EXPECT_EQ(wads[0].name, "doomed.wad");
}

TEST_F(Maps, HavePicturesThatAreKept) {
    const std::string path = write_room("data/enfilade/maps/mine.toml");
    {
        MapPictures pictures;
        EXPECT_EQ(wait_for(pictures, path).width, kPictureWidth);
        EXPECT_EQ(pictures.count(), 1u);
    }
    const auto kept = list_folder(home_.path("cache/enfilade/pictures"));
    ASSERT_EQ(kept.size(), 1u);
    fs::last_write_time(home_.path("cache/enfilade/pictures/") + kept[0], fs::file_time_type());
    MapPictures again;
    wait_for(again, path);
    EXPECT_EQ(fs::last_write_time(home_.path("cache/enfilade/pictures/") + kept[0]), fs::file_time_type())
        << "it is not drawn again";
}

TEST_F(Maps, HaveNoPictureWhereTheyHaveErrors) {
    MapPictures pictures;
    EXPECT_EQ(wait_for(pictures, write("data/enfilade/maps/bad.toml", "format = 1\nnonsense\n")).width, 0);
}

class OpenMapPage : public Maps {
protected:
    OpenMapPage() {
        std::vector<ListedMap> maps;
        for (int i = 0; i < 12; ++i) maps.push_back({"", "map " + std::to_string(i), MapOrigin::wad});
        page_.set_maps(maps);
        page_.open();
        draw();
    }
    void draw() {
        frame_.resize(800, 600);
        std::ranges::fill(frame_.pixels, 0xFF000000);
        Overlay overlay(frame_, font_);
        page_.draw(overlay, pictures_, "");
    }
    MapPageAction press(KeyCode key) { return page_.handle(KeyChange{key, true, false}); }

    MapPage page_;
    MapPictures pictures_;
    Frame frame_;
    Font font_;
};

TEST_F(OpenMapPage, GoesAlongAndAcrossRows) {
    press(KeyCode::right), press(KeyCode::right), press(KeyCode::left);
    EXPECT_EQ(page_.chosen().name, "map 1");
    press(KeyCode::down);  // 800 px hold six maps of 119
    EXPECT_EQ(page_.chosen().name, "map 7");
    press(KeyCode::down);
    EXPECT_EQ(page_.chosen().name, "map 11") << "the last";
    for (int i = 0; i < 20; ++i) press(KeyCode::up);
    EXPECT_EQ(page_.chosen().name, "map 0");
}

TEST_F(OpenMapPage, ChoosesByKeyButtonAndMouse) {
    EXPECT_EQ(press(KeyCode::enter), MapPageAction::choose);
    EXPECT_EQ(page_.handle(GamepadButtonChange{GamepadButton::a, true}), MapPageAction::choose);
    EXPECT_EQ(page_.handle(MouseButtonChange{MouseButton::left, true, 200, 60}), MapPageAction::choose);
    EXPECT_EQ(page_.chosen().name, "map 1");
    EXPECT_EQ(page_.handle(MouseButtonChange{MouseButton::left, true, 200, 5}), MapPageAction::none);
}

TEST_F(OpenMapPage, GoesToAMapByItsPath) {
    page_.set_maps({{"a.toml", "a", MapOrigin::own}, {"b.toml", "b", MapOrigin::own}, {"c.toml", "c", MapOrigin::own}});
    page_.choose("b.toml");
    EXPECT_EQ(page_.chosen().name, "b");
    page_.choose("nowhere.toml");
    EXPECT_EQ(page_.chosen().name, "b");
}

TEST_F(OpenMapPage, IsLeft) {
    EXPECT_EQ(press(KeyCode::escape), MapPageAction::leave);
    EXPECT_EQ(page_.handle(GamepadButtonChange{GamepadButton::b, true}), MapPageAction::leave);
    page_.close();
    EXPECT_EQ(press(KeyCode::enter), MapPageAction::none);
}

TEST_F(OpenMapPage, ChoosesNothingWhereThereIsNothing) {
    page_.set_maps({});
    draw();
    EXPECT_EQ(press(KeyCode::enter), MapPageAction::none);
    press(KeyCode::down);
}

}  // namespace
}  // namespace enfilade
