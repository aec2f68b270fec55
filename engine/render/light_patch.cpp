#include "render/light_patch.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "math/vec.h"
#include "world/snapshot.h"

namespace enfilade {
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
        sectors.push_back(map[opening.portal].sector);
        sectors.push_back(map[opening.portal].behind);
    }
}

namespace {

/// What a surface takes of light that only grazes it [1]. Without it, floors far from a low lamp were black.
constexpr double kGrazing = 1.0 / 3;

/// Numbers for the lots of lights, apart from those of sectors (world/snapshot.h).
constexpr std::uint64_t kLightSeeds = std::uint64_t{1} << 32;

/// What arrives at a place, were nothing in between. normal_way: how far the light is from the surface's plane [m].
double unhindered(double way, double normal_way, double reach) {
    return way < reach ? light_falloff(way, reach) * light_facing(way > 0 ? normal_way / way : 1) : 0;
}

}  // namespace

double light_falloff(double way, double reach) {
    const double left = 1 - way / reach;
    return left > 0 ? left * left : 0;
}

LightBox light_box(double u_low, double u_high, double v_low, double v_high, double per_m) {
    if (!(u_low <= u_high && v_low <= v_high)) return {};
    const auto first = [&](double metres) { return static_cast<int>(std::floor(metres * per_m)); };
    const auto count = [&](double low, double high) {
        return std::max(static_cast<int>(std::ceil(high * per_m)) - first(low) + 1, 2);
    };
    return {first(u_low), count(u_low, u_high), first(v_low), count(v_low, v_high)};
}

LightBox box_around(const LightBox& a, const LightBox& b) {
    if (a.columns == 0 || b.columns == 0) return a.columns == 0 ? b : a;
    const int column = std::min(a.column, b.column), row = std::min(a.row, b.row);
    return {column, std::max(a.column + a.columns, b.column + b.columns) - column, row,
            std::max(a.row + a.rows, b.row + b.rows) - row};
}

double light_facing(double cosine) { return kGrazing + (1 - kGrazing) * std::fabs(cosine); }

LightPatch patch_on(const Map& map, const Snapshot& snapshot, const UprightSurface& surface, const LampOnSurface& lamp,
                    double bottom, double top) {
    const double reach = map.lights[lamp.image.light].reach;
    const Vec2 along = (surface.b - surface.a) * (1 / surface.length);
    const double aside = dot(right_of(along), lamp.image.from - surface.a);
    const double above = std::sqrt(std::max(reach * reach - aside * aside, 0.0));
    const LightBox rows =
        light_box(0, 0, std::max(bottom, lamp.image.z - above), std::min(top, lamp.image.z + above), lamp.per_m);
    LightPatch patch{{lamp.box.column, lamp.box.columns, rows.row, rows.rows}, {}};
    patch.arrives.reserve(static_cast<std::size_t>(patch.box.columns) * static_cast<std::size_t>(rows.rows));
    for (int i = 0; i < patch.box.columns; ++i) {
        const Vec2 place = surface.a + along * ((patch.box.column + i) / lamp.per_m);
        const Vec2 flat_way = place - lamp.image.from;
        for (int j = 0; j < rows.rows; ++j) {
            const double z = (rows.row + j) / lamp.per_m, up = z - lamp.image.z;
            const double free = unhindered(std::sqrt(dot(flat_way, flat_way) + up * up), aside, reach);
            const bool is_lit = free > 0 && lamp.rays.arrives(map, snapshot, lamp.image, static_cast<std::size_t>(i),
                                                              std::clamp(z, bottom, top));
            patch.arrives.push_back(is_lit ? static_cast<float>(free) : 0);
        }
    }
    return patch;
}

LightPatch patch_on(const Map& map, const Snapshot& snapshot, double z, const LampOnSurface& lamp) {
    const double reach = map.lights[lamp.image.light].reach, up = z - lamp.image.z;
    LightPatch patch{lamp.box, {}};
    if (std::fabs(up) >= reach) patch.box = {};
    patch.arrives.reserve(static_cast<std::size_t>(patch.box.columns) * static_cast<std::size_t>(patch.box.rows));
    for (int i = 0; i < patch.box.columns; ++i)
        for (int j = 0; j < patch.box.rows; ++j) {
            const Vec2 place{(patch.box.column + i) / lamp.per_m, (patch.box.row + j) / lamp.per_m};
            const Vec2 flat_way = place - lamp.image.from;
            const double free = unhindered(std::sqrt(dot(flat_way, flat_way) + up * up), up, reach);
            const std::size_t ray = patch.arrives.size();
            const bool is_lit = free > 0 && lamp.rays.arrives(map, snapshot, lamp.image, ray, z);
            patch.arrives.push_back(is_lit ? static_cast<float>(free) : 0);
        }
    return patch;
}

LightPatch patch_at(const Map& map, const Snapshot& snapshot, Vec2 place, double z, const LampOnSurface& lamp) {
    const Vec2 flat_way = place - lamp.image.from;
    const double up = z - lamp.image.z, way = std::sqrt(dot(flat_way, flat_way) + up * up);
    const double free = unhindered(way, way, map.lights[lamp.image.light].reach);
    const bool is_lit = free > 0 && lamp.rays.arrives(map, snapshot, lamp.image, 0, z);
    return {{0, 2, 0, 2}, std::vector<float>(4, is_lit ? static_cast<float>(free) : 0)};
}

LampColor color_of_light(std::uint32_t color, double brightness) {
    const double bright = brightness * 256 * kLightSteps / 255;
    const auto channel = [&](int shift) { return static_cast<float>((color >> shift & 0xFF) * bright); };
    return {channel(16), channel(8), channel(0)};
}

LampColor lamp_color(const Map& map, const Snapshot& snapshot, std::uint32_t number) {
    const PointLight& light = map.lights[number];
    const double time_s = std::max(snapshot.time_s, 0.0);
    const bool changes = light.effect && !snapshot.is_light_still;
    const double level = changes ? level_of(*light.effect, 1, kLightSeeds + number, time_s) : 1;
    return color_of_light(light.color, light.brightness * level);
}

}  // namespace enfilade
