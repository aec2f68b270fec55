#include "app/play/game.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/messages.h"
#include "app/open_map.h"
#include "app/play/player_input.h"
#include "base/hash.h"
#include "map/load.h"
#include "map/sector_finder.h"
#include "math/vec.h"
#include "space/trace.h"
#include "world/world.h"

namespace enfilade {
namespace {

std::vector<std::string> lines_of(const std::string& path, const Findings& findings, Severity severity) {
    std::vector<std::string> lines;
    for (const Finding& finding : findings)
        if (finding.severity == severity) lines.push_back(to_text(path, finding));
    return lines;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
    return text;
}

constexpr const char* kNoPlaceForSaves =
    "there is no home folder to save games in; set HOME, or name a file by --save FILE";

/// How many games are kept that were saved in one place.
constexpr int kKeptSaves = 3;

/// Where the game is that was saved so many games ago.
std::string saved_before(const std::string& path, int age) {
    return age == 0 ? path : path + "." + std::to_string(age);
}

/// Nothing is copied where nothing is. A copy, not a rename: at every moment there is a game under each name.
Result<void> copy_saved(const std::string& from, const std::string& to) {
    std::error_code unknown;
    if (!std::filesystem::exists(from, unknown)) return {};
    const auto bytes = read_file(from);
    return bytes.ok() ? write_file(to, std::span<const std::byte>(bytes.value())) : Result<void>(bytes.error());
}

}  // namespace

FileReader MapWatch::start_reading() {
    files_.clear();
    return [this](const std::string& path) {
        files_[path] = written(path);  // before reading: a file saved while it is read is read again
        return read_file(path);
    };
}

bool MapWatch::changed() const {
    return std::ranges::any_of(files_, [](const auto& file) { return written(file.first) != file.second; });
}

std::filesystem::file_time_type MapWatch::written(const std::string& path) {
    std::error_code failed;
    const auto time = std::filesystem::last_write_time(path, failed);
    return failed ? std::filesystem::file_time_type::min() : time;
}

Game::Game(std::string path, std::vector<std::string> texture_folders, int skill)
    : path_(std::move(path)), texture_folders_(std::move(texture_folders)), skill_(skill) {}

Result<std::unique_ptr<Game>> Game::start(const std::string& map_path, std::vector<std::string> texture_folders,
                                          int skill, const MotionDials& motion) {
    std::unique_ptr<Game> game(new Game(map_path, std::move(texture_folders), skill));
    auto map = game->load(map_path, game->watch_);
    if (!map.ok()) return map.error();
    game->take(std::move(map).value());
    game->begin(motion);
    return game;
}

Result<Game::Loaded> Game::load(const std::string& map_path, MapWatch& watch) const {
    Loaded loaded;
    const FileReader watched = watch.start_reading();
    const auto read = [&](const std::string& path) {
        auto bytes = watched(path);
        if (bytes.ok() && path == map_path) loaded.hash = hash_of_text(as_text(bytes.value()));
        return bytes;
    };
    const MapStore cache = cache_of(map_path);
    LoadedMap map = load_map(map_path, texture_folders_, read, skill_, list_folder, &cache);
    if (!map.map)
        if (const Result<void> valid = refuse_as_map(map_path); !valid.ok()) return valid.error();
    if (!map.map) return Error{"", joined(lines_of(map_path, map.findings, Severity::error))};
    if (!map.map->player) return Error{map_path, "the map has no player to start as; give it a [player] to play it"};
    loaded.warnings = lines_of(map_path, map.findings, Severity::warning);
    loaded.open = OpenMap{std::move(*map.map), std::move(map.textures)};
    return loaded;
}

void Game::take(Loaded loaded) {
    end_recording();
    map_ = std::move(loaded.open);
    map_hash_ = loaded.hash;
    warnings_ = std::move(loaded.warnings);
    places_.reset();
    automap_ = Automap(map());
}

void Game::restart() { begin(world().history.motion()); }

void Game::begin(const MotionDials& motion) {
    timeline_ = Timeline(*start_of(map(), motion));  // load() made sure that there is a start
    from_start_ = true;
    snapshot_ = at_rest(map());
    automap_.visit(player().place.sector);
    from_start_ = true;
    if (recorder_) heed(recorder_->cut_to(0));
}

void Game::tick(const TickInput& input) {
    if (world().health == 0 && input.buttons & kButtonUse) return restart();
    timeline_.play(map(), input);
    if (recorder_) heed(recorder_->add(input));
    automap_.visit(player().place.sector);
}

void Game::rewind(std::size_t ticks) {
    const std::size_t played = timeline_.inputs().size();
    timeline_.go_back(map(), played - std::min(played, ticks));
    if (recorder_) heed(recorder_->cut_to(timeline_.inputs().size()));
}

Result<void> Game::check_savable() const {
    if (!from_start_)
        return Error{path_, "the map was loaded again while it was played; start it anew, then it can be saved"};
    const auto text = read_file(path_);
    if (!text.ok() || hash_of_text(as_text(text.value())) != map_hash_)
        return Error{path_,
                     "the game is not saved: " + path_ +
                         " is no longer the map that is played, so the game could not be loaded again; put it back "
                         "as it was, or mend it"};
    return {};
}

Result<void> Game::save(const std::string& path) const {
    if (path.empty()) return Error{"", kNoPlaceForSaves};
    if (const Result<void> valid = check_savable(); !valid.ok()) return Error{path, valid.error().what};
    std::error_code failed;
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    if (!folder.empty()) std::filesystem::create_directories(folder, failed);
    if (failed) return Error{path, "the folder for it cannot be made: " + failed.message()};
    for (int age = kKeptSaves - 1; age > 0; --age)
        if (const Result<void> done = copy_saved(saved_before(path, age - 1), saved_before(path, age)); !done.ok())
            return done.error();
    return write_file(path, std::span<const std::byte>(write_tape(tape())));
}

Result<void> Game::load_saved(const std::string& path) {
    if (path.empty()) return Error{"", kNoPlaceForSaves};
    const auto bytes = read_file(path);
    if (!bytes.ok()) return bytes.error();
    const auto saved = read_tape(bytes.value());
    if (!saved.ok()) return Error{path, saved.error().text()};
    if (saved.value().map_hash != map_hash_)
        return Error{path, "this game was saved in another map, or in this one before it was changed"};
    const auto motion = motion_of(saved.value());
    if (!motion)
        return Error{path,
                     "expected a game of 60, 35 or 140 ticks a second; found " + std::to_string(saved.value().rate)};
    Timeline played(*start_of(map(), *motion));
    for (const TickInput& input : saved.value().ticks) played.play(map(), input);
    if (saved.value().final_hash && hash(played.world()) != *saved.value().final_hash)
        return Error{path, "this game was saved by another version of Enfilade, or played with another --skill"};
    end_recording();
    timeline_ = std::move(played);
    from_start_ = true;
    return {};
}

Result<void> Game::enter(const std::string& map_path) {
    MapWatch watch;
    auto next = load(map_path, watch);
    if (!next.ok()) return next.error();
    take(std::move(next).value());
    watch_ = std::move(watch);
    path_ = map_path;
    restart();
    return {};
}

Result<void> Game::reload() {
    auto fresh = load(path_, watch_);
    if (!fresh.ok()) return fresh.error();
    const Player before = player();
    const std::string sector_name = map()[before.place.sector].name;
    const bool automap_open = automap_.is_open();
    take(std::move(fresh).value());
    if (automap_open) automap_.toggle();
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

View Game::view(double part, const LookSteps& ahead, const Lens& lens) const {
    return view_of(eye_between_ticks(map(), world(), part), ahead, lens);
}

const Snapshot& Game::snapshot(double part) {
    enfilade::show({map(), world().history, static_cast<double>(world().tick) - 1 + part}, snapshot_);
    return snapshot_;
}

const MapPlaces& Game::places() {
    if (places_) return *places_;
    const auto text = read_file(path_);
    const bool is_same = text.ok() && hash_of_text(as_text(text.value())) == map_hash_;
    return places_.emplace(is_same ? places_in(as_text(text.value()), skill_, path_, read_file) : MapPlaces());
}

Result<void> Game::record(const std::string& path) {
    auto begun = TapeRecorder::begin(path, tape());
    if (!begun.ok()) return begun.error();
    recorder_.emplace(std::move(begun).value());
    return {};
}

void Game::end_recording() {
    if (recorder_) heed(recorder_->finish(hash(world())));
    recorder_.reset();
}

void Game::heed(const Result<void>& recorded) {
    if (recorded.ok()) return;
    recorder_.reset();
    recording_fault_ = recorded.error();
}

Tape Game::tape() const {
    const std::span<const TickInput> inputs = timeline_.inputs();
    const MotionDials& motion = world().history.motion();
    return {path_,
            map_hash_,
            ticks_per_second(motion.rate),
            motion.crossing == CrossingMethod::naive,
            {inputs.begin(), inputs.end()},
            hash(world())};
}

}  // namespace enfilade
