// `enfilade check`: every finding about maps, for authors and for editors that jump to a place.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "app/bench.h"
#include "app/commands.h"
#include "app/messages.h"
#include "app/open_map.h"
#include "app/sounds.h"
#include "base/file_name.h"
#include "base/files.h"
#include "formats/map_toml.h"
#include "formats/text_parts.h"
#include "map/load.h"
#include "render/light_patch.h"

namespace enfilade {
namespace {

/// Nothing where the map cannot be read any more.
std::string effects_text(const std::string& path, const TextureSet& textures) {
    const auto bytes = read_file(path);
    if (!bytes.ok()) return "";
    const MapFile map = read_map_at(path, as_text(bytes.value()), read_file).map;
    return fmt::format("{}: {}, and\n{}", path, counted(map.sectors.size(), "sector"),
                       to_text(effect_prices(map, textures)));
}

/// "; did you mean 'X'?" with the sound that is called nearly so, where there is none of this name.
std::string nearest_sound(const std::string& map_path, const std::string& name) {
    const std::filesystem::path file = std::filesystem::path(map_path).parent_path() / name;
    std::error_code unknown;
    if (std::filesystem::exists(file, unknown)) return "";
    const std::string folder = file.parent_path().string();
    const std::vector<std::string> names = list_folder(folder.empty() ? "." : folder);
    const std::vector<std::string_view> known(names.begin(), names.end());
    return nearest_suggestion(file_name_of(file), known);
}

/// What only a look at other files shows.
Findings findings_around(const std::string& path, const LoadedMap& loaded) {
    Findings findings;
    const auto warn = [&](TextPlace place, const char* code, std::string sentence) {
        findings.push_back({place, Severity::warning, code, std::move(sentence)});
    };
    for (const SoundFault& fault : load_sounds(*loaded.map, path, read_file).faults) {
        const NamedFile& sound = loaded.sounds[fault.sound.index];
        warn(sound.place, "bad-sound", fault.sentence + nearest_sound(path, sound.name));
    }
    std::error_code unknown;
    for (const NamedFile& next : loaded.next_maps)
        if (const std::string there = next_map_path(path, next.name); !std::filesystem::exists(there, unknown))
            warn(next.place, "no-next-map",
                 fmt::format("expected a map in {}, to which this exit leads, found none; whoever takes it begins this "
                             "map again",
                             there));
    if (const auto first = LightImages(*loaded.map).left_out())
        warn({}, "lights-left-out",
             fmt::format("expected lights that together take a second at most to work out; the light at {} and all "
                         "after it light nothing more. Give them a shorter reach, or divide rooms of very many walls",
                         point_text(loaded.map->lights[*first].position)));
    tell_files(findings, loaded.sources);
    return findings;
}

/// All there is to say about one map; that it is none, where it is something else.
Findings findings_about(const std::string& path, const LoadedMap& loaded) {
    const bool was_read = loaded.findings.empty() || loaded.findings.front().code != "unreadable";
    if (!loaded.map)
        if (const Result<void> valid = refuse_as_map(path); !valid.ok())
            return {{{}, Severity::error, was_read ? "not-a-map" : "unreadable", valid.error().what}};
    Findings findings = loaded.findings;
    if (loaded.map) std::ranges::copy(findings_around(path, loaded), std::back_inserter(findings));
    sort_by_place(findings);
    return findings;
}

/// Tells people at once what it finds.
Result<CheckedMap> check_map(const std::string& path, const CheckRequest& request) {
    const LoadedMap loaded = load_map(path, request.texture_folders, read_file, {}, list_folder);
    CheckedMap checked{path, findings_about(path, loaded), has_errors(loaded.findings)};
    std::string text;
    if (request.format == kText) text = findings_text(path, checked.findings, request.talk);
    if (request.effects && loaded.map) text += effects_text(path, loaded.textures);
    if (const Result<void> done = print_to_stdout(text); !done.ok()) return done.error();
    return checked;
}

std::string summary_of(const std::vector<CheckedMap>& maps) {
    return fmt::format("{} checked, {} refused: {}, {}\n", counted(maps.size(), "map"),
                       std::ranges::count(maps, true, &CheckedMap::is_refused),
                       counted(count_of(maps, Severity::error), "error"),
                       counted(count_of(maps, Severity::warning), "warning"));
}

/// What is said when all maps are checked.
std::string text_about(const std::vector<CheckedMap>& maps, const CheckRequest& request) {
    if (request.format == kJson) return check_json(maps);
    if (request.format == kSarif) return check_sarif(maps);
    return request.talk == Talk::usual ? summary_of(maps) : "";
}

}  // namespace

int run_check(const CheckRequest& request) {
    if (request.effects && request.format != kText)
        return refuse_usage({"--effects", "its prices are for people to read; leave it out beside --format"});
    std::vector<CheckedMap> maps;
    for (const std::string& map : maps_in_folders(request.maps)) {
        auto checked = check_map(map, request);
        if (!checked.ok()) return fail(checked.error());
        maps.push_back(std::move(checked).value());
    }
    if (const Result<void> done = print_to_stdout(text_about(maps, request)); !done.ok()) return fail(done.error());
    return std::ranges::count(maps, true, &CheckedMap::is_refused) == 0 ? kDone : kFailed;
}

}  // namespace enfilade
