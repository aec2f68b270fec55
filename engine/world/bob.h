// Up and down for ever: a function of time.
#pragma once
#include "formats/effect_records.h"
#include "world/instant.h"

namespace enfilade {

/// How far it is above its rest at a time, negative below it: within its amplitude [m]. time_s: any finite number. The
/// same bits on every machine. Cost: one sine.
double offset_at(const BobRecord& bob, double time_s);

/// The heights of a sector of which nothing but bobs moves. The floor carries a ceiling that it meets.
Heights bobbing_heights(const Sector& sector, double time_s);

}  // namespace enfilade
