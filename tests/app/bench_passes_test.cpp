// What two programs that took turns said: read from among other words, and compared.
#include "app/bench.h"

#include <gmock/gmock.h>

namespace enfilade {
namespace {

using ::testing::HasSubstr;

const std::string kHeader = "subject,frame,minimum_ns,median_ns,walls,runs,viewports,pixels,hash\n";

TEST(ReadPass, FindsTheRowsAmongOtherWords) {
    const auto pass = read_pass("p", "[ms] frames\na.toml 1 2, 3\n" + kHeader +
                                         "\"a, b\",3,40,50,1,2,3,4,00ff\nb,0,7,8,1,2,3,4,0001\ndone, really\n");
    ASSERT_TRUE(pass.ok());
    ASSERT_EQ(pass.value().size(), 2u);
    EXPECT_EQ(pass.value()[0].subject, "\"a, b\"");
    EXPECT_EQ(pass.value()[0].number, 3);
    EXPECT_EQ(pass.value()[0].ns, 40);
    EXPECT_EQ(pass.value()[0].hash, "00ff");
    EXPECT_EQ(pass.value()[1].ns, 7);
}

TEST(ReadPass, TakesRowsOfProgramsThatTellNoHashes) {
    const auto pass = read_pass("p", "subject,frame,minimum_ns,median_ns\na,0,5,6\n");
    ASSERT_TRUE(pass.ok());
    EXPECT_EQ(pass.value()[0].ns, 5);
    EXPECT_FALSE(pass.value()[0].hash);
}

TEST(ReadPass, SaysWhatItFoundWhereThereAreNoRows) {
    for (const std::string said :
         {"hello\nworld\n", "hello", "hello\nsubject,frame,minimum_ns,median_ns\na,-1,5,6\na,b\n"}) {
        const auto pass = read_pass("other", said);
        ASSERT_FALSE(pass.ok());
        EXPECT_THAT(pass.error().text(), HasSubstr("other: expected rows"));
        EXPECT_THAT(pass.error().text(), HasSubstr("'hello'"));
    }
    EXPECT_FALSE(read_pass("other", "").ok());
}

/// Two frames of "a" and one of "b", with these times.
std::vector<PassFrame> pass(std::int64_t a0, std::int64_t a1, std::int64_t b, const std::string& hash = "1") {
    return {{"a", 0, a0, "1"}, {"a", 1, a1, hash}, {"b", 0, b, "2"}};
}

TEST(ComparisonTable, TellsRatiosOfMinimaAndMedians) {
    const Passes ours{pass(1'000'000, 3'000'000, 9'000'000), pass(2'000'000, 3'000'000, 6'000'000)};
    const Passes theirs{pass(4'000'000, 4'000'000, 3'000'000), pass(5'000'000, 5'000'000, 3'000'000)};
    const std::string table = comparison_table({ours, theirs});
    EXPECT_THAT(table, HasSubstr("\na        2.000     2.000     4.000     4.000     0.500     0.500  the same\n"));
    EXPECT_THAT(table, HasSubstr("\nb        6.000     6.000     3.000     3.000     2.000     2.000  the same\n"));
    EXPECT_THAT(table, HasSubstr("\nmean                                             1.250     1.250\n"));
}

TEST(ComparisonTable, SaysWhichPicturesDiffer) {
    EXPECT_THAT(comparison_table({Passes{pass(1, 1, 1)}, Passes{pass(1, 1, 1, "x")}}), HasSubstr("1 of 2 differ\n"));
    std::vector<PassFrame> silent = pass(1, 1, 1);
    for (PassFrame& frame : silent) frame.hash.reset();
    EXPECT_THAT(comparison_table({Passes{pass(1, 1, 1)}, Passes{silent}}), HasSubstr("not told by both\n"));
}

TEST(CompareFrames, RefusesOtherFrames) {
    const std::array<std::string, 2> programs{"ours", "theirs"};
    EXPECT_TRUE(compare_frames(programs, {Passes{pass(1, 1, 1)}, Passes{pass(2, 2, 2)}}).ok());
    std::vector<PassFrame> fewer = pass(1, 1, 1);
    fewer.pop_back();
    const Result<void> result = compare_frames(programs, {Passes{pass(1, 1, 1)}, Passes{pass(1, 1, 1), fewer}});
    ASSERT_FALSE(result.ok());
    EXPECT_THAT(result.error().text(), HasSubstr("theirs: expected the 3 frames"));
}

}  // namespace
}  // namespace enfilade
