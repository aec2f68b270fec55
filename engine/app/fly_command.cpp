// `enfilade fly`: a scripted flythrough as pictures, as a film, or as a test.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>

#include "app/commands.h"
#include "app/exit_codes.h"
#include "app/film.h"
#include "app/open_flight.h"
#include "app/options.h"
#include "app/pictures.h"
#include "app/progress.h"
#include "app/recorded_flight.h"
#include "app/validators.h"
#include "base/parallel.h"

namespace enfilade {
namespace {

struct FlyRequest {
    std::string script, out, renderer, frames, size, against;
    std::vector<std::string> texture_folders;
    std::size_t threads = hardware_threads();
    double tolerance_percent = 0;
    int keep_every = 0;
    bool check = false, record = false;
};

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

Status check_combination(const FlyRequest& request) {
    if (!request.check && !request.record && request.out.empty())
        return Error{"", "expected --out DIR, --out FILE.mp4 or FILE.y4m, --check or --record"};
    if (!request.against.empty() && !request.check) return Error{"--against", "needs --check"};
    if (request.keep_every > 0 && !request.record) return Error{"--keep", "needs --record"};
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

Result<RendererKind> renderer_of(const ScriptFile& script) {
    switch (script.renderer) {
        case RendererChoice::column: return RendererKind::column;
        case RendererChoice::reference: return RendererKind::reference;
        case RendererChoice::stencil: return parse_renderer("stencil");
    }
    return RendererKind::column;
}

Result<DrawPlan> plan_of(const FlyChoices& choices, const OpenFlight& open) {
    const int last = open.flight.frames() - 1;
    const FrameRange frames = choices.frames.value_or(FrameRange{0, last});
    if (frames.last > last)
        return Error{"--frames",
                     fmt::format("the flight has the frames 0..{}; found {}..{}", last, frames.first, frames.last)};
    const auto renderer = choices.renderer ? Result<RendererKind>(*choices.renderer) : renderer_of(open.script);
    if (!renderer.ok()) return renderer.error();
    const PictureSize size = choices.size.value_or(PictureSize{open.script.width, open.script.height});
    return DrawPlan{renderer.value(), size.width, size.height, frames.first, frames.last, 1};
}

Status draw_pictures_into(const std::string& folder, const FlightScene& scene, const DrawPlan& plan) {
    if (Status failed = make_folder(folder)) return failed;
    Progress progress(std::size_t(plan.last - plan.first + 1), "frames");
    return draw_frames(scene, plan, [&](int number, const Frame& frame, std::size_t worker) -> Status {
        progress.step(worker);
        return write_picture(numbered_picture(folder, std::size_t(number)), image_of(frame));
    });
}

Status draw_film(const std::string& path, const FlightScene& scene, const DrawPlan& plan, int rate) {
    auto film = start_film(path, {plan.width, plan.height, rate});
    if (!film.ok()) return film.error();
    Progress progress(std::size_t(plan.last - plan.first + 1), "frames");
    const Status failed = draw_frames_in_order(scene, plan, [&](int, const Frame& frame, std::size_t worker) {
        progress.step(worker);
        return film.value()->add(frame);
    });
    return failed ? failed : film.value()->finish();
}

/// Where the pictures of a failed check go if nobody said: beside nobody's files, in the current folder.
std::string report_folder(const FlyRequest& request) {
    if (!request.out.empty()) return request.out;
    return std::filesystem::path(request.script).stem().string() + ".failed";
}

class FlyCommand final : public Command {
public:
    CLI::App* declare(CLI::App& enfilade) override {
        CLI::App* command = enfilade.add_subcommand("fly", "Draw a scripted flythrough: pictures, a film, or a test");
        command->add_option("SCRIPT", request_.script, "The script (.toml): a map, a size and what the camera does")
            ->required();
        declare_drawing(*command);
        declare_tests(*command);
        command->footer(
            "Examples:\n  enfilade fly maps/flythroughs/enfilade.toml --out enfilade.mp4\n  enfilade fly "
            "maps/flythroughs/enfilade.toml --record\n  enfilade fly maps/flythroughs/enfilade.toml --check "
            "--out report\nExit status: 0 done, 1 something is at fault or differs, 2 wrong usage.");
        return command;
    }

    int run() override {
        const auto choices = choices_of(request_);
        if (!choices.ok()) return refuse_usage(choices.error());
        const auto open = open_flight(request_.script, request_.texture_folders);
        if (!open) return kFailed;
        auto plan = plan_of(choices.value(), *open);
        if (!plan.ok()) return refuse_usage(plan.error());
        plan.value().workers = request_.threads;
        if (Status failed = work(*open, plan.value(), choices.value())) return fail(*failed);
        return kDone;
    }

private:
    void declare_drawing(CLI::App& command) {
        command.add_option("--out", request_.out, "A folder for 000000.png onward, or a film; with --check, a report")
            ->type_name("DIR|FILE.mp4|FILE.y4m");
        command.add_option("--frames", request_.frames, "Only these frames, counted from 0")->type_name("A..B");
        command.add_option("--size", request_.size, "Size in pixels instead of the script's")->type_name("WxH");
        command.add_option("--renderer", request_.renderer, "column or reference, instead of the script's")
            ->type_name("NAME");
        command.add_option("--threads", request_.threads, "Threads to draw with; else one for each core")
            ->type_name("N")
            ->check(number_within(1, 256));
        command.add_option("--textures", request_.texture_folders, "More folders to look for pictures in")
            ->type_name("DIR")
            ->allow_extra_args(false);
    }

    void declare_tests(CLI::App& command) {
        auto* check = command.add_flag("--check", request_.check,
                                       "Compare every frame with its recorded hash; where some differ, exit with 1 "
                                       "and leave pictures of them in a report");
        command.add_flag("--record", request_.record, "Record the hash of every frame in SCRIPT's .hashes file")
            ->excludes(check);
        command.add_option("--keep", request_.keep_every, "With --record: also keep every N-th frame as a picture")
            ->type_name("N")
            ->check(number_within(1, 1e6));
        command.add_option("--against", request_.against, "With --check: compare with another renderer instead")
            ->type_name("NAME");
        command
            .add_option("--tolerance", request_.tolerance_percent,
                        "With --against: how many percent of a frame's pixels may differ; 0 if not given")
            ->type_name("PERCENT")
            ->check(number_within(0, 100));
    }

    Status work(const OpenFlight& open, const DrawPlan& plan, const FlyChoices& choices) const {
        const FlightScene scene{open.flight, open.map.map, open.map.textures};
        const std::string report = report_folder(request_);
        if (request_.record) return record_flight(scene, plan, request_.script, request_.keep_every);
        if (choices.against)
            return compare_renderers(scene, plan, *choices.against, request_.tolerance_percent / 100, report);
        if (request_.check) return check_flight(scene, plan, request_.script, report);
        if (names_film(request_.out)) return draw_film(request_.out, scene, plan, open.script.rate);
        return draw_pictures_into(request_.out, scene, plan);
    }

    FlyRequest request_;
};

}  // namespace

std::unique_ptr<Command> make_fly_command() { return std::make_unique<FlyCommand>(); }

}  // namespace enfilade
