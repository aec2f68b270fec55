// `enfilade accuracy` from outside.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "app/cli/program.h"

namespace enfilade {
namespace {

using test::Ended;
using test::Program;
using ::testing::HasSubstr;

class Accuracy : public ::testing::Test {
protected:
    Ended accuracy(const std::vector<std::string>& more) const {
        std::vector<std::string> arguments{"accuracy", "--quick"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return program_.run(arguments);
    }

    Program program_;
};

TEST_F(Accuracy, KeepsEveryPromiseInTheShippedRooms) {
    const Ended ended = accuracy({});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("0 show another surface than the reference"));
    EXPECT_THAT(ended.out, HasSubstr("| `exact` |"));
}

TEST_F(Accuracy, WritesAReportAndFindsItsErrorsAgain) {
    program_.write("map.toml", test::kTwoRooms);
    ASSERT_EQ(accuracy({"map.toml", "--out", "report"}).exit_code, 0);
    EXPECT_THAT(program_.text("report/README.md"), HasSubstr("# What accuracy costs in time"));
    EXPECT_THAT(program_.text("report/accuracy.gp"), HasSubstr("set logscale y"));
    EXPECT_TRUE(program_.exists("report/crops/span-16.png"));
    EXPECT_THAT(program_.text("report/accuracy.csv"), HasSubstr("\nmap,random,exact,0,"));
    EXPECT_EQ(accuracy({"map.toml", "--verify", "report/report.json"}).exit_code, 0);
    std::string report = program_.text("report/report.json");
    report.replace(report.find("\"judged\": "), 10, "\"judged\": 1");
    program_.write("other.json", report);
    const Ended other = accuracy({"map.toml", "--verify", "other.json"});
    EXPECT_EQ(other.exit_code, 1);
    EXPECT_THAT(other.err, HasSubstr("other.json: expected of map, random poses, exact the errors"));
}

TEST_F(Accuracy, GoesOnWhereItWasCutOff) {
    program_.write("map.toml", test::kTwoRooms);
    program_.write("more.toml", test::kTwoRooms);
    ASSERT_EQ(accuracy({"map.toml", "--out", "report"}).exit_code, 0);
    const auto times_of_map = [&] {
        const std::string csv = program_.text("report/accuracy.csv");
        return csv.substr(csv.find("\nmap,"), csv.find("\nmore,") - csv.find("\nmap,"));
    };
    const std::string before = times_of_map();
    ASSERT_EQ(accuracy({"map.toml", "more.toml", "--out", "report", "--resume"}).exit_code, 0);
    EXPECT_EQ(times_of_map() + "\n", before);
    EXPECT_THAT(program_.text("report/report.json"), HasSubstr("\"name\": \"more\""));
    EXPECT_THAT(accuracy({"map.toml", "--resume"}).err, HasSubstr("--resume: expected --out DIR"));
}

constexpr const char* kPlain = R"(format = 1
name = "Plain"

[player]
sector = "plain"
x = 2
y = 3

[[sectors]]
name = "plain"
floor = { z = 0, texture = "boards" }
ceiling = { z = 300, texture = "boards" }
[[sectors.loops]]
v = [0, 0,  4000, 0,  4000, 4000,  0, 4000]
walls = [{ texture = "boards" }, { texture = "boards" }, { texture = "boards" }, { texture = "boards" }]
)";

// Four kilometres of planks: exact is as exact there.
TEST_F(Accuracy, IsExactUpToTheHorizon) {
    program_.write("plain.toml", kPlain);
    const Ended ended = accuracy({"plain.toml", "--textures", ENFILADE_SOURCE_DIR "/maps/textures", "--out", "report"});
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
    const nlohmann::json report = nlohmann::json::parse(program_.text("report/report.json"));
    for (const nlohmann::json& row : report["scenes"][0]["rows"]) {
        if (row["setting"] != "exact") continue;
        EXPECT_LT(row["errors"]["largest"], 1e-5);
        EXPECT_GT(row["errors"]["judged"], 10'000);
        EXPECT_EQ(row["errors"]["wrong_ids"], 0);
    }
}

TEST_F(Accuracy, ScoresPicturesOfOthers) {
    program_.write("map.toml", test::kTwoRooms);
    ASSERT_EQ(accuracy({"map.toml", "--export", "truth"}).exit_code, 0);
    EXPECT_THAT(program_.text("truth/map/views.csv"), HasSubstr("x,y,z,yaw,pitch\n"));
    EXPECT_THAT(accuracy({"map.toml", "--score", "truth"}).out, HasSubstr("\n| map | 999.00 | 1.0000 | 0.0 |\n"));
    const Ended drawn = program_.run({"render", "map.toml", "--views", "truth/map/views.csv", "--size", "160x100",
                                      "--out", "mine/map/colors", "--ids", "mine/map/ids"});
    ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
    const Ended scored = accuracy({"map.toml", "--score", "mine"});
    EXPECT_THAT(scored.out, HasSubstr(" | 0.0 |\n"));
    EXPECT_EQ(scored.out.find("999.00"), scored.out.npos);
    program_.write("mine/map/colors/000001.png", "no picture");
    EXPECT_THAT(accuracy({"map.toml", "--score", "mine"}).err, HasSubstr("mine/map/colors/000001.png"));
    EXPECT_EQ(accuracy({"map.toml", "--score", "nobody"}).exit_code, 1);
    EXPECT_EQ(accuracy({"map.toml", "--score", "mine", "--export", "truth"}).exit_code, 2);
}

TEST_F(Accuracy, RefusesAMapWithErrorsAndWritesNothing) {
    program_.write("broken.toml", "format = 1\n");
    const Ended ended = accuracy({"broken.toml", "--out", "report"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_FALSE(program_.exists("report"));
}

}  // namespace
}  // namespace enfilade
