// Walks through FreeDoom: from each player's start over all that can be reached, never out of the world, never stuck.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "space/trace.h"
#include "wadconv/freedoom/explorer.h"
#include "wadconv/freedoom/wads.h"
#include "world/step.h"

namespace enfilade::test {
namespace {

constexpr int kTicks = 2000, kTicksOfALongRun = 20000;
/// Who does not move by kMinMove in so many ticks, a quarter of them spent on going in random directions, is stuck.
constexpr int kStuckTicks = 1500;
constexpr double kMinMove = 0.125;  ///< [m]

class FreeDoomWalks : public ::testing::TestWithParam<FreeDoomWad> {};

/// Notices who stays in one place.
class StuckWatch {
public:
    /// True where the body has not moved for too long.
    bool is_stuck(const Player& player) {
        const Vec2 moved = player.place.point - anchor_;
        if (dot(moved, moved) > kMinMove * kMinMove) {
            anchor_ = player.place.point;
            still_ = 0;
        }
        return ++still_ > kStuckTicks;
    }

private:
    Vec2 anchor_;
    int still_ = 0;
};

std::size_t count(const std::vector<bool>& marked) {
    return static_cast<std::size_t>(std::ranges::count(marked, true));
}

/// What came of a walk: sectors seen, of those a body gets to, of those that steps lead to, of all.
struct Tally {
    std::size_t seen = 0, in_reach = 0, up_steps = 0, all = 0;

    void operator+=(const Tally& t) {
        seen += t.seen;
        in_reach += t.in_reach;
        up_steps += t.up_steps;
        all += t.all;
    }
};

/// Looking over the whole floor takes longer than a short walk; only a long one is meant to see all of it.
std::string in_reach_text(const Tally& tally) {
    return is_long_run() ? " of " + std::to_string(tally.in_reach) + " in reach," : "";
}

void print_row(const std::string& name, const Tally& tally, const std::string& sectors) {
    std::printf("%-6s %5zu%s of %5zu sectors that steps lead to, %5zu in all%s\n", name.c_str(), tally.seen,
                in_reach_text(tally).c_str(), tally.up_steps, tally.all, sectors.c_str());
}

/// The map with nothing that happens in it: what is in reach stays so, and nobody is sent elsewhere.
Map stilled(Map map) {
    map.at_start.clear();
    for (Wall& wall : map.walls) wall.triggers = {};
    for (Panel& panel : map.panels) panel.triggers = {};
    for (Thing& thing : map.things) thing.triggers = {};
    for (Sector& sector : map.sectors) {
        sector.triggers = {};
        sector.damage = 0;
    }
    return map;
}

void walk(const std::string& name, const Map& map, Tally& total) {
    std::optional<World> world = start_of(map);
    ASSERT_TRUE(world) << name << " has no start";
    Explorer explorer(map, 1);
    Tally tally;
    if (is_long_run()) tally.in_reach = count(Explorer(map, 1).in_reach(world->player));
    StuckWatch watch;
    const int ticks = is_long_run() ? kTicksOfALongRun : kTicks;
    for (int tick = 0; tick < ticks; ++tick) {
        step(map, *world, explorer.next(*world));
        const Place& place = world->player.place;
        ASSERT_TRUE(contains(map, place.sector, place.point)) << name << ", tick " << tick;
        ASSERT_FALSE(watch.is_stuck(world->player))
            << name << ", tick " << tick << ": in sector " << map[place.sector].name << " at " << place.point.x << ", "
            << place.point.y;
    }
    tally.seen = explorer.visited_count();
    tally.up_steps = count(walkable_from(map, map.player->sector));
    tally.all = map.sectors.size();
    print_row(name, tally, ": " + ranges_text(explorer.visited()));
    total += tally;
}

// hard case W14
TEST_P(FreeDoomWalks, LeadThroughEveryMap) {
    if (is_missing(GetParam())) GTEST_SKIP() << kMissing;
    const ConvertedWad wad(GetParam(), Doors::open);
    ASSERT_EQ(wad.maps().size(), GetParam().maps) << wad.error();
    Tally total;
    for (const std::string& name : wad.maps()) {
        const LoadedMap loaded = wad.load(name, kUsualSkill);
        ASSERT_TRUE(loaded.map) << name;
        walk(name, stilled(*loaded.map), total);
    }
    print_row("all", total, "");
}

INSTANTIATE_TEST_SUITE_P(Wads, FreeDoomWalks, freedoom_wads(), name_of);

}  // namespace
}  // namespace enfilade::test
