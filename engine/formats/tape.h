// Recorded input: what the player pressed in each tick, so that a walk can be played again.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/result.h"

namespace enfilade {

/// Bits of InputRecord::buttons.
enum InputButton : std::uint8_t {
    kButtonRun = 1,
    kButtonCrouch = 2,
    kButtonUse = 4,
    kButtonJump = 8,  ///< reserved
};

/// What was asked of the player in one tick: whole numbers only, so that it means the same on every machine.
struct InputRecord {
    std::int8_t forward = 0;       ///< -127 back … 127 forward, in 127ths of the full pace
    std::int8_t strafe = 0;        ///< -127 left … 127 right
    std::int32_t yaw_steps = 0;    ///< turned in this tick, right positive [2^-32 turn]
    std::int32_t pitch_steps = 0;  ///< looked up in this tick, up positive [2^-32 turn]
    std::uint8_t buttons = 0;      ///< InputButton bits that are down; others are 0
    bool operator==(const InputRecord&) const = default;
};

struct Tape {
    std::string map;             ///< path of the map, as it was given when recording
    std::uint64_t map_hash = 0;  ///< hash_of_text() of the map's file, to notice that it was changed since
    std::uint32_t rate = 60;     ///< ticks a second, 1..1000
    bool is_naive = false;       ///< rooms were found by the place alone (CrossingMethod::naive)
    std::vector<InputRecord> ticks;
    /// Of the world after the last tick; none where the recording did not come to its end: the game or the machine was
    /// stopped, and the ticks are those that were written by then.
    std::optional<std::uint64_t> final_hash = 0;
    bool operator==(const Tape&) const = default;
};

/// Longest `map` [bytes].
inline constexpr std::size_t kMaxTapeMapName = 4096;

/// Reads a tape; layout in tape.cpp. Headers that end early, extra bytes and values out of range are errors whose
/// `where` is "byte N". A tape that ends in the middle of its ticks is one without a final hash, of the ticks that are
/// whole. Memory is taken only for what the bytes really hold.
Result<Tape> read_tape(std::span<const std::byte> bytes);

/// The bytes that read back as this tape. The tape's values are in their ranges.
Bytes write_tape(const Tape& tape);

/// The same in pieces, for a tape that is written while it is recorded: the beginning, a piece of kTapeTickBytes for
/// each tick, and the end.
Bytes tape_beginning(const Tape& tape);
Bytes tape_tick(const InputRecord& tick);
Bytes tape_end(std::uint64_t final_hash);
inline constexpr std::size_t kTapeTickBytes = 11;

}  // namespace enfilade
