#include "render/light_rays.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "math/vec.h"
#include "space/reach.h"

namespace enfilade {

namespace {

struct Reached {
    SectorId sector;
    LightImage image;
};

bool is_known(const std::vector<Reached>& all, std::size_t first, const Reached& reached) {
    return std::any_of(all.begin() + static_cast<std::ptrdiff_t>(first), all.end(), [&](const Reached& other) {
        return other.sector == reached.sector && is_same_place(other.image.from, reached.image.from) &&
               other.image.z == reached.image.z;
    });
}

void add_light(const Map& map, std::uint32_t number, std::vector<Reached>& all) {
    const PointLight& light = map.lights[number];
    const std::size_t first = all.size();
    for (const ReachedSector& there : reach(map, {light.sector, light.position}, light.reach).sectors) {
        const LightImage image{number, there.passage, snap_to_point_grid(there.passage.apply(light.position)),
                               there.passage.apply_height(light.z)};
        if (!is_known(all, first, {there.sector, image})) all.push_back({there.sector, image});
    }
}

}  // namespace

LightImages::LightImages(const Map& map) {
    std::vector<Reached> all;
    for (std::size_t i = 0; i < map.lights.size(); ++i) add_light(map, static_cast<std::uint32_t>(i), all);
    std::stable_sort(all.begin(), all.end(), [](const Reached& a, const Reached& b) { return a.sector < b.sector; });
    first_.assign(map.sectors.size() + 1, 0);
    for (const Reached& reached : all) {
        images_.push_back(reached.image);
        ++first_[reached.sector.index + 1];
    }
    for (std::size_t i = 0; i < map.sectors.size(); ++i) first_[i + 1] += first_[i];
}

namespace {

/// How far behind a wall one aims to be sure to meet it [m].
constexpr double kBeyond = 1.0 / 64;

/// How many portals are on the way to the spot; none: the way does not lead there.
std::optional<std::size_t> portals_before(const SightLine& line, const LightImage& image, const LightSpot& spot) {
    if (!spot.wall) {
        const bool is_there = !line.met && line.sector == spot.sector && is_same_place(line.from, image.from);
        return is_there ? std::optional(line.passed.size()) : std::nullopt;
    }
    for (std::size_t i = 0; i < line.passed.size(); ++i)
        if (line.passed[i].portal == spot.wall && is_same_place(line.passed[i].from, image.from)) return i;
    return line.met == spot.wall && is_same_place(line.from, image.from) ? std::optional(line.passed.size())
                                                                         : std::nullopt;
}

/// Between two rooms, at a height of the light's sector.
bool is_open_at(const Map& map, const Snapshot& snapshot, const Wall& portal, double rise, double rise_behind,
                double z) {
    const Heights here = heights_at(snapshot, portal.sector), behind = heights_at(snapshot, portal.behind);
    if (z + rise < here.floor_z || z + rise_behind < behind.floor_z) return false;
    if (map[portal.sector].ceiling.sky && map[portal.behind].ceiling.sky) return true;
    return z + rise < here.ceiling_z && z + rise_behind < behind.ceiling_z;
}

}  // namespace

void LightRays::add(const Map& map, const LightImage& image, const LightSpot& spot) {
    const PointLight& light = map.lights[image.light];
    rays_.push_back({});
    const Vec2 way = spot.place - image.from;
    const double length = std::sqrt(dot(way, way));
    if (spot.wall && !(length > 0)) return;
    const double longer = spot.wall ? 1 + kBeyond / length : 1;
    const Vec2 to = snap_to_point_grid(inverse(image.passage).apply(image.from + way * longer));
    look_along(map, {light.sector, light.position}, to, line_);
    const std::optional<std::size_t> portals = portals_before(line_, image, spot);
    if (!portals) return;
    rays_.back() = {static_cast<std::uint32_t>(openings_.size()), static_cast<std::uint32_t>(*portals), true};
    for (std::size_t i = 0; i < *portals; ++i) {
        const PassedPortal& passed = line_.passed[i];
        openings_.push_back(
            {passed.portal, passed.at * longer, passed.rise, passed.rise + map.passage(map[passed.portal]).rise});
    }
}

bool LightRays::arrives(const Map& map, const Snapshot& snapshot, const LightImage& image, std::size_t number,
                        double z) const {
    const LightRay& ray = rays_[number];
    if (!ray.is_straight) return false;
    const PointLight& light = map.lights[image.light];
    const Heights home = heights_at(snapshot, light.sector);
    if (light.z < home.floor_z || light.z > home.ceiling_z) return false;
    const double climb = z - image.z;
    for (std::size_t i = ray.first; i < std::size_t{ray.first} + ray.count; ++i) {
        const PortalOnRay& opening = openings_[i];
        const double height = light.z + climb * opening.at;
        if (!is_open_at(map, snapshot, map[opening.portal], opening.rise, opening.rise_behind, height)) return false;
    }
    return true;
}

void LightRays::add_sectors(const Map& map, std::vector<SectorId>& sectors) const {
    for (const PortalOnRay& opening : openings_) {
        for (const SectorId sector : {map[opening.portal].sector, map[opening.portal].behind})
            if (std::find(sectors.begin(), sectors.end(), sector) == sectors.end()) sectors.push_back(sector);
    }
}

}  // namespace enfilade
