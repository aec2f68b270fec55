#include "app/play/map_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/messages.h"
#include "app/open_map.h"
#include "app/options.h"
#include "app/pictures.h"
#include "app/play/conversions.h"
#include "app/programs.h"
#include "app/user_folders.h"
#include "base/attempt.h"
#include "base/file_name.h"
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
    return file_stem_of(map.string());
}

void add_maps(const fs::path& folder, MapOrigin origin, std::vector<ListedMap>& maps) {
    std::error_code unknown;
    if (!fs::is_directory(folder, unknown)) return;
    for (const std::string& path : maps_in_folders({folder.string()}))
        if (path.ends_with(".toml")) maps.push_back({path, name_in(path), origin});
}

/// A picture belongs to the map as its file is now. Empty where none is kept.
std::string kept_picture(const std::string& map_path) {
    std::error_code unknown;
    Hash hash;
    hash.add(map_path);
    hash.add(static_cast<std::uint64_t>(fs::file_size(map_path, unknown)));
    hash.add(static_cast<std::int64_t>(fs::last_write_time(map_path, unknown).time_since_epoch().count()));
    const std::string name = safe_file_name(file_stem_of(map_path));
    return in_user_folder(UserFolder::cache, fmt::format("pictures/{}-{:016x}.png", name, hash.value()));
}

Result<Frame> read_picture(const std::string& path) {
    const auto bytes = read_file(path);
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
    const std::string kept = kept_picture(map_path);
    auto before = read_picture(kept);
    if (before.ok()) return std::move(before).value();
    Frame frame;
    const Result<void> unbroken = attempt([&] {
        auto drawn = draw_picture(map_path);
        if (!drawn.ok()) return;
        frame = std::move(drawn).value();
        if (kept.empty()) return;
        std::error_code unknown;
        fs::create_directories(fs::path(kept).parent_path(), unknown);
        static_cast<void>(write_picture(kept, image_of(frame)));
    });
    return unbroken.ok() ? frame : Frame();
}

}  // namespace

std::vector<ListedMap> find_maps() {
    std::vector<ListedMap> maps;
    add_maps(fs::path(shipped_map("enfilade.toml")).parent_path(), MapOrigin::shipped, maps);
    std::ranges::stable_partition(maps, [](const ListedMap& map) { return map.path.ends_with("/enfilade.toml"); });
    add_maps(in_user_folder(UserFolder::data, "maps"), MapOrigin::own, maps);
    for (const KeptConversion& conversion : kept_conversions()) {
        const auto before = static_cast<std::ptrdiff_t>(maps.size());
        add_maps(conversion.folder, MapOrigin::converted, maps);
        std::for_each(maps.begin() + before, maps.end(),
                      [&](ListedMap& map) { map.name = conversion.name + " " + map.name; });
    }
    for (const std::string& wad : installed_wads()) maps.push_back({wad, file_name_of(wad), MapOrigin::wad});
    return maps;
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
