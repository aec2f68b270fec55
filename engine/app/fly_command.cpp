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
#include "base/file_name.h"
#include "base/files.h"
#include "formats/text_parts.h"
#include "platform/gl_context.h"

namespace enfilade {
namespace {

/// What of the command line is understood without the script; none: the script's own.
struct FlyChoices {
    std::optional<PictureSize> size;
    std::optional<FrameRange> frames;
    std::optional<FramePart> part;
    std::optional<RendererKind> renderer, against;
};

/// Puts the parsed argument into `choice` where it was given.
template <class T, class Parse>
Result<void> choose(const std::string& text, Parse parse, std::optional<T>& choice) {
    if (text.empty()) return {};
    auto parsed = parse(text);
    if (!parsed.ok()) return parsed.error();
    choice = parsed.value();
    return {};
}

Result<void> check_out(const FlyRequest& request) {
    const std::string expected =
        request.check ? "a folder for the report" : "a folder for many pictures, or a .mp4 or .y4m film";
    if (request.check && names_film(request.out)) return not_a("--out", expected, request.out);
    if (names_picture(request.out) && !names_film(request.out)) return not_a("--out", expected, request.out);
    return refuse_other_kinds("--out", expected, request.out);
}

/// Recorded frames show all that the script's map has, so with a part left out they can only differ.
Result<void> check_left_out(const FlyRequest& request) {
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
Result<void> refuse_other_dials(const FlyRequest& request) {
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

/// What is said to machines is said about a check; the rest of a command has nothing to tell.
Result<void> check_format(const FlyRequest& request) {
    if (request.format == kText || request.check) return {};
    return Error{"--format", "needs --check, whose result it is about"};
}

Result<void> check_combination(const FlyRequest& request) {
    if (!request.check && !request.record && !request.merge && request.out.empty())
        return Error{"", "expected --out DIR, --out FILE.mp4 or FILE.y4m, --check, --record or --merge"};
    if (const Result<void> valid = check_format(request); !valid.ok()) return valid.error();
    if (request.record && !request.out.empty())
        return Error{"--out",
                     fmt::format("--record writes {} and draws no pictures for --out; leave out one of the two, "
                                 "or keep every N-th picture with --keep N",
                                 hashes_path(request.script))};
    if (const Result<void> valid = check_out(request); !valid.ok()) return valid.error();
    if (request.tolerance_percent && request.against.empty())
        return Error{"--tolerance",
                     "needs --against: recorded frames are compared by their hashes, which are equal or not"};
    if (!request.against.empty() && !request.check) return Error{"--against", "needs --check"};
    if (request.keep_every > 0 && !request.record) return Error{"--keep", "needs --record"};
    if (const Result<void> valid = check_left_out(request); !valid.ok()) return valid.error();
    if (const Result<void> valid = refuse_other_dials(request); !valid.ok()) return valid.error();
    if (request.no_pictures && !request.record) return Error{"--no-pictures", "needs --record"};
    return {};
}

Result<FlyChoices> choices_of(const FlyRequest& request) {
    FlyChoices choices;
    if (const Result<void> valid = check_combination(request); !valid.ok()) return valid.error();
    if (const Result<void> valid = choose(request.size, parse_size, choices.size); !valid.ok()) return valid.error();
    if (const Result<void> valid = choose(request.frames, parse_frames, choices.frames); !valid.ok())
        return valid.error();
    if (const Result<void> valid = choose(request.part, parse_part, choices.part); !valid.ok()) return valid.error();
    if (const Result<void> valid = choose(request.renderer, parse_renderer, choices.renderer); !valid.ok())
        return valid.error();
    if (const Result<void> valid = choose(request.against, parse_renderer, choices.against); !valid.ok())
        return valid.error();
    return choices;
}

/// Which frames are drawn of a flight of so many.
Result<FrameRange> range_of(const FlyChoices& choices, int frames) {
    if (choices.part) return frames_of(*choices.part, frames);
    const FrameRange range = choices.frames.value_or(FrameRange{0, frames - 1});
    if (range.last < frames) return range;
    return Error{"--frames",
                 fmt::format("the flight has the frames 0..{}; found {}..{}", frames - 1, range.first, range.last)};
}

Result<DrawPlan> plan_of(const FlyRequest& request, const FlyChoices& choices, const OpenFlight& open) {
    const auto range = range_of(choices, open.flight.frames());
    if (!range.ok()) return range.error();
    const auto [first, last] = range.value();
    const PictureSize size = choices.size.value_or(PictureSize{open.script.width, open.script.height});
    const RendererKind renderer = choices.renderer.value_or(open.script.renderer);
    const auto dials = dials_from(request.dials, open.script.dials, renderer, size);
    if (!dials.ok()) return dials.error();
    return DrawPlan{renderer, dials.value(), size.width, size.height, first, last, 1, open_gl_for_pictures};
}

Result<void> draw_pictures_into(const std::string& folder, const FlightScene& scene, const DrawPlan& plan, Talk talk) {
    if (const Result<void> done = make_folder(folder); !done.ok()) return done.error();
    CutShortNote note(folder, talk);
    Progress progress(frames_of(plan), "frames", talk);
    const Result<void> drawn =
        draw_frames(scene, plan, [&](int number, const Frame& frame, std::size_t worker) -> Result<void> {
            progress.step(worker);
            note.look_at(frame);
            return write_numbered_picture(folder, std::size_t(number), image_of(frame));
        });
    return drawn.ok() ? flush_folder(folder) : drawn;
}

Result<void> draw_film(const std::string& path, const FlightScene& scene, const DrawPlan& plan, int rate, Talk talk) {
    auto film = start_film(path, {plan.width, plan.height, rate});
    if (!film.ok()) return film.error();
    CutShortNote note(path, talk);
    Progress progress(frames_of(plan), "frames", talk);
    const Result<void> drawn = draw_frames_in_order(scene, plan, [&](int, const Frame& frame, std::size_t worker) {
        progress.step(worker);
        note.look_at(frame);
        return film.value()->add(frame);
    });
    return drawn.ok() ? film.value()->finish() : drawn;
}

/// Where the pictures of a failed check go if nobody said: beside nobody's files, in the current folder.
std::string report_folder(const FlyRequest& request) {
    if (!request.out.empty()) return request.out;
    return safe_file_name(file_stem_of(request.script)) + ".failed";
}

/// Says that all is well.
Result<void> confirm(const FlyRequest& request, std::size_t frames, const char* what) {
    if (request.talk == Talk::errors_only || request.format != kText) return {};
    return print_to_stdout(fmt::format("{}: {} {}\n", request.script, counted(frames, "frame"), what));
}

/// To other programs.
Result<void> print_verdict(const FlyRequest& request, const CheckedFlight& checked) {
    if (request.format == kText) return {};
    return print_to_stdout(request.format == kJson ? flight_json(checked) : flight_junit(checked));
}

/// Compares, and says on stdout what that came to; an error where frames differ.
Result<void> check(const FlyRequest& request, const FlightScene& scene, const DrawPlan& plan,
                   const FlyChoices& choices) {
    const std::string folder = report_folder(request);
    const auto verdict = choices.against
                             ? compare_renderers(scene, plan, *choices.against,
                                                 request.tolerance_percent.value_or(0) / 100, folder, request.talk)
                             : check_flight(scene, plan, request.script, folder, request.talk);
    if (!verdict.ok()) return verdict.error();
    const std::string other = choices.against ? name_of(*choices.against) : "recording";
    const CheckedFlight checked{request.script, name_of(plan.renderer), other, plan.first, plan.last, verdict.value()};
    if (const Result<void> done = print_verdict(request, checked); !done.ok()) return done.error();
    const std::vector<int>& differing = verdict.value().differing;
    if (!differing.empty())
        return Error{request.script, fmt::format("{} of {} frames differ, frame {} first; see {}", differing.size(),
                                                 frames_of(plan), differing.front(), verdict.value().report)};
    if (const Result<void> done = remove_report(folder, request.script); !done.ok()) return done.error();
    return confirm(request, frames_of(plan),
                   choices.against ? "drawn alike by both renderers" : "as they were recorded");
}

Result<void> record(const FlyRequest& request, const FlightScene& scene, const DrawPlan& plan) {
    const PictureKeeping keeping{request.no_pictures, request.keep_every};
    if (const Result<void> done = record_flight(scene, plan, request.script, keeping, request.talk); !done.ok())
        return done.error();
    return confirm(request, frames_of(plan), "recorded");
}

Result<void> merge(const FlyRequest& request, int frames) {
    if (const Result<void> done = merge_parts(request.script, frames); !done.ok()) return done.error();
    return confirm(request, std::size_t(frames), "merged");
}

Result<void> work(const FlyRequest& request, const OpenFlight& open, const DrawPlan& plan, const FlyChoices& choices) {
    const FlightScene scene{open.flight, open.map.map, open.map.textures};
    if (request.merge) return merge(request, open.flight.frames());
    if (request.record) return record(request, scene, plan);
    if (request.check) return check(request, scene, plan, choices);
    if (names_film(request.out)) return draw_film(request.out, scene, plan, open.script.rate, request.talk);
    return draw_pictures_into(request.out, scene, plan, request.talk);
}

}  // namespace

int run_fly(const FlyRequest& request) {
    const auto choices = choices_of(request);
    if (!choices.ok()) return refuse_usage(choices.error());
    auto open = open_flight(request.script, request.texture_folders, request.skill, request.talk);
    if (!open) return kFailed;
    open->flight.leave_out(request.left_out);
    auto plan = plan_of(request, choices.value(), *open);
    if (!plan.ok()) return refuse_usage(plan.error());
    plan.value().workers = request.threads;
    return status_of(work(request, *open, plan.value(), choices.value()));
}

}  // namespace enfilade
