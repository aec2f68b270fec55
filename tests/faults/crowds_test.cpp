// Four processes at once that write one file, fill one folder, one cache: none fails, and what is there is whole.
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "app/cli/program.h"
#include "base/owned_folder.h"
#include "faults/work.h"
#include "formats/png.h"
#include "wadconv/wad_builder.h"

namespace enfilade::test {
namespace {

namespace fs = std::filesystem;
using ::testing::Each;
using ::testing::Eq;
using ::testing::IsEmpty;
using ::testing::Ne;

constexpr int kProcesses = 4;

/// Runs the command of each number below kProcesses by a shell in the folder, all at once: their exit statuses.
template <class CommandOf>
std::vector<int> all_at_once(const test::TempDir& dir, CommandOf command_of) {
    std::vector<pid_t> started;
    for (int number = 0; number < kProcesses; ++number) {
        const std::string command = "cd '" + dir.path() + "' && " + command_of(number) + " >/dev/null 2>err" +
                                    std::to_string(number) + ".txt </dev/null";
        const pid_t process = fork();
        if (process == 0) {
            execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
            _exit(127);
        }
        started.push_back(process);
    }
    std::vector<int> statuses;
    for (const pid_t process : started) {
        int status = 0;
        waitpid(process, &status, 0);
        statuses.push_back(WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status));
    }
    return statuses;
}

std::string said(const test::TempDir& dir) {
    std::string text;
    for (int number = 0; number < kProcesses; ++number) {
        const auto bytes = read_file(dir.path("err" + std::to_string(number) + ".txt"));
        if (bytes.ok()) text += as_text(bytes.value());
    }
    return text;
}

std::vector<std::string> temporary_files(const std::string& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().filename().string().starts_with(".enfilade-")) names.push_back(entry.path().string());
    return names;
}

void put_wad(const test::TempDir& dir) {
    wadconv::test::WadBuilder wad = wadconv::test::picture_wad();
    wad.add_map("MAP01", wadconv::test::small_level().map);
    const Bytes bytes = wad.finish("IWAD");
    ASSERT_TRUE(write_file(dir.path("doom.wad"), std::span<const std::byte>(bytes)).ok());
}

TEST(Crowd, ThatDrawsOnePictureLeavesAWholeOne) {
    const test::TempDir dir;
    ASSERT_TRUE(write_file(dir.path("map.toml"), std::string_view(kTwoRooms)).ok());
    for (std::size_t round = 0; round < trials(10, 200); ++round) {
        const auto statuses = all_at_once(dir, [](int number) {
            return std::string("'" ENFILADE_PROGRAM "' render map.toml --threads 1 --out x.png --size ") +
                   std::to_string(64 << number) + "x" + std::to_string(40 << number);
        });
        ASSERT_THAT(statuses, Each(Eq(0))) << said(dir);
        const auto image = read_png(read_file(dir.path("x.png")).value());
        ASSERT_TRUE(image.ok()) << image.error().text();
        ASSERT_THAT(temporary_files(dir.path()), IsEmpty());
    }
}

TEST(Crowd, ThatConvertsIntoOneFolderLeavesItWhole) {
    const test::TempDir dir;
    put_wad(dir);
    std::string first;
    for (std::size_t round = 0; round < trials(10, 200); ++round) {
        const auto statuses =
            all_at_once(dir, [](int) { return std::string("'" WADCONV_PROGRAM "' doom.wad --out levels --jobs 2"); });
        ASSERT_THAT(statuses, Each(Eq(0))) << said(dir);
        ASSERT_THAT(temporary_files(dir.path()), IsEmpty());
        for (const auto& entry : fs::recursive_directory_iterator(dir.path("levels/textures"))) {
            if (!entry.is_regular_file()) continue;
            ASSERT_TRUE(read_png(read_file(entry.path().string()).value()).ok()) << entry.path();
        }
        const std::string map(as_text(read_file(dir.path("levels/map01.toml")).value()));
        if (first.empty()) first = map;
        ASSERT_EQ(map, first);
        if (round % 2 == 0) fs::remove_all(dir.path("levels"));
    }
}

/// A checkout in which everything is built: the script, and the programs where it looks for them.
class Checkout {
public:
    Checkout() {
        put_wad(dir_);
        fs::copy_file(ENFILADE_SOURCE_DIR "/run", dir_.path("run"));
        for (const char* folder : {"build/release/wadconv", "build/release/engine/app", "tools"})
            fs::create_directories(dir_.path(folder));
        fs::create_symlink(WADCONV_PROGRAM, dir_.path("build/release/wadconv/wadconv"));
        fs::create_symlink(ENFILADE_PROGRAM, dir_.path("build/release/engine/app/enfilade"));
        // Nothing has to be built or installed.
        EXPECT_TRUE(write_file(dir_.path("build/release/build.ninja"), "built").ok());
        for (const char* tool : {"cmake", "ninja"}) fs::create_symlink("/bin/true", dir_.path("tools") + "/" + tool);
    }

    const test::TempDir& dir() const { return dir_; }
    /// Without a display a picture is taken of the level.
    std::string play(const std::string& words = "doom.wad MAP01") const {
        return "env -u DISPLAY -u WAYLAND_DISPLAY -u SDL_VIDEODRIVER PATH='" + dir_.path("tools") +
               "':\"$PATH\" XDG_CACHE_HOME='" + dir_.path("cache") + "' XDG_CONFIG_HOME='" + dir_.path("config") +
               "' ./run play " + words;
    }
    /// The same without the script, up to the window.
    std::string find_map(const std::string& words = "doom.wad MAP01") const {
        return "XDG_CACHE_HOME='" + dir_.path("cache") + "' XDG_CONFIG_HOME='" + dir_.path("config") +
               "' '" ENFILADE_PROGRAM "' play --print-map " + words;
    }
    std::string cached_map() const {
        for (const auto& entry : fs::directory_iterator(dir_.path("cache/enfilade/converted")))
            if (fs::exists(entry.path() / "map01.toml")) return (entry.path() / "map01.toml").string();
        return "";
    }

private:
    test::TempDir dir_;
};

TEST(Crowd, ThatPlaysOneLevelFindsItConverted) {
    const Checkout checkout;
    for (std::size_t round = 0; round < trials(5, 200); ++round) {
        const auto statuses = all_at_once(checkout.dir(), [&](int) { return checkout.play(); });
        ASSERT_THAT(statuses, Each(Eq(0))) << said(checkout.dir());
        fs::remove_all(checkout.dir().path("cache"));
    }
}

TEST(Crowd, ThatOpensOneWadFindsItConverted) {
    const Checkout checkout;
    for (std::size_t round = 0; round < trials(10, 200); ++round) {
        const auto statuses = all_at_once(checkout.dir(), [&](int) { return checkout.find_map(); });
        ASSERT_THAT(statuses, Each(Eq(0))) << said(checkout.dir());
        EXPECT_EQ(list_folder(checkout.dir().path("cache/enfilade/converted")).size(), 2u) << "a folder and the lock";
        fs::remove_all(checkout.dir().path("cache"));
    }
}

TEST(RunScript, TakesAnyNameOfAWad) {
    const Checkout checkout;
    for (const std::string name : {"a\\nb.wad", "two\nlines.wad", "it's \"$(touch gone)\";*.wad", "./-rf.wad", " .wad",
                                   "...wad", "..wad", "end\n.wad"}) {
        fs::copy_file(checkout.dir().path("doom.wad"), checkout.dir().path(name));
        std::string word = name;
        for (std::size_t at = 0; (at = word.find('\'', at)) != std::string::npos; at += 4) word.replace(at, 1, "'\\''");
        const auto statuses = all_at_once(checkout.dir(), [&](int) { return checkout.play("'" + word + "' MAP01"); });
        EXPECT_THAT(statuses, Each(Eq(0))) << name << ": " << said(checkout.dir());
    }
    EXPECT_FALSE(fs::exists(checkout.dir().path("gone")));
    EXPECT_EQ(list_folder(checkout.dir().path("cache/enfilade/converted")).size(), 9u) << "eight and the lock";
}

TEST(RunScript, RefusesWordsThatItWouldOverlookWithoutADisplay) {
    const Checkout checkout;
    for (const char* words :
         {"nonsense", "doom.wad nonsense", "doom.wad MAP01 nonsense", "a.toml b.toml", "a.toml --size 64x40 nonsense"})
        EXPECT_THAT(all_at_once(checkout.dir(), [&](int) { return checkout.play(words); }), Each(Ne(0))) << words;
    EXPECT_THAT(all_at_once(checkout.dir(), [&](int) { return checkout.play("doom.wad MAP01 --size 64x40"); }),
                Each(Eq(0)))
        << said(checkout.dir());
}

TEST(Crowd, ThatPlaysALevelFromADamagedCacheMakesItAnew) {
    const Checkout checkout;
    all_at_once(checkout.dir(), [&](int) { return checkout.play(); });
    const std::string map = checkout.cached_map();
    const std::string whole(as_text(read_file(map).value()));
    for (int damage = 0; damage < 3; ++damage) {
        if (damage == 0) fs::remove(map);
        if (damage == 1) fs::resize_file(map, 10);
        if (damage == 2) fs::resize_file(fs::path(map).replace_filename(kFolderMark), 10);
        const auto statuses = all_at_once(checkout.dir(), [&](int) { return checkout.play(); });
        ASSERT_THAT(statuses, Each(Eq(0))) << said(checkout.dir());
        EXPECT_EQ(as_text(read_file(map).value()), whole);
    }
}

}  // namespace
}  // namespace enfilade::test
