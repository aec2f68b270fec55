#include "render/light_patch.h"

#include <algorithm>
#include <cmath>

#include "math/vec.h"
#include "render/shade.h"
#include "space/reach.h"

namespace enfilade {
namespace {

struct Reached {
    SectorId sector;
    LightImage image;
};

/// What leads to any place that a light reaches, at most.
struct WayCost {
    double rooms = 0;  ///< that a ray passes
    double work = 0;   ///< of finding the ray [walls]
};

/// What a room on the way of a ray costs beside its walls: the portal into it is remembered [walls].
constexpr double kRoomWork = 8;

/// What looking for a place inside costs of each wall of a room: it is compared three times [walls].
constexpr double kPlaceWork = 3;

/// What a point of a surface's grid costs: the sum of all that falls on it is kept [walls].
constexpr double kPointWork = 8;

/// Of one grid [points].
constexpr double kMostPoints = kMostGridArea * kUsualLightPoints * kUsualLightPoints;

/// A rectangle of a surface [m], and how many points of a grid it holds.
struct LitBox {
    Vec2 min{INFINITY, INFINITY}, max{-INFINITY, -INFINITY};

    bool is_empty() const { return !(min.x <= max.x && min.y <= max.y); }
    double columns() const { return (max.x - min.x) * kUsualLightPoints + 2; }
    double points() const { return is_empty() ? 0 : columns() * ((max.y - min.y) * kUsualLightPoints + 2); }
    void include(const LitBox& box) {
        if (box.is_empty()) return;
        min = {std::min(min.x, box.min.x), std::min(min.y, box.min.y)};
        max = {std::max(max.x, box.max.x), std::max(max.y, box.max.y)};
    }
};

LitBox common(const LitBox& a, const LitBox& b) {
    return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
            {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}

/// The images that were found, and what they cost.
class LightSearch {
public:
    explicit LightSearch(const Map& map) : map_(map), lit_(map.sectors.size()) {
        for (const Thing& thing : map.things) ++lit_[thing.sector.index].things;
    }

    /// False: there is more of it than may be spent.
    bool add(std::uint32_t number) {
        const PointLight& light = map_.lights[number];
        const std::size_t first = all.size();
        const Reach reached = reach(map_, {light.sector, light.position}, light.reach);
        work += static_cast<double>(reached.walls_looked_at);
        const WayCost way = longest_way(reached);
        for (const ReachedSector& there : reached.sectors) {
            const LightImage image{number, there.passage, snap_to_point_grid(there.passage.apply(light.position)),
                                   there.passage.apply_height(light.z)};
            work += static_cast<double>(all.size() - first);
            if (is_known(first, {there.sector, image})) continue;
            work += work_of(there.sector, image, way);
            if (work > kMostLightWork) return false;
            all.push_back({there.sector, image});
        }
        return true;
    }

    std::vector<Reached> all;
    double work = 0;

private:
    struct LitSector {
        double things = 0;
        std::vector<LitBox> surfaces;  ///< what images light of the flats, each wall and each panel; empty: none does
    };

    bool is_known(std::size_t first, const Reached& reached) const {
        return std::any_of(all.begin() + static_cast<std::ptrdiff_t>(first), all.end(), [&](const Reached& other) {
            return other.sector == reached.sector && is_same_place(other.image.from, reached.image.from) &&
                   other.image.z == reached.image.z;
        });
    }

    static WayCost longest_way(const Reach& reached) {
        WayCost longest;
        for (const ReachedSector& there : reached.sectors) {
            longest.rooms = std::max<double>(longest.rooms, there.rooms_on_way);
            longest.work = std::max<double>(longest.work, there.walls_on_way + kRoomWork * there.rooms_on_way);
        }
        return longest;
    }

    double work_of(SectorId id, const LightImage& image, const WayCost& way) {
        const Sector& sector = map_[id];
        LitSector& lit = lit_[id.index];
        lit.surfaces.resize(1 + sector.wall_count + sector.panel_count);
        auto surface = lit.surfaces.begin();
        const double reach = map_.lights[image.light].reach;
        const Vec2 most{reach, reach};
        const LitBox flats = common({sector.min, sector.max}, {image.from - most, image.from + most});
        // A place is looked for near each point, among all walls, before a ray leads there.
        double sum = (flats.points() + lit.things) * (way.work + kPlaceWork * sector.wall_count);
        sum += sum_work(*surface++, flats, 2);
        for (std::uint32_t i = 0; i < sector.wall_count; ++i)
            sum += work_on(map_.walls[sector.first_wall + i], image, way, *surface++);
        for (std::uint32_t i = 0; i < sector.panel_count; ++i)
            sum += work_on(map_.panels[sector.first_panel + i], image, way, *surface++);
        return sum;
    }

    /// Of what stands upright: a ray to each column, along which each portal on the way is compared for each point.
    template <class Upright>
    double work_on(const Upright& upright, const LightImage& image, const WayCost& way, LitBox& lit) {
        const Vec2 along = (upright.b - upright.a) * (1 / upright.length), to_light = image.from - upright.a;
        const double reach = map_.lights[image.light].reach, aside = dot(right_of(along), to_light);
        const double half = std::sqrt(std::max(reach * reach - aside * aside, 0.0)), before = dot(along, to_light);
        const LitBox part{{std::max(before - half, 0.0), image.z - half},
                          {std::min(before + half, upright.length), image.z + half}};
        if (half == 0 || part.is_empty()) return 1;
        return 1 + part.columns() * way.work + part.points() * way.rooms + sum_work(lit, part, 1);
    }

    /// Of one more part of a surface: each of its points, and what the grid of all parts grows by.
    static double sum_work(LitBox& lit, const LitBox& part, double grids) {
        const double before = lit.points();
        lit.include(part);
        return kPointWork * grids * (part.points() + std::max(std::min(lit.points(), kMostPoints) - before, 0.0));
    }

    const Map& map_;
    std::vector<LitSector> lit_;
};

}  // namespace

LightImages::LightImages(const Map& map) {
    if (map.lights.empty()) return;
    LightSearch search(map);
    for (std::uint32_t i = 0; i < map.lights.size() && !left_out_; ++i)
        if (!search.add(i)) left_out_ = i;
    std::vector<Reached>& all = search.all;
    std::stable_sort(all.begin(), all.end(), [](const Reached& a, const Reached& b) { return a.sector < b.sector; });
    first_.assign(map.sectors.size() + 1, 0);
    for (const Reached& reached : all) {
        images_.push_back(reached.image);
        ++first_[reached.sector.index + 1];
    }
    for (std::size_t i = 0; i < map.sectors.size(); ++i) first_[i + 1] += first_[i];
    work_ = search.work;
}

// The ways from a light's image to places on the surfaces around it.

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

}  // namespace enfilade
