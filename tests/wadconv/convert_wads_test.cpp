// A whole run, down to the files it writes.
#include "wadconv/convert.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "app/cli/program.h"
#include "base/hash.h"
#include "map/load.h"
#include "support/temp_dir.h"
#include "wadconv/converted.h"
#include "wadconv/wad_builder.h"

namespace enfilade::wadconv {
namespace {

using namespace test;
using enfilade::test::TempDir;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A level that cannot be closed.
Level broken_level() {
    Level level;
    level.sector();
    level.line({0, 0}, {0, 64}, 0);
    level.line({64, 0}, {128, 0}, 0);
    return level;
}

/// A level in which something must be guessed: its gap is closed.
Level gappy_level() {
    Level level;
    level.sector();
    level.box(0, 0, 64, 64, 0);
    level.map.lines.pop_back();
    level.thing(32, 32, 1);
    return level;
}

/// WADs on disk and a folder to convert them into.
struct Bench {
    TempDir dir;
    RunOptions options;

    Bench() { options.out = dir.path("out"); }
    void add(const WadBuilder& wad, std::string_view magic = "IWAD") {
        options.wads.push_back(dir.path(std::to_string(options.wads.size()) + ".wad"));
        ASSERT_TRUE(write_file(options.wads.back(), wad.finish(magic)).ok());
    }
    Result<RunResult> run() {
        return convert_wads(options, [](std::size_t, std::size_t, std::size_t) {});
    }
    bool wrote(const std::string& file) const { return std::filesystem::exists(dir.path("out/" + file)); }
};

WadBuilder wad_with(const std::vector<std::pair<std::string, Level>>& maps) {
    WadBuilder wad = picture_wad();
    for (const auto& [name, level] : maps) wad.add_map(name, level.map);
    return wad;
}

TEST(ConvertWads, WritesMapsThatLoadWithoutAWord) {
    Bench bench;
    bench.add(wad_with({{"MAP01", small_level()}}));
    const auto result = bench.run();
    ASSERT_TRUE(result.ok()) << result.error().text();
    EXPECT_TRUE(result.value().is_complete());
    const LoadedMap loaded = load_map(bench.dir.path("out/map01.toml"), {}, read_file);
    for (const Finding& finding : loaded.findings) ADD_FAILURE() << finding.sentence;
    EXPECT_TRUE(loaded.map);
    EXPECT_TRUE(bench.wrote("sounds/doropn.wav"));
}

// hard case W15
TEST(ConvertWads, GivesTheSameBytesWithAnyNumberOfJobs) {
    Bench one, four;
    for (Bench* bench : {&one, &four})
        bench->add(wad_with({{"E1M1", small_level()}, {"E1M2", gappy_level()}, {"E1M3", broken_level()}}));
    four.options.jobs = 4;
    ASSERT_TRUE(one.run().ok());
    ASSERT_TRUE(four.run().ok());
    std::vector<std::string> compared;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(one.dir.path("out"))) {
        if (!entry.is_regular_file()) continue;
        compared.push_back(std::filesystem::relative(entry.path(), one.dir.path("out")).string());
        EXPECT_EQ(read_file(entry.path().string()).value(), read_file(four.dir.path("out/" + compared.back())).value())
            << compared.back();
    }
    EXPECT_GT(compared.size(), 10u);
}

/// All that the run wrote about the map.
std::string map_text(const Bench& bench) {
    const auto bytes = read_file(bench.dir.path("out/map01.toml"));
    return bytes.ok() ? std::string(as_text(bytes.value())) : "";
}

// What node builders made of the level is not looked at, whether it is right, rounded, damaged or not there.
// hard cases W1, W10
TEST(ConvertWads, DoesNotLookAtSegmentsNodesAndBlocks) {
    Bench without;
    without.add(wad_with({{"MAP01", small_level()}}));
    ASSERT_TRUE(without.run().ok());
    ASSERT_THAT(map_text(without), HasSubstr("[[sectors]]"));
    Random random(1);
    for (const std::size_t size : {0u, 1u, 12u, 4096u}) {
        WadBuilder wad = wad_with({{"MAP01", small_level()}});
        for (const char* lump : {"SEGS", "SSECTORS", "NODES", "REJECT", "BLOCKMAP"}) {
            Bytes noise(size);
            for (std::byte& b : noise) b = static_cast<std::byte>(random.bits());
            wad.add(lump, noise);
        }
        Bench with;
        with.add(wad);
        ASSERT_TRUE(with.run().ok());
        EXPECT_EQ(map_text(with), map_text(without)) << size;
    }
}

TEST(ConvertWads, ConvertsOnlyTheMapsAskedFor) {
    Bench bench;
    bench.add(wad_with({{"E1M1", small_level()}, {"E1M2", small_level()}}));
    bench.options.maps = {"e1m2"};
    ASSERT_TRUE(bench.run().ok());
    EXPECT_FALSE(bench.wrote("e1m1.toml"));
    EXPECT_TRUE(bench.wrote("e1m2.toml"));
}

TEST(ConvertWads, NamesAMapThatIsNotThere) {
    Bench bench;
    bench.add(wad_with({{"E1M1", small_level()}}));
    bench.options.maps = {"E9M9"};
    EXPECT_THAT(bench.run().error().text(), HasSubstr("no map 'E9M9'; the only one is E1M1"));
}

TEST(ConvertWads, RefusesOneMapAndConvertsTheOthers) {
    Bench bench;
    bench.add(wad_with({{"MAP01", broken_level()}, {"MAP02", small_level()}}));
    const RunResult result = bench.run().value();
    EXPECT_FALSE(result.is_complete());
    EXPECT_THAT(result.reports[0].refused, HasSubstr("sector 0 is not closed"));
    EXPECT_FALSE(bench.wrote("map01.toml"));
    EXPECT_TRUE(bench.wrote("map02.toml"));
}

TEST(ConvertWads, RefusesMapsThatDoNotPassTheCheck) {
    Level level;
    level.sector();
    level.sector();
    level.box(0, 0, 256, 256, 0);
    level.box(64, 64, 192, 192, 1, 0);
    level.box(96, 96, 128, 128, 1, 0);  // where sector 1 is on either side, it says that sector 0 is outside
    Bench bench;
    bench.add(wad_with({{"MAP01", level}}));
    EXPECT_THAT(bench.run().value().reports[0].refused, HasSubstr("not sound"));
    EXPECT_FALSE(bench.wrote("map01.toml"));
}

/// Two rooms with a doorway; the lines of the second cross.
Level crossed_level() {
    Level level;
    level.sector();
    level.sector();
    level.box(0, 0, 64, 64, 0);
    level.map.lines.pop_back();
    level.map.lines.erase(level.map.lines.begin() + 2);
    level.line({64, 0}, {0, 0}, 0);
    level.line({64, 64}, {64, 0}, 0, 1);
    level.line({64, 64}, {128, 0}, 1);
    level.line({128, 0}, {160, 96}, 1);
    level.line({160, 96}, {64, 0}, 1);
    level.thing(32, 32, 1);
    return level;
}

TEST(ConvertWads, LosesTheRoomWhoseLinesCrossAndNotTheLevel) {
    Bench bench;
    bench.add(wad_with({{"MAP01", crossed_level()}}));
    const RunResult result = bench.run().value();
    EXPECT_TRUE(result.is_complete());
    EXPECT_TRUE(bench.wrote("map01.toml"));
    const std::string report = to_text(result);
    EXPECT_THAT(report, HasSubstr("lines of one room that cross or lie on each other: 2."));
    EXPECT_THAT(report, HasSubstr("      lines 4, 6\n"));
    EXPECT_THAT(report, HasSubstr("rooms bounded by lines that cross: 1."));
    EXPECT_THAT(report, HasSubstr("      sector 1\n"));
    EXPECT_THAT(report, HasSubstr("doorways into rooms left out: 1."));
}

TEST(ConvertWads, RefusesToLoseRoomsWhenStrict) {
    Bench bench;
    bench.add(wad_with({{"MAP01", crossed_level()}}));
    bench.options.strict = true;
    EXPECT_THAT(bench.run().value().reports[0].refused, HasSubstr("rooms bounded by lines that cross: 1"));
    EXPECT_FALSE(bench.wrote("map01.toml"));
}

TEST(ConvertWads, RefusesALevelThatStartsInALostRoom) {
    Level level = crossed_level();
    level.map.things.clear();
    level.thing(32, 32, 2);  // another player's start does not do
    level.thing(120, 40, 1);
    Bench bench;
    bench.add(wad_with({{"MAP01", level}}));
    EXPECT_EQ(bench.run().value().reports[0].refused,
              "player 1 starts at (120, 40), in no room that is left: the rooms of sector 1 were left out, because "
              "lines cross there: 4 and 6");
}

TEST(ConvertWads, RefusesALevelWithoutARoomLeft) {
    Level level;
    level.sector();
    level.ring({{0, 0}, {96, 96}, {64, 0}, {0, 64}}, 0);
    Bench bench;
    bench.add(wad_with({{"MAP01", level}}));
    EXPECT_EQ(bench.run().value().reports[0].refused,
              "no room is left: the rooms of sector 0 were left out, because lines cross there: 0 and 2");
}

TEST(ConvertWads, RefusesGuessesOnlyWhenStrict) {
    Bench bench;
    bench.add(wad_with({{"MAP01", gappy_level()}}));
    EXPECT_EQ(bench.run().value().reports[0].refused, "");
    bench.options.strict = true;
    EXPECT_THAT(bench.run().value().reports[0].refused, HasSubstr("sectors that lack one line: 1"));
}

TEST(ConvertWads, LeavesOnlyTheReportWhereEveryMapIsRefused) {
    Bench bench;
    bench.add(wad_with({{"MAP01", gappy_level()}}));
    bench.options.strict = true;
    std::size_t steps = 0, of = 0;
    const auto result = convert_wads(bench.options, [&](std::size_t, std::size_t total, std::size_t) {
        ++steps;
        of = total;
    });
    ASSERT_TRUE(result.ok());
    EXPECT_EQ(steps, of);
    EXPECT_TRUE(bench.wrote("report.txt"));
    EXPECT_FALSE(bench.wrote("textures"));
    EXPECT_FALSE(bench.wrote("sounds"));
    EXPECT_EQ(written_text(result.value(), "out"), "No map was converted; out/report.txt says why\n");
}

TEST(ConvertWads, SaysWhatItWrote) {
    Bench bench;
    bench.add(wad_with({{"E1M1", small_level()}, {"E1M2", broken_level()}, {"E1M3", small_level()}}));
    const std::string& out = bench.options.out;
    EXPECT_EQ(written_text(bench.run().value(), out), "Written to " + out +
                                                          ": e1m1.toml, e1m3.toml, textures, sounds, report.txt\n"
                                                          "`enfilade play " +
                                                          out + "/e1m1.toml` walks through it\n");
}

TEST(ConvertWads, LaysAPatchOverTheIwad) {
    Bench bench;
    bench.add(wad_with({{"MAP01", broken_level()}}));
    WadBuilder above;
    above.add_map("MAP01", small_level().map);
    bench.add(above, "PWAD");
    EXPECT_TRUE(bench.run().value().is_complete());
}

TEST(ConvertWads, AsksForTheIwadWhereAPatchComesAlone) {
    Bench bench;
    WadBuilder wad;
    wad.add_map("MAP01", small_level().map);
    bench.add(wad, "PWAD");
    EXPECT_THAT(bench.run().error().text(), HasSubstr("give the IWAD too"));
}

TEST(ConvertWads, NamesAFileThatIsNotThere) {
    Bench bench;
    bench.options.wads = {bench.dir.path("none.wad")};
    EXPECT_THAT(bench.run().error().text(), HasSubstr("none.wad"));
}

TEST(ConvertWads, CountsItsStepsUpToTheTotal) {
    Bench bench;
    bench.add(wad_with({{"MAP01", small_level()}}));
    std::vector<std::size_t> steps;
    std::size_t of = 0;
    ASSERT_TRUE(convert_wads(bench.options, [&](std::size_t done, std::size_t total, std::size_t) {
                    steps.push_back(done);
                    of = total;
                }).ok());
    ASSERT_FALSE(steps.empty());
    EXPECT_EQ(steps.back(), of);
    EXPECT_EQ(steps.size(), of);
}

/// The program itself.
TEST(WadconvCommand, RefusesWrongUsageInOneSentence) {
    const enfilade::test::Program wadconv;
    const std::vector<std::vector<std::string>> wrong{
        {}, {"a.wad"}, {"--loud"}, {"a.wad", "--out", "o", "--jobs", "0"}};
    for (const auto& arguments : wrong) {
        const auto ended = wadconv.run(arguments);
        EXPECT_EQ(ended.exit_code, 2);
        EXPECT_THAT(ended.err, ::testing::MatchesRegex("wadconv: [^\n]+; see `wadconv --help`\n"));
    }
}

/// The program with a WAD of that level, which it converts into the folder "out".
enfilade::test::Ended convert_level(const Level& level, std::vector<std::string> options,
                                    const enfilade::test::Program& wadconv) {
    (void)write_file(wadconv.path("doom.wad"), wad_with({{"MAP01", level}}).finish("IWAD"));
    options.insert(options.begin(), {"doom.wad", "--out", "out", "--jobs", "1"});
    return wadconv.run(options);
}

TEST(WadconvCommand, TellsWhatItIs) {
    const enfilade::test::Program wadconv;
    EXPECT_THAT(wadconv.run({"--help"}).out, HasSubstr("--open-doors"));
    EXPECT_THAT(wadconv.run({"--version"}).out, ::testing::MatchesRegex("wadconv [0-9.]+\n"));
}

TEST(WadconvCommand, RefusesGuessesWithStrict) {
    const enfilade::test::Program wadconv;
    EXPECT_EQ(convert_level(gappy_level(), {}, wadconv).exit_code, 0);
    const auto strict = convert_level(gappy_level(), {"--strict"}, wadconv);
    EXPECT_EQ(strict.exit_code, 1);
    EXPECT_THAT(strict.err, HasSubstr("strict conversion refuses"));
}

TEST(WadconvCommand, TellsEveryMapWithVerbose) {
    const enfilade::test::Program wadconv;
    const std::string plain = convert_level(small_level(), {"--map", "MAP01"}, wadconv).out;
    const std::string verbose = convert_level(small_level(), {"--map", "MAP01", "--verbose"}, wadconv).out;
    EXPECT_THAT(verbose, HasSubstr("line specials (number x times)"));
    EXPECT_GT(verbose.size(), plain.size());
}

TEST(WadconvCommand, RaisesDoorsWithOpenDoors) {
    const enfilade::test::Program wadconv;
    Doorway doorway(0, 0);
    doorway.line().special = 1;
    const Level& door = doorway.level;
    convert_level(door, {}, wadconv);
    const std::string closed = wadconv.text("out/map01.toml");
    EXPECT_EQ(convert_level(door, {"--open-doors"}, wadconv).exit_code, 0);
    EXPECT_NE(closed, "");
    EXPECT_NE(wadconv.text("out/map01.toml"), closed);
}

TEST(ReportText, TellsNumbersByKind) {
    Bench bench;
    bench.add(wad_with({{"MAP01", small_level()}, {"MAP02", gappy_level()}}));
    const std::string text = to_text(bench.run().value());
    EXPECT_THAT(text, HasSubstr("2 maps converted, 0 refused"));
    EXPECT_THAT(text, HasSubstr("sectors that lack one line: 1. Closed by"));
    EXPECT_THAT(text, HasSubstr("      sector 0\n"));
    EXPECT_THAT(text, HasSubstr("line specials (number x times): 97x1"));
    EXPECT_THAT(text, HasSubstr("COLORMAP's 32 levels of light are within 1 %"));
}

}  // namespace
}  // namespace enfilade::wadconv
