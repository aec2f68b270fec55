// `enfilade bench`: how long frames take, and what effects cost.
#include <fmt/format.h>

#include "app/bench.h"
#include "app/commands.h"
#include "app/messages.h"
#include "app/open_map.h"
#include "app/options.h"
#include "app/programs.h"
#include "base/files.h"
#include "base/text.h"
#include "formats/map_toml.h"
#include "platform/clock.h"
#include "platform/gl_context.h"
#include "render/choice/renderer.h"
#include "render/column/column_renderer.h"

namespace enfilade {
namespace {

constexpr std::size_t kUsualRounds = 9;

struct BenchChoices {
    PictureSize size;
    RendererKind renderer = RendererKind::column;
    Dials dials;
    std::size_t threads = 1, rounds = kUsualRounds;  ///< >= 1
    PriceChoices prices;
};

/// What the measure of prices has no choice of.
Result<void> refuse_beside_effects(const BenchRequest& request) {
    if (!request.effects) return {};
    if (!request.against.empty() || request.instructions)
        return Error{request.instructions ? "--instructions" : "--against",
                     "the prices of effects are times of this program; leave it out beside --effects"};
    if (request.threads && *request.threads != 1)
        return Error{"--threads", "the prices of effects are those of one thread; leave it out beside --effects"};
    if (!request.renderer.empty() && request.renderer != "column")
        return Error{"--renderer",
                     "the prices of effects are those of the column renderer; leave it out beside --effects"};
    if (request.dials.is_given())
        return Error{request.dials.samples            ? "--samples"
                     : request.dials.accuracy.empty() ? "--dial"
                                                      : "--accuracy",
                     "the prices of effects are those of exact pictures of one ray a pixel; leave it out beside "
                     "--effects"};
    if (!request.csv.empty())
        return Error{"--csv", "--effects writes a table in Markdown to the terminal; leave one of the two out"};
    return {};
}

/// JSON is of the times of frames.
Result<void> refuse_beside_json(const BenchRequest& request) {
    if (request.format == kText) return {};
    if (request.csv == kStandardOutput)
        return Error{"--csv", "both would go to standard output; name a file, or leave one of the two out"};
    if (!request.effects && !request.instructions && request.against.empty()) return {};
    return Error{
        "--format",
        "expected it without --effects, --instructions and --against, which write tables; leave one of them out"};
}

/// What other processes measure has no frames to write down here.
Result<void> refuse_beside_children(const BenchRequest& request) {
    if (request.against.empty() && !request.instructions) return {};
    if (!request.against.empty() && request.instructions)
        return Error{"--instructions",
                     "expected it without --against, which compares times; measure one after the other"};
    if (request.instructions && request.threads && *request.threads != 1)
        return Error{"--threads", "instructions are counted on one thread; leave it out beside --instructions"};
    if (request.instructions && !request.renderer.empty() && request.renderer != "column")
        return Error{"--renderer", "instructions are those of the column renderer; leave it out beside --instructions"};
    if (!request.csv.empty())
        return Error{"--csv",
                     "expected it without --against and --instructions, which write a table; leave one of them "
                     "out"};
    return {};
}

PriceChoices price_choices(const BenchRequest& request, const PictureSize& size) {
    PriceChoices prices;
    if (!request.size.empty()) {
        prices.width = size.width;
        prices.height = size.height;
    }
    if (request.rounds) prices.rounds = *request.rounds + *request.rounds % 2;
    return prices;
}

Result<BenchChoices> choices_of(const BenchRequest& request) {
    if (request.files.empty() && !request.effects)
        return Error{"", "expected maps, walks or scripts to measure, or --effects; see `enfilade bench --help`"};
    if (const Result<void> valid = refuse_beside_effects(request); !valid.ok()) return valid.error();
    if (const Result<void> valid = refuse_beside_children(request); !valid.ok()) return valid.error();
    if (const Result<void> valid = refuse_beside_json(request); !valid.ok()) return valid.error();
    const auto size = request.size.empty() ? PictureSize{} : parse_size(request.size);
    if (!size.ok()) return size.error();
    const auto renderer = parse_renderer(request.renderer.empty() ? "column" : request.renderer);
    if (!renderer.ok()) return renderer.error();
    const auto dials = dials_from(request.dials, {}, renderer.value(), size.value());
    if (!dials.ok()) return dials.error();
    return BenchChoices{size.value(),
                        renderer.value(),
                        dials.value(),
                        request.threads.value_or(hardware_threads()),
                        request.rounds.value_or(kUsualRounds),
                        price_choices(request, size.value())};
}

/// What is measured of a picture, and nothing else: by time, and by valgrind, which finds it by its name
/// (kMeasuredFunction).
[[gnu::noinline]] Result<void> draw_measured(Renderer& renderer, Frame& picture, const FlightFrame& shown) {
    return renderer.render(picture, nullptr, shown.snapshot, shown.view);
}

Result<std::int64_t> time_picture(Renderer& renderer, Frame& picture, const FlightFrame& shown, bool is_counted) {
    const std::int64_t began_ns = now_ns();
    const Result<void> drawn = is_counted ? draw_measured(renderer, picture, shown)
                                          : renderer.render(picture, nullptr, shown.snapshot, shown.view);
    const std::int64_t took_ns = now_ns() - began_ns;
    if (!drawn.ok()) return drawn.error();
    return took_ns;
}

/// Of a picture in one piece: what threads draw is cut into strips, and so are its viewports.
std::size_t count_viewports(Renderer& renderer, RendererKind kind, Frame& picture, const BenchSubject& subject,
                            const FlightFrame& shown) {
    if (kind != RendererKind::column) return renderer.viewports().size();
    ColumnRenderer whole(subject.map(), subject.textures());
    whole.render(picture, nullptr, shown.snapshot, shown.view);
    return whole.counts().viewports;
}

/// One for each subject: what a renderer keeps of a map, light and pictures, it would make anew in every turn.
using Renderers = std::vector<std::unique_ptr<Renderer>>;

Result<Renderers> renderers_for(const std::vector<BenchSubject>& subjects, const BenchChoices& choices) {
    Renderers renderers;
    for (const BenchSubject& subject : subjects) {
        auto renderer = make_renderer({choices.renderer, choices.dials, choices.threads, open_gl_for_pictures},
                                      subject.map(), subject.textures());
        if (!renderer.ok()) return renderer.error();
        renderers.push_back(std::move(renderer).value());
    }
    return renderers;
}

/// Draws every frame once more, with facts, which cost too much to have them while time is measured.
Result<void> count_frames(const Renderers& renderers, RendererKind kind, Frame& picture,
                          const std::vector<BenchSubject>& subjects, std::vector<BenchFrame>& frames) {
    FrameFacts facts;
    for (BenchFrame& frame : frames) {
        const BenchSubject& subject = subjects[frame.subject];
        Renderer& renderer = *renderers[frame.subject];
        const FlightFrame shown = subject.frame(frame.number);
        reset(facts, picture.width, picture.height);
        if (const Result<void> done = renderer.render(picture, &facts, shown.snapshot, shown.view); !done.ok())
            return done.error();
        frame.counts = counts_of(subject.map(), picture, facts);
        frame.counts.viewports = count_viewports(renderer, kind, picture, subject, shown);
    }
    return {};
}

/// What was measured, on stdout; where the list of frames goes there, the table for people goes to stderr.
Result<void> tell_times(const BenchRequest& request, const BenchChoices& choices, const std::vector<BenchFrame>& frames,
                        std::string_view kernels) {
    if (request.format == kJson) {
        const BenchSetting setting{
            request.files,        choices.size.width, choices.size.height, name_of(choices.renderer),
            std::string(kernels), choices.dials,      choices.threads,     choices.rounds};
        return print_to_stdout(bench_json(setting, frames));
    }
    std::string table = bench_table(request.files, frames);
    if (!kernels.empty()) table += fmt::format("inner loops: {}\n", kernels);
    if (request.csv != kStandardOutput) return print_to_stdout(table);
    print_to_stderr(table);
    return {};
}

Result<void> time_frames(const BenchRequest& request, const BenchChoices& choices,
                         const std::vector<BenchSubject>& subjects) {
    const Result<Renderers> renderers = renderers_for(subjects, choices);
    if (!renderers.ok()) return renderers.error();
    std::vector<int> counts;
    for (const BenchSubject& subject : subjects) counts.push_back(subject.frames());
    std::vector<BenchFrame> frames = frames_in_turn(counts);
    Frame picture;
    picture.resize(choices.size.width, choices.size.height);
    const auto draw = [&](std::size_t subject, int number, bool is_counted) {
        return time_picture(*renderers.value()[subject], picture, subjects[subject].frame(number), is_counted);
    };
    if (const Result<void> done = measure(frames, choices.rounds, draw, request.talk); !done.ok()) return done.error();
    if (const Result<void> done = count_frames(renderers.value(), choices.renderer, picture, subjects, frames);
        !done.ok())
        return done.error();
    if (!request.csv.empty())
        if (const Result<void> done = write_file(request.csv, bench_csv(request.files, frames)); !done.ok())
            return done.error();
    return tell_times(request, choices, frames, renderers.value().front()->kernels());
}

ChildBench child_bench(const BenchRequest& request, const BenchChoices& choices) {
    ChildBench bench{
        request.files, {}, choices.rounds, std::size_t(choices.size.width) * std::size_t(choices.size.height)};
    const std::size_t threads = request.instructions ? 1 : choices.threads;
    bench.options = {"--size",     fmt::format("{}x{}", choices.size.width, choices.size.height),
                     "--threads",  std::to_string(threads),
                     "--renderer", name_of(choices.renderer)};
    const DialRequest& dials = request.dials;
    if (dials.samples) bench.options.insert(bench.options.end(), {"--samples", std::to_string(*dials.samples)});
    if (!dials.accuracy.empty()) bench.options.insert(bench.options.end(), {"--accuracy", dials.accuracy});
    for (const std::string& dial : dials.dials) bench.options.insert(bench.options.end(), {"--dial", dial});
    for (const std::string& folder : request.texture_folders) {
        bench.options.push_back("--textures");
        bench.options.push_back(folder);
    }
    return bench;
}

/// What other processes measure.
int measure_by_children(const BenchRequest& request, const BenchChoices& choices) {
    const ChildBench bench = child_bench(request, choices);
    const auto table = request.instructions ? count_instructions(bench) : compare_with(request.against, bench);
    return table.ok() ? status_of(print_to_stdout(table.value())) : fail(table.error());
}

/// The prices of one map; none where it has errors, which are told.
std::optional<std::string> price_table(const std::string& path, const BenchRequest& request,
                                       const PriceChoices& choices) {
    const auto map = open_map(path, request.texture_folders, {});
    const auto bytes = read_file(path);
    if (!map || !bytes.ok()) return {};
    const Prices prices =
        effect_prices(read_map_at(path, as_text(bytes.value()), read_file).map, map->textures, choices);
    return fmt::format("{}:\n\n{}\n", path, to_markdown(prices));
}

int price_maps(const BenchRequest& request, const PriceChoices& choices) {
    int status = kDone;
    for (const std::string& map : request.files.empty() ? std::vector{shipped_map("effects.toml")} : request.files) {
        const auto table = price_table(map, request, choices);
        if (!table) status = kFailed;
        if (const Result<void> done = print_to_stdout(table.value_or("")); !done.ok()) return fail(done.error());
    }
    return status;
}

}  // namespace

int run_bench(const BenchRequest& request) {
    const auto choices = choices_of(request);
    if (!choices.ok()) return refuse_usage(choices.error());
    if (request.effects) return price_maps(request, choices.value().prices);
    if (request.instructions || !request.against.empty()) return measure_by_children(request, choices.value());
    std::vector<BenchSubject> subjects;
    for (const std::string& name : request.files) {
        auto subject = BenchSubject::open(name, request.texture_folders, request.talk);
        if (!subject) return kFailed;
        subjects.push_back(std::move(*subject));
    }
    return status_of(time_frames(request, choices.value(), subjects));
}

}  // namespace enfilade
