// What the running test tried and how far off it was: figures for hard_cases/CASES.md, told as properties of the test.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>

namespace enfilade::test {

/// The running test's property of that name as a number; 0: it has none yet.
inline double told_so_far(const std::string& name) {
    const ::testing::TestInfo* test = ::testing::UnitTest::GetInstance()->current_test_info();
    for (int i = 0; test && i < test->result()->test_property_count(); ++i)
        if (test->result()->GetTestProperty(i).key() == name)
            return std::stod(test->result()->GetTestProperty(i).value());
    return 0;
}

/// The running test tried so many more of them: count_trials(1000, "moves").
inline void count_trials(std::uint64_t count, const std::string& of_what) {
    const auto sum = static_cast<std::uint64_t>(told_so_far(of_what)) + count;
    ::testing::Test::RecordProperty(of_what, std::to_string(sum));
}

/// In one trial the running test was off by so much: note_deviation(3e-10, "m").
inline void note_deviation(double size, const std::string& unit) {
    const std::string name = "at most " + unit + " off";
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", std::max(size, told_so_far(name)));
    ::testing::Test::RecordProperty(name, text);
}

}  // namespace enfilade::test
