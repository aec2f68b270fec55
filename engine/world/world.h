// The state of the world: everything that changes with time, as one plain value. A copy is a snapshot to come back to.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "map/map.h"
#include "math/angle.h"
#include "space/trace.h"
#include "world/body.h"
#include "world/history.h"
#include "world/input.h"

namespace enfilade {

// The player: a body with a will and an eye.

/// Everything about the player that the next tick depends on. A plain value.
struct Player {
    Place place;
    double feet_z = 0;                ///< [m]
    Vec2 velocity;                    ///< [m/s]
    double fall_speed = 0;            ///< downward, >= 0 [m/s]
    double height = kStandingHeight;  ///< of the body, between crouched and standing [m]
    double eye_lag = 0;               ///< how far the eye is still above where it goes, after a step [m]
    double eye_z = 0;                 ///< above the map's zero [m]; below every ceiling over the body
    Angle yaw;
    std::uint32_t yaw_rest =
        0;  ///< what links turned it beyond whole steps of yaw, so that nothing adds up [2^-64 turn]
    std::int32_t pitch_steps = 0;  ///< up positive, within ±kMaxPitchSteps [2^-32 turn]
    bool on_ground = true;

    bool operator==(const Player&) const = default;
};

/// How far up and down one can look: 60 degrees. The column renderer shears the picture, which at more than that
/// stretches it beyond recognition.
inline constexpr std::int32_t kMaxPitchSteps = 0x2AAAAAAA;

/// The eye above the feet of a body of this height [m]: 1.55 standing, 0.85 crouched.
double eye_height(double height);

/// How near the eye may come to a ceiling [m]: as near as it is to the top of a crouched head.
inline constexpr double kEyeBelowCeiling = 0.15;

/// Stands the player at the start: on the floor if the eye's height there says so, else above it, to fall. Too near to
/// a wall, it is moved off as far as there is room.
Player player_at(const Instant& now, const PlayerStart& start);

/// The player's body, as wide and high as there is room, and what is around it.
PlacedBody placed_body_of(const Instant& now, const Player& player);

/// The body alone.
inline Body body_of(const Instant& now, const Player& player) { return placed_body_of(now, player).body; }

/// Lifts the player onto every floor that its body is over, and ducks it below every ceiling, until nothing of it is in
/// either; then says what is free. Who is squeezed between walls comes free of some of them where it is lifted, as of a
/// step too high to climb, and is over more floors then: it is lifted onto those, too. Lifted by a step at most, the
/// free have come to rest.
/// Cost: that of body_of() for each time it is lifted or ducked, at most kMostLifts.
Clearance come_to_rest(const Instant& now, Player& player);

/// Far more than the steps that are below one disc in any honest map.
inline constexpr int kMostLifts = 64;

/// Where the eye belongs: above the feet, with its lag, below the ceiling.
double eye_z_of(const Player& player, double ceiling_z);

/// How well one is at the start, and at most [points].
inline constexpr int kFullHealth = 100;

/// What a player is told.
enum class PlayerMessageKind : std::uint8_t {
    needs_key,  ///< number: index into Map::keys
    got_key,    ///< number: index into Map::keys
    healed,
    secret,  ///< a secret sector was found
    hurt,
    died,
};

/// The last thing that was told.
struct PlayerMessage {
    PlayerMessageKind kind = PlayerMessageKind::hurt;
    std::uint32_t number = 0;
    std::uint64_t tick = 0;  ///< after which it was told
};

struct World {
    std::uint64_t tick = 0;  ///< ticks since the start
    Player player;

    History history;
    int health = kFullHealth;          ///< 0: dead
    std::uint64_t keys = 0;            ///< bit i: has Map::keys[i]
    std::uint8_t held = 0;             ///< InputButton bits that were down in the tick before
    std::vector<ThingId> touched;      ///< things that were touched in the tick before, in the order of their numbers
    std::vector<SectorId> secrets;     ///< that were found, a group by its leader, in the order of their numbers
    std::optional<TriggerId> left_by;  ///< the trigger by which the map was left
    std::optional<PlayerMessage> message;

    /// What drawing between two ticks needs, and nothing else: the player one tick ago, in the space where it then
    /// was, and the way from there into the space where it is now. The future does not depend on it.
    Player before;
    Rigid passage;
};

/// The map as it is now.
inline Instant now(const Map& map, const World& world) { return {map, world.history, static_cast<double>(world.tick)}; }

/// The world as a map begins, with what its start sets off; none where the map has no start.
std::optional<World> start_of(const Map& map, const MotionDials& motion = {});

/// Equal for equal states on every machine; value by value. Leaves out what is only for drawing.
std::uint64_t hash(const World& world);

/// One line "name: a / b" for each value in which two states differ, empty where they are the same.
std::string difference(const World& a, const World& b);

// The eye between two ticks.

/// Where the eye is and how it looks.
struct Eye {
    Place place;
    double z = 0;  ///< [m]
    Angle yaw;
    std::int32_t pitch_steps = 0;  ///< up positive [2^-32 turn]
};

/// The player's eye, `part` of the way from the tick before to this one, 0..1. It follows the player through portals
/// and links: place, height and yaw are those of the space that the eye is in at that moment, and its sector contains
/// it. part = 1 is exactly where the player is.
Eye eye_between_ticks(const Map& map, const World& world, double part);

}  // namespace enfilade
