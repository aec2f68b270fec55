// The map at one moment: what the functions of this module ask about. Floors, ceilings and feet of things come from
// here and from nowhere else.
#pragma once
#include <optional>

#include "formats/effect_records.h"
#include "map/map.h"
#include "world/history.h"

namespace enfilade {

/// A map together with what has happened in it, looked at at one time. Cheap to copy; both must outlive it.
struct Instant {
    const Map& map;
    const History* history = nullptr;  ///< null: nothing has happened
    double tick = 0;                   ///< may lie between two ticks
    std::optional<WallId> way_back;    ///< the one that stands open, or none, where that is not what the history says

    /// A map at rest is a moment of it, too.
    Instant(const Map& at_rest) : map(at_rest) {}
    Instant(const Map& of, const History& happened, double at) : map(of), history(&happened), tick(at) {}
};

struct Heights {
    double floor_z;    ///< [m]
    double ceiling_z;  ///< [m]; >= floor_z
};

/// The rate of its ticks.
inline TickRate rate_of(const Instant& now) { return now.history ? now.history->rate() : TickRate::hz60; }

/// How long what was held up waits before it tries again [ticks]: a quarter of a second.
constexpr std::uint32_t patience_at(TickRate rate) { return ticks_per_second(rate) / 4; }

/// The change that a value of the sector, and of all its group, now follows; null: it is as in the map.
/// Cost: History::change_of.
const Change* change_of(const Instant& now, SectorId sector, Channel channel);

/// The changes that the values of a sector now follow; null: as in the map.
struct ChangesNow {
    const Change* floor = nullptr;
    const Change* ceiling = nullptr;
    const Change* light = nullptr;
};

/// Of a record of the history of `now`. Cost: the newer changes of the sector.
ChangesNow changes_of(const Instant& now, const ChangedSector& sector);

/// Cost: that of two tracks or bobs, and of finding them (History::changed).
Heights heights_of(const Instant& now, SectorId sector);

/// The same of a sector whose changes have been found.
Heights heights_of(const Instant& now, SectorId sector, const ChangesNow& changes);

/// Whether the wall is a portal now, or a way back that stands open, which is one for as long.
bool is_portal(const Instant& now, WallId wall);

/// The way back that stands open, or none, once somebody has left by the portal; nothing where that changes nothing.
std::optional<WallId> way_back_left(const Map& map, WallId portal);

/// Whether a portal or way back is open by any gap: a hand can reach through, and sound passes.
bool is_open(const Instant& now, WallId portal);

/// Height of a thing's foot [m].
double foot_of(const Instant& now, ThingId thing);

/// What a second on the sector's floor costs [points].
int damage_of(const Instant& now, SectorId sector);

/// The picture that the change which a floor now follows, or one before it, gave it; none: that of the map.
/// floor: may be null.
TextureId changed_floor_picture(const Instant& now, const Change* floor);

// Heights and lights of the sectors around one: where floors and ceilings go that are told "as the neighbour".

/// The height a level stands for, in the space of the sector [m]. Where no sector around answers, `here`.
/// Around a group are the sectors behind the portals of all its sectors, but for its own.
/// Cost: the walls of the sector and its group.
double height_of(const Instant& now, SectorId sector, HeightLevel level, double here);

/// The brightest or darkest of the sector and those around it, without their effects, 0..1.
double light_of(const Instant& now, SectorId sector, LightLevel level);

/// The effect that a sector's light has now, of the map, or null: it is steady.
/// light: the change that it now follows, or null.
const LightEffectRecord* effect_of(const Instant& now, SectorId sector, const Change* light);

/// The light of a sector without its effect, 0..1.
double plain_light_of(const Instant& now, SectorId sector);

/// The same where the change that the light now follows has been found; null: there is none.
double plain_light_of(const Instant& now, SectorId sector, const Change* light);

// Up and down for ever: a function of time.

/// How far it is above its rest at a time, negative below it: within its amplitude [m]. time_s: any finite number. The
/// same bits on every machine. Cost: one sine.
double offset_at(const BobRecord& bob, double time_s);

/// The heights of a sector of which nothing but bobs moves. The floor carries a ceiling that it meets.
Heights bobbing_heights(const Sector& sector, double time_s);

}  // namespace enfilade
