// Where lights shine, and that no map, however hostile, makes more of it than can be worked out.
#include "render/light_patch.h"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "base/files.h"
#include "render/lighting.h"
#include "support/count_allocations.h"
#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;

PointLightRecord lamp_at(Vec2 at, double reach, double z = 1) {
    PointLightRecord light;
    light.position = at;
    light.z = z;
    light.reach = reach;
    return light;
}

/// Rooms side by side, each open to the next.
MapFile slivers(int count, double width, double length) {
    std::vector<SectorRecord> rooms;
    for (int i = 0; i < count; ++i)
        rooms.push_back(box_room("room" + std::to_string(i), i * width, 0, (i + 1) * width, length));
    MapFile file = map_of(std::move(rooms));
    split_and_join(file);
    return file;
}

/// One room with a wall for each part of a circle.
MapFile round_room(int walls, double radius) {
    std::vector<Vec2> corners;
    for (int i = 0; i < walls; ++i) {
        const double turn = 2 * std::numbers::pi * i / walls;
        corners.push_back(snap_to_vertex_grid({radius * std::cos(turn), radius * std::sin(turn)}));
    }
    return map_of({room("round", corners)});
}

/// What asking for all light of a map takes at one time [bytes].
std::size_t memory_of_all_light(const Map& map) {
    const Snapshot snapshot = at_rest(map);
    const std::size_t before = restart_peak();
    LightGrids grids(map);
    for (std::size_t i = 0; i < map.walls.size(); ++i) grids.on_wall(snapshot, WallId(i));
    for (std::size_t i = 0; i < map.sectors.size(); ++i) {
        grids.on_floor(snapshot, SectorId(i));
        grids.on_ceiling(snapshot, SectorId(i));
    }
    return peak_bytes() - before;
}

constexpr std::size_t kMiB = std::size_t{1} << 20;

TEST(LightImages, OfEveryShippedMapAreAllThere) {
    std::size_t lights = 0;
    for (const auto& entry : std::filesystem::directory_iterator(ENFILADE_SOURCE_DIR "/maps")) {
        if (entry.path().extension() != ".toml") continue;
        const LoadedMap loaded = load_map(entry.path().string(), {}, read_file);
        if (!loaded.map) continue;
        const LightImages images(*loaded.map);
        EXPECT_FALSE(images.left_out()) << entry.path();
        EXPECT_LE(images.work(), kMostLightWork / 6) << entry.path();
        lights += loaded.map->lights.size();
    }
    EXPECT_GT(lights, 100u);
}

TEST(LightImages, AreLeftOutFromTheFirstLightThatCannotBeWorkedOut) {
    MapFile file = slivers(400, 0.0625, 16);
    for (int i = 0; i < 1000; ++i) file.lights.push_back(lamp_at({0.03125 + 0.0625 * (i % 400), 8}, 8));
    const Map map = built(file);
    const LightImages images(map);
    ASSERT_TRUE(images.left_out());
    EXPECT_GT(*images.left_out(), 0u);
    for (std::size_t i = 0; i < map.sectors.size(); ++i)
        for (const LightImage& image : images.in(SectorId(i))) EXPECT_LE(image.light, *images.left_out());
    EXPECT_LT(memory_of_all_light(map), 768 * kMiB);
}

TEST(LightImages, CostNoMoreThanMayBeSpentAndOneLight) {
    MapFile file = round_room(4000, 60);
    for (int i = 0; i < 1000; ++i) file.lights.push_back(lamp_at({i % 50 - 25.0, i / 50 - 10.0}, 8));
    const LightImages images(built(file));
    EXPECT_TRUE(images.left_out());
    file.lights.resize(1);
    EXPECT_LE(images.work(), kMostLightWork + 2 * LightImages(built(file)).work());
}

TEST(LightImages, DoNotDependOnWhatComesAfterThem) {
    MapFile file = slivers(8, 1, 16);
    file.lights = {lamp_at({0.5, 8}, 4), lamp_at({6.5, 8}, 4)};
    const Map both = built(file);
    file.lights.pop_back();
    const Map one = built(file);
    EXPECT_EQ(LightImages(one).in(SectorId(0u)).size(), 1u);
    EXPECT_EQ(LightImages(both).in(SectorId(0u)).size(), 1u);
    EXPECT_EQ(LightImages(both).in(SectorId(4u)).size(), 2u);
    EXPECT_LT(LightImages(one).work(), LightImages(both).work());
}

// Two lamps at opposite ends of a plain made its floor's grid as large as the plain: five gigabytes for four
// kilometres, and no picture at all of thirty.
TEST(LightGrids, OfLampsFarApartTakeLittleMemoryAndShineWhereTheyAre) {
    for (const double half : {200.0, 2000.0, 15000.0}) {
        MapFile file = map_of({box_room("plain", -half, -half, half, half, 0, 100)});
        const double far = half - 20;
        file.lights = {lamp_at({-far, -far}, 64, 4), lamp_at({far, far}, 64, 4)};
        const Map map = built(file);
        EXPECT_LT(memory_of_all_light(map), 256 * kMiB) << half;
        const Snapshot snapshot = at_rest(map);
        LightGrids grids(map);
        const LightGrid* floor = grids.on_floor(snapshot, SectorId(0u));
        ASSERT_TRUE(floor) << half;
        EXPECT_GT(lane(light_on(*floor, far, far), 0), kMostLight / 8) << half;
        EXPECT_EQ(light_on(*floor, 0, 0), 0u) << half;
    }
}

TEST(LightGrids, OfLampsNearEachOtherAreAsDenseAsIsAskedFor) {
    MapFile file = map_of({box_room("plain", 0, 0, 300, 300, 0, 100)});
    file.lights = {lamp_at({20, 20}, 16, 4), lamp_at({280, 280}, 16, 4)};
    const Map map = built(file);
    const Snapshot snapshot = at_rest(map);
    EXPECT_EQ(LightGrids(map, 8).on_floor(snapshot, SectorId(0u))->per_m, 8);
}

}  // namespace
}  // namespace enfilade
