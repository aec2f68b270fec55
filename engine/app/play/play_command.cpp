// `enfilade play`, and `enfilade` alone: walk through maps in a window.
#include <algorithm>

#include "app/commands.h"
#include "app/messages.h"
#include "app/play/conversions.h"
#include "app/play/play_loop.h"
#include "app/play/saved_game.h"
#include "app/play/title.h"
#include "app/programs.h"
#include "base/attempt.h"
#include "base/files.h"
#include "base/text.h"
#include "formats/text_parts.h"

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

/// A game, and what the player should know of it at the beginning.
struct Begun {
    std::unique_ptr<Game> game;
    std::string note;
};

/// Plays until the player leaves, and keeps where that was. True where the title screen is wanted next.
Result<bool> play_in(Window& window, SettingsStore& store, const Begun& begun, const PlayRequest& request) {
    Game& game = *begun.game;
    PlayOptions options;
    options.mute = request.mute;
    options.tape = request.tape;
    options.dials = request.dials;
    options.save = request.save.empty() ? saved_game_of(game.path()) : request.save;
    options.note = begun.note;
    window.set_title("Enfilade - " + printable_line(game.map().name));
    PlayLoop loop(game, window, store, options);
    if (const Result<void> done = loop.run(); !done.ok()) return done.error();
    if (const Result<void> kept = keep_last_game(game); !kept.ok())
        print_to_stderr("\"Continue\" cannot go on with this game: " + kept.error().text() + "\n");
    return loop.is_left_for_title();
}

Result<Begun> game_for(const TitleChoice& choice, const PlayRequest& request, const MotionDials& motion) {
    auto game = Game::start(choice.map, request.texture_folders, request.skill, motion);
    if (!game.ok()) return game.error();
    Begun begun{std::move(game).value(), ""};
    if (choice.goes_on)
        if (const Result<void> done = begun.game->load_saved(last_game_path()); !done.ok())
            begun.note = "The map begins anew: " + done.error().text();
    return begun;
}

/// An error where a word is neither a WAD nor, at the end, a level.
Result<std::string> level_for(const std::vector<std::string>& words) {
    std::vector<std::string> wads;
    for (const std::string& word : words) {
        const auto wad = find_wad(word);
        if (wad) wads.push_back(*wad);
        if (!wad && (&word != &words.back() || !is_level_name(word)))
            return Error{"", "expected WADs, then a level such as MAP01 or E1M1; found " + in_quotes(word)};
    }
    const auto folder =
        convert_wads(wads, [](const std::string& sentence) { print_to_stderr("enfilade: " + sentence + "\n"); });
    if (!folder.ok()) return folder.error();
    return level_in(folder.value(), wads.size() < words.size() ? words.back() : "");
}

/// The map that was named, the level of a WAD that was, or the tour.
Result<std::string> map_for(const std::vector<std::string>& words) {
    if (words.empty()) return shipped_map("enfilade.toml");
    if (find_wad(words[0])) return level_for(words);
    if (words.size() > 1) return Error{"", "expected one map or WAD, then options; found " + in_quotes(words[1])};
    return words[0];
}

/// As it is, for a script: whatever is in the path.
int print_map(const std::string& map) {
    const Result<void> done = write_file("-", map + "\n");
    return done.ok() ? kDone : fail(done.error());
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
        const auto wants_title = play_in(window, store, game.value(), request);
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
    const auto map = map_for(request.words);
    if (!map.ok()) return fail(map.error());
    if (request.print_map) return print_map(map.value());
    auto begun = game_for({map.value(), false}, request, motion);
    if (!begun.ok()) return fail(begun.error());
    Game& game = *begun.value().game;
    if (!request.load.empty())
        if (const Result<void> done = game.load_saved(request.load); !done.ok()) return fail(done.error());
    auto window = window_for("Enfilade - " + printable_line(game.map().name), store.value().now());
    if (!window.ok()) return fail(window.error());
    const auto wants_title = play_in(*window.value(), store.value(), begun.value(), request);
    if (!wants_title.ok()) return fail(wants_title.error());
    if (!wants_title.value()) return kDone;
    begun.value().game.reset();
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
