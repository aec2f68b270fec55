// `enfilade check`: every finding about maps, for authors and for editors that jump to a place.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/commands.h"
#include "app/effects.h"
#include "app/exit_codes.h"
#include "base/files.h"
#include "formats/map_toml.h"
#include "map/load.h"

namespace enfilade {
namespace {

struct CheckRequest {
    std::vector<std::string> maps;
    std::vector<std::string> texture_folders;
    bool effects = false;
};

struct Tally {
    std::size_t maps = 0, refused = 0, errors = 0, warnings = 0;
};

std::string counted(std::size_t count, const char* noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

void print_effects(const std::string& path) {
    const auto bytes = read_file(path);
    if (!bytes.ok()) return;
    const MapFile map = read_map(as_text(bytes.value())).map;
    fmt::print("{}: {} calls for\n{}", path, counted(map.sectors.size(), "sector"), to_text(effects_in(map)));
}

void check_map(const std::string& path, const CheckRequest& request, Tally& tally) {
    const LoadedMap loaded = load_map(path, request.texture_folders, read_file);
    std::string text;
    for (const Finding& finding : loaded.findings) {
        text += to_text(path, finding) + '\n';
        ++(finding.severity == Severity::error ? tally.errors : tally.warnings);
    }
    fmt::print("{}", text);
    ++tally.maps;
    tally.refused += has_errors(loaded.findings);
    if (request.effects && loaded.map) print_effects(path);
}

class CheckCommand final : public Command {
public:
    CLI::App* declare(CLI::App& enfilade) override {
        CLI::App* command = enfilade.add_subcommand("check", "Say everything that is wrong with maps, with its place");
        command->add_option("MAP", request_.maps, "Map files (.toml)")->required();
        command->add_option("--textures", request_.texture_folders, "More folders to look for pictures in")
            ->type_name("DIR")
            ->allow_extra_args(false);
        command->add_flag("--effects", request_.effects,
                          "Also tell which effects each map calls for and what they cost");
        command->footer(
            "Findings are printed as FILE:LINE:COLUMN: error|warning: SENTENCE [CODE]. A warning does not "
            "refuse a map.\nExit status: 0 all maps are sound, 1 some have errors, 2 wrong usage.");
        return command;
    }

    int run() override {
        Tally tally;
        for (const std::string& map : request_.maps) check_map(map, request_, tally);
        fmt::print("{} checked, {} refused: {}, {}\n", counted(tally.maps, "map"), tally.refused,
                   counted(tally.errors, "error"), counted(tally.warnings, "warning"));
        return tally.refused == 0 ? kDone : kFailed;
    }

private:
    CheckRequest request_;
};

}  // namespace

std::unique_ptr<Command> make_check_command() { return std::make_unique<CheckCommand>(); }

}  // namespace enfilade
