// Long random walks: the player never leaves the world, never gets into a wall, and every machine agrees where it ends.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <iostream>

#include "base/files.h"
#include "base/random.h"
#include "map/load.h"
#include "space/mosaic.h"
#include "world/camera.h"
#include "world/game.h"

namespace enfilade {
namespace {

using namespace test;

/// Runs, turns and crouches as a bored person does: the same keys for a while, then others.
class RandomKeys {
public:
    explicit RandomKeys(std::uint64_t seed) : random_(seed) {}

    TickInput next() {
        if (random_.below(20) == 0) {
            keys_.forward = static_cast<std::int8_t>(random_.below(4) == 0 ? -127 : 127);
            keys_.strafe = static_cast<std::int8_t>(127 * (static_cast<int>(random_.below(3)) - 1));
            keys_.buttons = static_cast<std::uint8_t>(random_.below(4));
            keys_.yaw_steps = static_cast<std::int32_t>(random_.bits()) / 128;
        }
        return keys_;
    }

private:
    Random random_;
    TickInput keys_;
};

bool is_finite(const Player& p) {
    return std::isfinite(p.feet_z) && std::isfinite(p.eye_z) && std::isfinite(p.velocity.x) &&
           std::isfinite(p.velocity.y) && std::isfinite(p.place.point.x) && std::isfinite(p.place.point.y);
}

/// Walks for some ticks and checks after each; gives the hash of the end.
std::uint64_t soak(const Map& map, World world, std::uint64_t seed, int ticks) {
    RandomKeys keys(seed);
    bool was_free = false;
    for (int i = 0; i < ticks && !testing::Test::HasFatalFailure(); ++i) {
        SCOPED_TRACE(testing::Message() << map.name << ", seed " << seed << ", tick " << i);
        step(map, world, keys.next());
        const Player& player = world.player;
        [&] {
            ASSERT_TRUE(is_finite(player));
            ASSERT_TRUE(contains(map, player.place.sector, player.place.point));
            const Body body = body_of(map, player);
            // Who is free of walls stays free of them.
            ASSERT_TRUE(!was_free || body.radius == kBodyRadius);
            was_free = body.radius == kBodyRadius;
            ASSERT_LE(player.eye_z, body.ceiling_z);
            const Eye eye = eye_between_ticks(map, world, 0.5);
            ASSERT_TRUE(contains(map, eye.place.sector, eye.place.point));
        }();
    }
    return hash(world);
}

World start_at(const Map& map, const Place& place) {
    World world;
    world.player = world.before = player_at(map, {place.sector, place.point, map[place.sector].floor.z + 1.55, {}});
    return world;
}

Place somewhere(const Map& map, Random& random) {
    while (true) {
        const Sector& sector = map.sectors[random.below(map.sectors.size())];
        const Vec2 p{random.uniform(sector.min.x, sector.max.x), random.uniform(sector.min.y, sector.max.y)};
        const Vec2 point = snap_to_point_grid(p);
        if (const SectorId found = locate(map, point)) return {found, point};
    }
}

TEST(Soak, StaysInTheWorldOverMosaicsOfSteps) {
    std::uint64_t sum = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const MosaicPlan plan{
            .spacing = seed % 3 == 0 ? 0.5 : 2, .jitter = seed % 2 == 0 ? 0.1 : 0, .labels = 20, .solid = 0.15};
        Mosaic mosaic = lay_mosaic(plan, seed);
        Random random(seed);
        for (Sector& sector : mosaic.map.sectors) {
            sector.floor.z = static_cast<double>(random.below(7)) * 0.25;
            sector.ceiling.z = sector.floor.z + static_cast<double>(random.below(12)) * 0.25;
        }
        sum ^= soak(mosaic.map, start_at(mosaic.map, somewhere(mosaic.map, random)), seed, 2000);
    }
    std::cout << "hash " << sum << "\n";
}

TEST(Soak, StaysInTheWorldWhereEveryDoorwayIsALink) {
    // Octagons with sides of 29/16 m; the links between them turn by angles whose sine is 20/29, 21/29 and others.
    const Vec2 sides[] = {{29, 0}, {20, 21}, {0, 29}, {-20, 21}, {-29, 0}, {-20, -21}, {0, -29}, {20, -21}};
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        std::vector<Vec2> corners[2];
        std::vector<SectorRecord> rooms;
        for (int r = 0; r < 2; ++r) {
            corners[r].push_back({r * 50.0, r * 17.0});
            for (int i = 0; i < 7; ++i) corners[r].push_back(corners[r].back() + sides[i] * 0x1p-4);
            rooms.push_back(room(std::to_string(r), corners[r], r * 3, r * 3 + 2));
        }
        MapFile file = map_of(std::move(rooms));
        Random random(seed);
        std::vector<std::size_t> order(16);
        for (std::size_t i = 0; i < 16; ++i) order[i] = i;
        for (std::size_t i = 16; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
        for (std::size_t i = 0; i < 14; i += 2) {  // two sides stay walls
            const std::size_t r = order[i] / 8, s = order[i + 1] / 8;
            link(file, std::to_string(r), corners[r][order[i] % 8], corners[r][(order[i] + 1) % 8], std::to_string(s),
                 corners[s][order[i + 1] % 8], corners[s][(order[i + 1] + 1) % 8]);
        }
        const Map map = built(file);
        soak(map, start_at(map, somewhere(map, random)), seed, 2000);
    }
}

TEST(Soak, StaysInTheWorldInTheMapsThatComeWithTheEngine) {
    for (const auto& entry : std::filesystem::directory_iterator(ENFILADE_SOURCE_DIR "/maps")) {
        if (entry.path().extension() != ".toml") continue;
        const LoadedMap loaded = load_map(entry.path().string(), {}, read_file);
        ASSERT_TRUE(loaded.map.has_value()) << entry.path();
        const std::optional<World> start = start_of(*loaded.map);
        ASSERT_TRUE(start.has_value()) << entry.path();
        soak(*loaded.map, *start, 1, 3000);
    }
}

}  // namespace
}  // namespace enfilade
