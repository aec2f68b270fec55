// `enfilade bench`: how long frames take, and what effects cost.
#include <fmt/format.h>

#include <optional>

#include "app/bench.h"
#include "app/commands.h"
#include "app/effect_prices.h"
#include "app/exit_codes.h"
#include "app/open_flight.h"
#include "app/options.h"
#include "app/shipped_maps.h"
#include "app/viewing.h"
#include "base/files.h"
#include "base/terminal.h"
#include "flight/renderer.h"
#include "formats/map_toml.h"
#include "formats/script_toml.h"
#include "platform/clock.h"
#include "platform/gl_context.h"
#include "world/deed.h"

namespace enfilade {
namespace {

/// A map with what its player sees at the start, or a flythrough.
class Subject {
public:
    /// None where the file has errors, which then are on stderr.
    static std::optional<Subject> open(const std::string& path, const BenchRequest& request) {
        const auto bytes = read_file(path);
        if (!bytes.ok()) {
            fail(bytes.error());
            return {};
        }
        return is_script(as_text(bytes.value())) ? open_script(path, request) : open_start(path, request);
    }

    const Map& map() const { return flight_ ? flight_->map.map : map_->map; }
    const TextureSet& textures() const { return flight_ ? flight_->map.textures : map_->textures; }
    int frames() const { return flight_ ? flight_->flight.frames() : 1; }
    FlightFrame frame(int number) const { return flight_ ? flight_->flight.at(map(), number) : start_; }

private:
    static std::optional<Subject> open_script(const std::string& path, const BenchRequest& request) {
        Subject subject;
        subject.flight_ = open_flight(path, request.texture_folders, kUsualSkill);
        return subject.flight_ ? std::optional(std::move(subject)) : std::nullopt;
    }

    static std::optional<Subject> open_start(const std::string& path, const BenchRequest& request) {
        Subject subject;
        subject.map_ = open_map(path, request.texture_folders, kUsualSkill);
        if (!subject.map_) return {};
        const Map& map = subject.map_->map;
        const auto view = view_at_start(map, {90, map.render.stretch});
        if (!view.ok()) {
            fail({path, "the map has no player to look from"});
            return {};
        }
        subject.start_ = {view.value(), at_rest(map)};
        const History history = begun(map);
        show({map, history, 0}, subject.start_.snapshot);
        return subject;
    }

    std::optional<OpenFlight> flight_;
    std::optional<OpenMap> map_;
    FlightFrame start_;
};

constexpr std::size_t kUsualRounds = 9;

struct BenchChoices {
    PictureSize size;
    RendererKind renderer = RendererKind::column;
    std::size_t threads = 1, rounds = kUsualRounds;  ///< >= 1
    PriceChoices prices;
};

/// What the measure of prices has no choice of.
Status refuse_beside_effects(const BenchRequest& request) {
    if (!request.effects) return {};
    if (request.threads && *request.threads != 1)
        return Error{"--threads", "the prices of effects are those of one thread; leave it out beside --effects"};
    if (!request.renderer.empty() && request.renderer != "column")
        return Error{"--renderer",
                     "the prices of effects are those of the column renderer; leave it out beside --effects"};
    if (!request.csv.empty())
        return Error{"--csv", "--effects writes a table in Markdown to the terminal; leave one of the two out"};
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
        return Error{"", "expected maps or scripts to measure, or --effects; see `enfilade bench --help`"};
    if (Status wrong = refuse_beside_effects(request)) return *wrong;
    const auto size = request.size.empty() ? PictureSize{} : parse_size(request.size);
    if (!size.ok()) return size.error();
    const auto renderer = parse_renderer(request.renderer.empty() ? "column" : request.renderer);
    if (!renderer.ok()) return renderer.error();
    return BenchChoices{size.value(), renderer.value(), request.threads.value_or(hardware_threads()),
                        request.rounds.value_or(kUsualRounds), price_choices(request, size.value())};
}

Status time_frames(const BenchRequest& request, const BenchChoices& choices, const std::vector<Subject>& subjects) {
    auto renderer = make_renderer(choices.renderer, choices.threads, open_gl_for_pictures);
    if (!renderer.ok()) return renderer.error();
    std::vector<int> counts;
    for (const Subject& subject : subjects) counts.push_back(subject.frames());
    std::vector<BenchFrame> frames = frames_in_turn(counts);
    Frame picture;
    picture.resize(choices.size.width, choices.size.height);
    const auto draw = [&](std::size_t number, int frame) -> Result<std::int64_t> {
        const Subject& subject = subjects[number];
        const FlightFrame shown = subject.frame(frame);
        const std::int64_t began = now_ns();
        Status failed =
            renderer.value()->render(picture, nullptr, subject.map(), subject.textures(), shown.snapshot, shown.view);
        const std::int64_t took_ns = now_ns() - began;
        if (failed) return *failed;
        return took_ns;
    };
    if (Status failed = measure(frames, choices.rounds, draw)) return failed;
    print_text(request.csv == "-" ? stderr : stdout, bench_table(request.files, frames));
    return request.csv.empty() ? Status() : write_file(request.csv, bench_csv(request.files, frames));
}

/// The prices of one map as a table; false where it has errors.
bool price_map(const std::string& path, const BenchRequest& request, const PriceChoices& choices) {
    const auto map = open_map(path, request.texture_folders, {});
    const auto bytes = read_file(path);
    if (!map || !bytes.ok()) return false;
    const Prices prices = effect_prices(read_map(as_text(bytes.value())).map, map->textures, choices);
    print_text(stdout, fmt::format("{}:\n\n{}\n", path, to_markdown(prices)));
    return true;
}

int price_maps(const BenchRequest& request, const PriceChoices& choices) {
    if (request.files.empty()) return price_map(shipped_map("effects.toml"), request, choices) ? kDone : kFailed;
    bool all = true;
    for (const std::string& map : request.files) all &= price_map(map, request, choices);
    return all ? kDone : kFailed;
}

}  // namespace

int run_bench(const BenchRequest& request) {
    const auto choices = choices_of(request);
    if (!choices.ok()) return refuse_usage(choices.error());
    if (request.effects) return price_maps(request, choices.value().prices);
    std::vector<Subject> subjects;
    for (const std::string& path : request.files) {
        auto subject = Subject::open(path, request);
        if (!subject) return kFailed;
        subjects.push_back(std::move(*subject));
    }
    if (Status failed = time_frames(request, choices.value(), subjects)) return fail(*failed);
    return kDone;
}

}  // namespace enfilade
