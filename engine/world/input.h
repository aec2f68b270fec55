// What the player asks for in one tick, and how long a tick is.
#pragma once
#include <cstdint>
#include <optional>

#include "formats/dials.h"
#include "formats/tape.h"

namespace enfilade {

/// The record of a tape is the whole of it, so whatever was played can be played again.
using TickInput = InputRecord;

/// [s]
constexpr double tick_seconds(TickRate rate) { return 1.0 / ticks_per_second(rate); }

/// Of a world that nobody asked for another: everything that moves is tuned for it, and drawing interpolates.
inline constexpr TickRate kUsualTickRate = TickRate::hz60;
inline constexpr std::uint32_t kTickRate = ticks_per_second(kUsualTickRate);  ///< [1/s]
inline constexpr double kTickSeconds = tick_seconds(kUsualTickRate);

/// The rate of so many ticks a second; none where no world has it.
constexpr std::optional<TickRate> rate_of_ticks(std::uint32_t per_second) {
    for (const TickRate rate : {TickRate::hz60, TickRate::hz35, TickRate::hz140})
        if (ticks_per_second(rate) == per_second) return rate;
    return {};
}

/// How the world of a tape moves; none where no world has the tape's rate.
inline std::optional<MotionDials> motion_of(const Tape& tape) {
    const std::optional<TickRate> rate = rate_of_ticks(tape.rate);
    if (!rate) return {};
    return MotionDials{*rate, tape.is_naive ? CrossingMethod::naive : CrossingMethod::exact};
}

}  // namespace enfilade
