// The command `wadconv`: arguments in, words and an exit status out.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <cstdio>

#include "base/parallel.h"
#include "wadconv/convert_wads.h"

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
        std::fprintf(stderr, "\r[%s%s] %3d%%%s", std::string(static_cast<std::size_t>(filled), '#').c_str(),
                     std::string(static_cast<std::size_t>(kBarWidth - filled), ' ').c_str(), percent,
                     done == total ? "\n" : "");
    }

private:
    const bool is_terminal_ = isatty(STDERR_FILENO) == 1;
    std::atomic<int> shown_{-1};
};

int run(const RunOptions& options, bool is_verbose) {
    ProgressBar bar;
    const auto result = convert_wads(options, [&](std::size_t done, std::size_t total) { bar.show(done, total); });
    if (!result) {
        std::fprintf(stderr, "wadconv: %s\n", result.error().text().c_str());
        return kSomeRefused;
    }
    for (const std::string& problem : result.value().problems) std::fprintf(stderr, "wadconv: %s\n", problem.c_str());
    for (const Report& report : result.value().reports)
        if (!report.refused.empty())
            std::fprintf(stderr, "wadconv: %s refused: %s\n", report.map.c_str(), report.refused.c_str());
    const std::string text = is_verbose ? to_text(result.value()) : totals_text(result.value().reports);
    std::printf("%s", text.c_str());
    return result.value().is_complete() ? kAllConverted : kSomeRefused;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Converts the maps, textures and sprites of Doom and Doom II WADs into enfilade maps", "wadconv");
    RunOptions options;
    bool is_verbose = false;
    options.jobs = enfilade::hardware_threads();
    app.add_option("WAD", options.wads, "the IWAD, then PWADs that lie on top of it")->required();
    app.add_option("--map", options.maps, "convert only this map (E1M1, MAP01, …); may be given several times");
    app.add_option("--out", options.out, "folder for NAME.toml, textures/ and report.txt")->required();
    app.add_option("--jobs", options.jobs, "threads to use")->check(CLI::Range(1, 1024));
    app.add_flag("--strict", options.strict, "refuse maps in which something had to be guessed");
    app.add_flag("--open-doors", options.convert.open_doors, "raise every closed door, so that all can be walked");
    app.add_flag("--verbose", is_verbose, "print the whole report, map by map, not only its totals");
    app.set_version_flag("--version", "wadconv 0.1.0");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? kAllConverted : kUsage;
    }
    return run(options, is_verbose);
}
