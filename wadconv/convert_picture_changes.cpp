// Animations and switches that the converted map takes part in.
#include <algorithm>
#include <set>

#include "wadconv/workbench.h"

namespace enfilade::wadconv {
namespace {

using Names = std::set<std::string, std::less<>>;

void add(const std::optional<TextureSpec>& spec, Names& names) {
    if (spec) names.insert(spec->name);
}

void add(const std::vector<TriggerRecord>& triggers, Names& names) {
    for (const TriggerRecord& trigger : triggers)
        if (!trigger.texture.empty()) names.insert(trigger.texture);
}

void add(const WallRecord& wall, Names& names) {
    for (const auto* spec : {&wall.texture, &wall.upper, &wall.lower, &wall.middle}) add(*spec, names);
    add(wall.triggers, names);
}

template <class Use>
void for_each_wall(const MapFile& file, const Use& use) {
    for (const SectorRecord& sector : file.sectors)
        for (const LoopRecord& loop : sector.loops)
            for (const WallRecord& wall : loop.walls) use(wall);
}

/// All pictures on walls, flats and panels, at some time.
Names pictures_of(const MapFile& file) {
    Names names;
    for_each_wall(file, [&](const WallRecord& wall) { add(wall, names); });
    for (const SectorRecord& sector : file.sectors) {
        add(sector.floor.texture, names);
        add(sector.ceiling.texture, names);
        for (const PanelRecord& panel : sector.panels) names.insert(panel.texture.name);
    }
    return names;
}

/// Those on walls that do something.
Names pictures_of_triggers(const MapFile& file) {
    Names names;
    for_each_wall(file, [&](const WallRecord& wall) {
        if (!wall.triggers.empty()) add(wall, names);
    });
    for (const SectorRecord& sector : file.sectors)
        for (const PanelRecord& panel : sector.panels) add(panel.triggers, names);
    return names;
}

}  // namespace

void convert_picture_changes(Workbench& bench) {
    const Names seen = pictures_of(bench.file), on_triggers = pictures_of_triggers(bench.file);
    const auto is_seen = [&](const std::string& picture) { return seen.contains(picture); };
    for (const AnimationRecord& animation : bench.pictures.animations())
        if (std::ranges::any_of(animation.frames, is_seen)) bench.file.animations.push_back(animation);
    for (const SwitchRecord& pair : bench.pictures.switches())
        if (on_triggers.contains(pair.off) || on_triggers.contains(pair.on)) bench.file.switches.push_back(pair);
}

}  // namespace enfilade::wadconv
