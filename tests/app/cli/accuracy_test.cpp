// `enfilade accuracy` from outside.
#include <gmock/gmock.h>

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

TEST_F(Accuracy, RefusesAMapWithErrorsAndWritesNothing) {
    program_.write("broken.toml", "format = 1\n");
    const Ended ended = accuracy({"broken.toml", "--out", "report"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_FALSE(program_.exists("report"));
}

}  // namespace
}  // namespace enfilade
