// Result, Result<void> and Error: a value or a sentence, never both, and the wrong one is a broken contract.
#include "base/result.h"

#include <gtest/gtest.h>

#include <memory>

namespace enfilade {
namespace {

Result<int> half_of(int n) {
    if (n % 2 != 0) return Error{"n", "expected an even number, found " + std::to_string(n)};
    return n / 2;
}

TEST(Result, HoldsAValueOrAnError) {
    EXPECT_TRUE(half_of(8).ok());
    EXPECT_EQ(half_of(8).value(), 4);
    EXPECT_FALSE(half_of(7));
    EXPECT_EQ(half_of(7).error().what, "expected an even number, found 7");
}

TEST(Result, GivesItsValueAway) {
    Result<std::unique_ptr<int>> result(std::make_unique<int>(5));
    const std::unique_ptr<int> taken = std::move(result).value();
    EXPECT_EQ(*taken, 5);
}

TEST(Result, KeepsAValueThatIsItselfAString) {
    const Result<std::string> result(std::string("door"));
    EXPECT_EQ(result.value(), "door");
}

TEST(Result, LetsItsValueBeChanged) {
    Result<int> result(1);
    result.value() = 2;
    EXPECT_EQ(result.value(), 2);
}

TEST(Error, NamesThePlaceFirst) {
    EXPECT_EQ((Error{"a.toml:3:1", "expected a number"}).text(), "a.toml:3:1: expected a number");
}

TEST(Error, WithoutAPlaceIsTheSentenceAlone) {
    EXPECT_EQ((Error{"", "expected a number"}).text(), "expected a number");
}

TEST(ResultDeathTest, ReadingTheWrongSideStopsTheProgram) {
    EXPECT_DEATH(static_cast<void>(half_of(7).value()), "result.h:[0-9]+: broken contract");
    EXPECT_DEATH(static_cast<void>(half_of(8).error()), "result.h:[0-9]+: broken contract");
}

TEST(CheckDeathTest, NamesTheBrokenCondition) {
    EXPECT_DEATH(ENFILADE_CHECK(1 + 1 == 3), "result_test.cpp:[0-9]+: broken contract: 1 \\+ 1 == 3");
}

TEST(Check, EvaluatesItsConditionOnce) {
    int calls = 0;
    ENFILADE_CHECK(++calls == 1);
    EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace enfilade
