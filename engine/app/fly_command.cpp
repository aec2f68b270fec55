// `enfilade fly`: a scripted flythrough as pictures, as a film, or as a test.
#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "app/commands.h"
#include "app/messages.h"
#include "app/open_map.h"
#include "app/options.h"
#include "app/pictures.h"
#include "app/recorded_flight.h"
#include "base/output_file.h"
#include "base/terminal.h"
#include "formats/text_parts.h"
#include "platform/gl_context.h"

namespace enfilade {
namespace {

/// What of the command line is understood without the script; none: the script's own.
struct FlyChoices {
    std::optional<PictureSize> size;
    std::optional<FrameRange> frames;
    std::optional<RendererKind> renderer, against;
};

/// Puts the parsed argument into `choice` where it was given.
template <class T, class Parse>
Status choose(const std::string& text, Parse parse, std::optional<T>& choice) {
    if (text.empty()) return {};
    auto parsed = parse(text);
    if (!parsed.ok()) return parsed.error();
    choice = parsed.value();
    return {};
}

Status check_out(const FlyRequest& request) {
    const std::string expected =
        request.check ? "a folder for the report" : "a folder for many pictures, or a .mp4 or .y4m film";
    if (request.check && names_film(request.out)) return not_a("--out", expected, request.out);
    if (names_picture(request.out) && !names_film(request.out)) return not_a("--out", expected, request.out);
    return refuse_other_kinds("--out", expected, request.out);
}

/// Recorded frames show all that the script's map has, so with a part left out they can only differ.
Status check_left_out(const FlyRequest& request) {
    if (!request.left_out.things && !request.left_out.light_effects) return {};
    const char* const option = request.left_out.things ? "--no-things" : "--still-light";
    if (request.record)
        return Error{option,
                     "--record writes down the whole flight, so that --check finds the same; leave out one of "
                     "the two"};
    if (request.check && request.against.empty())
        return Error{option,
                     "--check compares with recorded frames, from which nothing was left out; leave it out, or "
                     "compare two renderers with --against"};
    return {};
}

/// Recorded frames are drawn as the script says.
Status refuse_other_dials(const FlyRequest& request) {
    const bool is_recorded = request.record || (request.check && request.against.empty());
    if (!request.dials.is_given() || !is_recorded) return {};
    if (request.dials.samples)
        return Error{"--samples", "recorded frames have the samples that the script says; write samples = " +
                                      std::to_string(*request.dials.samples) + " there, and leave it out"};
    return Error{
        request.dials.accuracy.empty() ? "--dial" : "--accuracy",
        "recorded frames are drawn as exactly as the script says; write accuracy or [dials] there, and leave it "
        "out"};
}

Status check_combination(const FlyRequest& request) {
    if (!request.check && !request.record && request.out.empty())
        return Error{"", "expected --out DIR, --out FILE.mp4 or FILE.y4m, --check or --record"};
    if (request.record && !request.out.empty())
        return Error{"--out",
                     fmt::format("--record writes {} and draws no pictures for --out; leave out one of the two, "
                                 "or keep every N-th picture with --keep N",
                                 hashes_path(request.script))};
    if (Status wrong = check_out(request)) return wrong;
    if (request.tolerance_percent && request.against.empty())
        return Error{"--tolerance",
                     "needs --against: recorded frames are compared by their hashes, which are equal or not"};
    if (!request.against.empty() && !request.check) return Error{"--against", "needs --check"};
    if (request.keep_every > 0 && !request.record) return Error{"--keep", "needs --record"};
    if (Status wrong = check_left_out(request)) return wrong;
    if (Status wrong = refuse_other_dials(request)) return wrong;
    if (request.no_pictures && !request.record) return Error{"--no-pictures", "needs --record"};
    if (request.record && !request.frames.empty()) return Error{"--record", "records all frames; leave out --frames"};
    return {};
}

Result<FlyChoices> choices_of(const FlyRequest& request) {
    FlyChoices choices;
    if (Status wrong = check_combination(request)) return *wrong;
    if (Status wrong = choose(request.size, parse_size, choices.size)) return *wrong;
    if (Status wrong = choose(request.frames, parse_frames, choices.frames)) return *wrong;
    if (Status wrong = choose(request.renderer, parse_renderer, choices.renderer)) return *wrong;
    if (Status wrong = choose(request.against, parse_renderer, choices.against)) return *wrong;
    return choices;
}

Result<DrawPlan> plan_of(const FlyRequest& request, const FlyChoices& choices, const OpenFlight& open) {
    const int last = open.flight.frames() - 1;
    const FrameRange frames = choices.frames.value_or(FrameRange{0, last});
    if (frames.last > last)
        return Error{"--frames",
                     fmt::format("the flight has the frames 0..{}; found {}..{}", last, frames.first, frames.last)};
    const PictureSize size = choices.size.value_or(PictureSize{open.script.width, open.script.height});
    const RendererKind renderer = choices.renderer.value_or(open.script.renderer);
    const auto dials = dials_from(request.dials, open.script.dials, renderer, size);
    if (!dials.ok()) return dials.error();
    return DrawPlan{renderer,     dials.value(), size.width, size.height,
                    frames.first, frames.last,   1,          open_gl_for_pictures};
}

Status draw_pictures_into(const std::string& folder, const FlightScene& scene, const DrawPlan& plan) {
    if (Status failed = make_folder(folder)) return failed;
    CutShortNote note(folder);
    Progress progress(std::size_t(plan.last - plan.first + 1), "frames");
    const Status failed = draw_frames(scene, plan, [&](int number, const Frame& frame, std::size_t worker) -> Status {
        progress.step(worker);
        note.look_at(frame);
        return write_numbered_picture(folder, std::size_t(number), image_of(frame));
    });
    return failed ? failed : flush_folder(folder);
}

Status draw_film(const std::string& path, const FlightScene& scene, const DrawPlan& plan, int rate) {
    auto film = start_film(path, {plan.width, plan.height, rate});
    if (!film.ok()) return film.error();
    CutShortNote note(path);
    Progress progress(std::size_t(plan.last - plan.first + 1), "frames");
    const Status failed = draw_frames_in_order(scene, plan, [&](int, const Frame& frame, std::size_t worker) {
        progress.step(worker);
        note.look_at(frame);
        return film.value()->add(frame);
    });
    return failed ? failed : film.value()->finish();
}

/// Where the pictures of a failed check go if nobody said: beside nobody's files, in the current folder.
std::string report_folder(const FlyRequest& request) {
    if (!request.out.empty()) return request.out;
    return std::filesystem::path(request.script).stem().string() + ".failed";
}

Status record_or_check(const FlyRequest& request, const FlightScene& scene, const DrawPlan& plan,
                       const FlyChoices& choices) {
    const std::string report = report_folder(request);
    if (request.record) return record_flight(scene, plan, request.script, {request.no_pictures, request.keep_every});
    if (choices.against)
        return compare_renderers(scene, plan, *choices.against, request.tolerance_percent.value_or(0) / 100, report);
    return check_flight(scene, plan, request.script, report);
}

/// Records or checks, and says that all is well.
Status test(const FlyRequest& request, const FlightScene& scene, const DrawPlan& plan, const FlyChoices& choices) {
    const Status failed = record_or_check(request, scene, plan, choices);
    if (!failed)
        print_text(stdout,
                   fmt::format("{}: {} {}\n", request.script, counted(std::size_t(plan.last - plan.first + 1), "frame"),
                               request.record    ? "recorded"
                               : choices.against ? "drawn alike by both renderers"
                                                 : "as they were recorded"));
    return failed;
}

Status work(const FlyRequest& request, const OpenFlight& open, const DrawPlan& plan, const FlyChoices& choices) {
    const FlightScene scene{open.flight, open.map.map, open.map.textures};
    if (request.record || request.check) return test(request, scene, plan, choices);
    if (names_film(request.out)) return draw_film(request.out, scene, plan, open.script.rate);
    return draw_pictures_into(request.out, scene, plan);
}

}  // namespace

int run_fly(const FlyRequest& request) {
    const auto choices = choices_of(request);
    if (!choices.ok()) return refuse_usage(choices.error());
    auto open = open_flight(request.script, request.texture_folders, request.skill);
    if (!open) return kFailed;
    open->flight.leave_out(request.left_out);
    auto plan = plan_of(request, choices.value(), *open);
    if (!plan.ok()) return refuse_usage(plan.error());
    plan.value().workers = request.threads;
    if (Status failed = work(request, *open, plan.value(), choices.value())) return fail(*failed);
    return kDone;
}

}  // namespace enfilade
