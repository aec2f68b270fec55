// What point lights throw on the surfaces around them: how it falls off, where shadows are, how it goes through
// portals, and that it is a function of the moment.
#include <gtest/gtest.h>

#include "render/lighting.h"
#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;

PointLightRecord lamp(double x, double y, double z = 1, double reach = 8) {
    PointLightRecord light;
    light.position = {x, y};
    light.z = z;
    light.reach = reach;
    return light;
}

/// A map and the light in it.
struct LitMap {
    Map map;
    Snapshot snapshot;
    LightGrids grids;

    explicit LitMap(const MapFile& file) : map(built(file)), snapshot(at_rest(map)), grids(map) {}

    SectorId sector(const std::string& name) const {
        for (std::size_t i = 0; i < map.sectors.size(); ++i)
            if (map.sectors[i].name == name) return SectorId(i);
        return {};
    }
    LightCell on_floor(const std::string& name, Vec2 at) {
        const LightGrid* grid = grids.on_floor(snapshot, sector(name));
        return grid ? light_on(*grid, at.x, at.y) : 0;
    }
    std::uint32_t red_on_floor(const std::string& name, Vec2 at) { return lane(on_floor(name, at), 0); }
};

MapFile hall_with(std::vector<PointLightRecord> lights) {
    MapFile file = map_of({box_room("hall", 0, 0, 8, 8, 0, 4)});
    file.lights = std::move(lights);
    return file;
}

TEST(LightFalloff, EndsAtItsReach) {
    EXPECT_EQ(light_falloff(0, 6), 1);
    EXPECT_EQ(light_falloff(3, 6), 0.25);
    EXPECT_EQ(light_falloff(6, 6), 0);
    EXPECT_EQ(light_falloff(9, 6), 0);
}

TEST(LightFalloff, TakesAThirdOfWhatOnlyGrazes) {
    EXPECT_EQ(light_facing(1), 1);
    EXPECT_EQ(light_facing(-1), 1);
    EXPECT_DOUBLE_EQ(light_facing(0), 1.0 / 3);
}

TEST(LightCell, KeepsItsChannelsApart) {
    const LightCell a = light_cell(8191, 0, 100), b = light_cell(0, 8191, 50);
    EXPECT_EQ(between(a, b, 0), a);
    EXPECT_EQ(between(a, b, (1u << kLightPartBits) - 1), b);  // rounded
    const LightCell middle = between(a, b, 1u << (kLightPartBits - 1));
    EXPECT_EQ(lane(middle, 0), 4096u);
    EXPECT_EQ(lane(middle, 1), 4096u);
    EXPECT_EQ(lane(middle, 2), 75u);
}

TEST(GridStep, IsAtTheNearestPartOfACellAndStaysBetweenThePoints) {
    constexpr double kPart = 0x1p-15;
    const auto is = [](const GridStep& step, int cell, LightPart part) {
        return step.cell == cell && step.part == part;
    };
    for (const int count : {2, 3, 1000}) {
        const double last = count - 1;
        EXPECT_TRUE(is(grid_step(0, count), 0, 0));
        EXPECT_TRUE(is(grid_step(-1e9, count), 0, 0));
        EXPECT_TRUE(is(grid_step(last, count), count - 2, (1u << kLightPartBits) - 1));
        EXPECT_TRUE(is(grid_step(1e300, count), count - 2, (1u << kLightPartBits) - 1));
        EXPECT_TRUE(is(grid_step(last - kPart, count), count - 2, (1u << kLightPartBits) - 1));
        EXPECT_TRUE(is(grid_step(last - 0.5, count), count - 2, 1u << (kLightPartBits - 1)));
        EXPECT_TRUE(is(grid_step(kPart, count), 0, 1));
        EXPECT_TRUE(is(grid_step(kPart - 0x1p-18, count), 0, 1)) << "rounded to 2^-16 first";
    }
    EXPECT_TRUE(is(grid_step_of_shifted(1.25 + kGridShift, 3), 1, 1u << (kLightPartBits - 2)));
    EXPECT_TRUE(is(grid_step_of_shifted(-40000 + kGridShift, 3), 0, 0));
}

TEST(LightCell, ThatIsDarkLeavesShadesAsTheyAre) {
    for (std::uint32_t shade = 0; shade <= 256; ++shade)
        for (std::uint32_t value = 0; value < 256; value += 5)
            ASSERT_EQ(lit(value * 0x010101u, shade, 0), shaded(value * 0x010101u, shade));
}

TEST(Lit, BrightensTwiceAtMost) { EXPECT_EQ(lit(0xFF203040u, 256, light_cell(8191, 8191, 8191)), 0xFF406080u); }

TEST(Lit, SaturatesEachChannelByItself) { EXPECT_EQ(lit(0xFF20C0F0u, 256, light_cell(0, 8191, 0)), 0xFF20FFF0u); }

TEST(PointLight, FallsOnTheFloorBelowItAsItsRuleSays) {
    LitMap lit(hall_with({lamp(4, 4, 2)}));
    const double expected = 256 * kLightSteps * light_falloff(2, 8);
    EXPECT_NEAR(lit.red_on_floor("hall", {4, 4}), expected, 1);  // rounded to whole steps
}

TEST(PointLight, IsTheSumOfItsLikes) {
    const PointLightRecord a = lamp(3, 4), b = lamp(6, 5, 2, 5);
    LitMap one(hall_with({a})), other(hall_with({b})), both(hall_with({a, b}));
    for (const Vec2 at : {Vec2{1, 1}, Vec2{4.3, 4.1}, Vec2{6, 6}})  // each is rounded to whole steps, twice
        EXPECT_NEAR(both.red_on_floor("hall", at), one.red_on_floor("hall", at) + other.red_on_floor("hall", at), 3);
}

TEST(PointLight, HasItsColor) {
    PointLightRecord light = lamp(4, 4);
    light.color = 0xFF8000;
    LitMap lit(hall_with({light}));
    const LightCell cell = lit.on_floor("hall", {4, 5});
    EXPECT_NEAR(lane(cell, 1) * 255.0, lane(cell, 0) * 128.0, 255);
    EXPECT_EQ(lane(cell, 2), 0u);
}

TEST(PointLight, LightsWallsAtTheHeightWhereItIs) {
    LitMap lit(hall_with({lamp(4, 1, 3, 3)}));
    const LightGrid* north = lit.grids.on_wall(lit.snapshot, WallId(0u));
    ASSERT_NE(north, nullptr);
    EXPECT_GT(lane(light_on(*north, 4, 3), 0), lane(light_on(*north, 4, 1), 0));
    EXPECT_GT(lane(light_on(*north, 4, 3), 0), lane(light_on(*north, 6, 3), 0));
    EXPECT_EQ(lit.grids.on_wall(lit.snapshot, WallId(2u)), nullptr) << "the south wall is too far away";
}

TEST(PointLight, ThrowsTheShadowOfAPillar) {
    MapFile file = hall_with({lamp(1.5, 4)});
    cut_pillar(sector(file, "hall"), 3, 3, 4, 5);
    LitMap lit(file);
    EXPECT_EQ(lit.red_on_floor("hall", {5.5, 4}), 0u);
    EXPECT_GT(lit.red_on_floor("hall", {5.5, 0.5}), 0u);
    LitMap open(hall_with({lamp(1.5, 4)}));
    EXPECT_GT(open.red_on_floor("hall", {5.5, 4}), 0u);
}

/// Two rooms with a doorway between y = 1.5 and y = 2.5.
MapFile two_rooms() {
    MapFile file =
        map_of({box_room("west", 0, 0, 4, 4), box_room("door", 4, 1.5, 4.25, 2.5), box_room("east", 4.25, 0, 8, 4)});
    split_and_join(file);
    file.lights = {lamp(2, 2)};
    return file;
}

TEST(PointLight, GoesThroughADoorwayAndNotAside) {
    LitMap lit(two_rooms());
    EXPECT_GT(lit.red_on_floor("east", {6, 2}), 0u);
    EXPECT_EQ(lit.red_on_floor("east", {5, 3.75}), 0u);
}

TEST(PointLight, ComesWithTheOpeningOfADoorAndGoesWithItsClosing) {
    MapFile file = two_rooms();
    sector(file, "door").ceiling.z = 0;
    LitMap lit(file);
    double& ceiling_z = lit.snapshot.sectors[lit.sector("door").index].ceiling_z;
    EXPECT_EQ(lit.red_on_floor("east", {6, 2}), 0u);
    ceiling_z = 2;
    const std::uint32_t open = lit.red_on_floor("east", {6, 2});
    EXPECT_GT(open, 0u);
    ceiling_z = 0.25;  // the light is higher up, so only what lies far behind is lit under the door's edge
    EXPECT_EQ(lit.red_on_floor("east", {6, 2}), 0u);
    ceiling_z = 2;
    EXPECT_EQ(lit.red_on_floor("east", {6, 2}), open);
}

TEST(PointLight, ThrowsTheShadowOfALintelOntoTheWallFarBehind) {
    MapFile file = two_rooms();
    sector(file, "door").ceiling.z = 1.25;
    LitMap lit(file);
    for (std::size_t i = 0; i < lit.map.walls.size(); ++i) {
        if (lit.map.walls[i].a != Vec2{8, 0}) continue;
        const LightGrid* east = lit.grids.on_wall(lit.snapshot, WallId(i));
        ASSERT_NE(east, nullptr);
        EXPECT_GT(lane(light_on(*east, 2, 1.5), 0), 0u);
        EXPECT_EQ(lane(light_on(*east, 2, 1.9), 0), 0u);
    }
}

TEST(PointLight, IsHeldBackByAHighStep) {
    MapFile file = map_of({box_room("low", 0, 0, 4, 4, 0, 4), box_room("high", 4, 0, 8, 4, 2, 4)});
    join_all(file);
    file.lights = {lamp(2, 2, 1)};
    LitMap lit(file);
    EXPECT_EQ(lit.red_on_floor("high", {6, 2}), 0u);
    lit.snapshot.sectors[1].floor_z = 0;
    EXPECT_GT(lit.red_on_floor("high", {6, 2}), 0u);
}

/// A link that turns by a quarter and raises by 3 m, and two rooms side by side that are the same.
// hard case I10
TEST(PointLight, GoesThroughALinkAsThroughADoorway) {
    MapFile plain = map_of({box_room("west", 0, 0, 4, 4), box_room("east", 4, 0, 8, 4)});
    MapFile linked = map_of({box_room("west", 0, 0, 4, 4), box_room("far", 100, 100, 104, 104, 3, 5)});
    cut_pillar(sector(plain, "east"), 5, 1, 6, 2);
    join_all(plain);
    link(linked, "west", {4, 0}, {4, 4}, "far", {100, 100}, {104, 100});
    const Rigid over = built(linked).links[built(linked).walls[1].link];
    std::vector<Vec2> pillar;
    for (const Vec2 v : {Vec2{5, 1}, Vec2{5, 2}, Vec2{6, 2}, Vec2{6, 1}}) pillar.push_back(over.apply(v));
    sector(linked, "far").loops.push_back(loop_of(pillar));
    plain.lights = linked.lights = {lamp(2.5, 1.25)};
    LitMap here(plain), there(linked);
    std::size_t lit = 0, dark = 0;
    for (double x = 4.25; x < 8; x += 0.5)
        for (double y = 0.25; y < 4; y += 0.5) {
            const std::uint32_t expected = here.red_on_floor("east", {x, y});
            EXPECT_NEAR(there.red_on_floor("far", over.apply({x, y})), expected, 2) << x << "," << y;
            ++(expected ? lit : dark);
        }
    EXPECT_GT(lit, 20u);
    EXPECT_GT(dark, 5u);
}

TEST(PointLight, ShinesFromEachPlaceThatLinksPutItAt) {
    MapFile file = map_of({box_room("room", 0, 0, 4, 4)});
    link(file, "room", {4, 0}, {4, 4}, "room", {0, 4}, {0, 0});  // out in the east, in again in the west
    LitMap once(hall_with({lamp(1, 2)}));
    file.lights = {lamp(1, 2)};
    LitMap endless(file);
    EXPECT_EQ(endless.map.lights.size(), 1u);
    EXPECT_GT(endless.red_on_floor("room", {3, 2}), once.red_on_floor("hall", {3, 2}));
}

TEST(PointLight, DoesNotComeBackFromAMirror) {
    MapFile file = hall_with({lamp(4, 7)}), mirrored = file;
    mirrored.sectors[0].loops[0].walls[0].mirror = true;
    LitMap plain(file), other(mirrored);
    EXPECT_EQ(plain.red_on_floor("hall", {4, 2}), other.red_on_floor("hall", {4, 2}));
}

TEST(PointLight, LightsThingsUnlessSomethingIsBefore) {
    MapFile file = hall_with({lamp(1.5, 4)});
    cut_pillar(sector(file, "hall"), 3, 3, 4, 5);
    file.things.resize(2);
    file.things[0].position = {1.5, 6};
    file.things[1].position = {6, 4};
    for (ThingRecord& thing : file.things) thing.frames = {{"figure", 0, {}}};
    LitMap lit(file);
    const LightGrid* near = lit.grids.on_thing(lit.snapshot, ThingId(0u));
    ASSERT_TRUE(near);
    EXPECT_GT(lane(light_on(*near, 0, 0), 0), 0u);
    EXPECT_FALSE(lit.grids.on_thing(lit.snapshot, ThingId(1u)));
}

TEST(PointLight, LightsPanelsFromBothSides) {
    MapFile file = hall_with({lamp(4, 2)});
    PanelRecord panel;
    panel.a = {2, 4};
    panel.b = {6, 4};
    panel.top = 2;
    panel.texture = spec("cloth");
    file.sectors[0].panels = {panel};
    std::swap(panel.a, panel.b);
    panel.a.y = panel.b.y = 8;  // along the wall, like a poster
    file.sectors[0].panels.push_back(panel);
    LitMap lit(file);
    for (const PanelId id : {PanelId(0u), PanelId(1u)}) {
        const LightGrid* grid = lit.grids.on_panel(lit.snapshot, id);
        ASSERT_NE(grid, nullptr);
        EXPECT_GT(lane(light_on(*grid, 2, 1), 0), 0u);
    }
}

TEST(PointLight, ChangesWithItsEffectAsAFunctionOfTime) {
    PointLightRecord light = lamp(4, 4);
    light.effect = LightEffectRecord{LightKind::strobe, 0.25, 1, 1, true, false, {}, 60, {}};
    LitMap lit(hall_with({light}));
    std::vector<std::uint32_t> levels;
    for (const double time_s : {0.5, 1.5, 0.5}) {
        lit.snapshot.time_s = time_s;
        levels.push_back(lit.red_on_floor("hall", {4, 4}));
    }
    EXPECT_NEAR(std::min(levels[0], levels[1]) * 4.0, std::max(levels[0], levels[1]), 4);
    EXPECT_EQ(levels[0], levels[2]);
}

TEST(LightGrids, AreAlikeWhateverWasAskedBefore) {
    MapFile file = two_rooms();
    LitMap used(file), fresh(file);
    for (const double ceiling_z : {0.0, 1.0, 2.0, 0.5}) {
        used.snapshot.sectors[used.sector("door").index].ceiling_z = ceiling_z;
        used.red_on_floor("east", {6, 2});
    }
    fresh.snapshot.sectors[fresh.sector("door").index].ceiling_z = 0.5;
    const LightGrid *a = used.grids.on_floor(used.snapshot, used.sector("east")),
                    *b = fresh.grids.on_floor(fresh.snapshot, fresh.sector("east"));
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->cells, b->cells);
}

TEST(LightGrids, AskNothingOfAMapWithoutLights) {
    EXPECT_FALSE(LitMap(hall_with({})).grids.where_lit());
    EXPECT_TRUE(LitMap(hall_with({lamp(1, 1)})).grids.where_lit());
}

TEST(LightGrids, AreNoneWhereNothingArrives) {
    LitMap lit(hall_with({lamp(1, 1, 1, 2)}));
    ASSERT_TRUE(lit.grids.on_floor(lit.snapshot, lit.sector("hall")));
    lit.map.lights[0].brightness = 0;
    LightGrids fresh(lit.map);
    EXPECT_FALSE(fresh.on_floor(lit.snapshot, lit.sector("hall")));
}

}  // namespace
}  // namespace enfilade
