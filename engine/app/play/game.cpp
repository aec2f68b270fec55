#include "app/play/game.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/file_kind.h"
#include "base/hash.h"
#include "map/load.h"
#include "math/grid.h"
#include "space/locate.h"
#include "world/camera.h"

namespace enfilade {
namespace {

std::string lines_of(const std::string& path, const Findings& findings) {
    std::string lines;
    for (const Finding& finding : findings)
        if (finding.severity == Severity::error) lines += to_text(path, finding) + "\n";
    if (!lines.empty()) lines.pop_back();
    return lines;
}

SectorId sector_named(const Map& map, const std::string& name) {
    const auto found = std::ranges::find(map.sectors, name, &Sector::name);
    return found == map.sectors.end() ? SectorId{} : SectorId(static_cast<std::size_t>(found - map.sectors.begin()));
}

/// The angle of pitch_steps, within ±kMaxPitchSteps.
Angle pitch_of(std::int64_t steps) {
    const std::int64_t within = std::clamp<std::int64_t>(steps, -kMaxPitchSteps, kMaxPitchSteps);
    return Angle{static_cast<std::uint32_t>(within)};
}

}  // namespace

Game::Game(std::string path, std::vector<std::string> texture_folders, int skill)
    : path_(std::move(path)), texture_folders_(std::move(texture_folders)), skill_(skill) {}

Result<std::unique_ptr<Game>> Game::start(const std::string& map_path, std::vector<std::string> texture_folders,
                                          int skill) {
    std::unique_ptr<Game> game(new Game(map_path, std::move(texture_folders), skill));
    auto map = game->load();
    if (!map.ok()) return map.error();
    game->map_ = std::move(map).value();
    game->automap_ = Automap(game->map());
    game->restart();
    return game;
}

Result<OpenMap> Game::load() {
    const FileReader watched = watch_.start_reading();
    const auto read = [&](const std::string& path) {
        auto bytes = watched(path);
        if (bytes.ok() && path == path_) map_hash_ = hash_of_text(as_text(bytes.value()));
        return bytes;
    };
    LoadedMap loaded = load_map(path_, texture_folders_, read, skill_, list_folder);
    if (!loaded.map)
        if (Status other = refuse_as_map(path_)) return *other;
    if (!loaded.map) return Error{"", lines_of(path_, loaded.findings)};
    if (!loaded.map->player) return Error{path_, "the map has no player to start as; give it a [player] to play it"};
    return OpenMap{std::move(*loaded.map), std::move(loaded.textures)};
}

void Game::restart() {
    timeline_ = Timeline(*start_of(map()));  // load() made sure that there is a start
    from_start_ = true;
    snapshot_ = at_rest(map());
    automap_.visit(player().place.sector);
}

void Game::tick(const TickInput& input) {
    if (world().health == 0 && input.buttons & kButtonUse) return restart();
    timeline_.play(map(), input);
    automap_.visit(player().place.sector);
}

void Game::rewind(std::size_t ticks) {
    const std::size_t played = timeline_.inputs().size();
    timeline_.go_back(map(), played - std::min(played, ticks));
}

Status Game::save(const std::string& path) const {
    if (!from_start_)
        return Error{path, "the map was loaded again while it was played; start it anew, then it can be saved"};
    std::error_code failed;
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    if (!folder.empty()) std::filesystem::create_directories(folder, failed);
    if (failed) return Error{path, "the folder for it cannot be made: " + failed.message()};
    return write_file(path, std::span<const std::byte>(write_tape(tape())));
}

Status Game::load_saved(const std::string& path) {
    const auto bytes = read_file(path);
    if (!bytes.ok()) return bytes.error();
    const auto saved = read_tape(bytes.value());
    if (!saved.ok()) return Error{path, saved.error().text()};
    if (saved.value().map_hash != map_hash_)
        return Error{path, "this game was saved in another map, or in this one before it was changed"};
    Timeline played(*start_of(map()));
    for (const TickInput& input : saved.value().ticks) played.play(map(), input);
    if (hash(played.world()) != saved.value().final_hash)
        return Error{path, "this game was saved by another version of Enfilade"};
    timeline_ = std::move(played);
    from_start_ = true;
    return {};
}

Status Game::enter(const std::string& map_path) {
    const std::string path_before = std::exchange(path_, map_path);
    const MapWatch watch_before = watch_;
    const std::uint64_t hash_before = map_hash_;
    auto next = load();
    if (!next.ok()) {
        path_ = path_before;
        watch_ = watch_before;
        map_hash_ = hash_before;
        return next.error();
    }
    map_ = std::move(next).value();
    automap_ = Automap(map());
    recording_ = false;
    restart();
    return {};
}

Status Game::reload() {
    auto fresh = load();
    if (!fresh.ok()) return fresh.error();
    const Player before = player();
    const std::string sector_name = map()[before.place.sector].name;
    const bool automap_open = automap_.is_open();
    map_ = std::move(fresh).value();
    automap_ = Automap(map());
    if (automap_open) automap_.toggle();
    recording_ = false;
    restart();
    keep_player(before, sector_name);
    return {};
}

void Game::keep_player(const Player& before, const std::string& sector_name) {
    const Vec2 point = before.place.point;
    const SectorId same = sector_named(map(), sector_name);
    const SectorId sector = same && contains(map(), same, point) ? same : locate(map(), point);
    if (!sector) return;
    const double least_eye_z = map()[sector].floor.z + eye_height(before.height);
    Player player = player_at(map(), {sector, point, std::max(before.eye_z, least_eye_z), before.yaw});
    player.pitch_steps = before.pitch_steps;
    World world = timeline_.world();
    world.player = world.before = player;
    timeline_ = Timeline(std::move(world));
    from_start_ = false;
    automap_.visit(sector);
}

View Game::view(double part, const LookSteps& ahead, double fov_degrees, bool true_pitch) const {
    const Eye eye = eye_between_ticks(map(), world(), part);
    View view;
    view.sector = eye.place.sector;
    view.eye = eye.place.point;
    view.eye_z = eye.z;
    view.forward = direction(eye.yaw + Angle{static_cast<std::uint32_t>(ahead.yaw)});
    const Angle pitch = pitch_of(eye.pitch_steps + ahead.pitch);
    if (true_pitch)
        view.tilt = Tilt{direction(pitch), {1, 0}};
    else
        view.pitch_tangent = tangent(pitch);
    view.fov_degrees = fov_degrees;
    view.stretch = map().render.stretch;
    return view;
}

const Snapshot& Game::snapshot(double part) {
    enfilade::show({map(), world().history, static_cast<double>(world().tick) - 1 + part}, snapshot_);
    return snapshot_;
}

void Game::record() { recording_ = true; }

Tape Game::tape() const {
    const std::span<const TickInput> inputs = timeline_.inputs();
    return {path_, map_hash_, kTickRate, {inputs.begin(), inputs.end()}, hash(world())};
}

}  // namespace enfilade
