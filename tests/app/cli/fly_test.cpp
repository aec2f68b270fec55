// `enfilade fly` from outside.
#include <gmock/gmock.h>

#include <csignal>

#include "app/cli/program.h"
#include "formats/tape.h"

namespace enfilade {
namespace {

using test::Ended;
using test::Program;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A second of walking at ten frames a second: eleven frames.
constexpr const char* kWalk = R"(map = "map.toml"
size = [64, 40]
rate = 10
[[legs]]
seconds = 1
to = [6, 3]
)";

class Fly : public ::testing::Test {
protected:
    Fly() {
        program_.write("map.toml", test::kTwoRooms);
        program_.write("walk.toml", kWalk);
    }

    Ended fly(std::vector<std::string> more) const {
        more.insert(more.begin(), {"fly", "walk.toml"});
        return program_.run(more);
    }

    Program program_;
};

TEST_F(Fly, DrawsEveryFrame) {
    EXPECT_EQ(fly({"--out", "frames"}).exit_code, 0);
    EXPECT_TRUE(program_.exists("frames/000000.png"));
    EXPECT_TRUE(program_.exists("frames/000010.png"));
    EXPECT_FALSE(program_.exists("frames/000011.png"));
}

TEST_F(Fly, DrawsAPartAsPartOfTheWhole) {
    fly({"--out", "all"});
    fly({"--out", "part", "--frames", "4..5"});
    EXPECT_FALSE(program_.exists("part/000003.png"));
    EXPECT_EQ(program_.text("part/000004.png"), program_.text("all/000004.png"));
}

TEST_F(Fly, LeavesThingsOut) {
    fly({"--out", "empty"});
    program_.write("map.toml",
                   test::kTwoRooms + std::string("\n[[things]]\nx = 4\ny = 3\nlight = 0.2\n"
                                                 "frames = [{ texture = \"statue\", origin = [32, 64] }]\n"));
    fly({"--out", "whole"});
    EXPECT_EQ(fly({"--no-things", "--out", "without"}).exit_code, 0);
    EXPECT_NE(program_.text("whole/000000.png"), program_.text("without/000000.png"));
    EXPECT_EQ(program_.text("empty/000000.png"), program_.text("without/000000.png"));
}

TEST_F(Fly, ShowsTheThingsOfTheSkill) {
    program_.write("map.toml",
                   test::kTwoRooms + std::string("\n[[things]]\nx = 4\ny = 3\nskills = [5]\nlight = 0.2\n"
                                                 "frames = [{ texture = \"statue\", origin = [32, 64] }]\n"));
    fly({"--out", "usual"});
    EXPECT_EQ(fly({"--skill", "5", "--out", "hard"}).exit_code, 0);
    EXPECT_NE(program_.text("usual/000000.png"), program_.text("hard/000000.png"));
}

TEST_F(Fly, DrawsByTheDialsThatAreGiven) {
    fly({"--out", "exact"});
    EXPECT_EQ(fly({"--out", "wide", "--samples", "2", "--dial", "light=bands"}).exit_code, 0);
    EXPECT_NE(program_.text("wide/000005.png"), program_.text("exact/000005.png"));
    EXPECT_EQ(fly({"--out", "promised", "--accuracy", "exact"}).exit_code, 0);
    EXPECT_EQ(program_.text("promised/000005.png"), program_.text("exact/000005.png"));
    for (const char* option : {"--dial", "--accuracy"}) EXPECT_EQ(fly({"--out", "f", option, "nonsense"}).exit_code, 2);
}

TEST_F(Fly, HoldsOnlyWholeFramesToTheRecord) {
    fly({"--record"});
    for (const char* option : {"--no-things", "--still-light"}) {
        EXPECT_EQ(fly({"--record", option}).exit_code, 2);
        const Ended ended = fly({"--check", option});
        EXPECT_EQ(ended.exit_code, 2);
        EXPECT_THAT(ended.err, HasSubstr(option));
        EXPECT_EQ(fly({"--check", option, "--against", "reference"}).exit_code, 0);
    }
}

TEST_F(Fly, FilmsAsY4m) {
    EXPECT_EQ(fly({"--out", "walk.y4m"}).exit_code, 0);
    const std::string film = program_.text("walk.y4m");
    EXPECT_THAT(film, StartsWith("YUV4MPEG2 W64 H40 F10:1 "));
    EXPECT_EQ(film.size(), film.find('\n') + 1 + 11 * (6 + 3 * 64 * 40));
    EXPECT_EQ(program_.hidden_files(), 0u);
}

TEST_F(Fly, FilmsIntoAStream) {
    fly({"--out", "walk.y4m"});
    for (const char* stream : {"-", "/dev/stdout"})
        EXPECT_TRUE(fly({"--out", stream}).out == program_.text("walk.y4m")) << stream;
}

TEST_F(Fly, FilmsAsMp4) {
    if (std::system("command -v ffmpeg >/dev/null") != 0) GTEST_SKIP() << "ffmpeg is not installed";
    EXPECT_EQ(fly({"--out", "walk.mp4"}).exit_code, 0);
    EXPECT_THAT(program_.text("walk.mp4").substr(0, 12), HasSubstr("ftyp"));
    EXPECT_EQ(program_.hidden_files(), 0u);
}

TEST_F(Fly, LeavesTheFilmOfBeforeWhereItIsStopped) {
    program_.write("walk.toml", std::string(kWalk) + "[[legs]]\nwait = 3600\n");
    program_.write("walk.y4m", "the film of before");
    const Ended ended = program_.run_other("sh", {"-c",
                                                  "\"$0\" fly walk.toml --out walk.y4m & "
                                                  "while kill -0 $! && ! ls .enfilade-*.part; do sleep 0.01; done; "
                                                  "kill $!; wait $!",
                                                  ENFILADE_PROGRAM});
    EXPECT_EQ(ended.exit_code, 128 + SIGTERM);
    EXPECT_EQ(program_.text("walk.y4m"), "the film of before");
    EXPECT_EQ(program_.hidden_files(), 0u);
}

TEST_F(Fly, SaysThatAnMp4NeedsFfmpeg) {
    const Ended ended = program_.run({"fly", "walk.toml", "--out", "walk.mp4"}, "PATH=/nowhere");
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.err, HasSubstr("ffmpeg"));
    EXPECT_FALSE(program_.exists("walk.mp4"));
}

TEST_F(Fly, ChecksWhatItRecorded) {
    EXPECT_EQ(fly({"--record"}).exit_code, 0);
    EXPECT_TRUE(program_.exists("walk.hashes"));
    EXPECT_EQ(fly({"--check"}).exit_code, 0);
    EXPECT_EQ(fly({"--check", "--frames", "3..7", "--threads", "3"}).exit_code, 0);
}

TEST_F(Fly, ReportsFramesThatChanged) {
    fly({"--record", "--keep", "5"});
    program_.write("walk.toml", std::string(kWalk) + "pitch = 10\n");
    const Ended ended = fly({"--check", "--out", "report"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.err, HasSubstr("10 of 11 frames differ, frame 1 first"));
    EXPECT_THAT(program_.text("report/index.html"), HasSubstr("as it was recorded"));
    for (const char* what : {"expected", "actual", "difference"})
        EXPECT_TRUE(program_.exists("report/000005-" + std::string(what) + ".png")) << what;
}

/// kTwoRooms with its walls' picture at another size.
std::string other_walls() {
    std::string map = test::kTwoRooms;
    for (std::size_t at = 0; (at = map.find("\"wall\"", at)) != std::string::npos;) map.replace(at, 6, "\"wall 3,3\"");
    return map;
}

TEST_F(Fly, ShowsWhatAChangedMapLookedLike) {
    fly({"--record"});
    EXPECT_TRUE(program_.exists("walk.sheet.png"));
    program_.write("map.toml", other_walls());
    const Ended ended = fly({"--check", "--out", "report"});
    EXPECT_THAT(ended.err, HasSubstr("11 of 11 frames differ, frame 0 first"));
    const std::string page = program_.text("report/index.html");
    EXPECT_THAT(page, HasSubstr("as it was recorded"));
    EXPECT_THAT(page, ::testing::Not(HasSubstr(">0 of ")));
    EXPECT_NE(program_.text("report/000005-expected.png"), program_.text("report/000005-actual.png"));
}

TEST_F(Fly, LeavesNothingOfAnEarlierReport) {
    fly({"--record"});
    program_.write("map.toml", other_walls());
    fly({"--check", "--out", "report"});
    program_.write("report/notes.txt", "mine");
    fly({"--check", "--frames", "3..3", "--out", "report"});
    EXPECT_TRUE(program_.exists("report/000003-actual.png"));
    EXPECT_FALSE(program_.exists("report/000000-actual.png"));
    fly({"--record"});
    EXPECT_EQ(fly({"--check", "--out", "report"}).exit_code, 0);
    EXPECT_FALSE(program_.exists("report/000003-actual.png"));
    EXPECT_FALSE(program_.exists("report/index.html"));
    EXPECT_EQ(program_.text("report/notes.txt"), "mine") << "what is not the report's stays";
}

TEST_F(Fly, ShowsSmallPicturesOfLargeFrames) {
    fly({"--record", "--size", "320x200"});
    program_.write("map.toml", other_walls());
    fly({"--check", "--size", "320x200", "--out", "report"});
    const std::string page = program_.text("report/index.html");
    EXPECT_THAT(page, HasSubstr("as it was recorded, 4 times smaller"));
    EXPECT_THAT(page, HasSubstr(" of 4000 pixels differ"));
    EXPECT_LT(program_.text("report/000005-expected.png").size(), program_.text("report/000005-actual.png").size());
}

TEST_F(Fly, SaysWhenSmallPicturesAreAlikeThoughFramesDiffer) {
    fly({"--record", "--size", "320x200"});
    std::string hashes = program_.text("walk.hashes");
    const std::size_t first_hash = hashes.find("\n0 ") + 3;
    hashes[first_hash] = hashes[first_hash] == '0' ? '1' : '0';
    program_.write("walk.hashes", hashes);
    EXPECT_THAT(fly({"--check", "--size", "320x200", "--out", "report"}).err, HasSubstr("1 of 11 frames differ"));
    EXPECT_THAT(program_.text("report/index.html"), HasSubstr(">0 of 4000 pixels differ"));
}

TEST_F(Fly, ChecksARecordingWithoutPicturesAndSaysWhatIsMissing) {
    fly({"--record", "--no-pictures"});
    EXPECT_FALSE(program_.exists("walk.sheet.png"));
    EXPECT_EQ(fly({"--check"}).exit_code, 0);
    program_.write("map.toml", other_walls());
    const Ended ended = fly({"--check", "--out", "report"});
    EXPECT_THAT(ended.err, HasSubstr("The recording has no small pictures of its frames."));
    EXPECT_THAT(program_.text("report/index.html"), HasSubstr("no picture of this frame was kept"));
    EXPECT_TRUE(program_.exists("report/000003-actual.png"));
    EXPECT_FALSE(program_.exists("report/000003-expected.png"));
}

TEST_F(Fly, KeepsThePicturesOfARecordingUntilTheNextOneIsThere) {
    ASSERT_EQ(fly({"--record", "--keep", "5"}).exit_code, 0);
    const std::string kept = "walk.frames/000005.png", sheet = program_.text("walk.sheet.png");
    ASSERT_TRUE(program_.exists(kept));
    std::filesystem::rename(program_.path("walk.hashes"), program_.path("hashes"));
    std::filesystem::create_directories(program_.path("walk.hashes/full"));
    EXPECT_EQ(fly({"--record", "--no-pictures"}).exit_code, 1) << "the hashes cannot be put in their place";
    EXPECT_TRUE(program_.exists(kept));
    EXPECT_EQ(program_.text("walk.sheet.png"), sheet);
}

TEST_F(Fly, RemovesPicturesThatAreNotWantedAnyMore) {
    fly({"--record", "--keep", "5"});
    fly({"--record", "--no-pictures"});
    EXPECT_FALSE(program_.exists("walk.sheet.png"));
    EXPECT_FALSE(program_.exists("walk.frames/000005.png"));
}

TEST_F(Fly, TakesNoPictureOfAnotherRecordingForExpected) {
    fly({"--record", "--keep", "5"});
    const std::string sheet = program_.text("walk.sheet.png"), frame = program_.text("walk.frames/000005.png");
    program_.write("walk.toml", std::string(kWalk) + "pitch = 10\n");
    fly({"--record"});
    program_.write("walk.sheet.png", sheet);
    program_.write("walk.frames/000005.png", frame);
    program_.write("map.toml", other_walls());
    const Ended ended = fly({"--check", "--out", "report"});
    EXPECT_THAT(ended.err, HasSubstr("walk.sheet.png are of another recording"));
    EXPECT_FALSE(program_.exists("report/000005-expected.png"));
    EXPECT_TRUE(program_.exists("report/000010-expected.png"));
}

TEST_F(Fly, SaysWhichPicturesItCannotRead) {
    fly({"--record"});
    program_.write("walk.sheet.png", "no picture");
    program_.write("map.toml", other_walls());
    const Ended ended = fly({"--check", "--out", "report"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.err, HasSubstr("walk.sheet.png: not a PNG image"));
}

TEST_F(Fly, KeepsPicturesForTheEyeAndRenewsThem) {
    fly({"--record", "--keep", "5"});
    const std::string before = program_.text("walk.frames/000010.png");
    EXPECT_NE(before, "");
    EXPECT_FALSE(program_.exists("walk.frames/000001.png"));
    program_.write("walk.toml", std::string(kWalk) + "pitch = 10\n");
    fly({"--record"});
    EXPECT_NE(program_.text("walk.frames/000010.png"), before);
    fly({"--record", "--keep", "4"});
    EXPECT_FALSE(program_.exists("walk.frames/000010.png"));
}

TEST_F(Fly, RefusesToCheckAgainstTheRecordOfAnotherLength) {
    fly({"--record"});
    program_.write("walk.toml", std::string(kWalk) + "[[legs]]\nwait = 1\n");
    const Ended ended = fly({"--check"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.err, HasSubstr("21 frames"));
}

TEST_F(Fly, RefusesToCheckAgainstTheRecordOfAnotherSizeOrRenderer) {
    fly({"--record"});
    const Ended larger = fly({"--check", "--size", "32x20"}), other = fly({"--check", "--renderer", "reference"});
    EXPECT_EQ(larger.exit_code, 1);
    EXPECT_THAT(larger.err, HasSubstr("the recording has pictures of 64x40 pixels, and these have 32x20"));
    EXPECT_EQ(other.exit_code, 1);
    EXPECT_THAT(other.err, HasSubstr("drawn by the column renderer, and these pictures are by reference"));
}

TEST_F(Fly, ChecksARecordOfAnotherSizeThanTheScripts) {
    fly({"--record", "--size", "32x20"});
    EXPECT_EQ(fly({"--check", "--size", "32x20"}).exit_code, 0);
}

TEST_F(Fly, SaysWhatAFileIsThatIsNoScript) {
    const Tape tape{"map.toml", 0, 60, false, {}, 0};
    (void)write_file(program_.path("walk.tape"), write_tape(tape));
    const auto said = [&](const std::string& file) { return program_.run({"fly", file, "--out", "frames"}).err; };
    EXPECT_THAT(said("walk.tape"), HasSubstr("found a tape or saved game of map.toml; `enfilade play map.toml --load"));
    EXPECT_THAT(said("walk.tape"), HasSubstr("map = \"map.toml\" and tape = \"walk.tape\""));
    EXPECT_THAT(said("map.toml"),
                HasSubstr("expected a flythrough script (.toml), found a map; `enfilade play map.toml`"));
    EXPECT_THAT(said("wakl.toml"), HasSubstr("wakl.toml: no such file; did you mean walk.toml?"));
    EXPECT_THAT(said("b.toml"), ::testing::Not(HasSubstr("did you mean")))
        << "that both end in .toml makes no likeness";
}

TEST_F(Fly, OffersOnlyWhatItTakes) {
    for (const char* path : {"f.avi", "f.png"})
        EXPECT_THAT(
            fly({"--out", path}).err,
            HasSubstr("expected a folder for many pictures, or a .mp4 or .y4m film; found '" + std::string(path)));
}

TEST_F(Fly, KnowsAFilmWhateverTheCaseOfItsEnding) {
    EXPECT_EQ(fly({"--out", "walk.Y4M"}).exit_code, 0);
    EXPECT_THAT(program_.text("walk.Y4M"), StartsWith("YUV4MPEG2"));
}

TEST_F(Fly, SaysHowToMakeARecord) {
    const Ended ended = fly({"--check"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.err, HasSubstr("--record"));
}

TEST_F(Fly, ComparesRenderers) {
    // A frame may differ in the texels that an edge falls on exactly: the start stands on the grid.
    EXPECT_EQ(fly({"--check", "--against", "reference", "--tolerance", "100"}).exit_code, 0);
    EXPECT_EQ(fly({"--check", "--against", "column"}).exit_code, 0);
}

TEST_F(Fly, PointsAtTheLegThatRunsIntoAWall) {
    program_.write("walk.toml", "map = \"map.toml\"\n[[legs]]\nseconds = 1\nto = [2, 9]\n");
    const Ended ended = fly({"--out", "frames"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.err, HasSubstr("walk.toml:2:1: error: leg 1"));
    EXPECT_FALSE(program_.exists("frames"));
}

TEST_F(Fly, RefusesWhatMakesNoSense) {
    const std::vector<std::vector<std::string>> wrong{{},
                                                      {"--check", "--record"},
                                                      {"--against", "reference", "--out", "f"},
                                                      {"--keep", "3", "--out", "f"},
                                                      {"--no-pictures", "--out", "f"},
                                                      {"--record", "--keep", "3", "--no-pictures"},
                                                      {"--record", "--out", "f"},
                                                      {"--check", "--tolerance", "1"},
                                                      {"--check", "--out", "f.mp4"},
                                                      {"--out", "f", "--frames", "5..99"},
                                                      {"--out", "f.webm"},
                                                      {"--out", "f.png"},
                                                      {"--out", "f", "--renderer", "vulkan"}};
    for (const auto& arguments : wrong) EXPECT_EQ(fly(arguments).exit_code, 2);
}

}  // namespace
}  // namespace enfilade
