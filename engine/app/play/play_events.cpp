// What becomes of the map that is played: it is edited, left, saved and come back to.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/open_map.h"
#include "app/play/play_loop.h"
#include "app/play/saved_game.h"
#include "base/attempt.h"

namespace enfilade {
namespace {

/// More findings than fit a screen help nobody.
constexpr std::size_t kMostLines = 12;

std::vector<std::string> split_lines(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

}  // namespace

void PlayLoop::look_for_changes(std::int64_t now) {
    if (now - looked_ns_ < kBetweenLooks) return;
    looked_ns_ = now;
    if (game_.map_changed()) reload();
}

void PlayLoop::reload() {
    const bool was_recording = game_.is_recording();
    Result<void> reloaded;
    if (const Result<void> unbroken = attempt([&] { reloaded = game_.reload(); }); !unbroken.ok()) reloaded = unbroken;
    if (!reloaded.ok()) {
        std::vector<std::string> lines = split_lines(reloaded.error().text());
        const std::size_t all = lines.size();
        lines.resize(std::min(all, kMostLines));
        if (all > kMostLines) lines.push_back(fmt::format("and {} more", all - kMostLines));
        lines.emplace_back("The map before is kept until this is put right.");
        return notices_.pin(std::move(lines));
    }
    free_camera_.reset();
    draw_another_map();
    begin_sounds();
    notices_.pin({});
    tell("The map was changed and loaded again.");
    tell_warnings();
    if (was_recording) tell("The recording ended with the map before.");
}

void PlayLoop::tell_warnings() {
    constexpr std::size_t kMostWarnings = 3;
    constexpr double kWarningSeconds = 12;
    const std::vector<std::string>& all = game_.warnings();
    for (std::size_t i = 0; i < std::min(all.size(), kMostWarnings); ++i)
        notices_.say(all[i], now_s(), kWarningSeconds);
    if (all.size() > kMostWarnings)
        notices_.say(fmt::format("and {} more; `enfilade check` lists them", all.size() - kMostWarnings), now_s(),
                     kWarningSeconds);
}

void PlayLoop::follow_events() {
    follow_recording();
    const World& world = game_.world();
    if (world.tick < told_) told_ = world.tick;
    if (world.message && world.message->tick > told_) {
        told_ = world.message->tick;
        const std::string text = message_text(game_.map(), *world.message);
        if (!text.empty()) tell(text);
    }
    if (world.left_by) leave_map();
}

/// The picture goes red where health is lost, the more the more of it.
void PlayLoop::follow_health(std::int64_t now) {
    constexpr double kFullFlash = 30;  // points at once that make it as red as can be
    const int health = game_.world().health;
    if (health < last_health_ && !rewinding_) {
        hurt_ns_ = now;
        hurt_ = std::clamp((last_health_ - health) / kFullFlash, 0.3, 1.0);
        if (health == 0) died_ns_ = now;
    }
    if (health != last_health_) is_changed_ = true;
    last_health_ = health;
}

/// The next map lies beside this one; where there is none, one begins again.
void PlayLoop::leave_map() {
    if (end_) return;
    const World& world = game_.world();
    const std::string next = game_.map()[*world.left_by].leads_to;
    MapEnd end{game_.map().name,
               next,
               "",
               static_cast<double>(world.tick) * tick_seconds(world.history.rate()),
               world.secrets.size(),
               count_of_secrets(game_.map())};
    const std::string path = next_map_path(game_.path(), next);
    std::error_code unknown;
    if (!next.empty() && std::filesystem::exists(path, unknown)) end.next_path = path;
    free_camera_.reset();
    input_.release_all();
    end_ = end;
    is_changed_ = true;
}

void PlayLoop::enter_next_map() {
    const MapEnd end = *end_;
    end_.reset();
    told_ = 0;
    if (end.next_path.empty()) return game_.restart();
    Result<void> entered;
    if (const Result<void> unbroken = attempt([&] { entered = game_.enter(end.next_path); }); !unbroken.ok())
        entered = unbroken;
    if (!entered.ok()) {
        game_.restart();
        return notices_.pin(split_lines(entered.error().text()));
    }
    options_.save = saved_game_of(game_.path());
    draw_another_map();
    begin_sounds();
    tell(fmt::format("This is {}.", game_.map().name));
}

void PlayLoop::save_game() {
    const Result<void> saved = game_.save(options_.save);
    tell(saved.ok() ? "Saved. F9 comes back here; the two games before are kept beside it." : saved.error().what);
}

void PlayLoop::load_game() {
    free_camera_.reset();
    const Result<void> loaded = game_.load_saved(options_.save);
    told_ = game_.world().tick;
    tell(loaded.ok() ? "Back where you saved." : loaded.error().text());
}

void PlayLoop::follow_recording() {
    if (const auto fault = game_.take_recording_fault()) tell("The recording ends here: " + fault->text());
}

Error PlayLoop::save_what_was_played(const Error& why) {
    Result<void> saved;
    const Result<void> unbroken = attempt([&] {
        game_.end_recording();
        saved = game_.save(options_.save);
    });
    if (!unbroken.ok()) saved = unbroken;
    if (!saved.ok()) return {"", fmt::format("{}; the game could not be saved: {}", why.text(), saved.error().text())};
    return {"", fmt::format("{}; the game was saved, and `enfilade play {} --load {}` goes on with it", why.text(),
                            game_.path(), options_.save)};
}

void PlayLoop::begin_sounds() {
    if (options_.mute) return;
    const Result<void> unbroken = attempt([&] {
        for (const std::string& fault : sounds_.begin(game_.map(), game_.path())) tell(fault);
    });
    if (!unbroken.ok()) play_without_sound(unbroken.error());
}

void PlayLoop::hear() {
    const Result<void> unbroken = attempt([&] {
        if (is_paused() || rewinding_)
            sounds_.fall_silent();
        else
            sounds_.hear(game_.map(), game_.world(), settings().volume);
    });
    if (!unbroken.ok()) play_without_sound(unbroken.error());
}

void PlayLoop::play_without_sound(const Error& why) {
    sounds_.end();
    options_.mute = true;
    tell("There is no sound from here on: " + why.text());
}

}  // namespace enfilade
