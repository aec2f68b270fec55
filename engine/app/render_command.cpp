// `enfilade render`: pictures of a map from given places, without a window.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/commands.h"
#include "app/messages.h"
#include "app/open_map.h"
#include "app/options.h"
#include "app/pictures.h"
#include "app/pixel_text.h"
#include "base/files.h"
#include "base/parallel.h"
#include "base/text.h"
#include "formats/text_parts.h"
#include "formats/views_csv.h"
#include "platform/clock.h"
#include "platform/gl_context.h"
#include "render/outside/outside_renderer.h"

namespace enfilade {
namespace {

// Many views of one map to picture files, on several threads.

/// What to draw, and where to put it. Empty paths: not wanted.
struct PictureJob {
    std::vector<View> views;
    PictureSize size;
    RendererKind renderer = RendererKind::column;
    Dials dials;
    double time_s = 0;  ///< the moment that is shown
    LeftOut left_out;
    std::size_t threads = 1;  ///< >= 1
    Talk talk = Talk::usual;
    std::string out;               ///< a .png file for the one view, or a folder for 000000.png onward
    std::string ids;               ///< the same for pictures of surface ids
    std::string id_list;           ///< a CSV file of what the ids stand for
    std::string timing;            ///< a CSV file `view,ns`
    std::string from_above;        ///< the same as `out` for pictures of the view from outside
    std::string from_behind;       ///< and for those
    std::vector<PixelPlace> at;    ///< what these pixels of each view show is told on standard output
    double reach_m = kUsualReach;  ///< of both (render/outside/outside_camera.h) [m]
};

/// What one thread draws with.
struct PictureTools {
    std::unique_ptr<Renderer> renderer;
    Frame frame;
    FrameFacts facts;
    std::unique_ptr<OutsideRenderer> outside;
    Frame outside_frame;
    Result<void> done;
};

/// Where a job puts what, by argument; what is not wanted is empty.
using Outputs = std::vector<std::pair<const char*, std::string>>;

Outputs picture_outputs(const PictureJob& job) {
    return {
        {"--out", job.out}, {"--ids", job.ids}, {"--from-above", job.from_above}, {"--from-behind", job.from_behind}};
}

Outputs all_outputs(const PictureJob& job) {
    Outputs all = picture_outputs(job);
    all.insert(all.end(), {{"--id-list", job.id_list}, {"--timing", job.timing}});
    return all;
}

class Drawing {
public:
    Drawing(const OpenMap& map, const PictureJob& job)
        : map_(map), job_(job), snapshot_(snapshot_at(map.map, job.time_s)), times_ns_(job.views.size()) {
        leave_out(job.left_out, snapshot_);
        const bool side_by_side = job.timing.empty() && job.views.size() >= job.threads;
        tools_.resize(side_by_side ? job.threads : 1);
        threads_each_ = side_by_side ? 1 : job.threads;
    }

    Result<void> run() {
        if (const Result<void> done = make_tools(); !done.ok()) return done.error();
        if (!job_.timing.empty())  // grows the renderer's memory, so that no view pays for it
            if (const Result<void> done = draw(tools_[0], 0); !done.ok()) return done.error();
        CutShortNote note(job_.out, job_.talk);
        Progress progress(job_.views.size(), "pictures", job_.talk);
        parallel_for(job_.views.size(), tools_.size(), [&](std::size_t i, std::size_t worker) {
            if (stop_) return;
            PictureTools& own = tools_[worker];
            own.done = draw(own, i);
            if (own.done.ok()) own.done = write(own, i);
            if (own.done.ok()) own.done = draw_outside(own, i, OutsideFrom::above, job_.from_above);
            if (own.done.ok()) own.done = draw_outside(own, i, OutsideFrom::behind, job_.from_behind);
            if (!own.done.ok()) stop_ = true;
            note.look_at(own.frame);
            progress.step(worker);
        });
        for (const PictureTools& own : tools_)
            if (!own.done.ok()) return own.done;
        if (const Result<void> done = flush_folders(); !done.ok()) return done.error();
        return write_timing();
    }

private:
    Result<void> make_tools() {
        for (PictureTools& own : tools_) {
            auto renderer = make_renderer({job_.renderer, job_.dials, threads_each_, open_gl_for_pictures}, map_.map,
                                          map_.textures);
            if (!renderer.ok()) return renderer.error();
            own.renderer = std::move(renderer).value();
            own.outside = std::make_unique<OutsideRenderer>(map_.map, map_.textures);
            own.frame.resize(job_.size.width, job_.size.height);
        }
        return {};
    }

    Result<void> draw(PictureTools& own, std::size_t i) {
        const bool want_facts = !job_.ids.empty();
        if (want_facts) reset(own.facts, job_.size.width, job_.size.height);
        const std::int64_t before = now_ns();
        Result<void> drawn =
            own.renderer->render(own.frame, want_facts ? &own.facts : nullptr, snapshot_, job_.views[i]);
        times_ns_[i] = now_ns() - before;
        return drawn;
    }

    Result<void> write(const PictureTools& own, std::size_t i) const {
        if (const Result<void> done = write(job_.out, i, image_of(own.frame)); !done.ok()) return done.error();
        if (job_.ids.empty()) return {};
        return write(job_.ids, i, ids_image(own.facts, own.frame.width, own.frame.height));
    }

    Result<void> draw_outside(PictureTools& own, std::size_t i, OutsideFrom from, const std::string& out) const {
        if (out.empty()) return {};
        const auto [width, height] = job_.size;
        own.outside_frame.resize(width, height);
        own.outside->render(own.outside_frame, snapshot_, job_.views[i], {from, job_.reach_m, width, height},
                            threads_each_);
        return write(out, i, image_of(own.outside_frame));
    }

    static Result<void> write(const std::string& out, std::size_t i, const Image& image) {
        return names_picture(out) ? write_picture(out, image) : write_numbered_picture(out, i, image);
    }

    Result<void> flush_folders() const {
        for (const auto& [argument, out] : picture_outputs(job_))
            if (!out.empty() && !names_picture(out))
                if (const Result<void> done = flush_folder(out); !done.ok()) return done.error();
        return {};
    }

    Result<void> write_timing() const {
        if (job_.timing.empty()) return {};
        std::string csv = "view,ns\n";
        for (std::size_t i = 0; i < times_ns_.size(); ++i) csv += fmt::format("{},{}\n", i, times_ns_[i]);
        return write_file(job_.timing, csv);
    }

    const OpenMap& map_;
    const PictureJob& job_;
    Snapshot snapshot_;
    std::vector<PictureTools> tools_;
    std::size_t threads_each_ = 1;
    std::vector<std::int64_t> times_ns_;
    std::atomic<bool> stop_ = false;
};

Result<void> check_places(const PictureJob& job) {
    const Outputs outputs = all_outputs(job);
    const auto is_standard_output = [](const auto& output) { return output.second == kStandardOutput; };
    if (std::ranges::count_if(outputs, is_standard_output) + !job.at.empty() > 1)
        return Error{
            "",
            "only one of --out, --ids, --id-list, --from-above, --from-behind and --timing can be '-', standard "
            "output, and none with --at, which tells there what it finds"};
    for (const auto& [argument, path] : outputs) {
        const auto is_same = [&p = path](const auto& output) { return output.second == p; };
        const bool is_place = !path.empty() && path != kStandardOutput && !std::filesystem::is_other(path);
        if (is_place && std::ranges::count_if(outputs, is_same) > 1)
            return Error{argument,
                         fmt::format("{} is given twice; each output needs a place of its own", in_quotes(path))};
    }
    return {};
}

/// An error where a path names one picture file but there are several views.
Result<void> check_outputs(const PictureJob& job) {
    if (const Result<void> valid = check_places(job); !valid.ok()) return valid.error();
    if (job.reach_m != kUsualReach && job.from_above.empty() && job.from_behind.empty())
        return Error{"--reach", "needs --from-above or --from-behind, whose pictures it is about"};
    for (const auto& [argument, path] : picture_outputs(job)) {
        if (names_film(path) && !names_picture(path))
            return Error{argument, "render writes pictures; `enfilade fly` writes films"};
        const std::size_t count = job.views.size();
        const std::string expected = count == 1 ? "a .png picture, or a folder for 000000.png"
                                                : fmt::format("a folder for {}", counted(count, "picture"));
        if (const Result<void> valid = refuse_other_kinds(argument, expected, path); !valid.ok()) return valid.error();
        if (count != 1 && names_picture(path)) return not_a(argument, expected, path);
    }
    return {};
}

/// Draws and writes everything. With timing, views are drawn one after another, each by all threads, so that nothing
/// disturbs the clock; else several views are drawn at a time.
Result<void> draw_pictures(const OpenMap& map, const PictureJob& job) {
    for (const auto& [argument, path] : picture_outputs(job))
        if (!path.empty() && !names_picture(path))
            if (const Result<void> done = make_folder(path); !done.ok()) return done.error();
    return Drawing(map, job).run();
}

// What the command line says about them.

/// What the command line alone says about the job; views come with the map.
Result<PictureJob> job_of(const RenderRequest& request) {
    const auto size = parse_size(request.size);
    if (!size.ok()) return size.error();
    const auto renderer = parse_renderer(request.renderer);
    if (!renderer.ok()) return renderer.error();
    if (const Result<void> valid = refuse_true_pitch(renderer.value(), request.true_pitch); !valid.ok())
        return valid.error();
    const auto dials = dials_from(request.dials, {}, renderer.value(), size.value());
    if (!dials.ok()) return dials.error();
    PictureJob job;
    job.size = size.value();
    job.renderer = renderer.value();
    job.dials = dials.value();
    job.time_s = request.time_s;
    job.left_out = request.left_out;
    job.threads = request.threads;
    job.talk = request.talk;
    job.out = request.out;
    job.ids = request.ids;
    job.id_list = request.id_list;
    job.timing = request.timing;
    for (const std::string& text : request.at) {
        const auto pixel = parse_pixel(text, job.size);
        if (!pixel.ok()) return pixel.error();
        job.at.push_back(pixel.value());
    }
    job.from_above = request.from_above;
    job.from_behind = request.from_behind;
    job.reach_m = request.reach_m;
    return job;
}

Lens lens_of(const Map& map, const RenderRequest& request) {
    Lens lens = lens_for(map.render, request.fov_degrees);
    if (request.stretch) lens.stretch = *request.stretch;
    lens.true_pitch = request.true_pitch;
    lens.roll_degrees = request.roll_degrees;
    return lens;
}

std::string place_text(const RenderRequest& request, const std::vector<ViewRow>& places, std::size_t view) {
    return request.views.empty() ? request.map : fmt::format("{}:{}", request.views, places[view].line);
}

Result<std::vector<View>> views_in(const Map& map, const std::vector<ViewRow>& places, const RenderRequest& request) {
    const Lens lens = lens_of(map, request);
    std::vector<View> views;
    for (const ViewRow& place : places) {
        auto view = view_from(map, place, lens);
        if (!view.ok()) return Error{place_text(request, places, views.size()), view.error().what};
        views.push_back(view.value());
    }
    return views;
}

Result<std::vector<View>> view_of_player(const Map& map, const RenderRequest& request) {
    auto view = view_at_start(map, lens_of(map, request));
    if (!view.ok()) return Error{request.map, view.error().what};
    return std::vector{view.value()};
}

/// A picture from inside a floor or above a ceiling can be drawn, but is hardly what somebody wanted: says so.
void mention_hidden_eyes(const Map& map, const RenderRequest& request, const std::vector<ViewRow>& places,
                         const std::vector<View>& views) {
    const Snapshot snapshot = snapshot_at(map, request.time_s);
    std::size_t count = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
        const auto hidden = hidden_eye(map, snapshot, views[i]);
        if (hidden && ++count == 1)
            print_to_stderr(fmt::format("{}: note: {}; the picture looks through it and smears it\n",
                                        place_text(request, places, i), *hidden));
    }
    if (count > 1) print_to_stderr(fmt::format("{}: note: {} more like it\n", request.views, count - 1));
}

MapPlaces places_in_file(const RenderRequest& request) {
    const auto text = read_file(request.map);
    return text.ok() ? places_in(as_text(text.value()), request.skill, request.map, read_file) : MapPlaces();
}

Snapshot shown_in(const PictureJob& job, const Map& map) {
    Snapshot snapshot = snapshot_at(map, job.time_s);
    leave_out(job.left_out, snapshot);
    return snapshot;
}

/// "120,80: floor of sector 'hall' …", with the view's number before it where there are several.
Result<void> tell_pixels(const OpenMap& map, const PictureJob& job, const RenderRequest& request) {
    if (job.at.empty()) return {};
    const Snapshot snapshot = shown_in(job, map.map);
    const MapPlaces places = places_in_file(request);
    std::string text;
    for (std::size_t i = 0; i < job.views.size(); ++i)
        for (const auto [x, y] : job.at) {
            const PixelOf pixel{job.views[i], job.size.width, job.size.height, x, y};
            text += fmt::format("{}{},{}: {}\n", job.views.size() > 1 ? fmt::format("view {}: ", i) : "", x, y,
                                pixel_text(map, snapshot, pixel, request.map, places));
        }
    return print_to_stdout(text);
}

Result<void> list_surfaces(const OpenMap& map, const PictureJob& job, const RenderRequest& request) {
    if (job.id_list.empty()) return {};
    return write_file(job.id_list, surfaces_csv(map.map, shown_in(job, map.map), request.map, places_in_file(request)));
}

}  // namespace

int run_render(const RenderRequest& request) {
    auto job = job_of(request);
    if (!job.ok()) return refuse_usage(job.error());
    std::vector<ViewRow> places;
    if (!request.view.empty()) {
        auto place = parse_view(request.view);
        if (!place.ok()) return refuse_usage({"--view", place.error().what});
        place.value().sector = request.sector;
        places.push_back(std::move(place).value());
    } else if (!request.views.empty()) {
        auto list = open_views(request.views);
        if (!list) return kFailed;
        places = std::move(*list);
    }
    const auto map = open_map(request.map, request.texture_folders, request.skill, request.talk);
    if (!map) return kFailed;
    const bool from_start = request.view.empty() && request.views.empty();
    auto views = from_start ? view_of_player(map->map, request) : views_in(map->map, places, request);
    if (!views.ok()) return fail(views.error());
    job.value().views = std::move(views).value();
    if (const Result<void> valid = check_outputs(job.value()); !valid.ok()) return refuse_usage(valid.error());
    if (request.talk == Talk::usual) mention_hidden_eyes(map->map, request, places, job.value().views);
    if (const Result<void> done = draw_pictures(*map, job.value()); !done.ok()) return fail(done.error());
    if (const Result<void> done = list_surfaces(*map, job.value(), request); !done.ok()) return fail(done.error());
    return status_of(tell_pixels(*map, job.value(), request));
}

}  // namespace enfilade
