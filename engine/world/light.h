// Light that flickers, flashes and glows: a function of time and place, which nobody has to tick.
#pragma once
#include <cstdint>

#include "formats/effect_records.h"

namespace enfilade {

/// The level, 0..1, of a light with this effect that would be `bright` without it, time_s >= 0 after the start. What is
/// random in it depends on `seed` alone, of a light in step not even on that; so any moment can be asked for, and
/// answers the same on every machine. Changes come at whole steps of its clock; only a glow goes on between them.
double level_of(const LightEffectRecord& effect, double bright, std::uint64_t seed, double time_s);

}  // namespace enfilade
