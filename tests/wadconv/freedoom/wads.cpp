#include "wadconv/freedoom/wads.h"

#include <cstdlib>
#include <filesystem>
#include <utility>

#include "wadconv/wad.h"
#include "wadconv/workbench.h"

namespace enfilade::test {

std::string lower(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

std::string path_of(const FreeDoomWad& wad) {
    const char* chosen = std::getenv("DOOMWADDIR");
    return std::string(chosen ? chosen : "/usr/share/games/doom") + "/" + wad.name + ".wad";
}

bool is_missing(const FreeDoomWad& wad) {
    return !std::filesystem::exists(path_of(wad)) && std::getenv("ENFILADE_REQUIRE_FREEDOOM") == nullptr;
}

bool is_long_run() { return std::getenv("ENFILADE_LONG") != nullptr; }

namespace {

wadconv::WadPile pile_of(const FreeDoomWad& wad) {
    const std::string path = path_of(wad);
    std::vector<wadconv::Wad> wads;
    wads.push_back(wadconv::Wad::read(path, read_file(path).value()).value());
    return wadconv::WadPile(std::move(wads));
}

}  // namespace

ReadWad::ReadWad(const FreeDoomWad& wad)
    : pile(pile_of(wad)),
      pictures(wadconv::Pictures::list(pile, wadconv::idle_frames()).value()),
      sounds(wadconv::Sounds::list(pile)) {
    for (const std::string& name : wadconv::map_names(pile))
        maps.push_back(wadconv::decode_map(wadconv::find_map(pile, name).value()).value());
}

ConvertedWad::ConvertedWad(const FreeDoomWad& wad, Doors doors, std::vector<std::string> only) {
    wadconv::RunOptions options;
    options.wads = {path_of(wad)};
    options.out = dir_.path();
    options.jobs = 2;
    options.maps = std::move(only);
    options.convert.open_doors = doors == Doors::open;
    const auto run = wadconv::convert_wads(options, [](std::size_t, std::size_t, std::size_t) {});
    if (!run) {
        error_ = run.error().text();
        return;
    }
    for (const wadconv::Report& report : run.value().reports) maps_.push_back(lower(report.map));
}

LoadedMap ConvertedWad::load(const std::string& map, std::optional<int> skill) const {
    return load_map(dir_.path(map + ".toml"), {}, read_file, skill);
}

}  // namespace enfilade::test
