// What arrives of one point light on one surface: a number at each point of a part of the surface's grid.
#pragma once
#include <span>
#include <vector>

#include "render/light_grid.h"
#include "render/light_rays.h"

namespace enfilade {

/// How much of a light arrives after `way` metres, 0..1: (1 - way / reach)^2, and nothing beyond.
double light_falloff(double way, double reach);

/// How much of it a surface takes: all where it comes squarely, a third where it only grazes. cosine: of the angle
/// between the light and the surface's normal, -1..1.
double light_facing(double cosine);

/// Points [column, column + columns) x [row, row + rows) of a surface's grid, counted from where u and v are 0.
struct LightBox {
    int column = 0, columns = 0;
    int row = 0, rows = 0;
};

/// The points around a rectangle of a surface, at least two each way, as one looks between them; none where it is
/// empty.
LightBox light_box(double u_low, double u_high, double v_low, double v_high);

/// What arrives at each point of a box, 0..1, by column.
struct LightPatch {
    LightBox box;
    std::vector<float> arrives;
};

/// A light whose image reaches a surface.
struct LampOnSurface {
    LightImage image;
    LightBox box;    ///< of a flat: all of it; of a wall: its columns
    LightRays rays;  ///< one for each point of a flat, or each column of a wall
};

/// An upright surface, a wall or a panel: u is metres along it from a, v is the height.
struct UprightSurface {
    SectorId sector;
    WallId wall;  ///< none: a panel
    Vec2 a, b;
    double length = 0;  ///< [m]
};

/// Where of the surface the light may be seen from, and the ways there. Empty columns: nowhere.
LampOnSurface lamp_on(const Map& map, const UprightSurface& surface, const LightImage& image);
/// The same for the floor and the ceiling of a sector.
LampOnSurface lamp_on(const Map& map, SectorId sector, const LightImage& image);
/// The same for a single place in a sector.
LampOnSurface lamp_on(const Map& map, SectorId sector, Vec2 place, const LightImage& image);

/// What arrives on it at the heights of the moment. Of an upright surface only between two heights is asked [m].
LightPatch patch_on(const Map& map, const Snapshot& snapshot, const UprightSurface& surface, const LampOnSurface& lamp,
                    double bottom, double top);
/// On a level surface at height z.
LightPatch patch_on(const Map& map, const Snapshot& snapshot, double z, const LampOnSurface& lamp);
/// At a single place at height z, whichever way it faces.
LightPatch patch_at(const Map& map, const Snapshot& snapshot, Vec2 place, double z, const LampOnSurface& lamp);

/// A light's colour at the moment, each channel in LightCell's units.
struct LampColor {
    float red = 0, green = 0, blue = 0;
    bool operator==(const LampColor&) const = default;
};

/// color: 0xRRGGBB. brightness: 1 is as much as full light.
LampColor color_of_light(std::uint32_t color, double brightness);

/// Of the light with its effect: a function of the snapshot's time.
LampColor lamp_color(const Map& map, const Snapshot& snapshot, std::uint32_t light);

/// The sum of patches, each in its light's colour, cut down to where it is bright enough to be seen and a rim around
/// it. Empty (columns == 0) where nothing of it is seen.
LightGrid sum_of(std::span<const LightPatch> patches, std::span<const LampColor> colors);

}  // namespace enfilade
