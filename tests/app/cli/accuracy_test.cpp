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
    std::string csv = program_.text("report/accuracy.csv");
    EXPECT_THAT(csv, HasSubstr("\nmap,random,exact,0,"));
    EXPECT_EQ(accuracy({"map.toml", "--verify", "report/accuracy.csv"}).exit_code, 0);
    csv.replace(csv.find("exact,0,"), 8, "exact,0,1");
    program_.write("other.csv", csv);
    const Ended other = accuracy({"map.toml", "--verify", "other.csv"});
    EXPECT_EQ(other.exit_code, 1);
    EXPECT_THAT(other.err, HasSubstr("other.csv:2: expected map,random,exact,0,"));
}

TEST_F(Accuracy, RefusesAMapWithErrorsAndWritesNothing) {
    program_.write("broken.toml", "format = 1\n");
    const Ended ended = accuracy({"broken.toml", "--out", "report"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_FALSE(program_.exists("report"));
}

}  // namespace
}  // namespace enfilade
