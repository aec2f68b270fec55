#include "hard_cases/linked_maps.h"

#include "base/files.h"
#include "base/result.h"

namespace enfilade::test {

LoadedMap load_linked_map(const std::string& name) {
    LoadedMap loaded = load_map(ENFILADE_SOURCE_DIR "/maps/" + name + ".toml", {}, read_file);
    ENFILADE_CHECK(loaded.map.has_value());
    return loaded;
}

std::vector<WallId> links_of(const Map& map) {
    std::vector<WallId> links;
    for (std::size_t i = 0; i < map.walls.size(); ++i)
        if (map.walls[i].kind == WallKind::portal && map.walls[i].link != Wall::kNoLink) links.emplace_back(i);
    return links;
}

SectorId sector_called(const Map& map, const std::string& name) {
    for (std::size_t i = 0; i < map.sectors.size(); ++i)
        if (map.sectors[i].name == name) return SectorId(i);
    ENFILADE_CHECK(false);
    return {};
}

}  // namespace enfilade::test
