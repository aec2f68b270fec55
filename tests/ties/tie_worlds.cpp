#include "ties/tie_worlds.h"

#include <filesystem>

#include "base/result.h"
#include "hard_cases/scenes.h"
#include "support/map_builder.h"
#include "support/shipped_maps.h"
#include "wild/worlds.h"

namespace enfilade::test {
namespace {

TieWorld world_of(const std::string& name, const MapFile& file) {
    Map map = built(file);
    Snapshot snapshot = at_rest(map);
    return {name, std::move(map), textures_for(file), std::move(snapshot)};
}

TieWorld scene(std::uint64_t number) {
    std::vector<NamedScene> scenes = plain_scenes();
    for (const NamedScene& linked : linked_scenes()) scenes.insert(scenes.end(), 3, linked);  // few, and hard
    const NamedScene& chosen = scenes[number % scenes.size()];
    return world_of(chosen.name, chosen.file());
}

}  // namespace

TieWorld laid_bare(TieWorld world) {
    for (Wall& wall : world.map.walls) wall.middle = {};
    for (Sector& sector : world.map.sectors) sector.panel_count = 0;
    world.snapshot = at_rest(world.map);
    leave_out({.things = true}, world.snapshot);
    return world;
}

TieWorlds::TieWorlds() {
    for (const std::string& path : shipped_maps()) {
        LoadedMap loaded = load_map(path, {}, read_file);
        ENFILADE_CHECK(loaded.map);
        Snapshot snapshot = at_rest(*loaded.map);
        shipped_.push_back({"maps/" + std::filesystem::path(path).filename().string(), std::move(*loaded.map),
                            std::move(loaded.textures), std::move(snapshot)});
        shipped_bare_.push_back(laid_bare(shipped_.back()));
    }
}

void TieWorlds::visit(std::uint64_t round, const std::function<void(const TieWorld&, bool)>& look) const {
    Random random(round);
    const std::uint64_t lot = random.below(8);
    const bool is_bare = random.below(2) == 0;
    if (lot >= 6) return look((is_bare ? shipped_bare_ : shipped_)[random.below(shipped_.size())], is_bare);
    TieWorld world =
        lot < 4 ? world_of("wild world " + std::to_string(round), wild_world(round)) : scene(random.below(1000));
    look(is_bare ? laid_bare(std::move(world)) : world, is_bare);
}

}  // namespace enfilade::test
