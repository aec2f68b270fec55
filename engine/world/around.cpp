#include "world/around.h"

#include <algorithm>
#include <optional>

namespace enfilade {
namespace {

/// Whether the portal leads from one sector of a group into another.
bool is_within_group(const Map& map, const Wall& portal) {
    return portal.behind != portal.sector && map[portal.behind].leader == map[portal.sector].leader;
}

/// Calls visit(wall) for each portal that leads out of the sector's group.
template <class Visit>
void each_portal(const Map& map, SectorId id, Visit visit) {
    each_of_group(map, id, [&](SectorId member) {
        const Sector& sector = map[member];
        for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i)
            if (map.walls[i].kind == WallKind::portal && !is_within_group(map, map.walls[i])) visit(map.walls[i]);
    });
}

/// The best of a height of all sectors around, by an order, among those that may count.
template <class Better, class Counts>
std::optional<double> best_around(const Instant& now, SectorId sector, double Heights::* which, Better better,
                                  Counts counts) {
    std::optional<double> best;
    each_portal(now.map, sector, [&](const Wall& portal) {
        const double height = heights_of(now, portal.behind).*which - now.map.passage(portal).rise;
        if (counts(height) && (!best || better(height, *best))) best = height;
    });
    return best;
}

std::optional<double> found_around(const Instant& now, SectorId sector, Level level) {
    const auto [floor_z, ceiling_z] = heights_of(now, sector);
    const auto any = [](double) { return true; };
    const auto higher = [own = floor_z](double z) { return z > own; };
    const auto lower = [own = floor_z](double z) { return z < own; };
    const std::less<double> less;
    const std::greater<double> more;
    switch (level) {
        case Level::lowest_floor: return best_around(now, sector, &Heights::floor_z, less, lower).value_or(floor_z);
        case Level::highest_floor: return best_around(now, sector, &Heights::floor_z, more, any);
        case Level::next_floor_up: return best_around(now, sector, &Heights::floor_z, less, higher);
        case Level::next_floor_down: return best_around(now, sector, &Heights::floor_z, more, lower);
        case Level::lowest_ceiling: return best_around(now, sector, &Heights::ceiling_z, less, any);
        case Level::highest_ceiling: return best_around(now, sector, &Heights::ceiling_z, more, any);
        case Level::floor: return floor_z;
        case Level::ceiling: return ceiling_z;
        case Level::lowest_ceiling_or_own:
            return std::min(best_around(now, sector, &Heights::ceiling_z, less, any).value_or(ceiling_z), ceiling_z);
        case Level::here: return {};
    }
    return {};
}

}  // namespace

double height_of(const Instant& now, SectorId sector, Level level, double here) {
    return found_around(now, sector, level).value_or(here);
}

const LightEffectRecord* effect_of(const Instant& now, SectorId sector, const Change* light) {
    const Boxed<LightEffectRecord>& own = now.map[sector].light_effect;
    if (own && own->lasts) return &*own;
    if (!light) return own ? &*own : nullptr;
    const std::optional<LightEffectRecord>& effect = now.map[light->cause].effect;
    return effect ? &*effect : nullptr;
}

double plain_light_of(const Instant& now, SectorId sector) {
    return plain_light_of(now, sector, change_of(now, sector, Channel::light));
}

double plain_light_of(const Instant& now, SectorId sector, const Change* light) {
    const Boxed<LightEffectRecord>& own = now.map[sector].light_effect;
    if (own && own->lasts) return now.map[sector].light;
    return light ? value_at(light->course, now.tick) : now.map[sector].light;
}

double light_of(const Instant& now, SectorId sector, LightLevel level) {
    double light = plain_light_of(now, sector);
    each_portal(now.map, sector, [&](const Wall& portal) {
        const double other = plain_light_of(now, portal.behind);
        light = level == LightLevel::brightest ? std::max(light, other) : std::min(light, other);
    });
    return light;
}

}  // namespace enfilade
