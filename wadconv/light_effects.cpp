#include "wadconv/light_effects.h"

#include <algorithm>

#include "wadconv/thing_table.h"

namespace enfilade::wadconv {
namespace {

/// Brightness that Doom's 0 to 255 become; see convert_sectors.cpp.
constexpr double kLightLevels = 256;

// Times [tics]. Flickering light is dark for 1 to 8 tics, and then bright for 1 or 65: in the mean for these.
constexpr double kFlash = 5, kFastDark = 15, kSlowDark = 35, kMeanCalm = 33, kMeanFlicker = 4.5, kFlame = 4;

/// Flickering light has times of half a tic [1/s].
constexpr double kFlickerClock = 2 * kTicsPerSecond;

/// How much darker a flame may be than the next [of 0..255].
constexpr double kFireStep = 16;

/// What glowing light changes by in a tic [of 0..255].
constexpr double kGlowSpeed = 8;

/// How much brighter than the darkest sector around fire stays [of 0..255].
constexpr int kFireAbove = 16;

LightEffectRecord effect(LightKind kind, int dark, double dark_tics, double bright_tics, bool in_step = false) {
    LightEffectRecord effect;
    effect.kind = kind;
    effect.dark = std::clamp(dark, 0, 255) / kLightLevels;
    effect.dark_s = dark_tics / kTicsPerSecond;
    effect.bright_s = bright_tics / kTicsPerSecond;
    effect.in_step = in_step;
    effect.lasts = true;
    effect.clock_hz = kind == LightKind::flicker ? kFlickerClock : kTicsPerSecond;
    if (kind == LightKind::fire) effect.step = kFireStep / kLightLevels;
    return effect;
}

/// Strobes go quite dark where nothing around is darker.
LightEffectRecord strobe(int light, int darkest, double dark_tics, bool in_step) {
    return effect(LightKind::strobe, darkest == light ? 0 : darkest, dark_tics, kFlash, in_step);
}

}  // namespace

LightEffectRecord slow_strobe(int dark) { return effect(LightKind::strobe, dark, kSlowDark, kFlash); }

std::optional<LightEffectRecord> light_effect_of(int special, int light, int darkest) {
    if (light <= 0) return {};
    switch (special) {
        case 2:
        case 4: return strobe(light, darkest, kFastDark, false);
        case 3: return strobe(light, darkest, kSlowDark, false);
        case 12: return strobe(light, darkest, kSlowDark, true);
        case 13: return strobe(light, darkest, kFastDark, true);
        default: break;
    }
    if (darkest >= light) return {};
    switch (special) {
        case 1: return effect(LightKind::flicker, darkest, kMeanCalm, kMeanFlicker);
        case 8: return effect(LightKind::glow, darkest, std::max(1.0, (light - darkest) / kGlowSpeed), kFlash);
        case 17: return effect(LightKind::fire, std::min(darkest + kFireAbove, light), kSlowDark, kFlame);
        default: return {};
    }
}

}  // namespace enfilade::wadconv
