// Which WADs are converted, when, and where to; by a converter that writes down what it is asked for.
#include "app/play/conversions.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>

#include "base/file_name.h"
#include "base/files.h"
#include "base/owned_folder.h"
#include "support/temp_dir.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Makes a map of the WADs' bytes, unless they are "broken"; none of "empty" ones.
constexpr const char* kConverter = R"(#!/bin/sh
text=$(while [ "$1" != --out ]; do cat -- "$1"; shift; done)
while [ "$1" != --out ]; do shift; done
say() { printf '%s\n' "$text"; }
say | wc -l >>"$CONVERTER_LOG"
if [ "$text" = broken ]; then echo 'no WAD'; exit 1; fi
mkdir -p "$2/textures"
[ "$text" = empty ] || say | tee "$2/map02.toml" "$2/map01.toml" >"$2/textures/wall.png"
echo >"$2/report.txt"
)";

class Conversions : public ::testing::Test {
protected:
    Conversions() {
        setenv("XDG_DATA_HOME", dir_.path("data").c_str(), 1);
        setenv("XDG_CACHE_HOME", dir_.path("cache").c_str(), 1);
        setenv("DOOMWADDIR", dir_.path("wads").c_str(), 1);
        setenv("CONVERTER_LOG", dir_.path("log").c_str(), 1);
        put_converter(kConverter);
    }
    ~Conversions() override {
        for (const char* name : {"XDG_DATA_HOME", "XDG_CACHE_HOME", "DOOMWADDIR", "CONVERTER_LOG"}) unsetenv(name);
    }

    void put_converter(const std::string& script) const {
        const std::string path = write("bin/wadconv", script);
        fs::permissions(path, fs::perms::owner_all);
    }
    std::string write(const std::string& name, const std::string& text) const {
        fs::create_directories(fs::path(dir_.path(name)).parent_path());
        EXPECT_TRUE(write_file(dir_.path(name), std::string_view(text)).ok());
        return dir_.path(name);
    }
    static void write_over(const std::string& path) { EXPECT_TRUE(write_file(path, std::string_view("damaged")).ok()); }
    Result<std::string> convert_by_ours(const std::vector<std::string>& wads, const Teller& tell = {}) const {
        return convert_wads(wads, tell, dir_.path("bin/wadconv"));
    }
    std::string convert(const std::vector<std::string>& wads) const {
        const auto folder = convert_by_ours(wads);
        EXPECT_TRUE(folder.ok()) << folder.error().text();
        return folder.ok() ? folder.value() : "";
    }
    std::string first_level(const std::vector<std::string>& wads) const {
        return test::content(level_in(convert(wads)).value());
    }
    /// How often the converter ran.
    long conversions() const {
        const std::string log = test::content(dir_.path("log"));
        return std::count(log.begin(), log.end(), '\n');
    }
    std::string cache(const std::string& name = "") const { return dir_.path("cache/enfilade/converted/") + name; }

    test::TempDir dir_;
};

TEST_F(Conversions, AreMadeOnce) {
    const std::string wad = write("g.wad", "levels");
    const std::string folder = convert({wad});
    EXPECT_EQ(convert({wad}), folder);
    EXPECT_EQ(conversions(), 1);
    EXPECT_EQ(level_in(folder).value(), folder + "/map01.toml");
    EXPECT_THAT(list_folder(cache()), ElementsAre(file_name_of(folder), "lock"));
}

TEST_F(Conversions, AreOfContentsNotOfNames) {
    const std::string a = write("A/g.wad", "levels of A"), b = write("B/g.wad", "levels of B");
    EXPECT_EQ(first_level({a}), "levels of A\n");
    EXPECT_EQ(first_level({b}), "levels of B\n");
    EXPECT_EQ(first_level({a}), "levels of A\n");
    EXPECT_EQ(conversions(), 2);
}

TEST_F(Conversions, AreMadeAnewForAWadThatIsOlderThanTheOneBefore) {
    const std::string wad = write("g.wad", "one");
    EXPECT_EQ(first_level({wad}), "one\n");
    write("g.wad", "two");
    fs::last_write_time(wad, fs::last_write_time(wad) - std::chrono::hours(100'000));
    EXPECT_EQ(first_level({wad}), "two\n");
}

TEST_F(Conversions, AreMadeAnewByAnotherConverterInTheSamePlace) {
    const std::string wad = write("g.wad", "levels"), folder = convert({wad});
    put_converter(std::string(kConverter) + "echo better >>\"$2/map01.toml\"\n");
    EXPECT_EQ(convert({wad}), folder) << "saved games are named after it";
    EXPECT_EQ(test::content(folder + "/map01.toml"), "levels\nbetter\n");
}

TEST_F(Conversions, AreMadeAnewWhereTheyAreNotWhole) {
    const std::string wad = write("g.wad", "levels"), folder = convert({wad});
    const std::function<void()> damages[] = {[&] { fs::remove(folder + "/map02.toml"); },
                                             [&] { fs::resize_file(folder + "/textures/wall.png", 3); },
                                             [&] { write_over(folder + "/map01.toml"); },
                                             [&] { write_over(folder + "/more.toml"); },
                                             [&] { write_over(folder + "/" + std::string(kFolderMark)); },
                                             [&] { fs::remove_all(folder + "/textures"); },
                                             [&] { fs::remove_all(folder); }};
    long count = conversions();
    for (const auto& damage : damages) {
        damage();
        EXPECT_EQ(convert({wad}), folder);
        EXPECT_EQ(conversions(), ++count);
        EXPECT_EQ(test::content(folder + "/map01.toml"), "levels\n");
        EXPECT_FALSE(fs::exists(folder + "/more.toml"));
    }
}

TEST_F(Conversions, KnowPatchesByTheirOrder) {
    const std::string game = write("game.wad", "game"), patch = write("patch.wad", "patch");
    EXPECT_EQ(first_level({game, patch}), "gamepatch\n");
    EXPECT_EQ(first_level({patch, game}), "patchgame\n");
    EXPECT_EQ(first_level({game}), "game\n");
}

TEST_F(Conversions, LieInOneFolderWhateverTheWadIsCalled) {
    write("data/enfilade/saved", "mine");
    for (const std::string name : {"...wad", "..wad", ".wad", "-rf.wad", "a\nb.wad", "a\\nb.wad", "it's \"$(x)\";*.wad",
                                   " .wad", "\xFF.wad", "CON.wad"}) {
        const std::string folder = convert({write("wads/" + name, name)});
        EXPECT_EQ(fs::path(folder).parent_path() / "", fs::path(cache())) << name;
        EXPECT_EQ(test::content(folder + "/map01.toml"), name + "\n");
    }
    EXPECT_EQ(test::content(dir_.path("data/enfilade/saved")), "mine");
}

TEST_F(Conversions, ThatFailLeaveWhatWasThere) {
    const std::string wad = write("g.wad", "levels"), folder = convert({wad});
    put_converter("#!/bin/sh\necho 'no memory'\nexit 1\n");
    const auto again = convert_by_ours({wad});
    ASSERT_FALSE(again.ok());
    EXPECT_THAT(again.error().what, HasSubstr("it cannot be converted: no memory"));
    EXPECT_EQ(test::content(folder + "/map01.toml"), "levels\n");
    EXPECT_THAT(list_folder(cache()), ElementsAre(file_name_of(folder), "lock")) << "no scratch is left";
}

TEST_F(Conversions, SayThatThereIsNoConverter) {
    const auto folder = convert_wads({write("g.wad", "levels")}, {}, {});
    ASSERT_FALSE(folder.ok());
    EXPECT_THAT(folder.error().what, HasSubstr("wadconv, is not installed"));
}

TEST_F(Conversions, DoNotTakeThePlaceOfWhatIsSomebodyElses) {
    const std::string wad = write("g.wad", "levels"), folder = convert({wad});
    fs::remove_all(folder);
    write("cache/enfilade/converted/" + file_name_of(folder) + "/saved", "mine");
    EXPECT_FALSE(convert_by_ours({wad}).ok());
    EXPECT_EQ(test::content(folder + "/saved"), "mine");
}

TEST_F(Conversions, AreRemovedWhenThereAreManyAndTheyWereNotPlayedForLong) {
    std::vector<std::string> folders;
    for (std::size_t i = 0; i <= kMostConversions; ++i) {
        const std::string text = "levels " + std::to_string(i);
        folders.push_back(convert({write("g.wad", text)}));
        const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(1000 - i);
        fs::last_write_time(folders.back() + "/" + std::string(kFolderMark), long_ago);
        if (i + 1 == kMostConversions) convert({write("g.wad", "levels 0")});  // it was played now
    }
    EXPECT_EQ(kept_conversions().size(), kMostConversions);
    EXPECT_TRUE(fs::exists(folders[0]));
    EXPECT_FALSE(fs::exists(folders[1]));
    EXPECT_TRUE(fs::exists(folders.back()));
}

TEST_F(Conversions, AreListedByTheNamesOfTheirWads) {
    const std::string folder = convert({write("a.b\n.wad", "levels")});
    write("cache/enfilade/converted/yours/map01.toml", "mine");
    const auto kept = kept_conversions();
    ASSERT_EQ(kept.size(), 1u);
    EXPECT_EQ(kept[0].name, "a.b?");
    EXPECT_EQ(kept[0].folder, folder);
}

TEST_F(Conversions, TellWhatTakesTime) {
    std::vector<std::string> told;
    const std::string wad = write("g.wad", "levels");
    for (int i = 0; i < 2; ++i)
        ASSERT_TRUE(convert_by_ours({wad}, [&](const std::string& sentence) { told.push_back(sentence); }).ok());
    EXPECT_THAT(told, ElementsAre(HasSubstr("converting g")));
}

TEST_F(Conversions, HaveLevels) {
    const std::string folder = convert({write("g.wad", "levels")});
    const auto second = level_in(folder, "MAP02");
    ASSERT_TRUE(second.ok()) << second.error().text();
    EXPECT_EQ(second.value(), folder + "/map02.toml");
    const auto missing = level_in(folder, "E1M1");
    ASSERT_FALSE(missing.ok());
    EXPECT_THAT(missing.error().what, HasSubstr("there is no level E1M1; there are map01 to map02"));
    const auto none = level_in(convert({write("g.wad", "empty")}));
    ASSERT_FALSE(none.ok());
    EXPECT_THAT(none.error().what, HasSubstr("report.txt says why"));
}

TEST_F(Conversions, AreOfWadsByPathOrName) {
    const std::string wad = write("wads/doomed.wad", "PWAD"), other = write("here.wad", "IWAD");
    write("wads/doomed.txt", "PWAD");
    EXPECT_EQ(find_wad("doomed"), wad);
    EXPECT_EQ(find_wad("doomed.wad"), wad);
    EXPECT_EQ(find_wad(other), other);
    for (const std::string& word :
         {std::string("MAP01"), std::string(), write("map.toml", "format = 1\n"), dir_.path()})
        EXPECT_EQ(find_wad(word), std::nullopt) << word;
}

TEST(LevelNames, AreThoseOfDoom) {
    for (const char* name : {"MAP01", "map32", "E1M1", "e4m9", "Map07"}) EXPECT_TRUE(is_level_name(name)) << name;
    for (const char* name : {"", "MAP1", "MAP001", "E1", "EXMY", "E1M10", "freedoom2"})
        EXPECT_FALSE(is_level_name(name)) << name;
}

}  // namespace
}  // namespace enfilade
