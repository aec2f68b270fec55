#include "map/load.h"

#include <iterator>
#include <utility>

#include "base/parallel.h"
#include "formats/map_toml.h"
#include "map/build.h"

namespace enfilade {
namespace {

/// "maps" of "maps/hall.toml", "." of "hall.toml".
std::string folder_of(const std::string& path) {
    const auto slash = path.find_last_of('/');
    if (slash == std::string::npos) return ".";
    return slash == 0 ? "/" : path.substr(0, slash);
}

std::string name_of(const std::string& path) {
    const auto slash = path.find_last_of('/');
    const std::string file = slash == std::string::npos ? path : path.substr(slash + 1);
    return file.substr(0, file.find_last_of('.'));
}

/// The caller's folders, then the map's own, seen from the map.
std::vector<std::string> texture_folders(const MapFile& file, const std::string& path,
                                         const std::vector<std::string>& more) {
    std::vector<std::string> folders = more;
    for (const std::string& folder : file.textures)
        folders.push_back(!folder.empty() && folder[0] == '/' ? folder : folder_of(path) + "/" + folder);
    return folders;
}

void leave_out_things(MapFile& file, int skill) {
    std::erase_if(file.things,
                  [&](const ThingRecord& thing) { return thing.multiplayer || !(thing.skills & 1u << (skill - 1)); });
}

void note_exits(const std::vector<TriggerRecord>& triggers, std::vector<NamedFile>& next_maps) {
    for (const TriggerRecord& trigger : triggers)
        if (trigger.deed == Deed::exit && !trigger.targets.empty())
            next_maps.push_back({trigger.targets.front(), key_place(trigger, "target")});
}

void note_named_files(const MapFile& file, LoadedMap& loaded) {
    for (const SoundRecord& sound : file.sounds) loaded.sounds.push_back({sound.file, key_place(sound, "file")});
    for (const SectorRecord& sector : file.sectors) {
        note_exits(sector.triggers, loaded.next_maps);
        for (const PanelRecord& panel : sector.panels) note_exits(panel.triggers, loaded.next_maps);
        for (const LoopRecord& loop : sector.loops)
            for (const WallRecord& wall : loop.walls) note_exits(wall.triggers, loaded.next_maps);
    }
    for (const ThingRecord& thing : file.things) note_exits(thing.triggers, loaded.next_maps);
}

/// Building needs the pictures' sizes only, so they are unpacked meanwhile.
void build_and_unpack(const MapFile& file, TextureLoader loader, LoadedMap& loaded) {
    const TextureSet sizes = loader.sizes();
    Findings findings = loaded.findings;
    parallel_for(loader.count() + 1, hardware_threads(), [&](std::size_t i, std::size_t) {
        if (i == 0)
            loaded.map = build_map(file, sizes, findings);
        else
            loader.unpack(i - 1);
    });
    const auto built = findings.begin() + static_cast<std::ptrdiff_t>(loaded.findings.size());
    loaded.textures = loader.take(loaded.findings);
    loaded.findings.insert(loaded.findings.end(), built, findings.end());
    if (has_errors(loaded.findings)) loaded.map.reset();
}

}  // namespace

LoadedMap load_map(const std::string& path, const std::vector<std::string>& more_texture_folders,
                   const FileReader& read, std::optional<int> skill, const FolderLister& list) {
    LoadedMap loaded;
    Result<Bytes> bytes = read(path);
    if (!bytes) {
        loaded.findings.push_back({{}, Severity::error, "unreadable", bytes.error().what});
        return loaded;
    }
    MapReading reading = read_map(as_text(bytes.value()));
    bytes = Bytes();  // a large file need not stay in memory beside the map
    loaded.findings = std::move(reading.findings);
    if (reading.map.name.empty()) reading.map.name = name_of(path);
    if (skill) leave_out_things(reading.map, *skill);
    note_named_files(reading.map, loaded);
    const auto folders = texture_folders(reading.map, path, more_texture_folders);
    build_and_unpack(reading.map, TextureLoader(reading.map, folders, read, list), loaded);
    sort_by_place(loaded.findings);
    return loaded;
}

MapPlaces places_in(std::string_view text, std::optional<int> skill) {
    MapFile file = read_map(text).map;
    if (skill) leave_out_things(file, *skill);
    MapPlaces places;
    for (const SectorRecord& sector : file.sectors) {
        places.sectors.push_back(sector.place);
        places.floors.push_back(sector.floor.place);
        places.ceilings.push_back(sector.ceiling.place);
        for (const LoopRecord& loop : sector.loops)
            for (const WallRecord& wall : loop.walls) places.walls.push_back(wall.place);
        for (const PanelRecord& panel : sector.panels) places.panels.push_back(panel.place);
    }
    for (const ThingRecord& thing : file.things) places.things.push_back(thing.place);
    return places;
}

}  // namespace enfilade
