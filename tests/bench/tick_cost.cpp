// What a tick costs in a map where every sector has effects: `tick_cost SECTORS ACTIVE SEEN TICKS`. Of them, the last
// ACTIVE move for ever, and of SEEN somebody asks heights and light in every tick, as a renderer does. Prints what the
// ticks took from the heap, the first aside, and the hash of what came of them. Meant to be counted by tick_cost.sh,
// not timed.
#include <valgrind/callgrind.h>

#include <cstdio>
#include <cstdlib>

#include "support/count_allocations.h"
#include "support/generate_map.h"
#include "world/snapshot.h"
#include "world/step.h"

using namespace enfilade;

namespace {

/// Doors, flickering lights and scrolling floors everywhere.
MapFile busy_map(std::size_t sectors) {
    MapFile file = test::RoomGrid(sectors, 1).take();
    for (SectorRecord& sector : file.sectors) {
        TriggerRecord door;
        door.on = Activation::use;
        sector.triggers = {door};
        sector.light_effect = LightEffectRecord{};
        sector.light_effect->kind = LightKind::flicker;
        sector.floor.scroll = {1, 0};
    }
    return file;
}

/// Of all that moves, so that in a map of any size the same is moving at the same time [m].
constexpr double kStroke = 3;

void set_moving(Map& map, std::size_t active) {
    Trigger shuttle;
    shuttle.action = TriggerAction::crush;
    shuttle.speed = 1;
    shuttle.targets = {static_cast<std::uint32_t>(map.targets.size()), static_cast<std::uint32_t>(active)};
    for (std::size_t i = 0; i < active; ++i) {
        map.targets.emplace_back(map.sectors.size() - 1 - i);
        Sector& sector = map.sectors[map.targets.back().index];
        sector.floor.z = 0;
        sector.ceiling.z = kStroke;
    }
    map.at_start.emplace_back(map.triggers.size());
    map.triggers.push_back(shuttle);
}

/// What the ticks gave.
struct Outcome {
    std::size_t allocations;
    std::uint64_t hash;
    double seen;
};

/// What is counted: not inlined, so that callgrind finds it by its name.
[[gnu::noinline]] Outcome run_ticks(const Map& map, World& world, Snapshot& snapshot, std::size_t seen,
                                    std::size_t ticks) {
    double sum = 0;
    std::size_t before = 0;
    for (std::size_t tick = 0; tick < ticks; ++tick) {
        if (tick == 1) before = test::allocations();
        step(map, world, {});
        show(now(map, world), snapshot);
        for (std::size_t i = 0; i < seen; ++i) sum += light_at(snapshot, SectorId(i)) + snapshot[SectorId(i)].ceiling_z;
    }
    return {test::allocations() - before, hash(world), sum};
}

}  // namespace

int main(int count, char** words) {
    if (count != 5) {
        std::fprintf(stderr, "usage: tick_cost SECTORS ACTIVE SEEN TICKS\n");
        return 2;
    }
    const auto number = [&](int i) { return static_cast<std::size_t>(std::strtoull(words[i], nullptr, 10)); };
    Map map = test::built(busy_map(number(1)));
    set_moving(map, number(2));
    World world = *start_of(map);
    Snapshot snapshot = at_rest(map);
    CALLGRIND_START_INSTRUMENTATION;  // building a hundred thousand sectors is not of interest, and slow when counted
    const Outcome end = run_ticks(map, world, snapshot, number(3), number(4));
    std::printf("%zu allocations, %016llx %g\n", end.allocations, static_cast<unsigned long long>(end.hash), end.seen);
    return 0;
}
