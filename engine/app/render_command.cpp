// `enfilade render`: pictures of a map from given places, without a window.
#include <fmt/format.h>

#include <optional>

#include "app/commands.h"
#include "app/messages.h"
#include "app/options.h"
#include "app/picture_job.h"
#include "app/pixel_text.h"
#include "base/files.h"
#include "base/terminal.h"
#include "formats/text_parts.h"
#include "formats/views_csv.h"

namespace enfilade {
namespace {

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
            print_text(stderr, fmt::format("{}: note: {}; the picture looks through it and smears it\n",
                                           place_text(request, places, i), *hidden));
    }
    if (count > 1) print_text(stderr, fmt::format("{}: note: {} more like it\n", request.views, count - 1));
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
void tell_pixels(const OpenMap& map, const PictureJob& job, const RenderRequest& request) {
    if (job.at.empty()) return;
    const Snapshot snapshot = shown_in(job, map.map);
    const MapPlaces places = places_in_file(request);
    for (std::size_t i = 0; i < job.views.size(); ++i)
        for (const auto [x, y] : job.at) {
            const PixelOf pixel{job.views[i], job.size.width, job.size.height, x, y};
            print_text(stdout, fmt::format("{}{},{}: {}\n", job.views.size() > 1 ? fmt::format("view {}: ", i) : "", x,
                                           y, pixel_text(map, snapshot, pixel, request.map, places)));
        }
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
    tell_pixels(*map, job.value(), request);
    return kDone;
}

}  // namespace enfilade
