// What exactness of motion gives and costs.
#include "app/accuracy/motion.h"

#include <gmock/gmock.h>

#include <cstdio>

namespace enfilade {
namespace {

using ::testing::HasSubstr;

const MotionPlan kShort{10'000, 20'000, 3};

std::vector<DriftRow> drifts() {
    static const std::vector<DriftRow> rows = measure_drift(kShort);
    return rows;
}

std::vector<CrossingRow> crossings() {
    static const std::vector<CrossingRow> rows = measure_crossings(kShort);
    return rows;
}

const DriftRow& row_of(const std::vector<DriftRow>& rows, const std::string& link, const std::string& way,
                       std::uint64_t passes) {
    for (const DriftRow& row : rows)
        if (row.link == link && row.way == way && row.passes == passes) return row;
    ADD_FAILURE() << link << " " << way << " " << passes;
    return rows.front();
}

TEST(MotionDrift, OfTheEngineIsWithinItsBounds) {
    for (const DriftRow& row : drifts()) {
        if (row.way != "engine") continue;
        EXPECT_LE(row.position_m, most_drift_m(row.passes)) << row.link;
        EXPECT_LE(row.heading_rad, most_drift_rad(row.passes)) << row.link;
        EXPECT_GT(row.position_m, 0) << "turned links round";
    }
}

TEST(MotionDrift, IsLargerTheFewerBitsNumbersHave) {
    const std::vector<DriftRow> rows = drifts();
    for (const char* link : {"20/21/29", "37 degrees"})
        for (const std::uint64_t passes : {1'000u, 10'000u}) {
            const double engine = row_of(rows, link, "engine", passes).position_m;
            const double real64 = row_of(rows, link, "matrix in double", passes).position_m;
            const double real32 = row_of(rows, link, "matrix in float", passes).position_m;
            const double fixed = row_of(rows, link, "16.16", passes).position_m;
            EXPECT_LT(real64, engine) << "the price of coming back to the very same point";
            EXPECT_LT(engine * 100, real32);
            EXPECT_LT(engine * 1000, fixed);
            EXPECT_EQ(row_of(rows, link, "engine", passes).same_again, 1);
            EXPECT_LT(row_of(rows, link, "matrix in double", passes).same_again, 0.9);
            EXPECT_LT(row_of(rows, link, "engine", passes).heading_rad, 1e-11);
            EXPECT_GT(row_of(rows, link, "matrix in float", passes).heading_rad, 1e-7);
        }
}

TEST(MotionCrossings, OfTheEngineAreNeverWrong) {
    std::size_t rates = 0;
    for (const CrossingRow& row : crossings()) {
        if (row.way != "engine") continue;
        ++rates;
        EXPECT_EQ(row.moves, kShort.moves);
        EXPECT_GT(row.crossings, row.moves / 20);
        EXPECT_EQ(row.wrong, 0u) << row.rate_hz;
        EXPECT_EQ(row.on_line, 0u) << row.rate_hz;
    }
    EXPECT_EQ(rates, 3u);
}

// Asking at the end of a step, and again in the room found there, is hardly ever wrong where nothing is in the way, but
// stays where it was on every line.
TEST(MotionCrossings, OfSimplerWaysAreSometimes) {
    for (const CrossingRow& row : crossings()) {
        if (row.way == "engine") continue;
        const bool is_repeated = row.way == "side of walls at the end, repeated";
        EXPECT_GT(is_repeated ? row.on_line : row.wrong, 0u) << row.way << ", " << row.rate_hz;
        EXPECT_LT(row.wrong, row.moves / 2) << row.way << ", " << row.rate_hz;
    }
}

TEST(MotionExperiment, FindsTheSameAgain) {
    const std::vector<CrossingRow> again = measure_crossings({1000, 2000, 1}),
                                   once = measure_crossings({1000, 2000, 1});
    ASSERT_EQ(again.size(), once.size());
    for (std::size_t i = 0; i < once.size(); ++i) {
        EXPECT_EQ(again[i].wrong, once[i].wrong);
        EXPECT_EQ(again[i].on_line, once[i].on_line);
    }
}

TEST(MotionReport, HasALineForEachRow) {
    const std::vector<DriftRow> drift{{"engine", "20/21/29", 1000, 2e-8, 3e-13, 1, {4, 5}}};
    const std::vector<CrossingRow> crossing{{"point in polygon at the end", 35, 1'000'000, 10, 7, 1, {40, 50}}};
    const std::string page = motion_page(drift, crossing), csv = motion_csv(drift, crossing);
    EXPECT_THAT(page, HasSubstr("| 20/21/29 | engine | 1000 | 2.0e-08 | 3.0e-13 | 100.0 | 4.00 | 5.00 |\n"));
    EXPECT_THAT(page, HasSubstr("| 35 | point in polygon at the end | 1000000 | 10 | 7 | 7 | 1 | 40.0 | 50.0 |\n"));
    EXPECT_THAT(csv, HasSubstr("20/21/29,\"engine\",1000,2.000000e-08,3.000000e-13,1.000000,4.000,5.000\n"));
    EXPECT_THAT(csv, HasSubstr("35,\"point in polygon at the end\",1000000,10,7,1,40.000,50.000\n"));
}

TEST(MotionReport, SaysWhatTheEngineBreaks) {
    std::vector<DriftRow> drift{{"engine", "20/21/29", 1000, 2e-8, 3e-13, 1, {}},
                                {"16.16", "20/21/29", 1000, 1, 1, 0, {}}};
    std::vector<CrossingRow> crossing{{"engine", 35, 1000, 10, 0, 0, {}}, {"another", 35, 1000, 10, 7, 1, {}}};
    EXPECT_TRUE(check_motion(drift, crossing).ok());
    drift[0].heading_rad = 1e-11;
    EXPECT_THAT(check_motion(drift, crossing).error().text(),
                HasSubstr("20/21/29, engine: expected to drift by at most"));
    drift[0].heading_rad = 0;
    drift[0].same_again = 0.5;
    EXPECT_THAT(check_motion(drift, crossing).error().text(), HasSubstr("to the bit; found 0.5000 of them"));
    drift[0].same_again = 1;
    crossing[0].on_line = 2;
    EXPECT_THAT(check_motion(drift, crossing).error().text(), HasSubstr("of 1000 moves 2 do not"));
}

}  // namespace
}  // namespace enfilade
