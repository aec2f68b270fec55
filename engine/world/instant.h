// The map at one moment: what the functions of this module ask about. Floors, ceilings and feet of things come from
// here and from nowhere else.
#pragma once
#include "map/map.h"
#include "world/history.h"

namespace enfilade {

/// A map together with what has happened in it, looked at at one time. Cheap to copy; both must outlive it.
struct Instant {
    const Map& map;
    const History* history = nullptr;  ///< null: nothing has happened
    double tick = 0;                   ///< may lie between two ticks

    /// A map at rest is a moment of it, too.
    Instant(const Map& at_rest) : map(at_rest) {}
    Instant(const Map& of, const History& happened, double at) : map(of), history(&happened), tick(at) {}
};

struct Heights {
    double floor_z;    ///< [m]
    double ceiling_z;  ///< [m]; >= floor_z
};

/// The change that a value of the sector, and of all its group, now follows; null: it is as in the map.
/// Cost: History::change_of.
const Change* change_of(const Instant& now, SectorId sector, Channel channel);

/// Cost: that of two courses, and of finding them (History::change_of).
Heights heights_of(const Instant& now, SectorId sector);

/// Whether a portal is open by any gap: a hand can reach through, and sound passes.
bool is_open(const Instant& now, const Wall& portal);

/// Height of a thing's foot [m].
double foot_of(const Instant& now, ThingId thing);

/// What a second on the sector's floor costs [points].
int damage_of(const Instant& now, SectorId sector);

/// The picture that a change gave the sector's floor; none: that of the map.
TextureId changed_floor_picture(const Instant& now, SectorId sector);

}  // namespace enfilade
