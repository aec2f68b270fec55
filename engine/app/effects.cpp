#include "app/effects.h"

#include <fmt/format.h>

#include <algorithm>

namespace enfilade {
namespace {

template <class Test>
std::size_t count_walls(const MapFile& map, Test test) {
    std::size_t count = 0;
    for (const SectorRecord& sector : map.sectors)
        for (const LoopRecord& loop : sector.loops) count += std::size_t(std::ranges::count_if(loop.walls, test));
    return count;
}

template <class Test>
std::size_t count_flats(const MapFile& map, Test test) {
    std::size_t count = 0;
    for (const SectorRecord& sector : map.sectors) count += std::size_t{test(sector.floor)} + test(sector.ceiling);
    return count;
}

std::size_t count_panels(const MapFile& map) {
    std::size_t count = 0;
    for (const SectorRecord& sector : map.sectors) count += sector.panels.size();
    return count;
}

bool has_middle(const WallRecord& wall) { return wall.middle && wall.middle->name != "-"; }

}  // namespace

std::vector<EffectUse> effects_in(const MapFile& map) {
    const auto animated = std::ranges::count_if(map.things, [](const ThingRecord& t) { return t.frames.size() > 1; });
    std::vector<EffectUse> all{
        {"sky", count_flats(map, [](const FlatRecord& flat) { return flat.parallax; }), "flats",
         "one direction for each column that shows it"},
        {"linked portals", count_walls(map, [](const WallRecord& wall) { return !wall.via.empty(); }), "walls",
         "the rooms behind, drawn once for each way they are seen"},
        {"mirrors", count_walls(map, [](const WallRecord& wall) { return wall.mirror; }), "walls",
         "the rooms in front, drawn once more while the mirror is in view"},
        {"masked walls", count_walls(map, has_middle), "walls", "a second pass over the pixels they cover"},
        {"panels", count_panels(map), "walls", "a second pass over the pixels they cover"},
        {"things", map.things.size(), "things", "a second pass over the pixels they cover"},
        {"animated things", std::size_t(animated), "things", "one look at the clock while in view"},
    };
    std::erase_if(all, [](const EffectUse& use) { return use.count == 0; });
    return all;
}

std::string to_text(const std::vector<EffectUse>& effects) {
    if (effects.empty()) return "  nothing beyond plain rooms\n";
    std::string text;
    for (const EffectUse& use : effects)
        text += fmt::format("  {:<16}{:>7} {:<8}{}\n", use.name, use.count, use.counted, use.cost);
    return text;
}

}  // namespace enfilade
