// What the numbers of Doom's lines mean, as far as they move floors and ceilings: by Doom's own lists and by nothing of
// the converter's. Source: as doom_rules.h.
#pragma once
#include <optional>

namespace enfilade::test {

/// What is done to a sector.
enum class Rule {
    door,
    open,
    close,
    close_then_open,
    lift,
    perpetual,
    raise_by,
    raise_to_next,
    to_highest,
    to_highest_and_up,
    to_lowest,
    to_ceiling,
    to_8_below_ceiling,
    by_texture,
    donut,
    stairs,
    ceiling_to_floor,
    ceiling_to_highest,
    ceiling_to_8_above_floor,
    crusher,
};

/// A special, however its number says so.
struct DoomSpecial {
    Rule rule;
    double speed;     ///< [map units / tic]
    double amount;    ///< of a rise or a stair [map units]
    double wait;      ///< of what waits [tics]
    bool is_pushed;   ///< acts on what is behind the line; others on the sectors with the line's tag
    bool is_crossed;  ///< set off by who walks across the line; others by hand or by a shot
};

/// The special of that number; none where it moves neither floors nor ceilings. Also those of Boom's generalized doors,
/// and of its lifts to the lowest floor around.
std::optional<DoomSpecial> special_of(int number);

}  // namespace enfilade::test
