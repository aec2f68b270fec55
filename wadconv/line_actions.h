// What Doom's lines do: every type of Doom and Doom II, and those of Boom that have a word here, as plain data.
// Source: the published tables (Matthew S. Fell, "The Unofficial Doom Specs", 1994, §4.3.3; the Boom reference, 1998,
// part I), times and speeds as measured there: map units and tics of 1/35 s.
#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "formats/effect_records.h"

namespace enfilade::wadconv {

/// How a line is set off. `push`: used, and acts on the sector behind it; the others on the sectors of its tag.
enum class How : std::uint8_t { push, use, cross, shoot };

enum class Times : std::uint8_t { once, again };

/// Cards and skulls of one colour open the same.
enum class DoorKey : std::uint8_t { none, blue, yellow, red };

/// What becomes of the floor's picture, and of what the floor does to who stands on it.
enum class FloorChange : std::uint8_t {
    none,
    picture,      ///< the picture of the sector in front of the line
    harmless,     ///< the same, and the floor no longer hurts
    as_in_front,  ///< picture and nature of the sector in front of the line
    as_beside,    ///< picture and nature of a sector around that has the height that the floor gets
};

/// What needs more than a word's own measures.
enum class SpecialCase : std::uint8_t {
    none,
    shortest_lower,  ///< `by` is the height of the shortest lower texture around
    donut,           ///< the pillar goes down into the ring, and the ring rises around it
    secret_exit,
};

struct LineAction {
    int special = 0;
    How how = How::use;
    Times times = Times::again;
    TriggerAction action = TriggerAction::door;
    double speed = 0;  ///< [map units / tic]
    double wait = 0;   ///< [tics]
    HeightLevel to = HeightLevel::here;
    double by = 0;  ///< [map units]; stairs: the height of one
    bool crushes = false;
    double crush_speed = 0;  ///< once it comes down on somebody; 0: as before [map units / tic]
    DoorKey key = DoorKey::none;
    FloorChange change = FloorChange::none;
    SpecialCase special_case = SpecialCase::none;
    int light = -1;  ///< 0..255, or -1: `light_of`, or a strobe where that is `given`
    LightLevel light_of = LightLevel::given;
};

/// All that are listed one by one, by rising number.
std::span<const LineAction> line_actions();

/// What the type does; nothing for 0, for types that are no action (scrollers), that only monsters set off, or that are
/// not known. Also knows Boom's generalized doors and lifts.
std::optional<LineAction> line_action_of(int special);

/// How far the wall's picture moves along it in a tic, to the right positive, or 0 [texels].
int scroll_of(int special);

}  // namespace enfilade::wadconv
