// `enfilade check`: every finding about maps, for authors and for editors that jump to a place.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "app/commands.h"
#include "app/effect_prices.h"
#include "app/file_kind.h"
#include "app/messages.h"
#include "app/open_map.h"
#include "app/sounds.h"
#include "base/files.h"
#include "base/terminal.h"
#include "formats/map_toml.h"
#include "formats/text_parts.h"
#include "map/load.h"

namespace enfilade {
namespace {

struct Tally {
    std::size_t maps = 0, refused = 0, errors = 0, warnings = 0;
};

void print_effects(const std::string& path, const TextureSet& textures) {
    const auto bytes = read_file(path);
    if (!bytes.ok()) return;
    const MapFile map = read_map(as_text(bytes.value())).map;
    print_text(stdout, fmt::format("{}: {}, and\n{}", path, counted(map.sectors.size(), "sector"),
                                   to_text(effect_prices(map, textures))));
}

/// What only a look at other files shows.
Findings findings_around(const std::string& path, const LoadedMap& loaded) {
    Findings findings;
    const auto warn = [&](TextPlace place, const char* code, std::string sentence) {
        findings.push_back({place, Severity::warning, code, std::move(sentence)});
    };
    for (const SoundFault& fault : load_sounds(*loaded.map, path, read_file).faults)
        warn(loaded.sounds[fault.sound.index].place, "bad-sound", fault.sentence);
    std::error_code unknown;
    for (const NamedFile& next : loaded.next_maps)
        if (const std::string there = next_map_path(path, next.name); !std::filesystem::exists(there, unknown))
            warn(next.place, "no-next-map",
                 fmt::format("expected a map in {}, to which this exit leads, found none; whoever takes it begins this "
                             "map again",
                             there));
    return findings;
}

/// All there is to say about one map; that it is none, where it is something else.
Findings findings_about(const std::string& path, const LoadedMap& loaded) {
    const bool was_read = loaded.findings.empty() || loaded.findings.front().code != "unreadable";
    if (!loaded.map)
        if (Status other = refuse_as_map(path))
            return {{{}, Severity::error, was_read ? "not-a-map" : "unreadable", other->what}};
    Findings findings = loaded.findings;
    if (loaded.map) std::ranges::copy(findings_around(path, loaded), std::back_inserter(findings));
    sort_by_place(findings);
    return findings;
}

void check_map(const std::string& path, const CheckRequest& request, Tally& tally) {
    const LoadedMap loaded = load_map(path, request.texture_folders, read_file, {}, list_folder);
    std::string text;
    for (const Finding& finding : findings_about(path, loaded)) {
        text += to_text(path, finding) + '\n';
        ++(finding.severity == Severity::error ? tally.errors : tally.warnings);
    }
    print_text(stdout, text);
    ++tally.maps;
    tally.refused += has_errors(loaded.findings);
    if (request.effects && loaded.map) print_effects(path, loaded.textures);
}

}  // namespace

int run_check(const CheckRequest& request) {
    Tally tally;
    for (const std::string& map : maps_in_folders(request.maps)) check_map(map, request, tally);
    print_text(stdout, fmt::format("{} checked, {} refused: {}, {}\n", counted(tally.maps, "map"), tally.refused,
                                   counted(tally.errors, "error"), counted(tally.warnings, "warning")));
    return tally.refused == 0 ? kDone : kFailed;
}

}  // namespace enfilade
