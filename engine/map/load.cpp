#include "map/load.h"

#include <utility>

#include "base/hash.h"
#include "base/parallel.h"

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
std::vector<std::string> texture_folders(const std::vector<std::string>& of_map, const std::string& path,
                                         const std::vector<std::string>& more) {
    std::vector<std::string> folders = more;
    for (const std::string& folder : of_map)
        folders.push_back(!folder.empty() && folder[0] == '/' ? folder : folder_of(path) + "/" + folder);
    return folders;
}

void leave_out_things(MapFile& file, int skill) {
    std::erase_if(file.things,
                  [&](const ThingRecord& thing) { return thing.multiplayer || !(thing.skills & 1u << (skill - 1)); });
}

void note_exits(const std::vector<TriggerRecord>& triggers, std::vector<NamedFile>& next_maps) {
    for (const TriggerRecord& trigger : triggers)
        if (trigger.action == TriggerAction::leave_map && !trigger.targets.empty())
            next_maps.push_back({trigger.targets.front(), key_place(trigger, "target")});
}

void note_named_files(const MapFile& file, CompiledMap& compiled) {
    for (const SoundRecord& sound : file.sounds) compiled.sounds.push_back({sound.file, key_place(sound, "file")});
    for (const SectorRecord& sector : file.sectors) {
        note_exits(sector.triggers, compiled.next_maps);
        for (const PanelRecord& panel : sector.panels) note_exits(panel.triggers, compiled.next_maps);
        for (const LoopRecord& loop : sector.loops)
            for (const WallRecord& wall : loop.walls) note_exits(wall.triggers, compiled.next_maps);
    }
    for (const ThingRecord& thing : file.things) note_exits(thing.triggers, compiled.next_maps);
}

std::vector<TextureSize> sizes_of(const TextureSet& pictures) {
    std::vector<TextureSize> sizes;
    for (const Texture& picture : pictures.textures) sizes.push_back({picture.width, picture.height});
    return sizes;
}

/// A map on its way: what is made of the text, or was kept of it, and its pictures.
class Loading {
public:
    Loading(const std::string& path, const std::vector<std::string>& more_folders, const FileReader& read,
            std::optional<int> skill, const FolderLister& list)
        : path_(path), more_folders_(more_folders), read_(read), skill_(skill), list_(list) {}

    /// A number for all that a map is made from but its pictures, whose sizes are compared.
    std::uint64_t source(std::span<const std::byte> text, std::uint64_t edition) const {
        Hash hash;
        hash.add(edition);
        hash.add(name_of(path_));
        hash.add(skill_.value_or(0));
        hash.add(hash_of_bytes(text));
        return hash.value();
    }

    void from_text(Bytes text) {
        MapReading reading = read_map_at(path_, as_text(text), read_);
        sources_ = std::move(reading.sources);
        text = Bytes();  // a large file need not stay in memory beside the map
        compiled_.findings = std::move(reading.findings);
        if (reading.map.name.empty()) reading.map.name = name_of(path_);
        if (skill_) leave_out_things(reading.map, *skill_);
        note_named_files(reading.map, compiled_);
        compiled_.textures = reading.map.textures;
        compiled_.needs = pictures_needed(reading.map);
        TextureLoader loader = loader_for(compiled_);
        const TextureSet sizes = loader.sizes();
        compiled_.sizes = sizes_of(sizes);
        std::optional<Map> map;
        with_pictures(loader, [&] { map = build_map(reading.map, sizes, compiled_.findings); });
        is_sound_ = map.has_value();
        if (map) compiled_.map = std::move(*map);
    }

    /// False where what was kept is not of this source, or its pictures have other sizes now.
    bool from_store(const Bytes& kept, std::uint64_t source) {
        auto compiled = read_compiled(kept, source);
        if (!compiled) return false;
        TextureLoader loader = loader_for(*compiled);
        if (sizes_of(loader.sizes()) != compiled->sizes) return false;
        compiled_ = std::move(*compiled);
        with_pictures(loader, [] {});
        return is_sound_ = true;
    }

    void keep_in(const MapStore& store, std::uint64_t source) const {
        if (is_sound_ && sources_.empty()) store.keep(compile(compiled_, source));
    }

    LoadedMap take() {
        LoadedMap loaded;
        loaded.findings = std::move(compiled_.findings);
        loaded.findings.insert(loaded.findings.end(), of_pictures_.begin(), of_pictures_.end());
        sort_by_place(loaded.findings);
        tell_files(loaded.findings, sources_);
        loaded.sources = std::move(sources_);
        loaded.textures = std::move(textures_);
        loaded.sounds = std::move(compiled_.sounds);
        loaded.next_maps = std::move(compiled_.next_maps);
        if (is_sound_ && !has_errors(loaded.findings)) loaded.map = std::move(compiled_.map);
        return loaded;
    }

private:
    TextureLoader loader_for(const CompiledMap& compiled) const {
        return TextureLoader(compiled.needs, texture_folders(compiled.textures, path_, more_folders_), read_, list_);
    }

    /// Building needs the pictures' sizes only, so they are unpacked meanwhile.
    void with_pictures(TextureLoader& loader, const std::function<void()>& build) {
        parallel_for(loader.count() + 1, hardware_threads(), [&](std::size_t i, std::size_t) {
            if (i == 0)
                build();
            else
                loader.unpack(i - 1);
        });
        textures_ = loader.take(of_pictures_);
    }

    const std::string& path_;
    const std::vector<std::string>& more_folders_;
    const FileReader& read_;
    std::optional<int> skill_;
    const FolderLister& list_;
    CompiledMap compiled_;
    TextureSet textures_;
    Findings of_pictures_;
    std::vector<SourceFile> sources_;
    bool is_sound_ = false;
};

LoadedMap refused(const Error& unreadable) {
    LoadedMap loaded;
    loaded.findings.push_back({{}, Severity::error, "unreadable", unreadable.what});
    return loaded;
}

}  // namespace

LoadedMap load_map(const std::string& path, const std::vector<std::string>& more_texture_folders,
                   const FileReader& read, std::optional<int> skill, const FolderLister& list, const MapStore* store) {
    Loading loading(path, more_texture_folders, read, skill, list);
    Result<Bytes> text = Error{}, kept = Error{};
    parallel_for(2, hardware_threads(), [&](std::size_t task, std::size_t) {
        if (task == 0)
            text = read(path);
        else if (store)
            kept = store->find();
    });
    if (!text) return refused(text.error());
    const bool is_kept = store && store->keep && text.value().size() >= kLeastKeptBytes;
    std::uint64_t source = is_kept ? loading.source(text.value(), store->edition) : 0;
    if (is_kept && kept && is_compiled_from(kept.value(), source)) {
        text = Bytes();  // text, bytes and map in memory at once would be much
        if (loading.from_store(kept.value(), source)) return loading.take();
        text = read(path);
        if (!text) return refused(text.error());
        source = loading.source(text.value(), store->edition);
    }
    kept = Bytes();
    loading.from_text(std::move(text).value());
    if (is_kept) loading.keep_in(*store, source);
    return loading.take();
}

MapReading read_map_at(const std::string& path, std::string_view text, const FileReader& read) {
    const std::string folder = path.find('/') == std::string::npos ? "" : folder_of(path) + "/";
    FileReader prefabs;
    if (read) prefabs = [&](const std::string& name) { return read(folder + name); };
    MapReading reading = read_map(text, prefabs);
    for (SourceFile& source : reading.sources) source.path = folder + source.path;
    return reading;
}

MapPlaces places_in(std::string_view text, std::optional<int> skill, const std::string& path, const FileReader& read) {
    MapReading reading = read_map_at(path, text, read);
    MapFile& file = reading.map;
    if (skill) leave_out_things(file, *skill);
    MapPlaces places;
    places.sources = std::move(reading.sources);
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
