// The subcommands of `enfilade`: what each may be given, as typed, what it does with it, and what it says of it to
// other programs.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/bench.h"
#include "app/messages.h"
#include "app/options.h"
#include "app/recorded_flight.h"
#include "base/finding.h"
#include "base/parallel.h"
#include "formats/dials.h"
#include "map/load.h"
#include "render/outside/outside_camera.h"
#include "world/snapshot.h"

namespace CLI {
class App;
}

namespace enfilade {

/// Notations of what a command found out (machine_output.cpp); text is for people.
inline constexpr const char *kText = "text", *kJson = "json", *kSarif = "sarif", *kJunit = "junit";

struct PlayRequest {
    std::vector<std::string> words;                               ///< a map, or WADs and a level; none: the tour
    std::string tape, save, load;                                 ///< empty where not given
    std::vector<std::pair<std::string, std::string>> settings{};  ///< that were given: names, and values as typed
    std::vector<std::string> texture_folders, dials;
    int skill = kUsualSkill;
    bool mute = false, print_map = false;
};

struct RenderRequest {
    DialRequest dials;
    std::string map, view, views, sector, size = "1280x800", renderer = "column";
    double fov_degrees = 90, time_s = 0, roll_degrees = 0;
    bool true_pitch = false;
    std::optional<double> stretch;
    std::size_t threads = hardware_threads();
    std::vector<std::string> texture_folders;
    int skill = kUsualSkill;
    LeftOut left_out;
    std::string out, ids, id_list, timing, from_above, from_behind;
    Talk talk = Talk::usual;
    std::vector<std::string> at;
    double reach_m = kUsualReach;
};

struct FlyRequest {
    std::string script, out, renderer, frames, part, size, against, format = kText;
    DialRequest dials;
    std::vector<std::string> texture_folders;
    std::size_t threads = hardware_threads();
    int skill = kUsualSkill;
    LeftOut left_out;
    std::optional<double> tolerance_percent;
    int keep_every = 0;
    bool check = false, record = false, merge = false, no_pictures = false;
    Talk talk = Talk::usual;
};

struct CheckRequest {
    std::vector<std::string> maps;
    std::vector<std::string> texture_folders;
    std::string format = kText;
    bool effects = false;
    Talk talk = Talk::usual;
};

struct BenchRequest {
    std::vector<std::string> files;            ///< maps, walks through maps and scripts
    std::string size, renderer, csv, against;  ///< empty where not given
    std::string format = kText;
    Talk talk = Talk::usual;
    std::vector<std::string> texture_folders;
    std::optional<std::size_t> threads, rounds;
    DialRequest dials;
    bool effects = false, instructions = false;
};

struct AccuracyRequest {
    std::vector<std::string> maps;  ///< empty: the shipped scenes
    std::string out, verify;        ///< empty where not given
    std::string export_to, score;   ///< folders of pictures; empty where not given
    std::vector<std::string> texture_folders;
    bool quick = false, resume = false;
};

// What authors of maps need besides.

struct ExpandRequest {
    std::string map, out;  ///< out: empty for standard output
};

struct NewRequest {
    std::string name;  ///< a path, with or without .toml
};

struct FmtRequest {
    std::vector<std::string> maps;
    bool check = false;  ///< only say which are not laid out
};

struct DrawRequest {
    std::string map, out;
};

/// Each does its work, says on stderr what went wrong and returns an exit code (app/messages.h).
int run_play(const PlayRequest& request);
/// The title screen, for who names no command.
int run_title();
int run_render(const RenderRequest& request);
int run_fly(const FlyRequest& request);
int run_check(const CheckRequest& request);
int run_bench(const BenchRequest& request);
int run_accuracy(const AccuracyRequest& request);
int run_expand(const ExpandRequest& request);
int run_new(const NewRequest& request);
int run_fmt(const FmtRequest& request);
int run_draw(const DrawRequest& request);

// The options of the tools: `accuracy` for who tunes renderers; new, expand, fmt and draw for authors of maps.

/// Declares `accuracy`, and runs it. Stays where it is: CLI11 writes into it.
class AccuracyCommand {
public:
    explicit AccuracyCommand(CLI::App& enfilade);

    bool is_asked_for() const;
    /// Its exit code. Once it is asked for.
    int run() const;

private:
    AccuracyRequest request_;
    const CLI::App* declared_ = nullptr;
};

/// Declares the commands for authors, and runs the one that was read. Stays where it is, too.
class AuthorCommands {
public:
    explicit AuthorCommands(CLI::App& enfilade);

    /// One of them was asked for. Returns its exit code.
    int run() const;

private:
    NewRequest new_;
    ExpandRequest expand_;
    FmtRequest fmt_;
    DrawRequest draw_;
    const CLI::App *declared_new_, *declared_expand_, *declared_fmt_;
};

// What commands say to other programs instead of to people: JSON (schemas in maps/*.schema.json), SARIF for findings
// and JUnit for flythroughs, which CI systems read.

/// A map with all that `check` has to say about it.
struct CheckedMap {
    std::string path;
    Findings findings;
    bool is_refused = false;
};

/// How many findings of that severity all of them have.
std::size_t count_of(const std::vector<CheckedMap>& maps, Severity severity);

/// maps/check.schema.json.
std::string check_json(const std::vector<CheckedMap>& maps);

/// SARIF 2.1.0, one result for each finding.
std::string check_sarif(const std::vector<CheckedMap>& maps);

/// What `fly --check` did.
struct CheckedFlight {
    std::string script, renderer;
    std::string compared_with;  ///< "recording", or the name of another renderer
    int first = 0, last = 0;    ///< frames, both included
    FlightVerdict verdict;
};

/// maps/fly.schema.json.
std::string flight_json(const CheckedFlight& flight);

/// JUnit's XML, one test case for each frame.
std::string flight_junit(const CheckedFlight& flight);

/// How `bench` measured.
struct BenchSetting {
    std::vector<std::string> subjects;
    int width = 0, height = 0;  ///< [px]
    std::string renderer, kernels;
    Dials dials;
    std::size_t threads = 1, rounds = 1;
};

/// maps/bench.schema.json.
std::string bench_json(const BenchSetting& setting, const std::vector<BenchFrame>& frames);

// The whole command line, as a function.

/// Runs `enfilade` with these arguments and returns its exit code (app/messages.h).
int run_command_line(int argc, const char* const* argv);

}  // namespace enfilade
