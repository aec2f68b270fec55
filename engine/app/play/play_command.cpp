// `enfilade play`, and `enfilade` alone: walk through maps in a window.
#include <algorithm>

#include "app/commands.h"
#include "app/messages.h"
#include "app/play/map_list.h"
#include "app/play/play_loop.h"
#include "app/play/saved_game.h"
#include "app/play/title.h"
#include "app/programs.h"
#include "base/attempt.h"
#include "base/text.h"

namespace enfilade {
namespace {

/// The player's settings, with what the options say for this time.
Result<SettingsStore> settings_for(const PlayRequest& request) {
    SettingsStore store(settings_path());
    for (const std::string& note : store.notes()) print_to_stderr(note + "\n");
    Settings now = store.now();
    for (const auto& [name, text] : request.settings) {
        const Setting& setting = setting_named(name);
        if (const Result<void> valid = setting.read(setting, text, now); !valid.ok())
            return Error{option_of(setting), valid.error().what};
    }
    const auto is_given = [&](std::string_view name) {
        return std::ranges::any_of(request.settings, [&](const auto& given) { return given.first == name; });
    };
    if (is_given("true_pitch") && now.true_pitch) {
        if (is_given("renderer"))
            if (const Result<void> valid = refuse_true_pitch(now.renderer, true); !valid.ok()) return valid.error();
        now.renderer = RendererKind::stencil;
    }
    store.change_for_now(now);
    return store;
}

/// Beside the settings.
Result<Dials> single_dials(const PlayRequest& request) {
    Dials dials;
    for (const std::string& dial : request.dials)
        if (const Result<void> valid = set_dial(dials, dial); !valid.ok()) return Error{"--dial", valid.error().what};
    return dials;
}

Result<std::unique_ptr<Window>> window_for(const std::string& title, const Settings& settings) {
    WindowOptions wanted;
    wanted.title = title;
    wanted.fullscreen = settings.fullscreen;
    if (settings.size) {
        wanted.width = settings.size->width;
        wanted.height = settings.size->height;
    }
    return open_window(wanted);
}

/// Plays until the player leaves, and keeps where that was. True where the title screen is wanted next.
Result<bool> play_in(Window& window, SettingsStore& store, Game& game, const PlayRequest& request) {
    PlayOptions options;
    options.mute = request.mute;
    options.tape = request.tape;
    options.dials = request.dials;
    options.save = request.save.empty() ? saved_game_of(game.path()) : request.save;
    window.set_title("Enfilade - " + printable_line(game.map().name));
    PlayLoop loop(game, window, store, options);
    if (const Result<void> done = loop.run(); !done.ok()) return done.error();
    keep_last_game(game);
    return loop.is_left_for_title();
}

Result<std::unique_ptr<Game>> game_for(const TitleChoice& choice, const PlayRequest& request,
                                       const MotionDials& motion) {
    auto game = Game::start(choice.map, request.texture_folders, request.skill, motion);
    if (game.ok() && choice.goes_on)
        static_cast<void>(game.value()->load_saved(last_game_path()));  // a map that was changed begins anew
    return game;
}

/// The map that was named, the first level of a WAD that was, or the tour.
Result<std::string> map_for(const PlayRequest& request) {
    if (request.map.empty()) return shipped_map("enfilade.toml");
    if (!is_wad_file(request.map)) return request.map;
    return first_level_of(request.map);
}

/// Title screen and game by turns, until the player quits.
Result<void> show_title(Window& window, SettingsStore& store, const PlayRequest& request, const MotionDials& motion) {
    std::string note;
    for (;;) {
        window.set_title("Enfilade");
        auto choice = TitleScreen(window, store, std::exchange(note, "")).run();
        if (!choice.ok()) return choice.error();
        if (choice.value().map.empty()) return {};
        auto game = game_for(choice.value(), request, motion);
        if (!game.ok()) {
            note = game.error().text();
            continue;
        }
        const auto wants_title = play_in(window, store, *game.value(), request);
        if (!wants_title.ok()) return wants_title.error();
        if (!wants_title.value()) return {};
    }
}

}  // namespace

int run_play(const PlayRequest& request) {
    const Result<Dials> dials = single_dials(request);
    if (!dials.ok()) return refuse_usage(dials.error());
    const MotionDials motion = dials.value().motion();
    auto store = settings_for(request);
    if (!store.ok()) return refuse_usage(store.error());
    const auto map = map_for(request);
    if (!map.ok()) return fail(map.error());
    auto game = Game::start(map.value(), request.texture_folders, request.skill, motion);
    if (!game.ok()) return fail(game.error());
    if (!request.load.empty())
        if (const Result<void> done = game.value()->load_saved(request.load); !done.ok()) return fail(done.error());
    auto window = window_for("Enfilade - " + printable_line(game.value()->map().name), store.value().now());
    if (!window.ok()) return fail(window.error());
    const auto wants_title = play_in(*window.value(), store.value(), *game.value(), request);
    if (!wants_title.ok()) return fail(wants_title.error());
    if (!wants_title.value()) return kDone;
    game.value().reset();
    if (const Result<void> done = show_title(*window.value(), store.value(), request, motion); !done.ok())
        return fail(done.error());
    return kDone;
}

int run_title() {
    const PlayRequest request;
    auto store = settings_for(request);
    if (!store.ok()) return refuse_usage(store.error());
    auto window = window_for("Enfilade", store.value().now());
    if (!window.ok()) return fail(window.error());
    if (const Result<void> done = show_title(*window.value(), store.value(), request, {}); !done.ok())
        return fail(done.error());
    return kDone;
}

}  // namespace enfilade
