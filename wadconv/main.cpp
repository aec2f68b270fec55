// The command `wadconv`: arguments in, words and an exit status out.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <sstream>

#include "base/attempt.h"
#include "base/output_file.h"
#include "base/parallel.h"
#include "base/terminal.h"
#include "wadconv/convert.h"

namespace {

using namespace enfilade::wadconv;

/// Exit statuses, which scripts rely on.
constexpr int kAllConverted = 0, kSomeRefused = 1, kUsage = 2;

constexpr int kBarWidth = 40;

/// A bar on stderr where that is a terminal, redrawn when a hundredth is done.
class ProgressBar {
public:
    void show(std::size_t done, std::size_t total) {
        if (!is_terminal_) return;
        const int percent = static_cast<int>(100 * done / total);
        if (shown_.exchange(percent) == percent) return;
        const int filled = kBarWidth * percent / 100;
        enfilade::redraw_line("[" + std::string(static_cast<std::size_t>(filled), '#') +
                              std::string(static_cast<std::size_t>(kBarWidth - filled), ' ') + "] " +
                              std::to_string(percent) + "%");
        if (done == total) enfilade::print_text(stderr, "\n");
    }

private:
    const bool is_terminal_ = isatty(STDERR_FILENO) == 1;
    std::atomic<int> shown_{-1};
};

void complain(const std::string& what) { enfilade::print_text(stderr, "wadconv: " + what + "\n"); }

int refuse_usage(const std::string& what) {
    complain(what + "; see `wadconv --help`");
    return kUsage;
}

int run(const RunOptions& options, bool is_verbose) {
    ProgressBar bar;
    const auto result = convert_wads(options, [&](std::size_t done, std::size_t total) { bar.show(done, total); });
    if (!result) {
        complain(result.error().text());
        return kSomeRefused;
    }
    for (const std::string& problem : result.value().problems) complain(problem);
    for (const Report& report : result.value().reports)
        if (!report.refused.empty()) complain(report.map + " refused: " + report.refused);
    const std::string text = is_verbose ? to_text(result.value()) : totals_text(result.value().reports);
    enfilade::print_text(stdout, text + written_text(result.value(), options.out));
    return result.value().is_complete() ? kAllConverted : kSomeRefused;
}

int run_command_line(int argc, char** argv) {
    CLI::App app("Converts the maps, textures and sprites of Doom and Doom II WADs into enfilade maps", "wadconv");
    RunOptions options;
    bool is_verbose = false;
    options.jobs = enfilade::hardware_threads();
    app.add_option("WAD", options.wads, "The game's WAD, then patches that lie on top of it")->required();
    app.add_option("--map", options.maps, "Convert only this map (E1M1, MAP01, …); may be given several times")
        ->type_name("NAME");
    app.add_option("--out", options.out,
                   "Folder for NAME.toml, textures, sounds and report.txt; made if it is not there")
        ->type_name("FOLDER")
        ->required();
    app.add_option("--jobs", options.jobs, "Threads to use; one for each core if not given")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    app.add_flag("--strict", options.strict, "Refuse maps in which something had to be guessed");
    app.add_flag("--open-doors", options.convert.open_doors, "Raise every closed door, so that all can be walked");
    app.add_flag("--verbose", is_verbose, "Print the whole report, map by map, not only its totals");
    app.set_version_flag("--version", "wadconv " ENFILADE_VERSION);
    app.footer(
        "Example:\n  wadconv /usr/share/games/doom/freedoom2.wad --map MAP01 --out levels\nExit status: 0 all "
        "converted, "
        "1 some maps refused, each by name, 2 wrong usage.");
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked_for_text) {
        std::ostringstream text;
        const int exit_code = app.exit(asked_for_text, text);
        enfilade::print_text(stdout, text.str());
        return exit_code;
    } catch (const CLI::ParseError& error) {
        return refuse_usage(error.what());
    }
    enfilade::remove_temporary_files_on({SIGHUP, SIGINT, SIGTERM});
    return run(options, is_verbose);
}

[[gnu::constructor(enfilade::kBeforeAllConstants)]] void begin() { enfilade::end_in_a_sentence("wadconv"); }

}  // namespace

int main(int argc, char** argv) {
    return enfilade::run_program("wadconv", [&] { return run_command_line(argc, argv); });
}
