// What portals by the graphics card's depths and planes show that is not there.
#include "app/accuracy/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/accuracy/experiment.h"
#include "platform/gl_context.h"
#include "render/choice/renderer.h"
#include "support/looks.h"
#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;
using ::testing::HasSubstr;

/// OpenGL comes with the machine, also without a graphics card; where there is none, there is nothing to measure.
class WithOpenGl : public ::testing::Test {
protected:
    void SetUp() override {
        if (!open_gl_for_pictures().ok()) GTEST_SKIP() << "there is no OpenGL here";
    }
};
class ErrorsAtPortals : public WithOpenGl {};
class PortalsByDepths : public WithOpenGl {};

/// Two halls with pillars, the doorway between which leads elsewhere.
OpenMap linked_halls() {
    MapFile file = map_of({box_room("near", 0, 0, 6, 6, 0, 3), box_room("far", 100, 50, 108, 56, 0, 3)});
    cut_pillar(file.sectors[0], 2, 2, 2.5, 2.5);
    cut_pillar(file.sectors[1], 103, 52, 103.5, 53.5);
    link(file, "near", {6, 0}, {6, 6}, "far", {100, 56}, {100, 50});
    return {built(file), textures_for(file)};
}

std::vector<PortalErrorRow> rows_of(PortalMethod method, const std::vector<PortalErrorRow>& rows) {
    std::vector<PortalErrorRow> some;
    for (const PortalErrorRow& row : rows)
        if (row.method == method) some.push_back(row);
    return some;
}

TEST_F(ErrorsAtPortals, AreNoneByTheExactMethodAndManyWhereOneStandsInThePortal) {
    std::vector<OpenMap> maps;
    maps.push_back(linked_halls());
    const auto rows = measure_portals(maps, {12, 128, 80, 1});
    ASSERT_TRUE(rows.ok()) << rows.error().text();
    const auto exact = rows_of(PortalMethod::exact, rows.value());
    ASSERT_EQ(exact.size(), kPortalDistances.size());
    for (const PortalErrorRow& row : exact) {
        EXPECT_GT(row.errors.pixels, 12u * 128 * 80 * 9 / 10) << row.distance_m;
        EXPECT_EQ(row.errors.elsewhere + row.errors.unwritten, 0u) << row.distance_m;
        EXPECT_EQ(row.time_ratio, 1) << row.distance_m;
    }
    for (const PortalMethod method : {PortalMethod::plane24, PortalMethod::oblique24}) {
        const auto classic = rows_of(method, rows.value());
        const PortalErrors& at_a_metre = classic.front().errors;
        EXPECT_LT(at_a_metre.elsewhere + at_a_metre.unwritten, at_a_metre.pixels / 1000);
        EXPECT_GT(classic.back().errors.unwritten, classic.back().errors.pixels / 4);
    }
}

TEST_F(ErrorsAtPortals, AreNotLookedForWhereThereIsNoLink) {
    std::vector<OpenMap> maps;
    const MapFile file = map_of({box_room("hall", 0, 0, 6, 6)});
    maps.push_back({built(file), textures_for(file)});
    const auto rows = measure_portals(maps, {});
    ASSERT_TRUE(rows.ok());
    EXPECT_TRUE(rows.value().empty());
}

TEST(CheckPortals, SaysWhereTheExactMethodShowsWhatIsNotThere) {
    EXPECT_TRUE(check_portals({{PortalMethod::plane24, 0, {100, 1, 50, 3}, 1}}).ok());
    const auto wrong = check_portals({{PortalMethod::exact, 0.1, {100, 1, 2, 0}, 1}});
    ASSERT_FALSE(wrong.ok());
    EXPECT_THAT(wrong.error().text(), HasSubstr("2 pixels of 100, 0.1 m before a portal, show something else"));
}

TEST(PortalPage, SaysWhenThereIsNoOpenGl) {
    EXPECT_THAT(portal_page(Error{"gl", "no such thing"}), HasSubstr("There is no OpenGL here that can do it: gl: no"));
    EXPECT_THAT(portal_page(std::vector<PortalErrorRow>{{PortalMethod::oblique32, 0.01, {2'000'000, 4, 6, 2}, 1.25}}),
                HasSubstr("| `oblique32` | 0.01 | 2000000 | 3.0 | 1.0 | 2.0 | 1.25 |"));
}

std::unique_ptr<Renderer> stencil_by(PortalMethod method, const OpenMap& map) {
    Dials dials;
    dials.portals = method;
    auto renderer = make_renderer({RendererKind::stencil, dials, 1, open_gl_for_pictures}, map.map, map.textures);
    EXPECT_TRUE(renderer.ok()) << renderer.error().text();
    return renderer.ok() ? std::move(renderer).value() : nullptr;
}

/// The share of pixels that differ from the exact picture's.
double share_off(const OpenMap& map, const std::vector<View>& views) {
    const Snapshot snapshot = at_rest(map.map);
    const auto exact = stencil_by(PortalMethod::exact, map), other = stencil_by(PortalMethod::plane24, map);
    std::size_t differ = 0, count = 0;
    for (const View& view : views) {
        Frame one, two;
        one.resize(160, 100);
        two.resize(160, 100);
        EXPECT_TRUE(exact->render(one, nullptr, snapshot, view).ok());
        EXPECT_TRUE(other->render(two, nullptr, snapshot, view).ok());
        for (std::size_t i = 0; i < one.pixels.size(); ++i) differ += one.pixels[i] != two.pixels[i];
        count += one.pixels.size();
    }
    return static_cast<double>(differ) / static_cast<double>(count);
}

// Skies, lamps, mirrors, things and panels are all there, in their colours.
TEST_F(PortalsByDepths, LookLikeTheExactOnesFromAnywhereInTheRooms) {
    for (const char* name : {"hut", "mirrors", "effects", "tunnels"}) {
        const auto map = open_map(ENFILADE_SOURCE_DIR "/maps/" + std::string(name) + ".toml", {}, {});
        ASSERT_TRUE(map) << name;
        EXPECT_LT(share_off(*map, poses_in(map->map, PoseKind::random, 8, 3)), 0.002) << name;
    }
}

TEST_F(PortalsByDepths, ShowTheSkyOverALowerRoom) {
    MapFile file = map_of({box_room("high", 0, 0, 6, 6, 0, 10), box_room("low", 6, 0, 12, 6, 0, 4)});
    for (SectorRecord& sector : file.sectors) sector.ceiling.parallax = true;
    join_all(file);
    const OpenMap map{built(file), textures_for(file)};
    View view = look_from(map.map, {2, 3}, 1.5, 0);
    view.pitch_tangent = 0.5;
    EXPECT_LT(share_off(map, {view}), 0.002);
}

// The stencil buffer counts to 255. There are three hundred edges, each of which is drawn a hair aside.
TEST_F(PortalsByDepths, LookThroughThreeHundredDoorways) {
    MapFile file = map_of({box_room("hall", 0, 0, 1, 3, 0, 3)});
    link(file, "hall", {1, 0}, {1, 3}, "hall", {0, 3}, {0, 0});
    file.render.max_depth = 400;
    const OpenMap map{built(file), textures_for(file)};
    View view = look_from(map.map, {0.5, 1.5}, 1.5, 0);
    view.fov_degrees = 2;
    EXPECT_LT(share_off(map, {view}), 0.01);
}

TEST_F(PortalsByDepths, HaveNoTruePitch) {
    const OpenMap map = linked_halls();
    View view = poses_in(map.map, PoseKind::random, 1, 1).front();
    view.pitch_tangent = 0;
    view.tilt = Tilt{};
    Frame frame;
    frame.resize(16, 10);
    const auto drawn = stencil_by(PortalMethod::oblique24, map)->render(frame, nullptr, at_rest(map.map), view);
    ASSERT_FALSE(drawn.ok());
    EXPECT_THAT(drawn.error().text(), HasSubstr("the dial portals has no true pitch"));
}

}  // namespace
}  // namespace enfilade
