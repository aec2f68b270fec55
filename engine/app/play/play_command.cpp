// `enfilade play`: walk through a map in a window.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>

#include "app/commands.h"
#include "app/exit_codes.h"
#include "app/play/play_loop.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

struct PlayRequest {
    std::string map, renderer = "column", size, tape;
    std::vector<std::string> texture_folders;
    bool fullscreen = false;
};

/// The map that is played if nobody names one: beside the program's share folder where it is installed, else in the
/// source tree it was built from.
std::string default_map() {
    std::error_code unknown;
    const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
    const std::array<fs::path, 2> folders{program.parent_path() / "../share/enfilade/maps", ENFILADE_MAPS_DIR};
    for (const fs::path& folder : folders)
        if (fs::exists(folder / "enfilade.toml", unknown))
            return (folder / "enfilade.toml").lexically_normal().string();
    return "maps/enfilade.toml";
}

Result<PlayOptions> options_of(const PlayRequest& request) {
    PlayOptions options;
    const auto renderer = parse_renderer(request.renderer);
    if (!renderer.ok()) return renderer.error();
    options.renderer = renderer.value();
    if (!request.size.empty()) {
        const auto size = parse_size(request.size);
        if (!size.ok()) return size.error();
        options.size = size.value();
    }
    options.fullscreen = request.fullscreen;
    options.tape = request.tape;
    return options;
}

Result<std::unique_ptr<Window>> window_for(const Game& game, const PlayOptions& options) {
    WindowOptions wanted;
    wanted.title = "Enfilade - " + game.map().name;
    wanted.fullscreen = options.fullscreen;
    if (options.size) {
        wanted.width = options.size->width;
        wanted.height = options.size->height;
    }
    return open_window(wanted);
}

class PlayCommand final : public Command {
public:
    CLI::App* declare(CLI::App& enfilade) override {
        CLI::App* command = enfilade.add_subcommand("play", "Walk through a map in a window");
        command->add_option("MAP", request_.map, "The map file (.toml); if none is given, the tour of Enfilade");
        command->add_option("--renderer", request_.renderer, "column (fast) or reference (slow, simply right)")
            ->type_name("NAME");
        command->add_option("--size", request_.size, "Size of the picture in pixels, scaled to the window")
            ->type_name("WxH");
        command->add_flag("--fullscreen", request_.fullscreen, "Fill the screen");
        command->add_option("--record", request_.tape, "Write down all input, to play it again")->type_name("TAPE");
        command->add_option("--textures", request_.texture_folders, "More folders to look for pictures in")
            ->type_name("DIR")
            ->allow_extra_args(false);
        command->footer(
            "Keys: WASD or up/down walk, mouse or left/right turn, Shift runs, C crouches, E uses, Tab shows the map\n"
            "(+ and - zoom), F3 shows times and viewports, F11 fills the screen, F12 saves a picture, Esc opens the "
            "menu.\nA gamepad works, too. Saving the map's file while playing loads it again in place.");
        return command;
    }

    int run() override {
        const auto options = options_of(request_);
        if (!options.ok()) return refuse_usage(options.error());
        auto game = Game::start(request_.map.empty() ? default_map() : request_.map, request_.texture_folders);
        if (!game.ok()) return fail(game.error());
        auto window = window_for(*game.value(), options.value());
        if (!window.ok()) return fail(window.error());
        if (Status failed = PlayLoop(*game.value(), *window.value(), options.value()).run()) return fail(*failed);
        return kDone;
    }

private:
    PlayRequest request_;
};

}  // namespace

std::unique_ptr<Command> make_play_command() { return std::make_unique<PlayCommand>(); }

}  // namespace enfilade
