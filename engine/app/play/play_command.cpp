// `enfilade play`: walk through a map in a window.
#include <fmt/format.h>

#include "app/commands.h"
#include "app/exit_codes.h"
#include "app/file_kind.h"
#include "app/play/play_loop.h"
#include "app/play/saved_game.h"
#include "app/viewing.h"
#include "base/parallel.h"
#include "base/terminal.h"
#include "platform/gl_context.h"

namespace enfilade {
namespace {

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
    auto renderer = make_renderer({options.value().renderer, 1, hardware_threads(), open_gl_for_play},
                                  game.value()->map(), game.value()->textures());
    if (!renderer.ok()) return fail(renderer.error());
    PlayOptions chosen = options.value();
    chosen.save = request.save.empty() ? saved_game_of(game.value()->path()) : request.save;
    PlayLoop loop(*game.value(), *window.value(), chosen, std::move(renderer).value());
    if (Status failed = loop.run()) return fail(*failed);
    return kDone;
}

}  // namespace enfilade
