// The reference's own light of lamps: what a formula says, shadows where they begin to the grid's last step, and what
// grids come near to as they get finer.
#include "render/reference/cast_ray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "base/hash.h"
#include "render/reference/picture.h"
#include "support/looks.h"

namespace enfilade::test {
namespace {

/// A step of the grid of moving points, four times.
constexpr double kHair = 0x1p-30;

PointLightRecord lamp(double x, double y, double z = 1, double reach = 8) {
    PointLightRecord light;
    light.position = {x, y};
    light.z = z;
    light.reach = reach;
    return light;
}

MapFile hall_with(const PointLightRecord& light) {
    MapFile file = map_of({box_room("hall", 0, 0, 8, 8, 0, 4)});
    file.lights = {light};
    return file;
}

/// A map at rest and the light in it.
struct LitRooms {
    Map map;
    Snapshot snapshot;

    explicit LitRooms(const MapFile& file) : map(built(file)), snapshot(at_rest(map)) {}

    SectorId sector(const std::string& name) const {
        for (std::size_t i = 0; i < map.sectors.size(); ++i)
            if (map.sectors[i].name == name) return SectorId(i);
        return {};
    }
    WallId wall(Vec2 a, Vec2 b) const {
        for (std::size_t i = 0; i < map.walls.size(); ++i)
            if (map.walls[i].a == a && map.walls[i].b == b) return WallId(i);
        return {};
    }
    LightCell on_floor(const std::string& name, Vec2 at) const {
        return OwnLight(map, snapshot).on_floor(sector(name), at);
    }
    std::uint32_t red_on_floor(const std::string& name, Vec2 at) const { return lane(on_floor(name, at), 0); }
};

/// Of a white lamp of brightness 1, in lanes of LightCell.
double formula(double way, double normal_way, double reach) {
    const double left = 1 - way / reach;
    return left > 0 ? 256 * 16 * left * left * (1.0 / 3 + 2.0 / 3 * normal_way / way) : 0;
}

double length(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }

TEST(OwnLight, IsWhatTheFormulaSaysInAnEmptyRoom) {
    const LitRooms rooms(hall_with(lamp(3, 5, 2.5, 6)));
    const OwnLight light(rooms.map, rooms.snapshot);
    Random random(5);
    for (int trial = 0; trial < 500; ++trial) {
        const double x = random.uniform(0, 8), y = random.uniform(0, 8), z = random.uniform(0, 4);
        EXPECT_NEAR(lane(light.on_floor(SectorId(0u), {x, y}), 0), formula(length(x - 3, y - 5, 2.5), 2.5, 6), 0.51);
        EXPECT_NEAR(lane(light.on_ceiling(SectorId(0u), {x, y}), 0), formula(length(x - 3, y - 5, 1.5), 1.5, 6), 0.51);
        EXPECT_NEAR(lane(light.on_wall(WallId(0u), x, z), 0), formula(length(x - 3, 5, z - 2.5), 5, 6), 0.51);
        EXPECT_NEAR(lane(light.on_wall(WallId(3u), y, z), 1), formula(length(3, 8 - y - 5, z - 2.5), 3, 6), 0.51);
    }
}

TEST(OwnLight, IsTheSumOfLampsInTheirColoursAndOfTheSun) {
    MapFile file = hall_with(lamp(2, 4, 1, 4));
    file.lights[0].color = 0x804000;
    file.lights.push_back(lamp(6, 4, 1, 4));
    file.lights[1].color = 0x0000FF;
    file.lights[1].brightness = 0.5;
    SunRecord sun;
    sun.name = "noon";
    sun.elevation_degrees = 90;
    sun.color = 0x00FF00;
    sun.brightness = 0.25;
    file.suns = {sun};
    file.sectors[0].sun = "noon";
    const LightCell at = LitRooms(file).on_floor("hall", {4, 4});
    const double each = formula(length(2, 0, 1), 1, 4);
    EXPECT_NEAR(lane(at, 0), each * 128 / 255, 0.51);
    EXPECT_NEAR(lane(at, 1), each * 64 / 255 + 1024, 0.51);
    EXPECT_NEAR(lane(at, 2), each / 2, 0.51);
}

// The look from the lamp at (1, 2) past the pillar's corner (4, 4) comes to (7, 6), and past (3, 5) to (5, 8).
TEST(OwnLight, HasTheShadowOfAPillarAtItsVeryPlace) {
    MapFile file = hall_with(lamp(1, 2, 1, 16));
    cut_pillar(sector(file, "hall"), 3, 4, 4, 5);
    const LitRooms rooms(file);
    EXPECT_GT(rooms.red_on_floor("hall", {7, 6 - kHair}), 0u);
    EXPECT_EQ(rooms.red_on_floor("hall", {7, 6 + kHair}), 0u);
    EXPECT_EQ(rooms.red_on_floor("hall", {5 + kHair, 8 - kHair}), 0u);
    EXPECT_GT(rooms.red_on_floor("hall", {5 - kHair, 8 - kHair}), 0u);
    const OwnLight light(rooms.map, rooms.snapshot);
    const WallId south = rooms.wall({8, 8}, {0, 8}), west_of_pillar = rooms.wall({3, 4}, {3, 5});
    EXPECT_EQ(lane(light.on_wall(south, 8 - 5 - kHair, 1), 0), 0u);
    EXPECT_GT(lane(light.on_wall(south, 8 - 5 + kHair, 1), 0), 0u);
    ASSERT_TRUE(west_of_pillar);
    EXPECT_GT(lane(light.on_wall(west_of_pillar, 0.5, 1), 0), 0u);
    EXPECT_EQ(lane(light.on_wall(rooms.wall({3, 5}, {4, 5}), 0.5, 1), 0), 0u) << "it turns its back on the lamp";
}

/// A doorway between y = 1.5 and y = 2.5 whose lintel is at 1.25 m, and a lamp 2 m before it at 1 m.
MapFile rooms_of_one_lamp() {
    MapFile file = map_of(
        {box_room("west", 0, 0, 4, 4), box_room("door", 4, 1.5, 4.5, 2.5, 0.5, 1.25), box_room("east", 4.5, 0, 8, 4)});
    split_and_join(file);
    file.lights = {lamp(2, 2)};
    return file;
}

// The look under the lintel climbs a quarter of a metre in 2.5 m; over the sill of the doorway it falls half a metre in
// 2.5 m, and comes to the floor 5 m from the lamp.
TEST(OwnLight, GoesUnderALintelAndOverASillAsFarAsItMay) {
    const LitRooms rooms(rooms_of_one_lamp());
    const OwnLight light(rooms.map, rooms.snapshot);
    const WallId east = rooms.wall({8, 0}, {8, 4});
    const double highest = 1 + 0.25 * 6 / 2.5;
    EXPECT_GT(lane(light.on_wall(east, 2, highest - 1e-9), 0), 0u);
    EXPECT_EQ(lane(light.on_wall(east, 2, highest + 1e-9), 0), 0u);
    EXPECT_GT(rooms.red_on_floor("east", {7 + 1e-8, 2}), 0u);
    EXPECT_EQ(rooms.red_on_floor("east", {7 - 1e-8, 2}), 0u);
    EXPECT_EQ(rooms.red_on_floor("east", {5, 3.75}), 0u) << "aside of the doorway";
}

TEST(OwnLight, FollowsADoor) {
    LitRooms rooms(rooms_of_one_lamp());
    double& ceiling_z = rooms.snapshot.sectors[rooms.sector("door").index].ceiling_z;
    const std::uint32_t open = rooms.red_on_floor("east", {7.5, 2});
    EXPECT_GT(open, 0u);
    ceiling_z = 0.5;
    EXPECT_EQ(rooms.red_on_floor("east", {7.5, 2}), 0u);
    ceiling_z = 1.25;
    EXPECT_EQ(rooms.red_on_floor("east", {7.5, 2}), open);
    rooms.snapshot.sectors[rooms.sector("west").index].ceiling_z = 0.875;
    EXPECT_EQ(rooms.red_on_floor("west", {1, 2}), 0u) << "the lamp is above the ceiling of its room";
}

TEST(OwnLight, GoesOverWallsThatAreUnderTheSkyOnBothSides) {
    MapFile file = map_of({box_room("yard", 0, 0, 4, 4, 0, 2), box_room("hill", 4, 0, 8, 4, 0, 1)});
    join_all(file);
    file.lights = {lamp(2, 2, 1.75)};
    EXPECT_EQ(LitRooms(file).red_on_floor("hill", {7.5, 2}), 0u);
    for (SectorRecord& s : file.sectors) s.ceiling.parallax = true;
    EXPECT_GT(LitRooms(file).red_on_floor("hill", {7.5, 2}), 0u);
}

TEST(OwnLight, IsOnPanelsFromBothSidesAlsoAlongDoorways) {
    MapFile file = rooms_of_one_lamp();
    PanelRecord panel;
    panel.a = {4.5, 1.5};
    panel.b = {4.5, 2.5};
    panel.top = 2;
    panel.texture = spec("cloth");
    sector(file, "east").panels = {panel};
    const LitRooms rooms(file);
    const double expected = formula(2.5, 2.5, 8);
    EXPECT_NEAR(lane(OwnLight(rooms.map, rooms.snapshot).on_panel(PanelId(0u), 0.5, 1), 0), expected, 0.51);
}

TEST(OwnLight, IsOnThingsWhatComesToTheirMiddle) {
    MapFile file = hall_with(lamp(1.5, 4));
    cut_pillar(sector(file, "hall"), 3, 3, 4, 5);
    file.things.resize(2);
    file.things[0].position = {1.5, 6};
    file.things[1].position = {6, 4};
    for (ThingRecord& thing : file.things) thing.frames = {{"figure", 0, {}}};
    const LitRooms rooms(file);
    const OwnLight light(rooms.map, rooms.snapshot);
    const double way = length(0, 2, rooms.map.things[0].height / 2 - 1);
    EXPECT_NEAR(lane(light.on_thing(ThingId(0u)), 0), formula(way, way, 8), 0.51);
    EXPECT_EQ(light.on_thing(ThingId(1u)), 0u);
}

TEST(OwnLight, DoesNotComeBackFromAMirror) {
    MapFile file = hall_with(lamp(4, 7)), mirrored = file;
    mirrored.sectors[0].loops[0].walls[0].mirror = true;
    EXPECT_EQ(LitRooms(file).on_floor("hall", {4, 2}), LitRooms(mirrored).on_floor("hall", {4, 2}));
}

TEST(OwnLight, ComesFromEachPlaceThatLinksPutALampAt) {
    MapFile file = map_of({box_room("room", 0, 0, 4, 4)});
    link(file, "room", {4, 0}, {4, 4}, "room", {0, 4}, {0, 0});  // out in the east, in again in the west
    file.lights = {lamp(1, 2)};
    double expected = 0;
    for (const double x : {-7, -3, 1, 5, 9}) expected += formula(length(3 - x, 0, 1), 1, 8);
    EXPECT_NEAR(LitRooms(file).red_on_floor("room", {3, 2}), expected, 1);
}

/// v turned by the angle whose cosine is 20/29: whole numbers of 29ths come onto the grid of vertices.
Vec2 turned(Vec2 v) { return {(20 * v.x - 21 * v.y) / 29, (21 * v.x + 20 * v.y) / 29}; }

/// How the room behind the doorway lies in the linked twin: four quarters and one odd angle.
Vec2 moved(Vec2 v, int way) {
    constexpr int kOdd = 4;
    if (way == kOdd) return turned(v) + Vec2{100, -50};
    for (int i = 0; i < way; ++i) v = right_of(v);
    return v + Vec2{100, -50};
}

/// Metres that a 29th of is on the grid.
constexpr double kUnit = 29.0 / 16;

/// Three rooms in a row, a pillar in the second and a lintel before the third, side by side or linked after the first.
MapFile lit_side_by_side() {
    MapFile file = map_of({box_room("near", 0, 0, 2 * kUnit, 2 * kUnit, 0, 3),
                           box_room("far", -2 * kUnit, 0, 0, 2 * kUnit, 0.25, 3),
                           box_room("end", -3 * kUnit, 0, -2 * kUnit, 2 * kUnit, 0.125, 0.75)});
    cut_pillar(sector(file, "far"), -1.5 * kUnit, kUnit, -kUnit, 1.5 * kUnit);
    join_all(file);
    file.lights = {lamp(0.7, 2.2, 1.4)};
    return file;
}

MapFile lit_far_apart(int way, double rise) {
    MapFile file = lit_side_by_side();
    for (const char* name : {"far", "end"}) {
        SectorRecord& room = sector(file, name);
        room.floor.z += rise;
        room.ceiling.z += rise;
        for (LoopRecord& loop : room.loops)
            for (Vec2& v : loop.vertices) v = moved(v, way);
    }
    link(file, "near", {0, 2 * kUnit}, {0, 0}, "far", moved({0, 0}, way), moved({0, 2 * kUnit}, way));
    wall(file, "near", {0, 2 * kUnit}, {0, 0}).rise = rise;
    return file;
}

// hard case I10
TEST(OwnLight, GoesThroughALinkAsThroughADoorway) {
    const LitRooms plain(lit_side_by_side());
    const OwnLight here(plain.map, plain.snapshot);
    for (int way = 0; way <= 4; ++way) {
        const LitRooms linked(lit_far_apart(way, 7.25));
        const OwnLight there(linked.map, linked.snapshot);
        Random random(9);
        std::size_t lit[2] = {}, dark[2] = {};
        for (int trial = 0; trial < 4000; ++trial) {
            const Vec2 at = snap_to_point_grid(Vec2{random.uniform(-3 * kUnit, 0), random.uniform(0, 2 * kUnit)});
            const std::string room = at.x < -2 * kUnit ? "end" : "far";
            if (!contains(plain.map, plain.sector(room), at)) continue;
            const Vec2 over = snap_to_point_grid(moved(at, way));
            const LightCell expected = here.on_floor(plain.sector(room), at);
            EXPECT_EQ(there.on_floor(linked.sector(room), over), expected) << way << ", " << at.x;
            ++(expected ? lit : dark)[room == "end"];
        }
        EXPECT_GT(lit[0], 500u);
        EXPECT_GT(dark[0], 100u);
        EXPECT_GT(lit[1], 50u);
        EXPECT_GT(dark[1], 50u);
    }
}

/// A hall with pillars and a room beside it, both dark but for three lamps; hardly anything is where grids have points.
MapFile pillared() {
    MapFile file = map_of({box_room("hall", 0.125, 0.375, 11.8125, 9.6875, 0, 3.3125),
                           box_room("side", 11.8125, 3.4375, 15.1875, 6.5625, 0, 2.4375)});
    split_and_join(file);
    for (const Vec2 at : {Vec2{2.4375, 2.8125}, Vec2{5.5625, 1.1875}, Vec2{6.3125, 6.4375}, Vec2{9.1875, 4.0625}})
        cut_pillar(sector(file, "hall"), at.x, at.y, at.x + 1.0625, at.y + 0.8125);
    for (SectorRecord& s : file.sectors) s.light = 0;
    file.lights = {lamp(4.3, 4.6, 1.4, 9), lamp(9.7, 7.3, 2.2, 8), lamp(13.6, 4.9, 0.9, 7)};
    for (PointLightRecord& light : file.lights) light.brightness = 0.5;
    return file;
}

/// Mean difference of grids from the light itself, on floors and walls.
double error_of_grids(const LitRooms& rooms, const OwnLight& truth, int points_per_m) {
    LightGrids grids(rooms.map, points_per_m);
    Random random(3);
    double sum = 0;
    int count = 0;
    const auto add = [&](const LightGrid* grid, double u, double v, LightCell light) {
        const LightCell shown = grid ? light_on(*grid, u, v) : 0;
        sum += std::fabs(static_cast<double>(lane(shown, 0)) - lane(light, 0));
        ++count;
    };
    for (int trial = 0; trial < 4000; ++trial) {
        const SectorId sector(random.below(rooms.map.sectors.size()));
        const Sector& room = rooms.map[sector];
        const Vec2 at{random.uniform(room.min.x, room.max.x), random.uniform(room.min.y, room.max.y)};
        if (contains(rooms.map, sector, snap_to_point_grid(at)))
            add(grids.on_floor(rooms.snapshot, sector), at.x, at.y, truth.on_floor(sector, at));
        const WallId wall(random.below(rooms.map.walls.size()));
        const double along = random.uniform(0, rooms.map[wall].length), z = random.uniform(0, 2.4);
        if (rooms.map[wall].kind == WallKind::solid)
            add(grids.on_wall(rooms.snapshot, wall), along, z, truth.on_wall(wall, along, z));
    }
    return sum / count;
}

TEST(OwnLight, IsWhatGridsComeNearToAsTheyGetFiner) {
    const LitRooms rooms(pillared());
    const OwnLight truth(rooms.map, rooms.snapshot);
    std::vector<double> errors;
    for (const int points_per_m : {1, 2, 4, 8, 16}) errors.push_back(error_of_grids(rooms, truth, points_per_m));
    for (std::size_t i = 0; i + 1 < errors.size(); ++i)
        EXPECT_LT(errors[i + 1], 0.7 * errors[i]) << "with " << (2 << i) << " points along a metre";
    for (std::size_t i = 0; i < errors.size(); ++i)
        std::printf("%d points along a metre: off by %.2f of 4096 in the mean\n", 1 << i, errors[i]);
    EXPECT_LT(errors.back(), 16) << "1/256 of full light";
}

// The picture of the default differs from the grids' own nowhere; that of the mode differs at shadow edges.
TEST(OwnLight, IsAModeOfTheReference) {
    const Rooms rooms(pillared());
    const View view = look_from(rooms.map, {0.7, 0.6}, 1.4, 40);
    LightGrids grids(rooms.map);
    const Picture by_grid = rooms.look(view, 96, 64), again = rooms.look(view, 96, 64, {1, 1, &grids});
    const Picture own = rooms.look(view, 96, 64, {.own_light = true}),
                  fast = rooms.look(view, 96, 64, {.workers = 3, .own_light = true});
    EXPECT_EQ(by_grid.frame.pixels, again.frame.pixels);
    EXPECT_EQ(own.frame.pixels, fast.frame.pixels);
    EXPECT_EQ(own.facts.ids, by_grid.facts.ids);
    std::size_t differ = 0;
    for (std::size_t i = 0; i < own.frame.pixels.size(); ++i) differ += own.frame.pixels[i] != by_grid.frame.pixels[i];
    EXPECT_GT(differ, 50u);
    EXPECT_LT(differ, own.frame.pixels.size() / 2);
}

}  // namespace
}  // namespace enfilade::test
