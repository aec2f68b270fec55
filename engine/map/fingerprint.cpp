// A number by which a map is told from another, so that what was worked out from one is never taken for the other's.
#include "base/hash.h"
#include "map/draft.h"

namespace enfilade {
namespace {

void add(Hash& hash, Vec2 point) {
    hash.add(point.x);
    hash.add(point.y);
}

void add(Hash& hash, const Wall& wall) {
    add(hash, wall.a);
    hash.add(wall.sector.index);
    hash.add(static_cast<std::uint32_t>(wall.kind));
    hash.add(wall.behind.index);
    hash.add(wall.exit.index);
    hash.add(wall.link);
}

void add(Hash& hash, const Rigid& link) {
    for (const double number : {link.c, link.s, link.flip, link.rise}) hash.add(number);
    add(hash, link.shift);
}

void add(Hash& hash, const Sector& sector) {
    hash.add(sector.floor.sky);
    hash.add(sector.ceiling.sky);
    hash.add(sector.sun.index);
}

void add(Hash& hash, const Panel& panel) {
    add(hash, panel.a);
    add(hash, panel.b);
    hash.add(panel.sector.index);
    hash.add(panel.bottom);
    hash.add(panel.top);
}

void add(Hash& hash, const Thing& thing) {
    add(hash, thing.position);
    hash.add(thing.sector.index);
    hash.add(thing.height);
}

void add(Hash& hash, const PointLight& light) {
    add(hash, light.position);
    hash.add(light.sector.index);
    hash.add(light.z);
    hash.add(light.reach);
}

void add(Hash& hash, const Sun& sun) {
    add(hash, sun.level);
    hash.add(sun.up);
    hash.add(sun.color);
    hash.add(sun.brightness);
}

template <class Parts>
void add_all(Hash& hash, const Parts& parts) {
    hash.add(parts.size());
    for (const auto& part : parts) add(hash, part);
}

}  // namespace

void take_fingerprint(Draft& draft) {
    Map& map = draft.map;
    Hash hash;
    add_all(hash, map.walls);
    add_all(hash, map.links);
    add_all(hash, map.sectors);
    add_all(hash, map.panels);
    add_all(hash, map.things);
    add_all(hash, map.lights);
    add_all(hash, map.suns);
    map.fingerprint = hash.value();
}

}  // namespace enfilade
