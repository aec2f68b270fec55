// Worlds to walk around in at random, and somebody who does.
#pragma once
#include <vector>

#include "base/hash.h"
#include "space/mosaic.h"
#include "world/game.h"

namespace enfilade::test {

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

/// The world with the player somewhere in the map.
inline World start_somewhere(const Map& map, Random& random) {
    while (true) {
        const Sector& box = map.sectors[random.below(map.sectors.size())];
        const Vec2 p{random.uniform(box.min.x, box.max.x), random.uniform(box.min.y, box.max.y)};
        const Vec2 point = snap_to_point_grid(p);
        const SectorId sector = locate(map, point);
        if (!sector) continue;
        World world;
        world.player = player_at(map, {sector, point, map[sector].floor.z + kEyeOnFloor, {}});
        world.before = world.player;
        return world;
    }
}

/// Sectors of wild shapes with floors and ceilings at many heights, from closed to high.
inline Map mosaic_of_steps(std::uint64_t seed) {
    MosaicPlan plan;
    plan.spacing = seed % 3 == 0 ? 0.5 : 2;
    plan.jitter = seed % 2 == 0 ? 0.1 : 0;
    plan.labels = 20;
    plan.solid = 0.15;
    Map map = lay_mosaic(plan, seed).map;
    Random random(seed);
    for (Sector& sector : map.sectors) {
        sector.floor.z = static_cast<double>(random.below(7)) * 0.25;
        sector.ceiling.z = sector.floor.z + static_cast<double>(random.below(12)) * 0.25;
    }
    return map;
}

/// Two octagons with sides of 29/16 m, at different heights. Fourteen sides are links between them at random, which
/// turn by angles whose sine is 20/29, 21/29 and others; two are walls. Around a corner angles add up to anything.
inline Map octagons_of_links(std::uint64_t seed) {
    const Vec2 sides[] = {{29, 0}, {20, 21}, {0, 29}, {-20, 21}, {-29, 0}, {-20, -21}, {0, -29}, {20, -21}};
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
    for (std::size_t i = 0; i < 14; i += 2) {
        const std::size_t r = order[i] / 8, s = order[i + 1] / 8;
        link(file, std::to_string(r), corners[r][order[i] % 8], corners[r][(order[i] + 1) % 8], std::to_string(s),
             corners[s][order[i + 1] % 8], corners[s][(order[i + 1] + 1) % 8]);
    }
    return built(file);
}

}  // namespace enfilade::test
