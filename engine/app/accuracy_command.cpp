// `enfilade accuracy`: what accuracy costs in time.
#include <fmt/format.h>

#include <algorithm>

#include "app/accuracy/errors.h"
#include "app/accuracy/motion.h"
#include "app/accuracy/picture_files.h"
#include "app/accuracy/report.h"
#include "app/commands.h"
#include "app/messages.h"
#include "app/pictures.h"
#include "app/programs.h"
#include "base/file_name.h"
#include "base/files.h"
#include "base/hash.h"
#include "base/text.h"

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
    if (is_quick) return {2, 160, 100, 1, {3, 320, 200, {}, {}}};
    return {20, 320, 200, 4, {21, 1280, 800, {}, {}}};
}

/// Plain rooms, a palace, lamps, links that turn, and links without an end.
std::vector<std::string> shipped_scenes() {
    std::vector<std::string> scenes;
    for (const char* name : {"rooms.toml", "enfilade.toml", "hut.toml", "quarter_turn.toml", "facing_doors.toml"})
        scenes.push_back(shipped_map(name));
    return scenes;
}

std::vector<std::string> maps_of(const AccuracyRequest& request) {
    return request.maps.empty() ? shipped_scenes() : request.maps;
}

std::string scene_name(const std::string& path) { return safe_file_name(file_stem_of(path)); }

/// One scene. An error where its map has errors, which then are on stderr.
Result<AccuracyScene> measure_scene(const std::string& path, const AccuracyRequest& request) {
    const auto map = open_map(path, request.texture_folders, {});
    if (!map) return Error{path, "expected a map without errors; see above"};
    AccuracyPlan plan = plan_of(request.quick);
    plan.price.map_options = {path};
    for (const std::string& folder : request.texture_folders)
        plan.price.map_options.insert(plan.price.map_options.end(), {"--textures", folder});
    const std::vector<AccuracySetting> settings = accuracy_settings(request.quick);
    const std::vector<View> timed = poses_in(map->map, PoseKind::random, plan.timed, kSeed);
    if (!request.out.empty()) {
        const std::string folder = request.out + "/views", file = folder + "/" + scene_name(path) + ".csv";
        if (const Result<void> done = make_folder(folder); !done.ok()) return done.error();
        if (const Result<void> done = write_file(file, views_csv(timed)); !done.ok()) return done.error();
        if (!request.quick && find_program("valgrind")) plan.price.views_file = file;
    }
    const auto prices = measure_prices(*map, timed, settings, plan.price);
    if (!prices.ok()) return prices.error();
    const auto bytes = read_file(path);
    if (!bytes.ok()) return bytes.error();
    AccuracyScene scene{scene_name(path), hash_of_bytes(bytes.value()), {}};
    for (const PoseKind kind : kPoseKinds) {
        const std::vector<View> views = poses_in(map->map, kind, plan.poses, kSeed);
        auto errors = measure_errors(*map, views, settings, plan.width, plan.height);
        if (!errors.ok()) return errors.error();
        for (std::size_t s = 0; s < settings.size(); ++s)
            scene.rows.push_back({kind, settings[s], errors.value()[s], prices.value()[s]});
    }
    return scene;
}

std::string command_text(const AccuracyRequest& request) {
    std::string text = "enfilade accuracy";
    for (const std::string& map : request.maps) text += " " + scene_name(map) + ".toml";
    return text + (request.quick ? " --quick" : "") + " --out DIR";
}

/// Pictures where gnuplot is installed; what it would be told in any case.
Result<void> write_plot(const std::string& folder, const std::vector<AccuracyScene>& scenes) {
    const std::string script = folder + "/accuracy.gp";
    if (const Result<void> done = write_file(script, accuracy_plot(scenes, folder)); !done.ok()) return done.error();
    if (!find_program("gnuplot")) {
        print_to_stderr("enfilade: no picture, because gnuplot is not installed; `gnuplot " + script + "` draws it\n");
        return {};
    }
    const auto end = run_child({"gnuplot", script});
    if (!end.ok()) return end.error();
    return end.value().exit_code == 0 ? Result<void>() : Error{"gnuplot", end.value().said};
}

std::string report_in(const std::string& folder) { return folder + "/report.json"; }

/// In the first of the maps.
Result<void> write_crops_of(const AccuracyRequest& request, const std::string& folder) {
    const auto map = open_map(maps_of(request).front(), request.texture_folders, {});
    ENFILADE_CHECK(map);  // it was measured
    return write_crops(folder, *map, crop_settings());
}

/// What is not about dials of texels.
struct Besides {
    std::vector<LightErrorRow> light;
    std::vector<DriftRow> drifts;
    std::vector<CrossingRow> crossings;
    Result<std::vector<PortalErrorRow>> portals;  ///< an error where there is no OpenGL
};

Result<Besides> measure_besides(const AccuracyRequest& request) {
    const AccuracyPlan plan = plan_of(request.quick);
    const MotionPlan motion = request.quick ? MotionPlan{10'000, 20'000, 3} : MotionPlan();
    Besides besides{{}, measure_drift(motion), measure_crossings(motion), std::vector<PortalErrorRow>()};
    std::vector<OpenMap> maps;
    for (const std::string& path : maps_of(request)) {
        auto map = open_map(path, request.texture_folders, {});
        ENFILADE_CHECK(map);  // it was measured
        auto rows = measure_light_grids(scene_name(path), *map, poses_in(map->map, PoseKind::random, plan.timed, kSeed),
                                        plan.width, plan.height);
        if (!rows.ok()) return rows.error();
        besides.light.insert(besides.light.end(), rows.value().begin(), rows.value().end());
        maps.push_back(std::move(*map));
    }
    besides.portals = measure_portals(
        maps, request.quick ? PortalPlan{4, plan.width, plan.height, 1} : PortalPlan{100, plan.width, plan.height, 3});
    return besides;
}

std::string whole_page(const AccuracyRun& run, const std::vector<AccuracyScene>& scenes, const Besides& besides) {
    return accuracy_page(scenes, run.command) + light_page(besides.light) + portal_page(besides.portals) +
           "\n## Motion\n\n" + motion_page(besides.drifts, besides.crossings);
}

Result<void> write_report(const AccuracyRequest& request, const std::string& page,
                          const std::vector<AccuracyScene>& scenes) {
    const std::string& folder = request.out;
    if (const Result<void> done = write_crops_of(request, folder + "/crops"); !done.ok()) return done.error();
    if (const Result<void> done = write_file(folder + "/accuracy.csv", accuracy_csv(scenes)); !done.ok())
        return done.error();
    if (const Result<void> done = write_file(folder + "/README.md", page); !done.ok()) return done.error();
    return write_plot(folder, scenes);
}

Result<ReadAccuracy> read_report(const std::string& path) {
    const auto bytes = read_file(path);
    if (!bytes.ok()) return bytes.error();
    return read_accuracy_json(path, as_text(bytes.value()));
}

/// Scenes that this very program has measured so already, where that is asked for and it was cut off.
Result<std::vector<AccuracyScene>> scenes_to_go_on_from(const AccuracyRequest& request, const AccuracyRun& run) {
    if (!request.resume) return std::vector<AccuracyScene>();
    auto report = read_report(report_in(request.out));
    if (!report.ok()) return report.error();
    const AccuracyRun& before = report.value().run;
    if (before.program_hash != run.program_hash || before.is_quick != run.is_quick)
        return Error{report_in(request.out),
                     "expected a report of this very program with the same --quick; begin anew "
                     "without --resume"};
    return std::move(report.value().scenes);
}

Result<AccuracyRun> run_of(const AccuracyRequest& request) {
    const auto program = read_file(this_program());
    if (!program.ok()) return program.error();
    return AccuracyRun{command_text(request), request.quick, hash_of_bytes(program.value())};
}

bool is_among(const std::vector<AccuracyScene>& scenes, const std::string& path) {
    return std::ranges::find(scenes, scene_name(path), &AccuracyScene::name) != scenes.end();
}

/// Adds what is not there yet, and keeps each scene as soon as it is measured.
Result<void> measure_scenes(const AccuracyRequest& request, const AccuracyRun& run,
                            std::vector<AccuracyScene>& scenes) {
    for (const std::string& path : maps_of(request)) {
        if (is_among(scenes, path)) continue;
        auto scene = measure_scene(path, request);
        if (!scene.ok()) return scene.error();
        scenes.push_back(std::move(scene).value());
        if (request.out.empty()) continue;
        if (const Result<void> done = make_folder(request.out); !done.ok()) return done.error();
        if (const Result<void> done = write_file(report_in(request.out), accuracy_json(run, scenes)); !done.ok())
            return done.error();
    }
    return {};
}

Result<void> verify(const std::string& path, const std::vector<AccuracyScene>& scenes) {
    const auto report = read_report(path);
    if (!report.ok()) return report.error();
    return compare_errors(path, report.value().scenes, scenes);
}

/// Poses of both kinds, first those anywhere.
std::vector<View> views_to_export(const Map& map, std::size_t poses) {
    std::vector<View> views;
    for (const PoseKind kind : kPoseKinds) {
        const std::vector<View> some = poses_in(map, kind, poses, kSeed);
        views.insert(views.end(), some.begin(), some.end());
    }
    return views;
}

std::string score_line(const std::string& scene, const EntryScore& score) {
    std::string wrong = "no pictures of them";
    if (score.judged_ids > 0)
        wrong =
            fmt::format("{:.1f}", 1e6 * static_cast<double>(score.wrong_ids) / static_cast<double>(score.judged_ids));
    return fmt::format("| {} | {:.2f} | {:.4f} | {} |\n", scene, score.psnr, score.ssim, wrong);
}

/// What --export and --score do with one map.
Result<void> exchange_scene(const std::string& path, const AccuracyRequest& request) {
    const auto map = open_map(path, request.texture_folders, {});
    if (!map) return Error{path, "expected a map without errors; see above"};
    const AccuracyPlan plan = plan_of(request.quick);
    const std::vector<View> views = views_to_export(map->map, plan.poses);
    const std::string& folder = request.score.empty() ? request.export_to : request.score;
    const EntryPlan entry{folder + "/" + scene_name(path), views, plan.width, plan.height};
    if (request.score.empty()) return export_truth(entry, *map);
    const auto score = score_entry(entry, *map);
    if (!score.ok()) return score.error();
    return print_to_stdout(score_line(scene_name(path), score.value()));
}

Result<void> exchange(const AccuracyRequest& request) {
    const char* const header =
        request.score.empty()
            ? ""
            : "| scene | noise [dB] | likeness | wrong surfaces [of a million] |\n|---|---|---|---|\n";
    if (const Result<void> done = print_to_stdout(header); !done.ok()) return done.error();
    for (const std::string& path : maps_of(request))
        if (const Result<void> done = exchange_scene(path, request); !done.ok()) return done.error();
    return {};
}

Result<void> measure_accuracy(const AccuracyRequest& request) {
    if (!request.score.empty() || !request.export_to.empty()) return exchange(request);
    if (request.resume && request.out.empty()) return Error{"--resume", "expected --out DIR, where the report is"};
    const auto run = run_of(request);
    if (!run.ok()) return run.error();
    auto scenes = scenes_to_go_on_from(request, run.value());
    if (!scenes.ok()) return scenes.error();
    if (const Result<void> done = measure_scenes(request, run.value(), scenes.value()); !done.ok()) return done.error();
    const auto besides = measure_besides(request);
    if (!besides.ok()) return besides.error();
    const std::string page = whole_page(run.value(), scenes.value(), besides.value());
    if (!request.out.empty())
        if (const Result<void> done = write_report(request, page, scenes.value()); !done.ok()) return done.error();
    if (const Result<void> done = print_to_stdout(page); !done.ok()) return done.error();
    if (const Result<void> valid = check_promises(scenes.value()); !valid.ok()) return valid.error();
    if (const Result<void> valid = check_motion(besides.value().drifts, besides.value().crossings); !valid.ok())
        return valid.error();
    if (besides.value().portals.ok())
        if (const Result<void> valid = check_portals(besides.value().portals.value()); !valid.ok())
            return valid.error();
    return request.verify.empty() ? Result<void>() : verify(request.verify, scenes.value());
}

}  // namespace

int run_accuracy(const AccuracyRequest& request) { return status_of(measure_accuracy(request)); }

}  // namespace enfilade
