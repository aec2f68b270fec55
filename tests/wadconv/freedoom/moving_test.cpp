// FreeDoom with all that moves in it: somebody with all keys runs about at random and uses whatever is there.
#include <cstdio>

#include "wadconv/freedoom/wads.h"
#include "world/soak.h"
#include "world/trigger_actions.h"

namespace enfilade::test {
namespace {

constexpr int kMovingTicks = 3000, kMovingTicksOfALongRun = 1'000'000;
constexpr int kStarts = 10;  ///< places from which the ticks are run, a part each

struct LevelsOfWad {
    FreeDoomWad wad;
    std::vector<std::string> levels;
};

/// Before a wall that has triggers, looking at it, a metre away; or none where there is no room.
std::optional<PlayerStart> before_a_trigger(const Map& map, Random& random) {
    std::vector<const Wall*> walls;
    for (const Wall& wall : map.walls)
        if (wall.triggers.count > 0) walls.push_back(&wall);
    if (walls.empty()) return {};
    const Wall& wall = *walls[random.below(walls.size())];
    const Vec2 inward = right_of(wall.b - wall.a) * (1 / wall.length);
    const Vec2 point = snap_to_point_grid((wall.a + wall.b) * 0.5 + inward);
    if (!contains(map, wall.sector, point)) return {};
    return PlayerStart{wall.sector, point, map[wall.sector].floor.z + kEyeOnFloor, angle_of(inward * -1)};
}

/// Somebody with all keys who can stand upright there.
World with_keys_before_a_trigger(const Map& map, std::uint64_t seed) {
    Random random(seed);
    World world;
    while (world.player.height < kStandingHeight || !world.player.place.sector)
        if (const auto start = before_a_trigger(map, random)) world.player = world.before = player_at(map, *start);
    world.history = begun(map);
    world.keys = ~std::uint64_t{0};
    return world;
}

class FreeDoomMoves : public ::testing::TestWithParam<LevelsOfWad> {};

// hard cases C21, W14, I11
TEST_P(FreeDoomMoves, AndNobodyIsEverInWhatIsSolid) {
    if (is_missing(GetParam().wad)) GTEST_SKIP() << kMissing;
    const ConvertedWad converted(GetParam().wad, Doors::as_they_are, GetParam().levels);
    ASSERT_EQ(converted.maps().size(), GetParam().levels.size()) << converted.error();
    const int ticks = is_long_run() ? kMovingTicksOfALongRun : kMovingTicks;
    std::size_t changes = 0;
    for (const std::string& name : converted.maps()) {
        const LoadedMap loaded = converted.load(name);
        ASSERT_TRUE(loaded.map) << name;
        std::size_t went_off = 0;
        for (std::uint64_t seed = 0; seed < kStarts; ++seed) {
            const World end = soak(*loaded.map, with_keys_before_a_trigger(*loaded.map, seed), seed, ticks / kStarts);
            went_off += end.history.firings().size();
            changes += end.history.changes().size();
        }
        std::printf("%-6s %5zu triggers, went off %5zu times\n", name.c_str(), loaded.map->triggers.size(), went_off);
    }
    EXPECT_GT(changes, 50u);
}

INSTANTIATE_TEST_SUITE_P(Wads, FreeDoomMoves,
                         ::testing::Values(LevelsOfWad{{"freedoom1", 36}, {"E1M1", "E1M2", "E2M1", "E3M1", "E4M1"}},
                                           LevelsOfWad{{"freedoom2", 32},
                                                       {"MAP01", "MAP02", "MAP07", "MAP12", "MAP20"}}),
                         [](const auto& param) { return std::string(param.param.wad.name); });

}  // namespace
}  // namespace enfilade::test
