#include "world/snapshot.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace enfilade {
namespace {

double foot_of(const Thing& thing, const SectorSnapshot& home) {
    switch (thing.footing) {
        case Footing::floor: return home.floor_z;
        case Footing::ceiling: return home.ceiling_z - thing.height;
        case Footing::fixed: return thing.z;
    }
    return thing.z;
}

}  // namespace

Snapshot at_rest(const Map& map) {
    Snapshot snapshot;
    snapshot.sectors.reserve(map.sectors.size());
    for (const Sector& s : map.sectors) snapshot.sectors.push_back({s.floor.z, s.ceiling.z, s.light});
    snapshot.things = presences_of(map);
    return snapshot;
}

ThingSnapshot thing_at(const Map& map, const Snapshot& snapshot, ThingId id) {
    const Thing& thing = map[id];
    const SectorSnapshot& home = snapshot[thing.sector];
    return {foot_of(thing, home), thing.light.value_or(home.light),
            thing.sprite ? frame_at(map[thing.sprite], snapshot.time_s) : 0};
}

std::size_t frame_at(const Sprite& sprite, double time_s) {
    const double cycle = sprite.frames.back().until_s;
    double at = std::max(time_s, 0.0);
    if (cycle < std::numeric_limits<double>::infinity()) at -= std::floor(at / cycle) * cycle;
    const auto is_over = [](double time, const SpriteFrame& frame) { return time < frame.until_s; };
    const auto shown = std::upper_bound(sprite.frames.begin(), sprite.frames.end() - 1, at, is_over);
    return static_cast<std::size_t>(shown - sprite.frames.begin());
}

}  // namespace enfilade
