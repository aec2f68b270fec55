#include "app/play/map_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "app/messages.h"
#include "app/open_map.h"
#include "app/options.h"
#include "app/pictures.h"
#include "app/play/saved_game.h"
#include "app/programs.h"
#include "base/attempt.h"
#include "base/files.h"
#include "base/hash.h"
#include "formats/text_parts.h"
#include "render/choice/renderer.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

/// The name that a map gives itself within its first lines, or its file's.
std::string name_in(const fs::path& map) {
    constexpr std::string_view kKey = "name = \"";
    constexpr std::size_t kLookedAt = 16384;  // [bytes]
    const auto beginning = read_beginning(map.string(), kLookedAt);
    LineReader lines(beginning.ok() ? as_text(beginning.value()) : "");
    for (auto line = lines.next(); line && !line->text.starts_with('['); line = lines.next())
        if (line->text.starts_with(kKey))
            return std::string(line->text.substr(kKey.size(), line->text.find('"', kKey.size()) - kKey.size()));
    return map.stem().string();
}

void add_maps(const fs::path& folder, MapOrigin origin, std::vector<ListedMap>& maps) {
    std::error_code unknown;
    if (!fs::is_directory(folder, unknown)) return;
    for (const std::string& path : maps_in_folders({folder.string()}))
        if (path.ends_with(".toml")) maps.push_back({path, name_in(path), origin});
}

fs::path cache_folder_of_play() {
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache) return fs::path(cache) / "enfilade";
    if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".cache/enfilade";
    return fs::path(data_folder()) / "cache";
}

fs::path converted_folder() { return fs::path(data_folder()) / "converted"; }

fs::path folder_of_wad(const fs::path& wad) { return converted_folder() / wad.stem(); }

bool is_converted_since(const fs::path& folder, const fs::path& wad) {
    std::error_code unknown;
    const auto converted = fs::last_write_time(folder / "report.txt", unknown);
    return !unknown && converted >= fs::last_write_time(wad, unknown) && !unknown;
}

/// "freedoom2" of ".../freedoom2", and of ".../freedoom2-1234-5678", as ./run names what it converts.
std::string wad_of(const fs::path& folder) {
    const std::string name = folder.filename().string();
    return name.substr(0, name.find('-'));
}

/// Folders of converted levels by the name of their WAD; what ./run has converted counts, too.
std::map<std::string, fs::path> converted_wads() {
    std::map<std::string, fs::path> wads;
    std::error_code unknown;
    for (const fs::path& place : {converted_folder(), cache_folder_of_play()})
        for (const auto& entry : fs::directory_iterator(place, unknown))
            if (fs::exists(entry.path() / "report.txt", unknown)) wads.emplace(wad_of(entry.path()), entry.path());
    return wads;
}

std::vector<fs::path> wads_on_this_machine() {
    const char* const named = std::getenv("DOOMWADDIR");
    std::set<fs::path> wads;
    std::error_code unknown;
    for (const fs::path& folder : {fs::path(named ? named : ""), fs::path("/usr/share/games/doom"),
                                   fs::path("/usr/local/share/games/doom"), fs::path(data_folder()) / "wads"})
        for (const auto& entry : fs::directory_iterator(folder, unknown))
            if (ending_of(entry.path().string()) == ".wad") wads.insert(entry.path());
    return {wads.begin(), wads.end()};
}

/// Beside this program, or where the build puts it, or wherever PATH leads.
std::string converter() {
    const fs::path here = fs::path(this_program()).parent_path();
    std::error_code unknown;
    for (const fs::path& path : {here / "wadconv", here / "../../wadconv/wadconv"})
        if (fs::is_regular_file(path, unknown)) return path.string();
    return "wadconv";
}

/// A picture belongs to the map as its file is now.
fs::path kept_picture(const std::string& map_path) {
    std::error_code unknown;
    Hash hash;
    hash.add(map_path);
    hash.add(static_cast<std::uint64_t>(fs::file_size(map_path, unknown)));
    hash.add(static_cast<std::int64_t>(fs::last_write_time(map_path, unknown).time_since_epoch().count()));
    return cache_folder_of_play() / "pictures" /
           fmt::format("{}-{:016x}.png", fs::path(map_path).stem().string(), hash.value());
}

Result<Frame> read_picture(const fs::path& path) {
    const auto bytes = read_file(path.string());
    if (!bytes.ok()) return bytes.error();
    auto image = read_png(bytes.value());
    if (!image.ok()) return image.error();
    return frame_of(image.value());
}

/// What the player sees at the start.
Result<Frame> draw_picture(const std::string& map_path) {
    const MapStore cache = cache_of(map_path);
    LoadedMap map = load_map(map_path, {}, read_file, kUsualSkill, list_folder, &cache);
    if (!map.map) return Error{map_path, "the map has errors"};
    const auto view = view_at_start(*map.map, lens_for(map.map->render));
    if (!view.ok()) return view.error();
    Dials dials;
    dials.samples = 2;
    auto renderer = make_renderer({RendererKind::column, dials, 1, {}}, *map.map, map.textures);
    if (!renderer.ok()) return renderer.error();
    Frame frame;
    frame.resize(kPictureWidth, kPictureHeight);
    if (const Result<void> done = renderer.value()->render(frame, nullptr, at_rest(*map.map), view.value()); !done.ok())
        return done.error();
    return frame;
}

/// An empty frame where there is nothing to show.
Frame picture_of(const std::string& map_path) {
    const fs::path kept = kept_picture(map_path);
    auto before = read_picture(kept);
    if (before.ok()) return std::move(before).value();
    Frame frame;
    const Result<void> unbroken = attempt([&] {
        auto drawn = draw_picture(map_path);
        if (!drawn.ok()) return;
        frame = std::move(drawn).value();
        std::error_code unknown;
        fs::create_directories(kept.parent_path(), unknown);
        static_cast<void>(write_picture(kept.string(), image_of(frame)));
    });
    return unbroken.ok() ? frame : Frame();
}

}  // namespace

std::vector<ListedMap> find_maps() {
    std::vector<ListedMap> maps;
    add_maps(fs::path(shipped_map("enfilade.toml")).parent_path(), MapOrigin::shipped, maps);
    std::ranges::stable_partition(maps, [](const ListedMap& map) { return map.path.ends_with("/enfilade.toml"); });
    add_maps(fs::path(data_folder()) / "maps", MapOrigin::own, maps);
    const auto converted = converted_wads();
    for (const auto& [wad, folder] : converted) {
        const auto before = static_cast<std::ptrdiff_t>(maps.size());
        add_maps(folder, MapOrigin::converted, maps);
        std::for_each(maps.begin() + before, maps.end(), [&](ListedMap& map) { map.name = wad + " " + map.name; });
    }
    for (const fs::path& wad : wads_on_this_machine())
        if (!converted.contains(wad_of(wad.stem())))
            maps.push_back({wad.string(), wad.filename().string(), MapOrigin::wad});
    return maps;
}

Result<void> convert_wad(const std::string& wad_path) {
    const fs::path folder = folder_of_wad(wad_path), scratch = folder.string() + ".unfinished";
    std::error_code failed;
    fs::create_directories(folder.parent_path(), failed);
    fs::remove_all(scratch, failed);
    const auto end = run_child({converter(), wad_path, "--out", scratch.string()});
    if (!end.ok()) return end.error();
    if (end.value().exit_code == 127)
        return Error{wad_path, "the converter, wadconv, is not installed beside this program, nor in PATH"};
    // Status 1: some levels were refused; the report is written where the others are there.
    if (end.value().exit_code > 1 || !fs::exists(scratch / "report.txt", failed))
        return Error{wad_path, "it cannot be converted: " + end.value().said.substr(0, end.value().said.find('\n'))};
    fs::remove_all(folder, failed);  // what an older file of this name was converted to
    fs::rename(scratch, folder, failed);
    if (failed) return Error{folder.string(), "the converted levels cannot be put here: " + failed.message()};
    return {};
}

Result<std::string> first_level_of(const std::string& wad_path) {
    const fs::path folder = folder_of_wad(wad_path);
    if (!is_converted_since(folder, wad_path))
        if (const Result<void> done = convert_wad(wad_path); !done.ok()) return done.error();
    const std::vector<std::string> levels = maps_in_folders({folder.string()});
    if (levels.empty() || !levels[0].ends_with(".toml"))
        return Error{wad_path, "no level of it could be converted; " + (folder / "report.txt").string() + " says why"};
    return levels[0];
}

MapPictures::MapPictures() : worker_([this] { work(); }) {}

MapPictures::~MapPictures() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    wanted_.notify_one();
    worker_.join();
}

std::optional<Frame> MapPictures::find(const std::string& map_path) {
    const std::lock_guard lock(mutex_);
    if (const auto found = pictures_.find(map_path); found != pictures_.end()) return found->second;
    if (std::ranges::find(queue_, map_path) == queue_.end()) queue_.push_back(map_path);
    wanted_.notify_one();
    return {};
}

std::size_t MapPictures::count() {
    const std::lock_guard lock(mutex_);
    return pictures_.size();
}

void MapPictures::work() {
    std::unique_lock lock(mutex_);
    for (;;) {
        wanted_.wait(lock, [this] { return ends_ || !queue_.empty(); });
        if (ends_) return;
        const std::string path = queue_.front();
        lock.unlock();
        Frame picture = picture_of(path);
        lock.lock();
        pictures_[path] = std::move(picture);
        std::erase(queue_, path);
    }
}

}  // namespace enfilade
