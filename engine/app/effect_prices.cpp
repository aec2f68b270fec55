#include "app/bench.h"

#include <fmt/format.h>
#include <algorithm>

#include "app/messages.h"
#include "app/options.h"
#include "base/result.h"
#include "formats/text_parts.h"
#include "map/load.h"
#include "map/sector_finder.h"
#include "math/vec.h"
#include "platform/clock.h"
#include "render/column/column_renderer.h"
#include "world/snapshot.h"
#include "world/world.h"

namespace enfilade {

namespace {

constexpr std::size_t kPlaces = 4, kAround = 8;  ///< places apart from the start, and looks from each
constexpr std::size_t kBuilds = 2;               ///< how often all that is drawn is built anew for it; even
constexpr double kTime = 10.3;                   ///< when, so that what moves has moved [s]

/// Somewhere in the sector, a metre from one of its walls, at eye level; none in a sector that is too narrow.
std::optional<View> view_in(const Map& map, SectorId id, const View& like) {
    const Sector& sector = map[id];
    for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i) {
        const Wall& wall = map.walls[i];
        View view = like;
        view.sector = id;
        view.eye = snap_to_point_grid((wall.a + wall.b) * 0.5 + right_of(wall.b - wall.a) * (1 / wall.length));
        view.eye_z = sector.floor.z + std::min(eye_height(kStandingHeight), (sector.ceiling.z - sector.floor.z) / 2);
        if (is_inside(map, id, view.eye)) return view;
    }
    return {};
}

/// All around from the start and from places spread over the map.
std::vector<View> looks_at(const Map& map, const View& start) {
    std::vector<View> places{start};
    for (std::size_t i = 0; i < kPlaces; ++i)
        if (const auto view = view_in(map, SectorId(i * map.sectors.size() / kPlaces), start)) places.push_back(*view);
    std::vector<View> looks;
    for (const View& place : places)
        for (std::size_t i = 0; i < kAround; ++i) {
            looks.push_back(place);
            looks.back().forward = direction(Angle::from_degrees(360.0 / kAround * static_cast<double>(i)));
        }
    return looks;
}

/// A map ready to be drawn, by a renderer of its own that keeps what it works out from it, and what drawing its looks
/// gave.
struct Sample {
    std::unique_ptr<const Map> map;  ///< stays where it is
    Snapshot snapshot;
    ColumnRenderer renderer;
    std::vector<std::vector<std::int64_t>> took_ns;  ///< by look and round
    std::vector<std::uint64_t> hashes;               ///< by look

    double frame_ms() const {
        double sum = 0;
        for (const auto& times : took_ns) sum += static_cast<double>(*std::ranges::min_element(times));
        return sum / (1e6 * static_cast<double>(took_ns.size()));
    }
};

class Measuring {
public:
    Measuring(const TextureSet& textures, std::vector<View> looks, const PriceChoices& choices)
        : textures_(textures), looks_(std::move(looks)), rounds_(choices.rounds) {
        frame_.resize(choices.width, choices.height);
    }

    std::size_t looks() const { return looks_.size(); }
    std::size_t rounds() const { return rounds_; }

    /// The map of a file, not drawn yet; none where it has errors.
    std::optional<Sample> sample_of(const MapFile& file) const {
        Findings findings;
        std::optional<Map> map = build_map(file, textures_, findings);
        if (!map) return {};
        auto kept = std::make_unique<const Map>(std::move(*map));
        ColumnRenderer renderer(*kept, textures_);
        Sample sample{std::move(kept), {}, std::move(renderer), {}, {}};
        sample.took_ns.assign(looks_.size(), std::vector<std::int64_t>(rounds_));
        sample.hashes.resize(looks_.size());
        sample.snapshot = at_rest(*sample.map);
        sample.snapshot.time_s = kTime;
        return sample;
    }

    /// Draws every look of both once, side by side; which of the two comes first changes from round to round, because
    /// the second finds what the first has read.
    void draw_round(Sample& one, Sample& other, std::size_t round) {
        for (std::size_t look = 0; look < looks_.size(); ++look) {
            draw(round % 2 == 0 ? one : other, look, round);
            draw(round % 2 == 0 ? other : one, look, round);
        }
    }

private:
    void draw(Sample& sample, std::size_t look, std::size_t round) {
        const std::int64_t began = thread_time_ns();
        sample.renderer.render(frame_, nullptr, sample.snapshot, looks_[look]);
        sample.took_ns[look][round] = thread_time_ns() - began;
        if (round == 0) sample.hashes[look] = hash_of(frame_);
    }

    const TextureSet& textures_;
    std::vector<View> looks_;
    std::size_t rounds_;
    Frame frame_;
};

/// How much longer a look takes with the effect, in the middle one of every other round.
double more_ms(const Sample& with, const Sample& without, std::size_t look, std::size_t first_round) {
    std::vector<std::int64_t> more(with.took_ns[look].size() / 2);
    for (std::size_t i = 0; i < more.size(); ++i) {
        const std::size_t round = 2 * i + first_round;
        more[i] = with.took_ns[look][round] - without.took_ns[look][round];
    }
    std::ranges::nth_element(more, more.begin() + static_cast<std::ptrdiff_t>(more.size() / 2));
    return static_cast<double>(more[more.size() / 2]) * 1e-6;
}

/// What looks take more with the effect: those that differ by it, and those that do not.
class Differences {
public:
    void add(const Sample& with, const Sample& without) {
        for (std::size_t look = 0; look < with.hashes.size(); ++look) {
            MeanTime& sum = sums_[with.hashes[look] != without.hashes[look]];
            sum.ms += (more_ms(with, without, look, 0) + more_ms(with, without, look, 1)) / 2;
            ++sum.count;
        }
    }

    Price price() const { return {sums_[1].count / kBuilds, sums_[1].mean(), sums_[0].mean()}; }

private:
    struct MeanTime {
        double ms = 0;
        std::size_t count = 0;

        std::optional<double> mean() const {
            return count > 0 ? std::optional(ms / static_cast<double>(count)) : std::nullopt;
        }
    };
    MeanTime sums_[2];  ///< of looks that are the same with it and without, and of those that are not
};

std::vector<View> looks_of(const MapFile& file, const TextureSet& textures) {
    Findings findings;
    const std::optional<Map> map = build_map(file, textures, findings);
    if (!map) return {};
    const auto start = view_at_start(*map, lens_for(map->render));
    return start.ok() ? looks_at(*map, start.value()) : std::vector<View>();
}

bool can_be_taken_out(const EffectPrice& effect) { return effect.use.effect->take_out != nullptr; }

/// Draws with and without one effect. Which of the two is built first changes from build to build, because it gets
/// other places in memory, which make a few hundredths of a frame.
void measure(EffectPrice& effect, const MapFile& file, Measuring& measuring, Prices& prices, Progress& progress) {
    MapFile plain = file;
    effect.use.effect->take_out(plain);
    Differences differences;
    for (std::size_t build = 0; build < kBuilds; ++build) {
        auto first = measuring.sample_of(build % 2 == 0 ? file : plain);
        auto second = measuring.sample_of(build % 2 == 0 ? plain : file);
        if (!first || !second) return;
        for (std::size_t round = 0; round < measuring.rounds(); ++round) {
            measuring.draw_round(*first, *second, round);
            progress.step(0);
        }
        const Sample& with = build % 2 == 0 ? *first : *second;
        differences.add(with, build % 2 == 0 ? *second : *first);
        prices.frame_ms = with.frame_ms();
    }
    effect.price = differences.price();
}

}  // namespace

Prices effect_prices(const MapFile& file, const TextureSet& textures, const PriceChoices& choices) {
    ENFILADE_CHECK(choices.rounds >= 2 && choices.rounds % 2 == 0);
    Prices prices;
    prices.width = choices.width;
    prices.height = choices.height;
    for (const EffectUse& use : effects_in(file)) prices.effects.push_back({use, {}});
    if (prices.effects.empty()) return prices;
    Measuring measuring(textures, looks_of(file, textures), choices);
    prices.looks = measuring.looks();
    if (prices.looks == 0) return prices;
    const auto count = std::ranges::count_if(prices.effects, can_be_taken_out);
    Progress progress(kBuilds * choices.rounds * static_cast<std::size_t>(count), "rounds");
    for (EffectPrice& effect : prices.effects)
        if (can_be_taken_out(effect)) measure(effect, file, measuring, prices, progress);
    return prices;
}

// Prices of effects as tables.

namespace {

std::string ms_text(const std::optional<double>& ms) { return ms ? fmt::format("{:+.3f} ms", *ms) : "-"; }

/// What is counted, as it follows the number.
std::string noun_for(const EffectUse& use) { return std::string(use.effect->counted) + (use.count == 1 ? "" : "s"); }

std::string footnote(const Prices& prices) {
    return fmt::format(
        "a frame with everything: {:.3f} ms of processor time (column, {}x{}, one thread, mean of {} looks)\n",
        prices.frame_ms, prices.width, prices.height, prices.looks);
}

}  // namespace

std::string to_text(const Prices& prices) {
    if (prices.effects.empty()) return "  nothing beyond plain rooms\n";
    std::string text = fmt::format("  {:<17}{:>16}{:>14}{:>14}\n", "", "", "where seen", "elsewhere");
    for (const auto& [use, price] : prices.effects)
        text += fmt::format("  {:<17}{:>6} {:<9}{:>14}{:>14}  {}\n", use.effect->name, use.count, noun_for(use),
                            ms_text(price ? price->seen : std::nullopt), ms_text(price ? price->unseen : std::nullopt),
                            use.effect->cost);
    if (prices.frame_ms > 0) text += "  " + footnote(prices);
    return text;
}

std::string to_markdown(const Prices& prices) {
    std::string text = "| effect | in the map | where it is seen | elsewhere | what is paid |\n|---|---|---|---|---|\n";
    for (const auto& [use, price] : prices.effects)
        text += fmt::format("| {} | {} | {} | {} | {} |\n", use.effect->name, counted(use.count, use.effect->counted),
                            ms_text(price ? price->seen : std::nullopt), ms_text(price ? price->unseen : std::nullopt),
                            use.effect->cost);
    if (prices.frame_ms > 0) text += "\n" + footnote(prices);
    return text;
}

}  // namespace enfilade
