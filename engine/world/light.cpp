#include "world/light.h"

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "world/input.h"

namespace enfilade {
namespace {

/// A length of time as whole ticks, one at least.
std::uint64_t ticks_of(double seconds) {
    return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(seconds * kTickRate + 0.5));
}

/// A number for each pair of numbers, as if drawn by lot.
Random lot(std::uint64_t seed, std::uint64_t number) { return Random(Random(seed).bits() ^ number); }

/// Bright, but for one dark moment in each span, drawn by lot.
bool flickers(const LightEffectRecord& effect, std::uint64_t seed, std::uint64_t tick) {
    const std::uint64_t dark = ticks_of(effect.bright_s), span = dark + ticks_of(effect.dark_s);
    const std::uint64_t begin = lot(seed, tick / span).below(span - dark + 1);
    return tick % span >= begin && tick % span < begin + dark;
}

/// How much of the way from dark to bright.
double part_of(const LightEffectRecord& effect, std::uint64_t seed, double time_s) {
    const auto tick = static_cast<std::uint64_t>(time_s * kTickRate);
    const std::uint64_t dark = ticks_of(effect.dark_s), bright = ticks_of(effect.bright_s);
    switch (effect.kind) {
        case LightKind::flicker: return flickers(effect, seed, tick) ? 0 : 1;
        case LightKind::strobe: return (tick + lot(seed, 0).below(dark + bright)) % (dark + bright) < bright ? 1 : 0;
        case LightKind::fire: return 1 - 0.25 * static_cast<double>(lot(seed, tick / bright).below(4));
        case LightKind::glow: {
            const double ways = time_s / effect.dark_s + lot(seed, 0).uniform(0, 2);
            return std::fabs(1 - (ways - 2 * std::floor(ways / 2)));
        }
    }
    return 1;
}

}  // namespace

double level_of(const LightEffectRecord& effect, double bright, std::uint64_t seed, double time_s) {
    const double dark = std::min(effect.dark, bright);
    return dark + (bright - dark) * part_of(effect, effect.in_step ? 0 : seed, time_s);
}

}  // namespace enfilade
