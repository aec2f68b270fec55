#include "map/load.h"

#include <utility>

#include "map/draft.h"

namespace enfilade {

void Draft::error(TextPlace place, std::string_view code, std::string sentence) {
    ++error_count;
    if (error_count == kMostErrors + 1)
        findings.push_back({{}, Severity::error, "too-many-errors", "there are more errors than these"});
    if (error_count <= kMostErrors)
        findings.push_back({place, Severity::error, std::string(code), std::move(sentence)});
}

void Draft::warning(TextPlace place, std::string_view code, std::string sentence) {
    if (!was_sound) return;
    ++warning_count;
    if (warning_count == kMostWarnings + 1)
        findings.push_back({{}, Severity::warning, "too-many-warnings", "there are more warnings than these"});
    if (warning_count <= kMostWarnings)
        findings.push_back({place, Severity::warning, std::string(code), std::move(sentence)});
}

std::optional<Map> build_map(const MapFile& file, const TextureSet& textures, Findings& findings) {
    Draft draft{file, textures, findings, {}, {}, {}, {}, {}, !has_errors(findings)};
    draft.map.name = file.name;
    draft.map.render = file.render;
    place_walls(draft);
    check_sectors(draft);
    gather_groups(draft);
    check_loops(draft);
    place_panels(draft);
    resolve_portals(draft);
    link_walls(draft);
    lay_surfaces(draft);
    check_textures(draft);
    place_inhabitants(draft);
    place_triggers(draft);
    place_keys(draft);
    place_sounds(draft);
    place_suns(draft);
    note_picture_changes(draft);
    if (has_errors(findings)) return std::nullopt;
    list_near_things(draft.map);
    return std::move(draft.map);
}

}  // namespace enfilade
