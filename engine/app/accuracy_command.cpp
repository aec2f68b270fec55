// `enfilade accuracy`: what accuracy costs in time.
#include <fmt/format.h>

#include <cstdlib>

#include "app/accuracy/report.h"
#include "app/child_program.h"
#include "app/commands.h"
#include "app/file_kind.h"
#include "app/messages.h"
#include "app/pictures.h"
#include "base/files.h"
#include "base/output_file.h"
#include "base/terminal.h"

namespace enfilade {
namespace {

/// How much is looked at.
struct AccuracyPlan {
    std::size_t poses;  ///< of each kind, in each scene
    int width, height;  ///< of judged pictures [px]
    std::size_t timed;  ///< poses whose pictures are timed
    PricePlan price;
};
constexpr std::uint64_t kSeed = 1;

AccuracyPlan plan_of(bool is_quick) {
    if (is_quick) return {2, 160, 100, 1, {3, 320, 200, false, {}}};
    return {20, 320, 200, 4, {21, 1280, 800, is_installed("valgrind"), {}}};
}

/// Plain rooms, a palace, lamps, links that turn, and links without an end.
std::vector<std::string> shipped_scenes() {
    std::vector<std::string> scenes;
    for (const char* name : {"rooms.toml", "enfilade.toml", "hut.toml", "quarter_turn.toml", "facing_doors.toml"})
        scenes.push_back(shipped_map(name));
    return scenes;
}

std::string scene_name(const std::string& path) {
    const std::string file = path.substr(path.rfind('/') + 1);
    return file.substr(0, file.rfind('.'));
}

/// Adds the rows of one scene. False where its map has errors, which then are on stderr.
Status measure_scene(const std::string& path, const AccuracyRequest& request, std::vector<AccuracyRow>& rows) {
    const auto map = open_map(path, request.texture_folders, {});
    if (!map) return Error{path, "expected a map without errors; see above"};
    AccuracyPlan plan = plan_of(request.quick);
    plan.price.map_options = {path};
    for (const std::string& folder : request.texture_folders)
        plan.price.map_options.insert(plan.price.map_options.end(), {"--textures", folder});
    const std::vector<AccuracySetting> settings = accuracy_settings(request.quick);
    std::vector<View> timed = poses_in(map->map, PoseKind::random, plan.timed, kSeed);
    const auto prices = measure_prices(*map, timed, settings, plan.price);
    if (!prices.ok()) return prices.error();
    for (const PoseKind kind : kPoseKinds) {
        const std::vector<View> views = poses_in(map->map, kind, plan.poses, kSeed);
        auto errors = measure_errors(*map, views, settings, plan.width, plan.height);
        if (!errors.ok()) return errors.error();
        for (std::size_t s = 0; s < settings.size(); ++s)
            rows.push_back({scene_name(path), kind, settings[s], std::move(errors.value()[s]), prices.value()[s]});
    }
    return {};
}

std::string command_text(const AccuracyRequest& request) {
    std::string text = "enfilade accuracy";
    for (const std::string& map : request.maps) text += " " + scene_name(map) + ".toml";
    return text + (request.quick ? " --quick" : "") + " --out DIR";
}

/// A picture where gnuplot is installed; what it would be told in any case.
Status write_plot(const std::string& folder, std::vector<AccuracyRow>& rows) {
    const std::string script = folder + "/accuracy.gp";
    if (Status failed = write_file(script, accuracy_plot(rows, folder + "/accuracy.svg"))) return failed;
    if (!is_installed("gnuplot")) {
        print_text(stderr,
                   "enfilade: no picture, because gnuplot is not installed; `gnuplot " + script + "` draws it\n");
        return {};
    }
    const auto end = run_child({"gnuplot", script});
    if (!end.ok()) return end.error();
    return end.value().exit_code == 0 ? Status() : Error{"gnuplot", end.value().said};
}

Status write_report(const AccuracyRequest& request, std::vector<AccuracyRow>& rows) {
    const std::string& folder = request.out;
    if (Status failed = make_folder(folder)) return failed;
    if (Status failed = write_file(folder + "/accuracy.csv", accuracy_csv(rows))) return failed;
    if (Status failed = write_file(folder + "/README.md", accuracy_page(rows, command_text(request)))) return failed;
    return write_plot(folder, rows);
}

Status verify(const std::string& path, std::vector<AccuracyRow>& rows) {
    const auto bytes = read_file(path);
    if (!bytes.ok()) return bytes.error();
    return compare_errors(path, as_text(bytes.value()), rows);
}

}  // namespace

int run_accuracy(const AccuracyRequest& request) {
    std::vector<AccuracyRow> rows;
    for (const std::string& scene : request.maps.empty() ? shipped_scenes() : request.maps)
        if (Status failed = measure_scene(scene, request, rows)) return fail(*failed);
    print_text(stdout, accuracy_page(rows, command_text(request)));
    if (!request.out.empty())
        if (Status failed = write_report(request, rows)) return fail(*failed);
    if (Status broken = check_promises(rows)) return fail(*broken);
    if (request.verify.empty()) return kDone;
    if (Status other = verify(request.verify, rows)) return fail(*other);
    return kDone;
}

}  // namespace enfilade
