// What the player asks for in one tick, and how long a tick is.
#pragma once
#include <cstdint>

#include "formats/tape.h"

namespace enfilade {

/// The record of a tape is the whole of it, so whatever was played can be played again.
using TickInput = InputRecord;

/// Ticks a second. Fixed: everything that moves is tuned for it, and drawing interpolates.
inline constexpr std::uint32_t kTickRate = 60;
inline constexpr double kTickSeconds = 1.0 / kTickRate;

}  // namespace enfilade
