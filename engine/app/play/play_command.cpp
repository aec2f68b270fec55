// `enfilade play`: walk through a map in a window.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/commands.h"
#include "app/file_kind.h"
#include "app/messages.h"
#include "app/open_map.h"
#include "app/options.h"
#include "app/play/play_loop.h"
#include "app/play/saved_game.h"
#include "base/attempt.h"
#include "base/parallel.h"
#include "base/terminal.h"
#include "platform/gl_context.h"

namespace enfilade {
namespace {

// What becomes of the map that is played: it is edited, left, saved and come back to.

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

Result<PlayOptions> options_of(const PlayRequest& request) {
    PlayOptions options;
    const auto renderer = parse_renderer(request.renderer);
    if (!renderer.ok()) return renderer.error();
    options.renderer = renderer.value();
    if (Status refused = refuse_true_pitch(options.renderer, request.true_pitch)) return *refused;
    options.true_pitch = request.true_pitch;
    if (!request.size.empty()) {
        const auto size = parse_size(request.size);
        if (!size.ok()) return size.error();
        options.size = size.value();
    }
    options.fullscreen = request.fullscreen;
    options.tape = request.tape;
    options.mute = request.mute;
    return options;
}

Result<std::unique_ptr<Window>> window_for(const Game& game, const PlayOptions& options) {
    WindowOptions wanted;
    wanted.title = "Enfilade - " + printable_line(game.map().name);
    wanted.fullscreen = options.fullscreen;
    if (options.size) {
        wanted.width = options.size->width;
        wanted.height = options.size->height;
    }
    return open_window(wanted);
}

}  // namespace

void PlayLoop::look_for_changes(std::int64_t now) {
    if (now - looked_ns_ < kBetweenLooks) return;
    looked_ns_ = now;
    if (game_.map_changed()) reload();
}

void PlayLoop::reload() {
    const bool was_recording = game_.is_recording();
    Status refused;
    if (Status broken = attempt([&] { refused = game_.reload(); })) refused = broken;
    if (refused) {
        std::vector<std::string> lines = split_lines(refused->text());
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
    if (was_recording) tell("The recording ended with the map before.");
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

/// The next map lies beside this one; where there is none, one begins again.
void PlayLoop::leave_map() {
    namespace fs = std::filesystem;
    const std::string left = game_.map().name, next = game_.map()[*game_.world().left_by].leads_to;
    const std::string path = next_map_path(game_.path(), next);
    std::error_code unknown;
    free_camera_.reset();
    told_ = 0;
    if (next.empty() || !fs::exists(path, unknown)) {
        game_.restart();
        return tell(next.empty() ? fmt::format("You left {}.", left)
                                 : fmt::format("You left {}; the next map, {}, is not here.", left, next));
    }
    Status failed;
    if (Status broken = attempt([&] { failed = game_.enter(path); })) failed = broken;
    if (failed) {
        game_.restart();
        return notices_.pin(split_lines(failed->text()));
    }
    options_.save = saved_game_of(game_.path());
    draw_another_map();
    begin_sounds();
    tell(fmt::format("{} lies behind you. This is {}.", left, game_.map().name));
}

void PlayLoop::save_game() {
    const Status failed = game_.save(options_.save);
    tell(failed ? failed->what : "Saved. F9 comes back here; the two games before are kept beside it.");
}

void PlayLoop::load_game() {
    free_camera_.reset();
    const Status failed = game_.load_saved(options_.save);
    told_ = game_.world().tick;
    tell(failed ? failed->text() : "Back where you saved.");
}

void PlayLoop::follow_recording() {
    if (Status failed = game_.take_recording_fault()) tell("The recording ends here: " + failed->text());
}

Error PlayLoop::save_what_was_played(const Error& why) {
    Status unsaved;
    if (Status broken = attempt([&] {
            game_.end_recording();
            unsaved = game_.save(options_.save);
        }))
        unsaved = broken;
    if (unsaved) return {"", fmt::format("{}; the game could not be saved: {}", why.text(), unsaved->text())};
    return {"", fmt::format("{}; the game was saved, and `enfilade play {} --load {}` goes on with it", why.text(),
                            game_.path(), options_.save)};
}

void PlayLoop::begin_sounds() {
    if (options_.mute) return;
    const Status broken = attempt([&] {
        for (const std::string& fault : sounds_.begin(game_.map(), game_.path())) tell(fault);
    });
    if (broken) play_without_sound(*broken);
}

void PlayLoop::hear() {
    const Status broken = attempt([&] {
        if (menu_.is_open() || rewinding_)
            sounds_.fall_silent();
        else
            sounds_.hear(game_.map(), game_.world(), settings_.volume);
    });
    if (broken) play_without_sound(*broken);
}

void PlayLoop::play_without_sound(const Error& why) {
    sounds_.end();
    options_.mute = true;
    tell("There is no sound from here on: " + why.text());
}

int run_play(const PlayRequest& request) {
    const auto options = options_of(request);
    if (!options.ok()) return refuse_usage(options.error());
    auto game = Game::start(request.map.empty() ? shipped_map("enfilade.toml") : request.map, request.texture_folders,
                            request.skill);
    if (!game.ok()) return fail(game.error());
    if (!request.load.empty())
        if (Status failed = game.value()->load_saved(request.load)) return fail(*failed);
    auto window = window_for(*game.value(), options.value());
    if (!window.ok()) return fail(window.error());
    auto renderer = make_renderer({options.value().renderer, {}, hardware_threads(), open_gl_for_play},
                                  game.value()->map(), game.value()->textures());
    if (!renderer.ok()) return fail(renderer.error());
    PlayOptions chosen = options.value();
    chosen.save = request.save.empty() ? saved_game_of(game.value()->path()) : request.save;
    PlayLoop loop(*game.value(), *window.value(), chosen, std::move(renderer).value());
    if (Status failed = loop.run()) return fail(*failed);
    return kDone;
}

}  // namespace enfilade
