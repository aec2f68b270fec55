// From typed numbers to a view inside the map.
#include "app/options.h"

#include <gtest/gtest.h>

#include "support/map_builder.h"

namespace enfilade {
namespace {

/// Two rooms in the same place, and one beside them.
Map three_rooms() {
    MapFile file = test::map_of({test::box_room("below", 0, 0, 4, 4), test::box_room("above", 0, 0, 4, 4),
                                 test::box_room("beside", 4, 0, 8, 4)});
    test::place_player(file, "beside", {6, 2}, 1.5, 90);
    return test::built(file);
}

ViewRow at(double x, double y, const std::string& sector = "") { return {x, y, 1, 0, 0, sector, 0}; }

TEST(ViewFrom, TakesTheFirstOfOverlappingSectors) {
    EXPECT_EQ(view_from(three_rooms(), at(1, 1), {}).value().sector, SectorId(0u));
}

TEST(ViewFrom, TakesTheNamedSector) {
    EXPECT_EQ(view_from(three_rooms(), at(1, 1, "above"), {}).value().sector, SectorId(1u));
}

TEST(ViewFrom, RefusesANamedSectorThatDoesNotHoldThePoint) {
    EXPECT_FALSE(view_from(three_rooms(), at(5, 1, "above"), {}).ok());
}

TEST(ViewFrom, RefusesANameThatTheMapDoesNotHave) {
    const auto view = view_from(three_rooms(), at(1, 1, "attic"), {});
    ASSERT_FALSE(view.ok());
    EXPECT_NE(view.error().what.find("'attic'"), std::string::npos);
}

TEST(ViewFrom, RefusesAPointOutsideEveryRoom) { EXPECT_FALSE(view_from(three_rooms(), at(9, 1), {}).ok()); }

TEST(ViewFrom, LooksWhereYawAndPitchSay) {
    const auto view = view_from(three_rooms(), {1, 1, 1, 90, 45, "", 0}, {70, 1.2}).value();
    EXPECT_EQ(view.forward, (Vec2{0, 1}));
    EXPECT_EQ(view.pitch_tangent, 1);
    EXPECT_EQ(view.fov_degrees, 70);
    EXPECT_EQ(view.stretch, 1.2);
}

TEST(ViewFrom, PutsTheEyeOntoThePointGrid) {
    EXPECT_EQ(view_from(three_rooms(), at(0.1, 1), {}).value().eye.x, snap_to_point_grid(0.1));
}

TEST(ViewAtStart, IsThePlayers) {
    const auto view = view_at_start(three_rooms(), {}).value();
    EXPECT_EQ(view.sector, SectorId(2u));
    EXPECT_EQ(view.eye, (Vec2{6, 2}));
    EXPECT_EQ(view.eye_z, 1.5);
    EXPECT_EQ(view.forward, (Vec2{0, 1}));
}

TEST(ViewAtStart, RefusesAMapWithoutPlayer) {
    EXPECT_FALSE(view_at_start(test::built(test::map_of({test::box_room("main", 0, 0, 1, 1)})), {}).ok());
}

TEST(ViewFrom, TiltsTheViewWhereTruePitchIsWanted) {
    ViewRow row = at(1, 1);
    row.pitch_degrees = 45;
    const View view = view_from(three_rooms(), row, {.true_pitch = true, .roll_degrees = 90}).value();
    ASSERT_TRUE(view.tilt);
    EXPECT_EQ(view.tilt->pitch.x, view.tilt->pitch.y);
    EXPECT_EQ(view.tilt->roll, (Vec2{0, 1}));
    EXPECT_EQ(view.pitch_tangent, 0);
}

TEST(TruePitch, IsRefusedForTheColumnRendererOnly) {
    const Result<void> result = refuse_true_pitch(RendererKind::column, true);
    ASSERT_FALSE(result.ok());
    EXPECT_NE(result.error().what.find("upright columns"), std::string::npos);
    EXPECT_TRUE(refuse_true_pitch(RendererKind::stencil, true).ok());
    EXPECT_TRUE(refuse_true_pitch(RendererKind::reference, true).ok());
    EXPECT_TRUE(refuse_true_pitch(RendererKind::column, false).ok());
}

}  // namespace
}  // namespace enfilade
