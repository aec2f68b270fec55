// The command `wadconv`: arguments in, words and an exit status out.
#include <CLI/CLI.hpp>
#include <csignal>

#include "base/attempt.h"
#include "base/files.h"
#include "base/parallel.h"
#include "command/command.h"
#include "wadconv/convert.h"

namespace {

using namespace enfilade::wadconv;

constexpr const char* kName = "wadconv";
constexpr int kMostThreads = 1024;

void complain(const std::string& what) { enfilade::fail(kName, {"", what}); }

enfilade::Result<RunResult> convert(const RunOptions& options) {
    enfilade::Progress progress(0, "maps and pictures");
    return convert_wads(
        options, [&](std::size_t done, std::size_t total, std::size_t worker) { progress.show(done, total, worker); });
}

int run(const RunOptions& options, bool is_verbose) {
    const auto result = convert(options);
    if (!result) return enfilade::fail(kName, result.error());
    for (const std::string& problem : result.value().problems) complain(problem);
    for (const Report& report : result.value().reports)
        if (!report.refused.empty()) complain(report.map + " refused: " + report.refused);
    const std::string text = is_verbose ? to_text(result.value()) : totals_text(result.value().reports);
    const auto printed = enfilade::print_to_stdout(text + written_text(result.value(), options.out));
    if (!printed.ok()) return enfilade::fail(kName, printed.error());
    return result.value().is_complete() ? enfilade::kDone : enfilade::kFailed;
}

int run_command_line(int argc, char** argv) {
    CLI::App app("Converts the maps, textures and sprites of Doom and Doom II WADs into enfilade maps", kName);
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
        ->check([](const std::string& text) { return enfilade::range_fault(text, 1, kMostThreads); });
    app.add_flag("--strict", options.strict, "Refuse maps in which something had to be guessed");
    app.add_flag("--open-doors", options.convert.open_doors, "Raise every closed door, so that all can be walked");
    app.add_flag("--verbose", is_verbose, "Print the whole report, map by map, not only its totals");
    app.set_version_flag("--version", std::string(kName) + " " ENFILADE_VERSION, "Print the version and exit");
    app.footer(
        "Example:\n  wadconv /usr/share/games/doom/freedoom2.wad --map MAP01 --out levels\nExit status: 0 all "
        "converted, "
        "1 some maps refused, each by name, 2 wrong usage.");
    if (const auto status = enfilade::read_arguments(app, argc, argv)) return *status;
    enfilade::remove_temporary_files_on({SIGHUP, SIGINT, SIGTERM});
    return run(options, is_verbose);
}

[[gnu::constructor(enfilade::kBeforeAllConstants)]] void begin() { enfilade::end_in_a_sentence(kName); }

}  // namespace

int main(int argc, char** argv) {
    return enfilade::run_program(kName, [&] { return run_command_line(argc, argv); });
}
