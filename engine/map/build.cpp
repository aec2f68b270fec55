#include "map/build.h"

#include <utility>

#include "map/draft.h"

namespace enfilade {

std::optional<Map> build_map(const MapFile& file, const TextureSet& textures, Findings& findings) {
    Draft draft{file, textures, findings, {}, {}, {}, {}};
    draft.map.name = file.name;
    draft.map.render = file.render;
    place_walls(draft);
    check_sectors(draft);
    check_loops(draft);
    resolve_portals(draft);
    link_walls(draft);
    lay_surfaces(draft);
    place_inhabitants(draft);
    if (has_errors(findings)) return std::nullopt;
    return std::move(draft.map);
}

}  // namespace enfilade
