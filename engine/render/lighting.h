// How light falls on a surface, shared by all renderers: that of its room, of a sun, and of lamps.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/parallel.h"
#include "map/map.h"
#include "math/predicates.h"
#include "render/light_patch.h"
#include "render/shade.h"

namespace enfilade {

// How the light of a room falls on a surface of it, shared by all renderers: chosen once for each surface.

// The light of one surface at many depths: shade_at() with all that does not depend on the depth worked out before.

inline constexpr double kFarthest = 1e9;  ///< stands for an infinite depth, which times 0 would be no number [m]

/// shade_at() of one surface, made ready for many depths.
class Dimming {
public:
    Dimming() = default;
    Dimming(LightModel model, double light, double contrast);

    Shade at(double depth) const { return model_ == LightModel::classic ? classic(depth) : smooth(depth); }

    /// shades[i] of depths[i]; both [count].
    void at_all(const double* depths, int count, Shade* shades) const;

private:
    Shade classic(double depth) const;
    Shade smooth(double depth) const;

    LightModel model_ = LightModel::smooth;
    int dark_levels_ = 0;       ///< classic: where nothing is won back
    double per_metre_ = 0;      ///< smooth: 1 / reach; 0 at full light
    double brightest_ = kFull;  ///< smooth: at depth 0

    static constexpr double kFull = 256;
    static constexpr int kClassicLevels = 32;         ///< COLORMAP's levels from full to black
    static constexpr double kClassicDepth = 40;       ///< levels won back at 1 m: 1280 map units / 32
    static constexpr double kClassicNearest = 23;     ///< most levels that are won back, as for Doom's walls
    static constexpr double kClassicTouching = 0.01;  ///< nearer than this counts as this [m]
};

inline Shade Dimming::classic(double depth) const {
    const double touching = depth > kClassicTouching ? depth : kClassicTouching;
    const double won = on_nearest_step(kClassicDepth / touching);
    const int level = dark_levels_ - static_cast<int>(won < kClassicNearest ? won : kClassicNearest);
    const int seen = level > 0 ? (level < kClassicLevels ? level : kClassicLevels - 1) : 0;
    return static_cast<Shade>((kClassicLevels - seen) * (static_cast<int>(kFull) / kClassicLevels));
}

inline Shade Dimming::smooth(double depth) const {
    const double nearness = per_metre_ * (depth < kFarthest ? depth : kFarthest);
    return static_cast<Shade>(static_cast<int>(brightest_ * (1 / (1 + nearness * nearness)) + 0.5));
}

/// What shade_at() asks of a surface.
struct Lighting {
    LightModel model = LightModel::smooth;
    double light = 1;     ///< 0..1
    double contrast = 1;  ///< as Wall::contrast
    bool operator==(const Lighting&) const = default;
};

/// Of a surface in a sector that has this light, 0..1. contrast: Wall::contrast, 1 for flats and things.
inline Lighting lighting_in(const Map& map, SectorId sector, double light, double contrast) {
    if (!map[sector].unlit) return {map.render.light, light, contrast};
    // Full smooth light does not fall off; what contrast leaves of it is then all that is left of the colours.
    return {LightModel::smooth, 1, std::clamp(light, 0.0, 1.0)};
}

inline Dimming dimming_of(const Lighting& lighting) { return {lighting.model, lighting.light, lighting.contrast}; }

/// depth: >= 0 [m], infinity allowed.
inline Shade shade_at(const Lighting& lighting, double depth) {
    return shade_at(lighting.model, lighting.light, lighting.contrast, depth);
}

// What a sector's sun adds to the light of its surfaces: worked out once for each, the same all over it.

/// Of the sector's sun, as much as falls on what takes `part` of it, 0..1. None where it has no sun.
inline LampColor sunlight(const Map& map, SectorId sector, double part) {
    if (!map[sector].sun || part <= 0) return {};
    const Sun& sun = map[map[sector].sun];
    return color_of_light(sun.color, sun.brightness * part);
}

/// By the angle between the way to the sun and the wall's normal; none on what faces away.
inline LampColor sunlight_on(const Map& map, const Wall& wall) {
    if (!map[wall.sector].sun) return {};
    return sunlight(map, wall.sector, dot(right_of(wall.b - wall.a), map[map[wall.sector].sun].level) / wall.length);
}

/// Panels are so thin that both sides have the light of either.
inline LampColor sunlight_on(const Map& map, const Panel& panel) {
    if (!map[panel.sector].sun) return {};
    const Vec2 to_sun = map[map[panel.sector].sun].level;
    return sunlight(map, panel.sector, std::fabs(dot(right_of(panel.b - panel.a), to_sun)) / panel.length);
}

/// By the sun's elevation.
inline LampColor sunlight_on_floor(const Map& map, SectorId sector) {
    return map[sector].sun ? sunlight(map, sector, map[map[sector].sun].up) : LampColor{};
}

/// A picture that faces whoever looks takes all of it, as it does of lamps.
inline LampColor sunlight_on(const Map& map, const Thing& thing) { return sunlight(map, thing.sector, 1); }

/// A grid with the sun added everywhere; of an empty one, a grid that has nothing else. The same where there is no sun.
LightGrid in_sun(LightGrid grid, const LampColor& sun);

// The light of all point lights on the surfaces of a map, worked out when somebody looks at a surface, and kept.
//
// A surface's grid is a function of the map and the snapshot alone: of the heights of the rooms that light passes on
// its way, and of the colours its lights have at that moment. What depends on neither, which light comes which way to
// which place, is found once.

/// Grids of one map at one moment after another. Several threads may ask at the same time, about the same moment. A map
/// without lights and suns costs nothing: no memory, no time.
class LightGrids {
public:
    /// Nothing is worked out yet. The map outlives this. points_per_m: 1..kMostLightPoints.
    explicit LightGrids(const Map& map, int points_per_m = kUsualLightPoints);

    /// These, or null: the map has no lights and no suns, so there is nothing to ask for.
    LightGrids* where_lit() { return memos_.empty() ? nullptr : this; }

    // What falls on a surface, or null: nothing, as on a sky. Valid until another moment is asked about.
    // Cost: of the first look at a surface, a look for each point that a light's reach covers; when
    // something moves on the way of its light, a comparison for each; else one for each sector on the way.

    const LightGrid* on_wall(const Snapshot& snapshot, WallId wall);
    const LightGrid* on_panel(const Snapshot& snapshot, PanelId panel);
    const LightGrid* on_floor(const Snapshot& snapshot, SectorId sector);
    const LightGrid* on_ceiling(const Snapshot& snapshot, SectorId sector);
    /// The same everywhere on the thing's picture: what arrives in the middle of its body.
    const LightGrid* on_thing(const Snapshot& snapshot, ThingId thing);

private:
    /// A wall, a panel, a thing, or a sector's floor and ceiling.
    struct Memo {
        Lock lock;
        bool is_new = true;
        double per_m = 0;  ///< points along a metre
        std::vector<LampOnSurface> lamps;
        std::vector<SectorId> sectors;       ///< whose heights count
        std::vector<double> heights;         ///< of the moment that patches are of [m]
        std::vector<LampColor> colors;       ///< of the moment that grids are of
        std::vector<LightPatch> patches[2];  ///< by lamp; of a sector: floor, ceiling
        LightGrid grids[2];
    };

    const LightGrid* on_flat(const Snapshot& snapshot, SectorId sector, int side);
    Memo& memo(std::size_t number);
    template <class Make>
    void note_lamps(std::span<const LightImage> images, Make make, Memo& memo) const;
    void note_sectors(SectorId home, Memo& memo) const;
    static bool heights_changed(const Snapshot& snapshot, Memo& memo, double own_height);
    bool colors_changed(const Snapshot& snapshot, Memo& memo) const;
    using Suns = std::array<LampColor, 2>;  ///< that falls on each side of a memo
    template <class Make, class Patch>
    const LightGrid* grid(const Snapshot& snapshot, std::size_t number, SectorId home, int side, double own_height,
                          const Suns& suns, Make make, Patch patch);

    const Map& map_;
    double per_m_;
    Lock lock_;
    LightImages images_;
    std::vector<std::unique_ptr<Memo>> memos_;  ///< of walls, then panels, things, sectors
};

}  // namespace enfilade
