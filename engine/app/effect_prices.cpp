#include "app/effect_prices.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "app/viewing.h"
#include "map/build.h"
#include "platform/clock.h"
#include "render/column/column_renderer.h"
#include "world/snapshot.h"

namespace enfilade {
namespace {

constexpr int kWidth = 640, kHeight = 400;  ///< of the pictures [px]
constexpr std::size_t kLooks = 8;           ///< all around
constexpr int kRounds = 12;                 ///< how often each is drawn; the fastest counts
constexpr double kTime = 10.3;              ///< when, so that what moves has moved [s]

/// A map ready to be drawn, and the fastest time of each look.
struct Sample {
    Map map;
    Snapshot snapshot;
    View view;
    std::array<std::int64_t, kLooks> fastest_ns;

    double frame_ms() const {
        double sum = 0;
        for (const std::int64_t ns : fastest_ns) sum += static_cast<double>(ns);
        return sum / (1e6 * kLooks);
    }
};

std::optional<Sample> sample_of(const MapFile& file, const TextureSet& textures) {
    Findings findings;
    std::optional<Map> map = build_map(file, textures, findings);
    if (!map) return {};
    const auto view = view_at_start(*map, {90, map->render.stretch});
    if (!view.ok()) return {};
    Sample sample{std::move(*map), {}, view.value(), {}};
    sample.snapshot = at_rest(sample.map);
    sample.snapshot.time_s = kTime;
    sample.fastest_ns.fill(std::numeric_limits<std::int64_t>::max());
    return sample;
}

/// Draws every look of every sample once, in turn.
void draw_round(std::vector<Sample*> samples, const TextureSet& textures, ColumnRenderer& renderer, Frame& frame) {
    for (std::size_t look = 0; look < kLooks; ++look)
        for (Sample* sample : samples) {
            View view = sample->view;
            view.forward = direction(Angle::from_degrees(360.0 / kLooks * static_cast<double>(look)));
            const std::int64_t began = now_ns();
            renderer.render(frame, nullptr, sample->map, textures, sample->snapshot, view);
            sample->fastest_ns[look] = std::min(sample->fastest_ns[look], now_ns() - began);
        }
}

void measure(const std::vector<Sample*>& samples, const TextureSet& textures) {
    ColumnRenderer renderer;
    Frame frame;
    frame.resize(kWidth, kHeight);
    for (int round = 0; round < kRounds; ++round) draw_round(samples, textures, renderer, frame);
}

}  // namespace

Prices effect_prices(const MapFile& file, const TextureSet& textures) {
    Prices prices;
    for (const EffectUse& use : effects_in(file)) {
        prices.effects.push_back({use, {}});
        if (!use.effect->take_out) continue;
        MapFile plain = file;
        use.effect->take_out(plain);
        std::optional<Sample> with = sample_of(file, textures), without = sample_of(plain, textures);
        if (!with || !without) continue;
        measure({&*with, &*without}, textures);
        prices.frame_ms = with->frame_ms();
        prices.effects.back().ms = with->frame_ms() - without->frame_ms();
    }
    return prices;
}

std::string to_text(const Prices& prices) {
    if (prices.effects.empty()) return "  nothing beyond plain rooms\n";
    std::string text;
    for (const EffectPrice& price : prices.effects) {
        const Effect& effect = *price.use.effect;
        const std::string ms = price.ms ? fmt::format("{:+.3f} ms", *price.ms) : "-";
        text += fmt::format("  {:<17}{:>6} {:<9}{:>11}  {}\n", effect.name, price.use.count, effect.counted, ms,
                            effect.cost);
    }
    if (prices.frame_ms > 0)
        text +=
            fmt::format("  a frame with everything: {:.3f} ms (column, {}x{}, one thread, all around from the start)\n",
                        prices.frame_ms, kWidth, kHeight);
    return text;
}

}  // namespace enfilade
