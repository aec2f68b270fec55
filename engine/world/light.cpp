#include "world/light.h"

#include <algorithm>
#include <cmath>

#include "base/hash.h"

namespace enfilade {
namespace {

/// A length of time as whole steps of the effect's clock, one at least.
std::uint64_t steps_of(const LightEffectRecord& effect, double seconds) {
    return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(seconds * effect.clock_hz + 0.5));
}

/// A number for each pair of numbers, as if drawn by lot.
Random random_for(std::uint64_t seed, std::uint64_t number) { return Random(Random(seed).bits() ^ number); }

/// Bright, but for one dark moment in each span, drawn by lot.
bool flickers(const LightEffectRecord& effect, std::uint64_t seed, std::uint64_t now) {
    const std::uint64_t dark = steps_of(effect, effect.bright_s), span = dark + steps_of(effect, effect.dark_s);
    const std::uint64_t begin = random_for(seed, now / span).below(span - dark + 1);
    return now % span >= begin && now % span < begin + dark;
}

/// 0, the brightest, to 3: drawn by lot for each flame.
std::uint64_t level_of_fire(const LightEffectRecord& effect, std::uint64_t seed, double time_s) {
    const auto now = static_cast<std::uint64_t>(time_s * effect.clock_hz);
    return random_for(seed, now / steps_of(effect, effect.bright_s)).below(4);
}

/// How much of the way from dark to bright.
double part_of(const LightEffectRecord& effect, std::uint64_t seed, double time_s) {
    const auto now = static_cast<std::uint64_t>(time_s * effect.clock_hz);
    const std::uint64_t dark = steps_of(effect, effect.dark_s), bright = steps_of(effect, effect.bright_s);
    switch (effect.kind) {
        case LightKind::flicker: return flickers(effect, seed, now) ? 0 : 1;
        case LightKind::strobe:
            return (now + random_for(seed, 0).below(dark + bright)) % (dark + bright) < bright ? 1 : 0;
        case LightKind::fire: return 1 - 0.25 * static_cast<double>(level_of_fire(effect, seed, time_s));
        case LightKind::glow: {
            const double ways = time_s / effect.dark_s + random_for(seed, 0).uniform(0, 2);
            return std::fabs(1 - (ways - 2 * std::floor(ways / 2)));
        }
    }
    return 1;
}

}  // namespace

double level_of(const LightEffectRecord& effect, double bright, std::uint64_t seed, double time_s) {
    const double dark = std::min(effect.dark, bright);
    const std::uint64_t own_seed = effect.in_step ? 0 : seed;
    if (effect.kind == LightKind::fire && effect.step)
        return std::max(dark, bright - *effect.step * static_cast<double>(level_of_fire(effect, own_seed, time_s)));
    return dark + (bright - dark) * part_of(effect, own_seed, time_s);
}

}  // namespace enfilade
