// Lists of views: what is read, and what is refused where.
#include "formats/views_csv.h"

#include <gmock/gmock.h>

#include "formats/findings.h"
#include "formats/hostile.h"

namespace enfilade {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::string_view kList =
    "x,y,z,yaw,pitch,sector\n"
    "1,-2.5,1.55,90,-10,hall\n"
    "\n"
    " 1e1 , +2 ,3,-720,0, \"hall, \"\"upper\"\" part\" \r\n"
    "0,0,0,0,0,";

std::vector<std::string> faults_of_views(std::string_view text) { return codes_and_places(read_views(text).findings); }

std::vector<std::string> complaints_of_row(const std::string& row) {
    return faults_of_views("x,y,z,yaw,pitch\n" + row);
}

TEST(Views, AreReadRowByRow) {
    const ViewsReading reading = read_views(kList);
    EXPECT_THAT(codes_and_places(reading.findings), IsEmpty());
    EXPECT_THAT(reading.views,
                ElementsAre(ViewRow{1, -2.5, 1.55, 90, -10, "hall", 2},
                            ViewRow{10, 2, 3, -720, 0, "hall, \"upper\" part", 4}, ViewRow{0, 0, 0, 0, 0, "", 5}));
}

TEST(Views, NeedNoSector) {
    const ViewsReading reading = read_views("x,y,z,yaw,pitch\r\n-5,-9.5,1.28125,354,0\r\n");
    EXPECT_THAT(reading.views, ElementsAre(ViewRow{-5, -9.5, 1.28125, 354, 0, "", 2}));
}

TEST(Views, LookPastAByteOrderMark) { EXPECT_THAT(faults_of_views("\xEF\xBB\xBFx,y,z,yaw,pitch\n"), IsEmpty()); }

struct BadRow {
    const char* row;
    const char* complaint;
};

void PrintTo(const BadRow& bad, std::ostream* out) { *out << bad.row; }

class BadView : public testing::TestWithParam<BadRow> {};

// hard case G13
TEST_P(BadView, IsReportedAtItsPlace) {
    EXPECT_THAT(complaints_of_row(GetParam().row), ElementsAre(GetParam().complaint));
}

INSTANTIATE_TEST_SUITE_P(
    Rows, BadView,
    testing::Values(BadRow{"1,2,3,4", "bad-row 2:1"}, BadRow{"1,2,3,4,5,", "bad-row 2:1"},
                    BadRow{",,,,,,,,,,,,,,,,,", "bad-row 2:1"}, BadRow{"1,2,,4,5", "bad-number 2:5"},
                    BadRow{"1,2,x,4,5", "bad-number 2:5"}, BadRow{"1,2,3 3,4,5", "bad-number 2:5"},
                    BadRow{"nan,2,3,4,5", "bad-number 2:1"}, BadRow{"1,inf,3,4,5", "bad-number 2:3"},
                    BadRow{"1,2,0x3,4,5", "bad-number 2:5"}, BadRow{"1,2,1e999,4,5", "bad-number 2:5"},
                    BadRow{"+-1,2,3,4,5", "bad-number 2:1"}, BadRow{"32769,2,3,4,5", "out-of-range 2:1"},
                    BadRow{"1,2,3,4,90", "out-of-range 2:9"}, BadRow{"1,2,3,4,\"5", "bad-row 2:9"},
                    BadRow{"1,2,\"3\"x,4,5", "bad-row 2:5"}, BadRow{"é,2,3,4,5", "bad-number 2:1"},
                    BadRow{"\"1\",x,3,4,5", "bad-number 2:5"}));

TEST(Views, ReportAllThatIsWrongInARow) {
    EXPECT_THAT(complaints_of_row("é,b,0,0,91"), ElementsAre("bad-number 2:1", "bad-number 2:3", "out-of-range 2:9"));
}

TEST(Views, WantTheirHeader) {
    EXPECT_THAT(faults_of_views("x,y,z,pitch,yaw\n1,2,3,4,5\n"), ElementsAre("bad-header 1:1"));
    EXPECT_THAT(faults_of_views(""), ElementsAre("bad-header 1:1"));
}

TEST(Views, RefuseWhatIsNotUtf8) {
    EXPECT_THAT(faults_of_views("x,y,z,yaw,pitch\né\xFF"), ElementsAre("not-utf8 2:2"));
}

TEST(Views, StopComplainingAtSomePoint) {
    std::string text = "x,y,z,yaw,pitch\n";
    for (int i = 0; i < 5000; ++i) text += "x\n";
    EXPECT_EQ(read_views(text).findings.size(), 1001u);
}

TEST(Views, SurviveBeingCutAnywhere) {
    for_each_cut(kList, [](std::string_view cut) { EXPECT_LE(read_views(cut).views.size(), 3u); });
}

TEST(View, IsReadFromACommandLine) {
    const auto view = parse_view("1,2,1.5,90,-5");
    ASSERT_TRUE(view.ok());
    EXPECT_EQ(view.value(), (ViewRow{1, 2, 1.5, 90, -5, "", 0}));
}

TEST(View, SaysWhatWasExpected) {
    const auto view = parse_view("1,2,1.5");
    ASSERT_FALSE(view.ok());
    EXPECT_EQ(view.error().text(), "expected a view as X,Y,Z,YAW,PITCH: expected 5 fields, found 3");
}

}  // namespace
}  // namespace enfilade
