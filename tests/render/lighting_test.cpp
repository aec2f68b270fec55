// What light falls on a surface beside that of lamps: of rooms that are unlit, and of suns.
#include "render/lighting.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;

Shade shade_of(const Map& map, double light, double contrast, double depth) {
    return shade_at(lighting_in(map, SectorId(0u), light, contrast), depth);
}

TEST(UnlitRoom, HasTheSameLightAtAnyDistanceAndInAnyDirection) {
    for (const LightModel model : {LightModel::smooth, LightModel::classic}) {
        MapFile file = map_of({box_room("room", 0, 0, 4, 4)});
        file.render.light = model;
        file.sectors[0].unlit = true;
        const Map map = built(file);
        for (const double light : {0.0, 0.3, 0.5, 1.0, 1.5})
            for (const double contrast : {0.8, 1.0, 1.2})
                for (const double depth : {0.0, 1.0, 100.0, HUGE_VAL})
                    EXPECT_EQ(shade_of(map, light, contrast, depth),
                              static_cast<Shade>(256 * std::min(light, 1.0) + 0.5))
                        << light << ' ' << depth;
    }
}

TEST(LitRoom, IsShadedAsItsMapSays) {
    for (const LightModel model : {LightModel::smooth, LightModel::classic}) {
        MapFile file = map_of({box_room("room", 0, 0, 4, 4)});
        file.render.light = model;
        const Map map = built(file);
        for (const double depth : {0.0, 1.0, 9.0, 100.0})
            EXPECT_EQ(shade_of(map, 0.4, 0.8, depth), shade_at(model, 0.4, 0.8, depth));
    }
}

/// An octagon, about (0, 0), with a floor, a ceiling, a panel along x and a thing, under a sun in the direction of yaw
/// 0 that is 30 degrees high.
MapFile sunny_octagon() {
    MapFile file =
        map_of({room("yard", {{-1, -3}, {1, -3}, {3, -1}, {3, 1}, {1, 3}, {-1, 3}, {-3, 1}, {-3, -1}}, 0, 4)});
    SunRecord sun;
    sun.name = "noon";
    sun.elevation_degrees = 30;
    sun.color = 0xFF8000;
    sun.brightness = 1;
    file.suns = {sun};
    file.sectors[0].sun = "noon";
    file.sectors[0].panels = {{{-1, 0}, {1, 0}, 0, 1, spec("fence"), {}, false, false, {}, {}, {}, {}},
                              {{0, 1}, {0, 2}, 0, 1, spec("fence"), {}, false, false, {}, {}, {}, {}}};
    file.things.resize(1);
    file.things[0].position = {-1, -1};
    return file;
}

struct SunnyMap {
    explicit SunnyMap(const MapFile& file) : map(built(file)), snapshot(at_rest(map)), grids(map) {}

    Map map;
    Snapshot snapshot;
    LightGrids grids;
};

/// As many parts of full light as the grid has everywhere; 0 where there is none. channel: as lane()'s.
double light_of(const LightGrid* grid, int channel = 0) {
    if (!grid) return 0;
    for (const Vec2 at : {Vec2{-1000, -1000}, Vec2{0.1, 0.7}, Vec2{999, 999}})
        EXPECT_EQ(light_on(*grid, at.x, at.y), grid->cells[0]);
    return lane(grid->cells[0], channel) / (256.0 * kLightSteps);
}

TEST(Sun, FallsOnWallsByTheAngleToTheirNormal) {
    SunnyMap sunny(sunny_octagon());
    ASSERT_TRUE(sunny.grids.where_lit());
    const double level = std::cos(30 * 3.14159265358979 / 180), aslant = level * std::sqrt(0.5);
    const double expected[] = {0, 0, 0, 0, 0, aslant, level, aslant};  // the last ones look towards +x
    for (std::uint32_t i = 0; i < 8; ++i)
        EXPECT_NEAR(light_of(sunny.grids.on_wall(sunny.snapshot, WallId(i))), expected[i], 1e-3) << i;
}

TEST(Sun, FallsOnFloorsByItsHeightAndOnCeilingsNot) {
    SunnyMap sunny(sunny_octagon());
    EXPECT_NEAR(light_of(sunny.grids.on_floor(sunny.snapshot, SectorId(0u))), 0.5, 1e-3);
    EXPECT_EQ(sunny.grids.on_ceiling(sunny.snapshot, SectorId(0u)), nullptr);
}

TEST(Sun, FallsOnBothSidesOfPanelsAndWhollyOnThings) {
    SunnyMap sunny(sunny_octagon());
    EXPECT_EQ(sunny.grids.on_panel(sunny.snapshot, PanelId(0u)), nullptr);
    EXPECT_NEAR(light_of(sunny.grids.on_panel(sunny.snapshot, PanelId(1u))), std::sqrt(0.75), 1e-3);
    EXPECT_NEAR(light_of(sunny.grids.on_thing(sunny.snapshot, ThingId(0u))), 1, 1e-3);
}

TEST(Sun, HasItsColour) {
    SunnyMap sunny(sunny_octagon());
    const LightGrid* grid = sunny.grids.on_thing(sunny.snapshot, ThingId(0u));
    EXPECT_NEAR(light_of(grid, 1), 128.0 / 255, 1e-3);
    EXPECT_EQ(light_of(grid, 2), 0);
}

TEST(Sun, IsAddedToLampsWhereTheyAre) {
    MapFile file = sunny_octagon();
    file.lights.emplace_back().position = {0, 0};
    file.lights[0].z = 1;
    file.lights[0].reach = 2;
    file.lights[0].brightness = 0.4;
    SunnyMap both(file), sunny(sunny_octagon());
    file.sectors[0].sun.clear();
    SunnyMap lamp(file);
    const LightGrid* sum = both.grids.on_floor(both.snapshot, SectorId(0u));
    const LightGrid* only_lamp = lamp.grids.on_floor(lamp.snapshot, SectorId(0u));
    const LightGrid* only_sun = sunny.grids.on_floor(sunny.snapshot, SectorId(0u));
    ASSERT_TRUE(sum && only_lamp && only_sun);
    for (const Vec2 at : {Vec2{0, 0}, Vec2{0.9, 0.4}, Vec2{-1.7, 0}, Vec2{2.9, 0.3}})
        EXPECT_NEAR(lane(light_on(*sum, at.x, at.y), 0),
                    lane(light_on(*only_lamp, at.x, at.y), 0) + lane(light_on(*only_sun, at.x, at.y), 0), 2)
            << at.x;
    EXPECT_FALSE(sum->is_dark_before_u || sum->is_dark_after_u || sum->is_dark_before_v || sum->is_dark_after_v);
}

TEST(Sun, ThatShinesOnNoSectorCostsNoGrid) {
    MapFile file = sunny_octagon();
    file.sectors[0].sun.clear();
    SunnyMap sunny(file);
    EXPECT_EQ(sunny.grids.on_floor(sunny.snapshot, SectorId(0u)), nullptr);
}

}  // namespace
}  // namespace enfilade
