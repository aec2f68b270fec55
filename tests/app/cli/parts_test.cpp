// A flythrough recorded in parts, as many machines would: the same bytes as in one piece, or a sentence.
#include <gmock/gmock.h>

#include "app/cli/program.h"

namespace enfilade {
namespace {

using test::Ended;
using test::Program;
using ::testing::HasSubstr;

/// Eleven frames.
constexpr const char* kWalkInParts = R"(map = "map.toml"
size = [64, 40]
rate = 10
[[legs]]
seconds = 1
to = [6, 3]
)";

const std::vector<std::string> kFiles{"walk.hashes", "walk.sheet.png", "walk.frames/000000.png",
                                      "walk.frames/000004.png", "walk.frames/000008.png"};

class Parts : public ::testing::Test {
protected:
    Parts() {
        program_.write("map.toml", test::kTwoRooms);
        program_.write("walk.toml", kWalkInParts);
    }

    Ended fly(std::vector<std::string> more) const {
        more.insert(more.begin(), {"fly", "walk.toml"});
        return program_.run(more);
    }

    void record(int count, const std::vector<std::string>& options) const {
        for (int number = count; number >= 1; --number) {
            std::vector<std::string> more{"--record", "--part", std::to_string(number) + "/" + std::to_string(count)};
            more.insert(more.end(), options.begin(), options.end());
            EXPECT_EQ(fly(more).exit_code, 0);
        }
    }

    std::vector<std::string> texts() const {
        std::vector<std::string> all;
        for (const std::string& file : kFiles) all.push_back(program_.text(file));
        return all;
    }

    Program program_;
};

TEST_F(Parts, AreTogetherTheSameBytesAsTheWhole) {
    fly({"--record", "--keep", "4"});
    const std::vector<std::string> whole = texts();
    for (const std::string& text : whole) EXPECT_NE(text, "");
    for (const int count : {1, 2, 3, 8, 11}) {
        for (const std::string& file : kFiles) std::filesystem::remove(program_.path(file));
        record(count, {"--keep", "4"});
        if (count > 1) {
            EXPECT_FALSE(program_.exists("walk.hashes"));
            EXPECT_EQ(fly({"--merge"}).exit_code, 0);
        }
        EXPECT_EQ(texts(), whole) << count;
        for (const auto& entry : std::filesystem::directory_iterator(program_.path("")))
            EXPECT_THAT(entry.path().string(), Not(HasSubstr(".part-")));
        EXPECT_EQ(fly({"--check"}).exit_code, 0);
    }
}

TEST_F(Parts, MayBeNamedByTheirFrames) {
    fly({"--record", "--frames", "0..3"});
    fly({"--record", "--frames", "4..10"});
    EXPECT_EQ(fly({"--merge"}).exit_code, 0);
    EXPECT_EQ(fly({"--check"}).exit_code, 0);
}

TEST_F(Parts, WithoutPicturesTakeAwayThoseThatWereKept) {
    fly({"--record", "--keep", "4"});
    record(2, {"--no-pictures"});
    EXPECT_EQ(fly({"--merge"}).exit_code, 0);
    EXPECT_FALSE(program_.exists("walk.sheet.png"));
    EXPECT_FALSE(program_.exists("walk.frames/000004.png"));
}

TEST_F(Parts, MustBeAllThere) {
    fly({"--record", "--part", "1/3"});
    fly({"--record", "--part", "3/3"});
    const Ended ended = fly({"--merge"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.err, HasSubstr("the parts lack the frames 3..6; draw them with --record --frames 3..6"));
    EXPECT_FALSE(program_.exists("walk.hashes"));
    fly({"--record", "--frames", "3..6"});
    EXPECT_EQ(fly({"--merge"}).exit_code, 0);
    EXPECT_THAT(fly({"--merge"}).err, HasSubstr("lack the frames 0..10"));
}

TEST_F(Parts, MustBeOfOneRecording) {
    record(2, {});
    fly({"--record", "--part", "2/2", "--size", "32x20"});
    EXPECT_THAT(fly({"--merge"}).err, HasSubstr("its pictures have another size"));
    fly({"--record", "--part", "2/2", "--no-pictures"});
    EXPECT_THAT(fly({"--merge"}).err, HasSubstr("only one has small pictures"));
    fly({"--record", "--part", "2/2"});
    fly({"--record", "--frames", "2..2"});
    EXPECT_THAT(fly({"--merge"}).err, HasSubstr("another part has frame 2, too"));
    std::filesystem::remove(program_.path("walk.part-000002-000002.hashes"));
    program_.write("walk.part-000000-000004.sheet.png", "no picture");
    EXPECT_THAT(fly({"--merge"}).err, HasSubstr("cannot be read"));
    EXPECT_FALSE(program_.exists("walk.hashes"));
}

TEST_F(Parts, WithPicturesOfNoSizeAreRefused) {
    record(2, {});
    const std::string name = "walk.part-000000-000004.hashes", text = program_.text(name);
    for (const std::string size : {"4294967295x4294967295", "4294967295x1", "2147483648x2147483648", "16385x1"}) {
        std::string other = text;
        other.replace(other.find("64x40"), 5, size);
        program_.write(name, other);
        const Ended ended = fly({"--merge"});
        EXPECT_EQ(ended.exit_code, 1);
        EXPECT_THAT(ended.err, HasSubstr(name + ":2:1: expected \"picture WIDTHxHEIGHT RENDERER\""));
    }
}

TEST_F(Parts, OfAFilmAreItsFrames) {
    fly({"--out", "whole"});
    fly({"--out", "parts", "--part", "1/2"});
    EXPECT_FALSE(program_.exists("parts/000005.png"));
    fly({"--out", "parts", "--part", "2/2"});
    for (const char* name : {"000000.png", "000005.png", "000010.png"})
        EXPECT_EQ(program_.text("parts/" + std::string(name)), program_.text("whole/" + std::string(name)));
}

TEST_F(Parts, RefusesWhatMakesNoSense) {
    const std::vector<std::vector<std::string>> wrong{{"--record", "--part", "0/2"},
                                                      {"--record", "--part", "3/2"},
                                                      {"--record", "--part", "1"},
                                                      {"--record", "--part", "1/2x"},
                                                      {"--out", "f", "--part", "1/12"},
                                                      {"--merge", "--record"},
                                                      {"--merge", "--check"},
                                                      {"--merge", "--out", "f"},
                                                      {"--record", "--part", "1/2", "--frames", "0..1"}};
    for (const auto& arguments : wrong) EXPECT_EQ(fly(arguments).exit_code, 2) << ::testing::PrintToString(arguments);
}

}  // namespace
}  // namespace enfilade
