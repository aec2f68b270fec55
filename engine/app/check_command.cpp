// `enfilade check`: every finding about maps, for authors and for editors that jump to a place.
#include <fmt/format.h>

#include <algorithm>

#include "app/commands.h"
#include "app/effect_prices.h"
#include "app/exit_codes.h"
#include "app/sounds.h"
#include "base/files.h"
#include "formats/map_toml.h"
#include "map/load.h"

namespace enfilade {
namespace {

struct Tally {
    std::size_t maps = 0, refused = 0, errors = 0, warnings = 0;
};

std::string counted(std::size_t count, const char* noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

void print_effects(const std::string& path, const TextureSet& textures) {
    const auto bytes = read_file(path);
    if (!bytes.ok()) return;
    const MapFile map = read_map(as_text(bytes.value())).map;
    fmt::print("{}: {}, and\n{}", path, counted(map.sectors.size(), "sector"), to_text(effect_prices(map, textures)));
}

void check_map(const std::string& path, const CheckRequest& request, Tally& tally) {
    const LoadedMap loaded = load_map(path, request.texture_folders, read_file);
    std::string text;
    for (const Finding& finding : loaded.findings) {
        text += to_text(path, finding) + '\n';
        ++(finding.severity == Severity::error ? tally.errors : tally.warnings);
    }
    if (loaded.map) {
        for (const std::string& fault : load_sounds(*loaded.map, path, read_file).faults) {
            text += to_text(path, {{}, Severity::warning, "bad-sound", fault}) + '\n';
            ++tally.warnings;
        }
    }
    fmt::print("{}", text);
    ++tally.maps;
    tally.refused += has_errors(loaded.findings);
    if (request.effects && loaded.map) print_effects(path, loaded.textures);
}

}  // namespace

int run_check(const CheckRequest& request) {
    Tally tally;
    for (const std::string& map : request.maps) check_map(map, request, tally);
    fmt::print("{} checked, {} refused: {}, {}\n", counted(tally.maps, "map"), tally.refused,
               counted(tally.errors, "error"), counted(tally.warnings, "warning"));
    return tally.refused == 0 ? kDone : kFailed;
}

}  // namespace enfilade
