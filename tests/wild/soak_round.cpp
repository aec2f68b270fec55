#include "wild/soak_round.h"

#include <algorithm>

#include "app/play/game.h"
#include "base/attempt.h"
#include "base/files.h"
#include "formats/map_toml.h"
#include "hard_cases/comparison.h"
#include "world/player_fault.h"

namespace enfilade::test {
namespace {

constexpr int kTicks = 600;
constexpr PictureSize kLargestPicture{64, 40};

class Round {
public:
    Round(std::unique_ptr<Game> game, const std::string& folder, std::uint64_t seed)
        : game_(std::move(game)),
          save_(folder + "/game.save"),
          may_change_map_(game_->path().starts_with(folder + "/")),
          random_(seed),
          keys_(random_inputs(kTicks, random_)) {
        hashes_.push_back(hash(game_->world()));
    }

    SoakResult run() {
        result_.counts.rounds = 1;
        find(ground_fault({game_->map(), game_->textures()}, random_.bits()));
        for (int tick = 0; tick < kTicks && !result_.fault; ++tick) {
            const Result<void> result = attempt([&] { play(keys_[static_cast<std::size_t>(tick)]); });
            if (!result.ok()) find(result.error().text());
            if (result.ok() && random_.below(24) == 0) interrupt();
        }
        Hash all;
        for (const std::uint64_t state : hashes_) all.add(state);
        result_.hash = all.value();
        return std::move(result_);
    }

private:
    void find(std::string what) {
        if (what.empty() || result_.fault) return;
        result_.fault = Fault{std::move(what), {}, game_->tape().ticks, game_->world().history.motion()};
    }

    void play(const TickInput& keys) {
        game_->tick(keys);
        ++result_.counts.ticks;
        if (game_->world().tick == 0) begin_anew();  // who died stands at the start again
        hashes_.resize(game_->world().tick - first_tick_);
        hashes_.push_back(hash(game_->world()));
        find(watch_.fault_of(game_->map(), game_->world()));
    }

    void begin_anew() {
        watch_ = {};
        first_tick_ = game_->world().tick;
        hashes_.assign(1, hash(game_->world()));
    }

    void interrupt() {
        switch (random_.below(6)) {
            case 0: return save();
            case 1: return load();
            case 2: return rewind();
            case 3: return random_.below(4) == 0 ? reload() : look();
            default: return look();
        }
    }

    void save() {
        if (is_reloaded_) return;  // such a game is not to be saved
        if (const Result<void> done = game_->save(save_); !done.ok())
            return find("saving failed: " + done.error().text());
        saved_ = hash(game_->world());
    }

    void load() {
        if (!saved_) return;
        if (const Result<void> done = game_->load_saved(save_); !done.ok())
            return find("loading failed: " + done.error().text());
        ++result_.counts.loads;
        if (hash(game_->world()) != *saved_) return find("the loaded game is another one than was saved");
        is_reloaded_ = false;
        begin_anew();
    }

    void rewind() {
        const std::size_t ticks = random_.below(hashes_.size());
        game_->rewind(ticks);
        ++result_.counts.rewinds;
        if (hash(game_->world()) != hashes_[hashes_.size() - 1 - ticks])
            return find("the past is another one than it was");
        hashes_.resize(hashes_.size() - ticks);
        watch_ = {};
    }

    /// Other heights, as an author would try them.
    void change_map() {
        MapFile file = read_map(as_text(read_file(game_->path()).value())).map;
        for (SectorRecord& sector : file.sectors) {
            sector.floor.z += random_.uniform(-0.5, 0.5);
            sector.ceiling.z = std::max(sector.ceiling.z + random_.uniform(-0.5, 0.5), sector.floor.z);
        }
        if (const Result<void> done = write_file(game_->path(), write_map(file)); !done.ok()) find(done.error().text());
    }

    void reload() {
        if (may_change_map_) change_map();
        if (const Result<void> done = game_->reload(); !done.ok())
            return find("loading the map again failed: " + done.error().text());
        ++result_.counts.reloads;
        is_reloaded_ = true;
        begin_anew();
    }

    View seen_by_player(double fov_degrees) {
        return game_->view(random_.uniform(0, 1), {}, lens_for(game_->map().render, fov_degrees));
    }

    /// As the player sees it now, or from a hard place.
    void look() {
        HardPose pose = hard_pose(game_->map(), kLargestPicture, random_);
        if (random_.below(2) == 0) pose.view = seen_by_player(pose.view.fov_degrees);
        const std::string fault = what_is_wrong([&] {
            const Comparison seen =
                compare({game_->path(), game_->map(), game_->textures()}, game_->snapshot(1), pose.view, pose.size);
            result_.counts.pixels += seen.pixels;
            return seen.is_faultless() ? std::string() : describe(seen);
        });
        if (fault.empty()) return;
        find(fault);
        result_.fault->pose = pose;
        result_.sector = game_->map()[pose.view.sector].name;
    }

    std::unique_ptr<Game> game_;
    std::string save_;
    bool may_change_map_;
    Random random_;
    std::vector<TickInput> keys_;
    PlayerWatch watch_;
    std::uint64_t first_tick_ = 0;       ///< at which what is known of the past begins
    std::vector<std::uint64_t> hashes_;  ///< of the world then and after each tick since
    std::optional<std::uint64_t> saved_;
    bool is_reloaded_ = false;
    SoakResult result_;
};

}  // namespace

SoakCounts& SoakCounts::operator+=(const SoakCounts& other) {
    rounds += other.rounds;
    ticks += other.ticks;
    pixels += other.pixels;
    loads += other.loads;
    rewinds += other.rewinds;
    reloads += other.reloads;
    return *this;
}

SoakResult soak_round(const std::string& map_path, const std::string& folder, std::uint64_t seed) {
    Random lot(seed);
    auto game = Game::start(map_path, {}, kUsualSkill, random_motion(lot));
    if (!game.ok()) {
        SoakResult refused;
        refused.fault = Fault{game.error().text(), {}, {}, {}};
        return refused;
    }
    return Round(std::move(game).value(), folder, seed).run();
}

}  // namespace enfilade::test
