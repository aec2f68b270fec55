// Point lights: where they shine, by which ways their light comes to a surface, and what arrives of each: a number at
// each point of a part of the surface's grid.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "map/map.h"
#include "render/shade.h"
#include "space/trace.h"
#include "world/snapshot.h"

namespace enfilade {

// Where point lights shine: which sectors each reaches, and from where it seems to shine there.

/// A light as one sector sees it: in its own place, or through a link, somewhere else.
struct LightImage {
    std::uint32_t light = 0;  ///< index into Map::lights
    Rigid passage;            ///< from the space of the light's sector into that of this one
    Vec2 from;                ///< where it seems to be, on the point grid
    double z = 0;             ///< [m]
};

/// What all images together may cost whoever looks at all they light: a second and 512 MiB [walls compared with a ray,
/// or what takes as long]. Of the shipped maps none takes a sixth of it; rooms of thousands of walls do.
inline constexpr double kMostLightWork = 0x1p30;

/// All of them, by sector.
class LightImages {
public:
    LightImages() = default;

    /// A light is in every sector that a disc as wide as its reach overlaps (space/reach.h), whatever the heights; in
    /// one that it reaches by two ways that put it at different places, twice. Lights come in the order of the map,
    /// until kMostLightWork is spent: what comes after that lights nothing.
    /// Cost: the walls of the sectors reached, up to kMostLightWork.
    explicit LightImages(const Map& map);

    std::span<const LightImage> in(SectorId sector) const {
        if (first_.empty()) return {};
        return std::span(images_).subspan(first_[sector.index], first_[sector.index + 1] - first_[sector.index]);
    }

    /// The first light that lights less than it reaches, as an index into Map::lights; none: all shine everywhere.
    std::optional<std::uint32_t> left_out() const { return left_out_; }

    /// What all images together cost [as kMostLightWork].
    double work() const { return work_; }

private:
    std::vector<LightImage> images_;
    std::vector<std::uint32_t> first_;  ///< those of sector i are images_[first_[i]] to images_[first_[i + 1]]
    std::optional<std::uint32_t> left_out_;
    double work_ = 0;
};

/// Images of one light nearer to each other than this are one: links that lead round a pillar agree but for rounding
/// [m].
inline constexpr double kSameImage = 0x1p-10;

inline bool is_same_place(Vec2 p, Vec2 q) { return dot(p - q, p - q) < kSameImage * kSameImage; }

// The ways from a point light to places on the surfaces around it: found once, as nothing moves in the plane, and then
// asked at any heights.

/// Where a way is to end.
struct LightSpot {
    SectorId sector;
    Vec2 place;   ///< in the sector, or on the wall
    WallId wall;  ///< of the sector: the way must come to it from inside; none: it must end inside the sector
};

/// Ways from one light's image in one sector to spots of that sector.
class LightRays {
public:
    /// The way to the spot becomes number count(). Cost: that of look_along().
    void add(const Map& map, const LightImage& image, const LightSpot& spot);

    /// A way that leads nowhere: it is not needed.
    void add_none() { rays_.push_back({}); }

    std::size_t count() const { return rays_.size(); }

    /// Whether the light comes through at the heights of the moment: it is in its room, and every portal on the way is
    /// open where the straight way from it to height z passes. Where both sides are under the sky, there is nothing
    /// above. z: of the spot, in its sector's space [m].
    bool arrives(const Map& map, const Snapshot& snapshot, const LightImage& image, std::size_t ray, double z) const;

    /// Adds the sectors whose heights the answers depend on, the spots' own among them, each any number of times.
    void add_sectors(const Map& map, std::vector<SectorId>& sectors) const;

private:
    struct PortalOnRay {
        WallId portal;
        double at;           ///< part of the way before it
        double rise;         ///< from heights of the light's sector to those of the portal's [m]
        double rise_behind;  ///< and to those of the sector behind it [m]
    };
    struct LightRay {
        std::uint32_t first = 0, count = 0;  ///< of openings_
        bool is_straight = false;            ///< there is a way
    };

    std::vector<LightRay> rays_;
    std::vector<PortalOnRay> openings_;
    SightLine line_;  ///< scratch
};

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
/// empty. per_m: points along a metre.
LightBox light_box(double u_low, double u_high, double v_low, double v_high, double per_m);

/// Around both; a box without columns counts as none.
LightBox box_around(const LightBox& a, const LightBox& b);

/// What arrives at each point of a box, 0..1, by column.
struct LightPatch {
    LightBox box;
    std::vector<float> arrives;
};

/// A light whose image reaches a surface.
struct LampOnSurface {
    LightImage image;
    double per_m = kUsualLightPoints;  ///< points along a metre
    LightBox box;    ///< that it reaches, whatever the heights of the room; of a wall: rays by columns
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
LampOnSurface lamp_on(const Map& map, const UprightSurface& surface, const LightImage& image, double per_m);
/// The same for the floor and the ceiling of a sector.
LampOnSurface lamp_on(const Map& map, SectorId sector, const LightImage& image, double per_m);
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
LightGrid sum_of(std::span<const LightPatch> patches, std::span<const LampColor> colors, double per_m);

}  // namespace enfilade
