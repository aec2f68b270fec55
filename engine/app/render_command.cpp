// `enfilade render`: pictures of a map from given places, without a window.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <optional>

#include "app/commands.h"
#include "app/exit_codes.h"
#include "app/picture_job.h"
#include "app/validators.h"
#include "app/viewing.h"
#include "base/files.h"
#include "base/parallel.h"
#include "formats/views_csv.h"

namespace enfilade {
namespace {

/// The arguments as typed.
struct RenderRequest {
    std::string map, view, views, sector, size = "1280x800", renderer = "column", accuracy = "exact";
    double fov_degrees = 90, time_s = 0;
    std::optional<double> stretch;
    std::size_t threads = hardware_threads();
    std::vector<std::string> texture_folders;
    std::string out, ids, timing;
};

/// The places of a list; where it is refused, its findings are on stderr.
std::optional<std::vector<ViewRow>> read_places(const std::string& path) {
    const auto bytes = read_file(path);
    if (!bytes.ok()) {
        fail(bytes.error());
        return {};
    }
    ViewsReading reading = read_views(as_text(bytes.value()));
    for (const Finding& finding : reading.findings) fmt::print(stderr, "{}\n", to_text(path, finding));
    if (has_errors(reading.findings)) return {};
    return std::move(reading.views);
}

/// What the command line alone says about the job; views come with the map.
Result<PictureJob> job_of(const RenderRequest& request) {
    const auto size = parse_size(request.size);
    if (!size.ok()) return size.error();
    const auto renderer = parse_renderer(request.renderer);
    if (!renderer.ok()) return renderer.error();
    if (request.accuracy != "exact")
        return Error{"--accuracy",
                     fmt::format("expected 'exact', the only one there is; found '{}'", request.accuracy)};
    PictureJob job;
    job.size = size.value();
    job.renderer = renderer.value();
    job.time_s = request.time_s;
    job.threads = request.threads;
    job.out = request.out;
    job.ids = request.ids;
    job.timing = request.timing;
    return job;
}

Result<std::vector<View>> views_in(const Map& map, const std::vector<ViewRow>& places, const RenderRequest& request) {
    const Lens lens{request.fov_degrees, request.stretch.value_or(map.render.stretch)};
    std::vector<View> views;
    for (const ViewRow& place : places) {
        auto view = view_from(map, place, lens);
        const std::string where = request.views.empty() ? request.map : fmt::format("{}:{}", request.views, place.line);
        if (!view.ok()) return Error{where, view.error().what};
        views.push_back(view.value());
    }
    return views;
}

Result<std::vector<View>> view_of_player(const Map& map, const RenderRequest& request) {
    auto view = view_at_start(map, {request.fov_degrees, request.stretch.value_or(map.render.stretch)});
    if (!view.ok()) return Error{request.map, view.error().what};
    return std::vector{view.value()};
}

class RenderCommand final : public Command {
public:
    CLI::App* declare(CLI::App& enfilade) override {
        CLI::App* command = enfilade.add_subcommand("render", "Draw pictures of a map, without a window");
        command->add_option("MAP", request_.map, "The map file (.toml)")->required();
        declare_places(*command);
        declare_pictures(*command);
        declare_outputs(*command);
        command->footer(
            "Examples:\n  enfilade render maps/enfilade.toml --out start.png\n  enfilade render "
            "maps/enfilade.toml --view 3,2,1.7,90,0 --size 640x400 --out door.png\n  enfilade render "
            "maps/enfilade.toml --views places.csv --out pictures --timing times.csv\nExit status: 0 done, 1 "
            "the map or a file is at fault, 2 wrong usage.");
        return command;
    }

    int run() override {
        auto job = job_of(request_);
        if (!job.ok()) return refuse_usage(job.error());
        std::vector<ViewRow> places;
        if (!request_.view.empty()) {
            auto place = parse_view(request_.view);
            if (!place.ok()) return refuse_usage({"--view", place.error().what});
            place.value().sector = request_.sector;
            places.push_back(std::move(place).value());
        } else if (!request_.views.empty()) {
            auto list = read_places(request_.views);
            if (!list) return kFailed;
            places = std::move(*list);
        }
        const auto map = open_map(request_.map, request_.texture_folders);
        if (!map) return kFailed;
        const bool from_start = request_.view.empty() && request_.views.empty();
        auto views = from_start ? view_of_player(map->map, request_) : views_in(map->map, places, request_);
        if (!views.ok()) return fail(views.error());
        job.value().views = std::move(views).value();
        if (Status wrong = check_outputs(job.value())) return refuse_usage(*wrong);
        if (Status failed = draw_pictures(*map, job.value())) return fail(*failed);
        return kDone;
    }

private:
    void declare_places(CLI::App& command) {
        auto* view = command.add_option(
            "--view", request_.view, "Place of the eye in metres and look in degrees; without it, the player's start");
        view->type_name("X,Y,Z,YAW,PITCH");
        auto* views = command.add_option("--views", request_.views,
                                         "Many places: a CSV file with the header x,y,z,yaw,pitch and maybe sector");
        views->type_name("FILE.csv")->excludes(view);
        command.add_option("--sector", request_.sector, "The sector that holds the view; else it is found")
            ->type_name("NAME")
            ->needs(view);
        command.add_option("--time", request_.time_s, "The moment to show, in seconds since the start")
            ->type_name("S")
            ->check(number_within(0.0, 1e9));
    }

    void declare_pictures(CLI::App& command) {
        command.add_option("--size", request_.size, "Size in pixels, 1280x800 if not given")->type_name("WxH");
        command.add_option("--fov", request_.fov_degrees, "Horizontal field of view, 90 if not given")
            ->type_name("DEG")
            ->check(number_within(kMinFov, kMaxFov));
        command.add_option("--stretch", request_.stretch, "Vertical stretch instead of the map's own; Doom's is 1.2")
            ->type_name("S")
            ->check(number_within(0.1, 10.0));
        command.add_option("--renderer", request_.renderer, "column (fast) or reference (slow, simply right)")
            ->type_name("NAME");
        command.add_option("--accuracy", request_.accuracy, "exact")->type_name("NAME");
        command.add_option("--threads", request_.threads, "Threads to draw with; else one for each core")
            ->type_name("N")
            ->check(number_within(1, 256));
        command.add_option("--textures", request_.texture_folders, "More folders to look for pictures in")
            ->type_name("DIR")
            ->allow_extra_args(false);
    }

    void declare_outputs(CLI::App& command) {
        command.add_option("--out", request_.out, "One picture, or a folder for 000000.png onward")
            ->type_name("FILE.png|DIR")
            ->required();
        command.add_option("--ids", request_.ids, "The same for pictures of 24-bit surface ids, red the high byte")
            ->type_name("FILE.png|DIR");
        command.add_option("--timing", request_.timing, "How long each view took to draw: view,ns")
            ->type_name("FILE.csv");
    }

    RenderRequest request_;
};

}  // namespace

std::unique_ptr<Command> make_render_command() { return std::make_unique<RenderCommand>(); }

}  // namespace enfilade
