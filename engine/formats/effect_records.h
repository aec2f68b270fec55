// What a map may call for beyond rooms that stay as they are, as its author wrote it: triggers, light effects, lamps
// and suns, moving and animated pictures, sounds.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/finding.h"
#include "math/vec.h"

namespace enfilade {

// Where the keys of a record were written, so that whoever finds one of them wrong can point at it.

/// The places of a record's values, and which of them the reader could not make sense of. Empty for a record that was
/// not read from a text. Cost: one allocation for a record that has keys, none for others.
class KeyPlaces {
public:
    /// Makes room for so many notes.
    void reserve(std::size_t count) { notes_.reserve(count); }

    /// The value of `key` is at `place`, and whether the reader found nothing wrong with it.
    /// key : a name from a list of keys, which outlives every record
    void note(std::string_view key, TextPlace place, bool is_sound) {
        notes_.push_back({key, place, is_sound});
        is_sound_ = is_sound_ && is_sound;
    }

    /// Something else is wrong with the record: a key that it has not, or lacks.
    void note_fault() { is_sound_ = false; }

    /// The place of the key's value, or `otherwise` where it is not given.
    TextPlace of(std::string_view key, TextPlace otherwise) const {
        const Note* note = find(key);
        return note ? note->place : otherwise;
    }

    bool has(std::string_view key) const { return find(key) != nullptr; }

    /// The reader had nothing to say about the whole record, or about this key of it: what is wrong now is no
    /// consequence of what it said.
    bool is_sound() const { return is_sound_; }
    bool is_sound(std::string_view key) const {
        const Note* note = find(key);
        return !note || note->is_sound;
    }

    /// Always: records that say the same are equal, wherever they were written.
    bool operator==(const KeyPlaces&) const { return true; }

private:
    struct Note {
        std::string_view key;
        TextPlace place;
        bool is_sound;
    };

    const Note* find(std::string_view key) const {
        const auto it = std::ranges::find(notes_, key, &Note::key);
        return it == notes_.end() ? nullptr : &*it;
    }

    std::vector<Note> notes_;
    bool is_sound_ = true;
};

/// Where the value of one of the record's keys is, or where the record begins if it has none.
template <class Record>
TextPlace key_place(const Record& record, std::string_view key) {
    return record.places.of(key, record.place);
}

/// What sets a trigger off.
enum class Activation : std::uint8_t {
    use,    ///< somebody presses "use" at the wall or panel; a sector's: at any portal that leads into it
    cross,  ///< somebody passes the portal or the panel, in whichever direction; walls and panels only
    enter,  ///< somebody comes into the sector; sectors only
    touch,  ///< somebody touches the thing; things only
    start,  ///< the map begins
};

/// What a trigger does to its targets.
enum class TriggerAction : std::uint8_t {
    door,             ///< the ceiling goes up to open, waits, and comes down again
    open,             ///< the ceiling goes up, and stays
    close,            ///< the ceiling comes down to the floor, and stays
    close_then_open,  ///< the ceiling comes down, waits, and goes up again
    lift,             ///< the floor goes down to the lowest floor around, waits, and comes back
    shuttle,          ///< the floor goes between the lowest and the highest floor around for ever, waiting at each
    floor,            ///< the floor goes somewhere, and stays
    ceiling,          ///< the ceiling goes somewhere, and stays
    crush,            ///< the ceiling goes down almost to the floor and up again for ever, and hurts
    stairs,           ///< the floors of all targets rise, each one step higher than the one before
    stop,             ///< shuttles and crushers stop where they are
    light,            ///< the light changes
    teleport,         ///< who set it off stands where the target thing is
    leave_map,        ///< the map is left
    sound,            ///< nothing but its sound
};

/// A height that is found when the trigger goes off. "Around" are the sectors behind the target's portals.
enum class HeightLevel : std::uint8_t {
    here,                   ///< where it is
    lowest_floor,           ///< around, if lower than its own
    highest_floor,          ///< around
    next_floor_up,          ///< the lowest of those around that are higher
    next_floor_down,        ///< the highest of those around that are lower
    lowest_ceiling,         ///< around
    highest_ceiling,        ///< around
    floor,                  ///< its own floor
    ceiling,                ///< its own ceiling
    lowest_ceiling_or_own,  ///< around, or its own if that is lower
};

/// A level of light that is found when the trigger goes off.
enum class LightLevel : std::uint8_t { given, brightest, darkest };

/// How light changes with time.
enum class LightKind : std::uint8_t {
    flicker,  ///< bright, with short dark moments at random
    strobe,   ///< dark, with a bright flash in every period
    glow,     ///< from dark to bright and back, evenly
    fire,     ///< restless, never quite dark
};

struct LightEffectRecord {
    LightKind kind = LightKind::glow;
    double dark = 0;             ///< the lower level, 0..1; the upper is the sector's light
    double dark_s = 1;           ///< strobe: how long dark; glow: how long one way takes; flicker: mean bright time [s]
    double bright_s = 0.125;     ///< strobe and flicker: how long bright, or dark, at least; both 1/64..86400 [s]
    bool in_step = false;        ///< in time with all others that have the same measures
    bool lasts = false;          ///< a trigger's light neither ends nor changes it
    std::optional<double> step;  ///< fire: how much darker a level is than the next, 0..1; none: a quarter of the way
    double clock_hz = 60;        ///< changes come at whole parts of a second, this many, 1..240; so are its times [1/s]
    TextPlace place;
    KeyPlaces places{};
    bool operator==(const LightEffectRecord&) const = default;
};

struct TriggerRecord {
    Activation on = Activation::use;
    TriggerAction action = TriggerAction::door;  ///< `do`
    std::vector<std::string> targets;  ///< `target`: sectors by name or tag; teleport: a thing; exit: a map. None: the
                                       ///< sector it is on, or the one behind its wall
    bool once = false;                 ///< works only once
    bool one_way = false;              ///< cross: only when leaving the sector of this wall; use and cross of a panel:
                                       ///< only from its right, as one_sided
    std::string key;                   ///< works only for who has it; empty: for everybody
    double after = 0;                  ///< how long it takes before it works, 0..86400 [s]
    std::optional<double> z;           ///< floor, ceiling: where to go [m]
    HeightLevel to = HeightLevel::here;  ///< the same, found when it goes off
    std::string like;                    ///< the same: the floor of the sector of this name
    double by = 0;                       ///< added to either [m]
    double speed = 2;                    ///< 1/64..1024 [m/s]
    double wait = 4;                     ///< how long doors and lifts wait, 0..86400 [s]
    double step = 0.25;                  ///< height of a stair, -64..64 [m]
    bool reverses = true;                ///< door, on use: used while it moves or waits, it turns round or closes
    bool crushes = false;                ///< hurts who is in the way, instead of waiting
    std::optional<double> crush_speed;   ///< speed further down on who is in its way, as speed; none: as before [m/s]
    std::string texture;          ///< the floor's new picture: rising at once, falling on arrival; empty: as it was
    bool heals = false;           ///< the floor no longer hurts, from when it gets its new picture
    std::optional<double> light;  ///< light: 0..1
    LightLevel light_of = LightLevel::given;  ///< light: that of the sectors around
    std::optional<LightEffectRecord> effect;  ///< light: from now on it changes like this; none: it is steady
    std::string sound;  ///< heard when it goes off, from the wall, sector or thing it is on; empty: silent
    TextPlace place;
    KeyPlaces places{};
    bool operator==(const TriggerRecord&) const = default;
};

/// How what bobs gets from one end of its way to the other: slower towards the ends, or evenly.
enum class BobShape : std::uint8_t { sine, triangle };

/// Up and down for ever, around where it is at rest.
struct BobRecord {
    double amplitude = 0;  ///< how far it gets from its rest to either side, 2^-10..1024 [m]
    double period = 4;     ///< how long once up and down takes, 1/8..86400 [s]
    double phase = 0;      ///< 0..1, how much of its period is over at the start; 0: it leaves its rest upwards
    BobShape shape = BobShape::sine;
    bool operator==(const BobRecord&) const = default;
};

/// Pictures that follow one another wherever one of them is on a wall or flat.
struct AnimationRecord {
    std::vector<std::string> frames;
    double seconds = 0.25;  ///< each, 1/64..86400 [s]
    TextPlace place;
    KeyPlaces places{};
    bool operator==(const AnimationRecord&) const = default;
};

/// A lamp: light that falls on the walls, floors and things around it, and throws shadows.
struct PointLightRecord {
    std::string sector;                       ///< empty: found from the position
    Vec2 position;                            ///< [m]
    double z = 0;                             ///< [m]
    std::uint32_t color = 0xFFFFFF;           ///< 0xRRGGBB
    double brightness = 1;                    ///< at the lamp itself, 0..2; 1 adds as much as full light
    double reach = 8;                         ///< beyond this there is none of it, 1/16..64 [m]
    std::optional<LightEffectRecord> effect;  ///< how it changes; its `dark` is a part of the brightness
    TextPlace place;
    KeyPlaces places{};
    bool operator==(const PointLightRecord&) const = default;
};

/// Light that comes from far away, in one direction, and falls on the sectors that name it.
struct SunRecord {
    std::string name;
    double yaw_degrees = 0;          ///< where one looks to see it
    double elevation_degrees = 45;   ///< above the horizon, 0..90
    std::uint32_t color = 0xFFFFFF;  ///< 0xRRGGBB
    double brightness = 0.5;         ///< of what faces it, 0..2; 1 adds as much as full light
    TextPlace place;
    KeyPlaces places{};
    bool operator==(const SunRecord&) const = default;
};

/// The two faces of a switch: a wall with triggers that shows one shows the other once it went off.
struct SwitchRecord {
    std::string off, on;
    TextPlace place;
    KeyPlaces places{};
    bool operator==(const SwitchRecord&) const = default;
};

/// Something that can be heard.
struct SoundRecord {
    std::string name, file;  ///< the file is seen from the map's folder
    double volume = 1;       ///< at its source, 0..1
    double reach = 32;       ///< how long the way to it may be before it is silent, 1/16..1024 [m]
    bool loops = false;      ///< of what moves: over and over, for as long as it moves
    TextPlace place;
    KeyPlaces places{};
    bool operator==(const SoundRecord&) const = default;
};

}  // namespace enfilade
