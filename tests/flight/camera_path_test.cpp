// Legs laid into a map, and the camera at any moment.
#include "flight/flight.h"

#include <gtest/gtest.h>

#include "flight/scenes.h"
#include "math/vec.h"

namespace enfilade {
namespace {

using test::go;
using test::leg;
using test::script_of;

/// A map and the path of a script in it.
struct Laid {
    Map map;
    CameraPath path;

    CameraPose at(std::int64_t frame, int rate = 10) const { return path.pose_at(map, {frame, rate}); }
};

Laid laid(const MapFile& file, const ScriptFile& script) {
    Map map = test::built(file);
    Findings findings;
    auto path = CameraPath::plan(script, map, findings);
    EXPECT_TRUE(path) << test::text_of(findings);
    return {std::move(map), path ? std::move(*path) : CameraPath()};
}

Laid in_hall(std::vector<LegRecord> legs) { return laid(test::hall_file(), script_of(std::move(legs))); }

/// The one finding about a script in the hall.
Finding refusal(const ScriptFile& script) {
    Findings findings;
    EXPECT_FALSE(CameraPath::plan(script, test::built(test::hall_file()), findings));
    EXPECT_EQ(findings.size(), 1u) << test::text_of(findings);
    return findings.empty() ? Finding{} : findings[0];
}

TEST(CameraPath, StartsAsThePlayerDoes) {
    const CameraPose pose = in_hall({}).at(0);
    EXPECT_EQ(pose.place, (Place{SectorId(0u), {2, 3}}));
    EXPECT_EQ(pose.eye_z, 1.5);
    EXPECT_EQ(pose.yaw, Angle{});
}

TEST(CameraPath, StartsWhereTheScriptSays) {
    ScriptFile script = script_of({});
    script.start.x = 9;
    script.start.y = 3;
    script.start.z = 2;
    script.start.yaw_degrees = 90;
    const CameraPose pose = laid(test::hall_file(), script).at(0);
    EXPECT_EQ(pose.place, (Place{SectorId(1u), {9, 3}}));
    EXPECT_EQ(pose.eye_z, 2);
    EXPECT_EQ(pose.yaw, Angle::from_degrees(90));
}

TEST(CameraPath, GoesEvenlyWithLinearEase) { EXPECT_EQ(in_hall({go(4, {6, 3})}).at(10).place.point, (Vec2{3, 3})); }

TEST(CameraPath, StartsAndStopsGentlyWithSmoothEase) {
    LegRecord record = go(4, {6, 3});
    record.ease = Ease::smooth;
    const Laid hall = in_hall({record});
    EXPECT_EQ(hall.at(10).place.point.x, snap_to_point_grid(2 + 4 * (3 * 0.25 * 0.25 - 2 * 0.25 * 0.25 * 0.25)));
    EXPECT_EQ(hall.at(20).place.point, (Vec2{4, 3}));
}

TEST(CameraPath, KnowsTheSectorItPassesInto) {
    const Laid hall = in_hall({go(1, {9, 3})});
    EXPECT_EQ(hall.at(8).place.sector, SectorId(0u));
    EXPECT_EQ(hall.at(9).place.sector, SectorId(1u));
}

TEST(CameraPath, StaysAtTheEnd) { EXPECT_EQ(in_hall({go(1, {6, 3})}).at(1000).place.point, (Vec2{6, 3})); }

TEST(CameraPath, KeepsWhatALegDoesNotMention) {
    LegRecord up = leg(1);
    up.to_z = 2.5;
    up.pitch_degrees = 20;
    const CameraPose pose = in_hall({up, go(1, {6, 3})}).at(15);
    EXPECT_EQ(pose.eye_z, 2.5);
    EXPECT_EQ(pose.pitch_degrees, 20);
}

TEST(CameraPath, TurnsTheShorterWayRound) {
    LegRecord look = leg(1);
    look.look_degrees = 270;
    EXPECT_EQ(in_hall({look}).at(5).yaw, Angle::from_degrees(-45));
}

TEST(CameraPath, TurnsRightWhereBothWaysAreAsLong) {
    LegRecord look = leg(1);
    look.look_degrees = 180;
    EXPECT_EQ(in_hall({look}).at(5).yaw, Angle::from_degrees(90));
}

TEST(CameraPath, TurnsMoreThanAFullTurn) {
    LegRecord turn = leg(4);
    turn.turn_degrees = -720;
    const Laid hall = in_hall({turn});
    EXPECT_EQ(hall.at(10).yaw, Angle::from_degrees(180));
    EXPECT_EQ(hall.at(40).yaw, Angle{});
}

TEST(CameraPath, LooksAtAPointFromWhereTheLegEnds) {
    LegRecord look = go(1, {6, 3});
    look.look_at = Vec2{6, 5};
    EXPECT_EQ(in_hall({look}).at(10).yaw, Angle::from_degrees(90));
}

TEST(CameraPath, JumpsWithACut) {
    const Laid hall = in_hall({leg(1), go(0, {9, 3}), leg(1)});
    EXPECT_EQ(hall.at(9).place.point, (Vec2{2, 3}));
    EXPECT_EQ(hall.at(10).place, (Place{SectorId(1u), {9, 3}}));
}

TEST(CameraPath, GoesOnBehindALink) {
    // 1 m beyond the east wall of "here" is 1 m south of the north wall of "there", which runs along x: south is +y.
    const Laid rooms = laid(test::linked_file(), script_of({go(3, {5, 2}), go(1, {102, 3})}));
    const CameraPose behind = rooms.at(30);
    EXPECT_EQ(behind.place, (Place{SectorId(1u), {102, 1}}));
    EXPECT_EQ(behind.eye_z, 2.5);
    EXPECT_EQ(behind.yaw, Angle::from_degrees(90));
    EXPECT_EQ(rooms.at(40).place.point, (Vec2{102, 3}));
}

TEST(CameraPath, LooksTheSameWayJustBeforeAndBehindALink) {
    LegRecord record = go(3, {5, 2});
    record.look_degrees = 30;
    const Laid rooms = laid(test::linked_file(), script_of({record}));
    const CameraPose before = rooms.at(1999, 1000), behind = rooms.at(2001, 1000);
    ASSERT_NE(before.place.sector, behind.place.sector);
    EXPECT_NEAR((behind.yaw - before.yaw).degrees(), 90, 0.03);  // two thousandths of the leg turn by 0.02 degrees
}

TEST(CameraPath, DecidesInWholeNumbersWhichLegAMomentIsIn) {
    // Three legs of 0.1 s are 0.30000000000000004 s as doubles; frame 9 of 30 a second still starts the fourth.
    const Laid hall = in_hall({leg(0.1), leg(0.1), leg(0.1), leg(0.1)});
    EXPECT_EQ(hall.path.leg_at({9, 30}), 3u);
    EXPECT_EQ(hall.path.leg_at({8, 30}), 2u);
}

TEST(CameraPath, NamesTheLegThatRunsIntoAWall) {
    const Finding finding = refusal(script_of({go(1, {4, 3}), go(1, {4, 7})}));
    EXPECT_EQ(finding.code, "leg-blocked");
    EXPECT_EQ(finding.place.line, 2u);
    EXPECT_NE(finding.sentence.find("leg 2"), std::string::npos) << finding.sentence;
}

TEST(CameraPath, RefusesACutToNowhere) { EXPECT_EQ(refusal(script_of({go(0, {50, 50})})).code, "cut-outside"); }

TEST(CameraPath, RefusesALookAtTheVeryPlaceWhereTheLegEnds) {
    LegRecord look = go(1, {4, 3});
    look.look_at = Vec2{4, 3};
    EXPECT_EQ(refusal(script_of({look})).code, "look-at-self");
}

TEST(CameraPath, RefusesAStartOutsideTheMap) {
    ScriptFile script = script_of({});
    script.start.x = 20;
    script.start.y = 3;
    EXPECT_EQ(refusal(script).code, "start-outside");
}

TEST(CameraPath, RefusesAStartInASectorThatDoesNotExist) {
    ScriptFile script = script_of({});
    script.start.sector = "cellar";
    EXPECT_EQ(refusal(script).code, "unknown-sector");
}

TEST(CameraPath, RefusesAMapWithoutPlayerWhereTheScriptHasNoStart) {
    MapFile file = test::hall_file();
    file.player.reset();
    Findings findings;
    EXPECT_FALSE(CameraPath::plan(script_of({}), test::built(file), findings));
    EXPECT_EQ(findings.at(0).code, "no-start");
}

}  // namespace
}  // namespace enfilade
