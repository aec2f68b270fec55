// Heights and lights of the sectors around one: where floors and ceilings go that are told "as the neighbour".
#pragma once
#include "world/instant.h"

namespace enfilade {

/// The height a level stands for, in the space of the sector [m]. Where no sector around answers, `here`.
/// Around a group are the sectors behind the portals of all its sectors, but for its own.
/// Cost: the walls of the sector and its group.
double height_of(const Instant& now, SectorId sector, Level level, double here);

/// The brightest or darkest of the sector and those around it, without their effects, 0..1.
double light_of(const Instant& now, SectorId sector, LightLevel level);

/// The effect that a sector's light has now, of the map, or null: it is steady.
/// light: the change that it now follows, or null.
const LightEffectRecord* effect_of(const Instant& now, SectorId sector, const Change* light);

/// The light of a sector without its effect, 0..1.
double plain_light_of(const Instant& now, SectorId sector);

/// The same where the change that the light now follows has been found; null: there is none.
double plain_light_of(const Instant& now, SectorId sector, const Change* light);

}  // namespace enfilade
