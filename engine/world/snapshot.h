// The world at one instant, as renderers see it: plain values, nothing that ticks.
#pragma once
#include <cstdint>
#include <vector>

#include "formats/effect_records.h"
#include "map/map.h"
#include "space/reach.h"
#include "world/instant.h"

namespace enfilade {

/// A sector at one instant.
struct SectorSnapshot {
    double floor_z = 0;                         ///< without its bob [m]
    double ceiling_z = 0;                       ///< likewise [m]; >= floor_z
    double light = 1;                           ///< 0..1, without its effect
    const LightEffectRecord* effect = nullptr;  ///< of the map, or null: the light is steady
    TextureId floor_picture;                    ///< that the floor was given, or none: the map's
    const Sector* bobbing = nullptr;            ///< of the map, whose floor or ceiling bobs now; or null
    SectorId light_seed;                        ///< whose number is the seed of its effect: leads its group
};

/// Everything that can differ from the map at rest.
struct Snapshot {
    std::vector<SectorSnapshot> sectors;  ///< indexed by SectorId
    double time_s = 0;
    Presences things;  ///< which things are to be seen in which sector, and where there

    std::vector<ThingId> taken;     ///< things that are gone, in the order of their numbers
    std::vector<SectorId> changed;  ///< sectors that are not, or lately were not, as at rest, each once
    WallId way_back;                ///< the one that stands open, or none
    std::vector<WallId> pressed;    ///< walls that show the other face of their switch, in the order of their numbers
    bool is_light_still = false;    ///< light effects, of sectors and of lamps, stand as if there were none

    const SectorSnapshot& operator[](SectorId id) const { return sectors[id.index]; }
};

/// The map at rest. Cost: the sectors, and the walls around the things; setting time_s afterwards costs nothing.
Snapshot at_rest(const Map& map);

/// Makes the snapshot that of another moment of its map. `snapshot` came from at_rest of the same map.
/// Cost: what ever changed in the history, and what had changed in the snapshot, however large the map.
void show(const Instant& now, Snapshot& snapshot);

/// The map `time_s` >= 0 after its start, when nobody has done anything. Cost: that of at_rest().
Snapshot snapshot_at(const Map& map, double time_s);

/// What the wall is at the moment: a way back is a portal or solid.
inline WallKind kind_now(const Map& map, const Snapshot& snapshot, WallId wall) {
    const WallKind kind = map[wall].kind;
    if (kind != WallKind::way_back) return kind;
    return snapshot.way_back == wall ? WallKind::portal : WallKind::solid;
}

/// What somebody wants to see a map without: what other engines, other moments and chance would draw elsewhere.
struct LeftOut {
    bool things = false;         ///< none is to be seen
    bool light_effects = false;  ///< is_light_still
};

/// Takes it out of the snapshot, for good: show() brings none of it back.
void leave_out(const LeftOut& what, Snapshot& snapshot);

/// The heights of a sector with its bob: worked out when somebody looks.
inline Heights heights_at(const Snapshot& snapshot, SectorId id) {
    const SectorSnapshot& sector = snapshot[id];
    if (!sector.bobbing) return {sector.floor_z, sector.ceiling_z};
    return bobbing_heights(*sector.bobbing, snapshot.time_s);
}

/// The light of a sector with its effect, 0..1: worked out when somebody looks.
double light_at(const Snapshot& snapshot, SectorId sector);

/// How long a switch that can be used again shows its other face [s].
inline constexpr double kSwitchSeconds = 1;

/// A thing at one instant.
struct ThingSnapshot {
    double z = 0;           ///< of its picture's foot, in the space of its own sector [m]
    Angle yaw;              ///< turned
    double light = 1;       ///< 0..1
    std::size_t frame = 0;  ///< of its sprite
};

/// How the thing is at the snapshot's time: worked out when somebody looks, so that things out of sight cost nothing.
ThingSnapshot thing_at(const Map& map, const Snapshot& snapshot, ThingId thing);

/// The frame that a sprite shows `time_s` after the start: a function of time, whatever was asked before. Negative
/// times count as 0.
std::size_t frame_at(const Sprite& sprite, double time_s);

// Light that flickers, flashes and glows: a function of time and place, which nobody has to tick.

/// The level, 0..1, of a light with this effect that would be `bright` without it, time_s >= 0 after the start. What is
/// random in it depends on `seed` alone, of a light in step not even on that; so any moment can be asked for, and
/// answers the same on every machine. Changes come at whole steps of its clock; only a glow goes on between them.
double level_of(const LightEffectRecord& effect, double bright, std::uint64_t seed, double time_s);

}  // namespace enfilade
