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

/// Whether a line of that special can be set off again and again; else once in a level. Of Doom's own specials and
/// Boom's generalized ones; none for others, and for those that end the level.
std::optional<bool> repeats(int number);

/// Whether who pushes such a door while it moves turns it round: Doom's own doors that are pushed again and again.
bool turns_round(int number);

/// What a line does to the light of the sectors with its tag.
enum class LightRule {
    brightest,  ///< as bright as the brightest around, which may be darker than they are
    darkest,    ///< as dark as the darkest of them and those around
    to_level,   ///< to amount
    strobe,     ///< flashes, to the darkest around
};
struct DoomLight {
    LightRule rule;
    double amount;  ///< 0 to 255
};
std::optional<DoomLight> light_of(int number);

/// Whether it is a teleport for players.
bool is_teleport(int number);

}  // namespace enfilade::test
