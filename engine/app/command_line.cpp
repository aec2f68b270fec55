// The command line as a whole. Besides the options of the tools the only file that knows CLI11: reading its headers
// takes longer than compiling the rest of a command.
#include "app/commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>

#include "app/messages.h"
#include "app/options.h"
#include "app/play/settings.h"
#include "base/files.h"
#include "formats/text_parts.h"
#include "render/view.h"

namespace enfilade {
namespace {

constexpr const char* kRenderers = "column (by the CPU), stencil (by OpenGL) or reference (slow, simply right)";
constexpr std::array<std::string_view, 10> kCommands{"play",     "render", "fly",    "check", "bench",
                                                     "accuracy", "new",    "expand", "fmt",   "draw"};
constexpr double kLatestMoment = 1e9;                     // [s], thirty years
constexpr double kLeastStretch = 0.1, kMostStretch = 10;  // beyond them nothing can be told apart
constexpr int kMostThreads = 256, kMostFramesBetween = 1'000'000, kMostRounds = 10'000;

/// A finite number from low to high. CLI11's own Range lets NaN through.
CLI::Validator number_within(double low, double high) {
    return CLI::Validator([=](std::string& text) { return range_fault(text, low, high); }, "");
}

void declare_textures(CLI::App& command, std::vector<std::string>& folders) {
    command.add_option("--textures", folders, "More folders to look for pictures in")
        ->type_name("DIR")
        ->allow_extra_args(false);
}

void declare_skill(CLI::App& command, int& skill) {
    command.add_option("--skill", skill, "Which things stand in the map, as it says itself; 3 if not given")
        ->type_name("1..5")
        ->check(number_within(1, kMostSkill));
}

template <class Count>
void declare_threads(CLI::App& command, Count& threads) {
    command.add_option("--threads", threads, "Threads to draw with; else one for each core")
        ->type_name("N")
        ->check(number_within(1, kMostThreads));
}

void declare_true_pitch(CLI::App& command, bool& true_pitch) {
    command.add_flag("--true-pitch", true_pitch,
                     "Looking up and down turns the picture, as a head turns, instead of shifting the horizon: upright "
                     "lines converge. Drawn by stencil and reference");
}

void declare_single_dials(CLI::App& command, std::vector<std::string>& dials) {
    command
        .add_option(
            "--dial", dials,
            "A single dial, to see what it does: span=1..64 (columns or rows from one exact position to the "
            "next), number=double, float, fixed or vanilla, sampling=nearest, mip (distant pictures made smaller), "
            "bilinear (texels blended with their neighbours) or trilinear (both), light=map, smooth or bands, "
            "fog=smooth or bands, "
            "light_grid=1..64 (places along a metre where lamps' light is worked out), links=0..1000 (looked through "
            "in one chain), of `play` alone tick_rate=60, 35 or 140 (a second, in which bodies move) and "
            "crossing=exact or naive (rooms "
            "found by the place on the plan alone, as Build did: wrong where rooms lie over each other), and of the "
            "stencil renderer portals=exact, plane24, plane32, oblique24 or oblique32 (told "
            "apart by a depth buffer of so many bits, and cut off at the portal's plane or by a near plane that lies "
            "in it). May be given many times")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
}

/// otherwise: what holds where nothing is given.
void declare_dials(CLI::App& command, DialRequest& request, const std::string& otherwise = "1") {
    command
        .add_option("--samples", request.samples,
                    "Each pixel shows the mean of N x N rays: smooth edges, in N x N times the time or more; " +
                        otherwise + " if not given")
        ->type_name("N")
        ->check(number_within(1, kMostSamples));
    command
        .add_option("--accuracy", request.accuracy,
                    "How far texels may be off: exact, fine (a quarter of a texel), fast (one), or a number of texels; "
                    "or as far as Doom's were: vanilla. "
                    "By the column renderer; what a pixel belongs to is exact with all of them")
        ->type_name("NAME|TEXELS");
    declare_single_dials(command, request.dials);
}

void declare_quiet(CLI::App& command, Talk& talk) {
    command.add_flag_function(
        "--quiet", [&](std::int64_t) { talk = Talk::errors_only; }, "Say nothing but errors and what is asked for");
}

/// names : the notations there are, the first for people.
void declare_format(CLI::App& command, std::string& format, std::vector<std::string> names, const std::string& what) {
    const auto check = [names](const std::string& text) -> std::string {
        if (std::ranges::find(names, text) != names.end()) return {};
        return fmt::format("expected {}; found {}", fmt::join(names, " or "), in_quotes(text));
    };
    command.add_option("--format", format, what)->type_name("NAME")->check(CLI::Validator(check, ""));
}

void declare_left_out(CLI::App& command, LeftOut& left_out) {
    command.add_flag("--no-things", left_out.things, "Draw no things");
    command.add_flag("--still-light", left_out.light_effects,
                     "Flickering and other effects of light stand: rooms and lamps have their own light");
}

/// Every setting is an option, for one time; switches have one to turn them off, too.
void declare_settings(CLI::App& command, PlayRequest& request) {
    for (const Setting& setting : all_settings()) {
        const auto give = [&request, &setting](const std::string& text) {
            request.settings.emplace_back(setting.name, text);
        };
        const auto turn = [give](std::int64_t times) { give(times > 0 ? "on" : "off"); };
        const std::string name = option_of(setting), help(setting.help);
        CLI::Option* const option = setting.is_flag
                                        ? command.add_flag_function(name + ",!--no-" + name.substr(2), turn, help)
                                        : command.add_option_function<std::string>(name, give, help);
        option->group("Settings, for this time; otherwise they are as the menu has them");
        if (!setting.is_flag) option->type_name(setting.step > 0 ? "N" : setting.name == "size" ? "WxH" : "NAME");
    }
}

CLI::App* declare_play(CLI::App& enfilade, PlayRequest& request) {
    CLI::App* command = enfilade.add_subcommand("play", "Walk through a map in a window");
    command->add_option("MAP", request.words,
                        "The map file (.toml); or a WAD of Doom, by its path or, where it is installed, by its name, "
                        "patches that follow it, and a level (MAP01, E1M1, ...; if not given, the first). If nothing "
                        "is given, the tour of Enfilade");
    command->add_flag("--print-map", request.print_map,
                      "Print the path of the map instead of playing it; levels of a WAD are converted first");
    command->add_flag("--mute", request.mute, "No sounds");
    declare_settings(*command, request);
    declare_single_dials(*command, request.dials);
    command->add_option("--record", request.tape, "Write down all input, to play it again")->type_name("TAPE");
    command
        ->add_option("--save", request.save,
                     "Where F5 saves the game and F9 finds it; if not given, a file of its own for each map in "
                     "$XDG_DATA_HOME/enfilade or ~/.local/share/enfilade")
        ->type_name("FILE");
    command->add_option("--load", request.load, "Go on with a game that was saved")->type_name("FILE");
    declare_textures(*command, request.texture_folders);
    declare_skill(*command, request.skill);
    command->footer(
        "Keys (F1 shows them): WASD or up/down walk, mouse or left/right turn, Shift runs, Alt walks slowly, Ctrl and "
        "the wheel change "
        "the field of view, C crouches, E uses, Tab shows the map\n"
        "(+ and - zoom), R held goes back in time, F5 saves and F9 loads, F2 changes between the column and the "
        "stencil renderer, F3 shows times and viewports, F4\n"
        "shows the rooms one sees from outside (F6 from above or from behind, + and - zoom), F7 tells what one looks "
        "at, F8 flies through walls and comes back, F11 fills the screen, F12 "
        "saves a picture, Esc opens the menu.\nA gamepad works, too. Saving the map's file while "
        "playing loads it again in place.");
    return command;
}

void declare_places(CLI::App& command, RenderRequest& request) {
    auto* view = command.add_option("--view", request.view,
                                    "Place of the eye in metres and look in degrees; without it, the player's start");
    view->type_name("X,Y,Z,YAW,PITCH");
    auto* views = command.add_option("--views", request.views,
                                     "Many places: a CSV file with the header x,y,z,yaw,pitch and maybe sector");
    views->type_name("FILE.csv")->excludes(view);
    command.add_option("--sector", request.sector, "The sector that holds the view; else it is found")
        ->type_name("NAME")
        ->needs(view);
    command.add_option("--time", request.time_s, "The moment to show, in seconds since the start")
        ->type_name("S")
        ->check(number_within(0, kLatestMoment));
}

void declare_pictures(CLI::App& command, RenderRequest& request) {
    command.add_option("--size", request.size, "Size in pixels, 1280x800 if not given")->type_name("WxH");
    command.add_option("--fov", request.fov_degrees, "Horizontal field of view, 90 if not given")
        ->type_name("DEG")
        ->check(number_within(kMinFov, kMaxFov));
    declare_true_pitch(command, request.true_pitch);
    command.add_option("--roll", request.roll_degrees, "Lean the head to its right")
        ->type_name("DEG")
        ->check(number_within(-360, 360))
        ->needs("--true-pitch");
    command.add_option("--stretch", request.stretch, "Vertical stretch instead of the map's own; Doom's is 1.2")
        ->type_name("S")
        ->check(number_within(kLeastStretch, kMostStretch));
    command.add_option("--renderer", request.renderer, kRenderers)->type_name("NAME");
    declare_dials(command, request.dials);
    declare_threads(command, request.threads);
    declare_textures(command, request.texture_folders);
    declare_skill(command, request.skill);
    declare_left_out(command, request.left_out);
    command.add_option("--out", request.out, "One picture (- for standard output), or a folder for 000000.png onward")
        ->type_name("FILE.png|DIR")
        ->required();
    command.add_option("--ids", request.ids, "The same for pictures of 24-bit surface ids, red the high byte")
        ->type_name("FILE.png|DIR");
    command
        .add_option("--id-list", request.id_list,
                    "What the ids stand for: id,surface,sector,place, the place in the map's file")
        ->type_name("FILE.csv");
    command.add_option("--timing", request.timing, "How long each view took to draw: view,ns")->type_name("FILE.csv");
}

void declare_outside(CLI::App& command, RenderRequest& request) {
    command
        .add_option("--from-above", request.from_above,
                    "The same for pictures of the eye and the rooms it sees, from above: what it sees is bright, what "
                    "lies behind linked doorways and in mirrors is where it appears")
        ->type_name("FILE.png|DIR");
    command.add_option("--from-behind", request.from_behind, "The same for pictures from behind the eye")
        ->type_name("FILE.png|DIR");
    command
        .add_option("--reach", request.reach_m,
                    "How many metres of ground --from-above shows, 24 if not given; --from-behind stands a fifth of it "
                    "away")
        ->type_name("M")
        ->check(number_within(kLeastReach, kMostReach));
}

void declare_readout(CLI::App& command, RenderRequest& request) {
    command
        .add_option("--at", request.at,
                    "Tell what this pixel shows: the surface, how far ahead it is (its depth), the texel, and the line "
                    "of the map's "
                    "file. May be given many times")
        ->type_name("X,Y")
        ->allow_extra_args(false);
}

CLI::App* declare_render(CLI::App& enfilade, RenderRequest& request) {
    CLI::App* command = enfilade.add_subcommand("render", "Draw pictures of a map, without a window");
    command->add_option("MAP", request.map, "The map file (.toml)")->required();
    declare_places(*command, request);
    declare_pictures(*command, request);
    declare_outside(*command, request);
    declare_readout(*command, request);
    declare_quiet(*command, request.talk);
    command->footer(
        "Examples:\n  enfilade render maps/enfilade.toml --out start.png\n  enfilade render "
        "maps/enfilade.toml --view 3,2,1.7,90,0 --size 640x400 --out door.png\n  enfilade render "
        "maps/enfilade.toml --views places.csv --out pictures --timing times.csv\nExit status: 0 done, 1 "
        "the map or a file is at fault, 2 wrong usage.");
    return command;
}

void declare_drawing(CLI::App& command, FlyRequest& request) {
    command
        .add_option(
            "--out", request.out,
            "A folder for 000000.png onward, or a film (- for standard output, as .y4m); needed, unless --check or "
            "--record is given. With "
            "--check, the folder of its report; if not given, SCRIPT's name with .failed in the current folder")
        ->type_name("DIR|FILE.mp4|FILE.y4m");
    auto* frames = command.add_option("--frames", request.frames, "Only these frames, counted from 0");
    frames->type_name("A..B");
    command
        .add_option("--part", request.part,
                    "Only the K-th of N parts of the frames: for many cores or machines. With --record, --merge makes "
                    "one recording of the parts")
        ->type_name("K/N")
        ->excludes(frames);
    command.add_option("--size", request.size, "Size in pixels instead of the script's")->type_name("WxH");
    command.add_option("--renderer", request.renderer, "column, stencil or reference, instead of the script's")
        ->type_name("NAME");
    declare_dials(command, request.dials, "the script's");
    declare_threads(command, request.threads);
    declare_textures(command, request.texture_folders);
    declare_skill(command, request.skill);
    declare_left_out(command, request.left_out);
}

void declare_tests(CLI::App& command, FlyRequest& request) {
    auto* check = command.add_flag("--check", request.check,
                                   "Compare every frame with its recorded hash; where some differ, exit with 1 "
                                   "and leave pictures of them in a report");
    command
        .add_flag("--record", request.record,
                  "Record the hash of every frame in SCRIPT's .hashes file, and beside it small pictures of some in "
                  "SCRIPT's .sheet.png, for the report of a later --check; draws no pictures for --out")
        ->excludes(check);
}

/// What belongs to --record, which is declared.
void declare_recordings(CLI::App& command, FlyRequest& request) {
    command
        .add_flag("--merge", request.merge,
                  "Make one recording of the parts that lie beside the script, recorded with --part or --frames, and "
                  "remove them")
        ->excludes("--check")
        ->excludes("--record")
        ->excludes("--out");
    auto* keep = command
                     .add_option("--keep", request.keep_every,
                                 "With --record: also keep every N-th frame in full size, in SCRIPT's .frames folder; "
                                 "if not given, those that are there are drawn anew")
                     ->type_name("N")
                     ->check(number_within(1, kMostFramesBetween));
    command
        .add_flag("--no-pictures", request.no_pictures,
                  "With --record: keep only hashes, and remove pictures that were kept")
        ->excludes(keep);
}

/// What belongs to --check, which is declared.
void declare_comparisons(CLI::App& command, FlyRequest& request) {
    command.add_option("--against", request.against, "With --check: compare with another renderer instead")
        ->type_name("NAME");
    command
        .add_option("--tolerance", request.tolerance_percent,
                    "With --check --against: how many percent of a frame's pixels may differ; 0 if not given")
        ->type_name("PERCENT")
        ->check(number_within(0, 100));
    declare_format(command, request.format, {kText, kJson, kJunit},
                   "With --check: how to say what differs: text, json or junit");
    declare_quiet(command, request.talk);
}

CLI::App* declare_fly(CLI::App& enfilade, FlyRequest& request) {
    CLI::App* command = enfilade.add_subcommand("fly", "Draw a scripted flythrough: pictures, a film, or a test");
    command->add_option("SCRIPT", request.script, "The script (.toml): a map, a size and what the camera does")
        ->required();
    declare_drawing(*command, request);
    declare_tests(*command, request);
    declare_recordings(*command, request);
    declare_comparisons(*command, request);
    command->footer(
        "Examples:\n  enfilade fly maps/flythroughs/enfilade.toml --out enfilade.mp4\n  enfilade fly "
        "maps/flythroughs/enfilade.toml --record\n  enfilade fly maps/flythroughs/enfilade.toml --check "
        "--out report\nExit status: 0 done, 1 something is at fault or differs, 2 wrong usage.");
    return command;
}

CLI::App* declare_check(CLI::App& enfilade, CheckRequest& request) {
    CLI::App* command = enfilade.add_subcommand("check", "Say everything that is wrong with maps, with its place");
    command->add_option("MAP", request.maps, "Map files (.toml), or folders: all maps in them")->required();
    declare_textures(*command, request.texture_folders);
    command->add_flag("--effects", request.effects, "Also tell which effects each map calls for and what they cost");
    declare_format(*command, request.format, {kText, kJson, kSarif}, "How to say it: text, json or sarif");
    declare_quiet(*command, request.talk);
    command->footer(
        "Findings are printed as FILE:LINE:COLUMN: error|warning: SENTENCE [CODE]. A warning does not "
        "refuse a map.\nExit status: 0 all maps are sound, 1 some have errors, 2 wrong usage.");
    return command;
}

CLI::App* declare_bench(CLI::App& enfilade, BenchRequest& request) {
    CLI::App* command = enfilade.add_subcommand("bench", "Measure how long frames take, or what effects cost");
    command->add_option("MAP|MAP:WALK.csv|SCRIPT", request.files,
                        "Maps, seen from the player's start; walks, every view of a list as `render --views` takes it; "
                        "and flythroughs, every frame of them");
    command->add_option("--size", request.size, "Size in pixels, 1280x800 if not given; with --effects 640x400")
        ->type_name("WxH");
    command->add_option("--renderer", request.renderer, kRenderers)->type_name("NAME");
    declare_dials(*command, request.dials);
    command
        ->add_option(
            "--rounds", request.rounds,
            "How often each frame is drawn, 9 if not given; with --effects 10 in each of two builds, and made even")
        ->type_name("N")
        ->check(number_within(1, kMostRounds));
    declare_threads(*command, request.threads);
    declare_textures(*command, request.texture_folders);
    command
        ->add_option("--csv", request.csv,
                     "Every frame: subject,frame,minimum_ns,median_ns,walls,runs,viewports,pixels,hash")
        ->type_name("FILE");
    command
        ->add_option(
            "--against", request.against,
            "Instead, let another build of this program measure the same, in turn with this one, pass by pass: "
            "ratios of this one's times to the other's, and whether the pictures are the same")
        ->type_name("PROGRAM");
    declare_format(*command, request.format, {kText, kJson}, "How to say it: text, or json with every frame");
    declare_quiet(*command, request.talk);
    command->add_flag("--instructions", request.instructions,
                      "Instead, count the instructions of a pixel on one thread; needs valgrind and takes fifty times "
                      "as long");
    command->add_flag(
        "--effects", request.effects,
        "Instead, a table in Markdown of what each effect of the maps costs by the column renderer on one "
        "thread; without maps, of effects.toml");
    command->footer(
        "Frames are drawn in turn, so that what else the machine does troubles all of them alike. Walls, runs (of one "
        "surface "
        "down one column) and viewports are means of a picture. Slowest is the frame whose minimum is the "
        "largest.\nExamples:\n  "
        "enfilade bench maps/enfilade.toml maps/flythroughs/cells.toml --threads 1 --csv times.csv\n  enfilade bench "
        "e1m1.toml:walk.csv --threads 1 --against old/enfilade\n  enfilade bench --effects\nExit status: 0 done, 1 "
        "something is at fault, 2 wrong usage.");
    return command;
}

/// What is said of a word that is no command of ours.
std::string about_command(const std::string& word) {
    return word.empty() ? fmt::format("expected a command: {}", fmt::join(kCommands, ", "))
                        : unknown_command(word, kCommands);
}

/// Whether somebody could see a window.
bool has_display() {
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"})
        if (const char* value = std::getenv(name); value && *value) return true;
    return false;
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
    CLI::App app("Rooms, portals and doorways that lead where they should not: a Doom-style engine.", "enfilade");
    app.set_version_flag("--version", "enfilade " ENFILADE_VERSION, "Print the version and exit");
    app.require_subcommand(0, 1);
    app.footer("`enfilade COMMAND --help` tells more about each. Exit status: 0 done, 1 failed, 2 wrong usage.");
    PlayRequest play;
    RenderRequest render;
    FlyRequest fly;
    CheckRequest check;
    BenchRequest bench;
    const CLI::App* const declared_play = declare_play(app, play);
    const CLI::App* const declared_render = declare_render(app, render);
    const CLI::App* const declared_fly = declare_fly(app, fly);
    const CLI::App* const declared_bench = declare_bench(app, bench);
    AccuracyCommand accuracy(app);
    const CLI::App* const declared_check = declare_check(app, check);
    AuthorCommands author(app);
    if (const auto status = read_arguments(app, argc, argv, about_command)) return *status;
    if (app.get_subcommands().empty() && !has_display())
        return refuse_usage(
            {"",
             about_command("") + "; see `enfilade --help`. With a display, `enfilade` alone opens the title screen"});
    remove_temporary_files_on({SIGHUP});
    if (app.get_subcommands().empty()) return run_title();
    if (declared_play->parsed()) return run_play(play);  // its window turns the other signals into leaving the game
    remove_temporary_files_on({SIGINT, SIGTERM});
    if (declared_render->parsed()) return run_render(render);
    if (declared_fly->parsed()) return run_fly(fly);
    if (declared_bench->parsed()) return run_bench(bench);
    if (accuracy.is_asked_for()) return accuracy.run();
    if (declared_check->parsed()) return run_check(check);
    return author.run();
}

}  // namespace enfilade
