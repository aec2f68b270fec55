#include "render/reference/cast_ray.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "math/predicates.h"
#include "render/lighting.h"

namespace enfilade {
namespace {

/// What a surface takes of light that only grazes it, as the manual has it [1].
constexpr double kTakenGrazing = 1.0 / 3;

/// Of the lamp at `way` metres, `normal_way` of them off the surface's plane, 0..1.
double part_arriving(double way, double normal_way, double reach) {
    if (way >= reach) return 0;
    const double left = 1 - way / reach, squareness = way > 0 ? std::fabs(normal_way) / way : 1;
    return left * left * (kTakenGrazing + (1 - kTakenGrazing) * squareness);
}

std::uint32_t lane_of(double light) {
    return static_cast<std::uint32_t>(std::lround(std::min(light, static_cast<double>(kMostLight))));
}

/// A lamp that shines at one place by several chains of links, turned in several ways, is one lamp.
bool is_counted(const std::vector<SeenLamp>& lamps, const std::vector<std::size_t>& lit, const SeenLamp& lamp) {
    return std::any_of(lit.begin(), lit.end(), [&](std::size_t i) {
        const Vec2 apart = lamps[i].place - lamp.place;
        return lamps[i].lamp == lamp.lamp && dot(apart, apart) < kSameLampPlace * kSameLampPlace &&
               std::fabs(lamps[i].z - lamp.z) < kSameLampPlace;
    });
}

/// How far a place is off the line a -> b, to its right [m].
double aside(Vec2 a, Vec2 b, double length, Vec2 p) { return exact_cross(a, b, p) / length; }

}  // namespace

OwnLight::OwnLight(const Map& map, const Snapshot& snapshot) : map_(map), snapshot_(snapshot), seen_(seen_lamps(map)) {
    for (std::uint32_t i = 0; i < map.lights.size(); ++i) colors_.push_back(lamp_color(map, snapshot, i));
}

/// normal_way(place): how far a lamp there is off the surface's plane [m]; none: the surface turns its back on it.
template <class NormalWay>
LightCell OwnLight::sum_at(const LitPlace& at, const LampColor& sun, NormalWay normal_way) const {
    const std::vector<SeenLamp>& lamps = seen_[at.sector.index];
    std::vector<std::size_t> lit;
    double red = static_cast<double>(sun.red), green = static_cast<double>(sun.green),
           blue = static_cast<double>(sun.blue);
    for (std::size_t i = 0; i < lamps.size(); ++i) {
        const SeenLamp& lamp = lamps[i];
        const Vec2 flat_way = at.place - lamp.place;
        const double up = at.z - lamp.z, way = std::sqrt(dot(flat_way, flat_way) + up * up);
        const std::optional<double> off = normal_way(lamp, way);
        const double part = off ? part_arriving(way, *off, map_.lights[lamp.lamp].reach) : 0;
        if (part == 0 || is_counted(lamps, lit, lamp) || !is_lit(map_, snapshot_, lamp, at)) continue;
        lit.push_back(i);
        red += part * static_cast<double>(colors_[lamp.lamp].red);
        green += part * static_cast<double>(colors_[lamp.lamp].green);
        blue += part * static_cast<double>(colors_[lamp.lamp].blue);
    }
    return light_cell(lane_of(red), lane_of(green), lane_of(blue));
}

LightCell OwnLight::on_wall(WallId id, double along, double z) const {
    const Wall& wall = map_[id];
    const LitPlace at{wall.sector, wall.a + (wall.b - wall.a) * (along / wall.length), z, id};
    return sum_at(at, sunlight_on(map_, wall), [&](const SeenLamp& lamp, double) -> std::optional<double> {
        if (side_of_line(wall.a, wall.b, lamp.place) < 0) return {};
        return aside(wall.a, wall.b, wall.length, lamp.place);
    });
}

LightCell OwnLight::on_panel(PanelId id, double along, double z) const {
    const Panel& panel = map_[id];
    const LitPlace at{panel.sector, panel.a + (panel.b - panel.a) * (along / panel.length), z, {}};
    return sum_at(at, sunlight_on(map_, panel), [&](const SeenLamp& lamp, double) -> std::optional<double> {
        return aside(panel.a, panel.b, panel.length, lamp.place);
    });
}

LightCell OwnLight::on_floor(SectorId sector, Vec2 place) const {
    return on_flat({sector, place, heights_at(snapshot_, sector).floor_z, {}}, sunlight_on_floor(map_, sector));
}

LightCell OwnLight::on_ceiling(SectorId sector, Vec2 place) const {
    return on_flat({sector, place, heights_at(snapshot_, sector).ceiling_z, {}}, {});
}

LightCell OwnLight::on_flat(const LitPlace& at, const LampColor& sun) const {
    return sum_at(at, sun, [&](const SeenLamp& lamp, double) -> std::optional<double> { return at.z - lamp.z; });
}

LightCell OwnLight::on_thing(ThingId id) const {
    const Thing& thing = map_[id];
    const double z = thing_at(map_, snapshot_, id).z + thing.height / 2;
    return sum_at({thing.sector, thing.position, z, {}}, sunlight_on(map_, thing),
                  [](const SeenLamp&, double way) -> std::optional<double> { return way; });
}

namespace {

LightCell light_in(const LightGrid* grid, double u, double v) { return grid ? light_on(*grid, u, v) : 0; }

}  // namespace

LightCell Lamplight::on_wall(WallId wall, double along, double z) const {
    if (!grids_) return 0;
    return own_ ? own_->on_wall(wall, along, z) : light_in(grids_->on_wall(*snapshot_, wall), along, z);
}

LightCell Lamplight::on_panel(PanelId panel, double along, double z) const {
    if (!grids_) return 0;
    return own_ ? own_->on_panel(panel, along, z) : light_in(grids_->on_panel(*snapshot_, panel), along, z);
}

LightCell Lamplight::on_floor(SectorId sector, Vec2 place) const {
    if (!grids_) return 0;
    return own_ ? own_->on_floor(sector, place) : light_in(grids_->on_floor(*snapshot_, sector), place.x, place.y);
}

LightCell Lamplight::on_ceiling(SectorId sector, Vec2 place) const {
    if (!grids_) return 0;
    return own_ ? own_->on_ceiling(sector, place) : light_in(grids_->on_ceiling(*snapshot_, sector), place.x, place.y);
}

LightCell Lamplight::on_thing(ThingId thing) const {
    if (!grids_) return 0;
    return own_ ? own_->on_thing(thing) : light_in(grids_->on_thing(*snapshot_, thing), 0, 0);
}

}  // namespace enfilade
