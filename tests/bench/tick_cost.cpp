// What a tick costs in a map where every sector has effects: `tick_cost SECTORS ACTIVE SEEN TICKS`. Of them, the last
// ACTIVE move for ever, and of SEEN somebody asks heights and light in every tick, as a renderer does. Prints the hash
// of what came of it. Meant to be counted by tick_cost.sh, not timed.
#include <cstdio>
#include <cstdlib>

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
        door.on = Occasion::use;
        sector.triggers = {door};
        sector.light_effect = LightEffectRecord{};
        sector.light_effect->kind = LightKind::flicker;
        sector.floor.scroll = {1, 0};
    }
    return file;
}

void set_moving(Map& map, std::size_t active) {
    Trigger shuttle;
    shuttle.deed = Deed::crush;
    shuttle.speed = 1;
    for (std::size_t i = 0; i < active; ++i) shuttle.targets.emplace_back(map.sectors.size() - 1 - i);
    map.at_start.emplace_back(map.triggers.size());
    map.triggers.push_back(shuttle);
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
    double sum = 0;
    for (std::size_t tick = 0; tick < number(4); ++tick) {
        step(map, world, {});
        show(now(map, world), snapshot);
        for (std::size_t i = 0; i < number(3); ++i)
            sum += light_at(snapshot, SectorId(i)) + snapshot[SectorId(i)].ceiling_z;
    }
    std::printf("%016llx %g\n", static_cast<unsigned long long>(hash(world)), sum);
    return 0;
}
