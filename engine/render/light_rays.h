// The ways from a point light to places on the surfaces around it: found once, as nothing moves in the plane, and then
// asked at any heights.
#pragma once
#include <vector>

#include "render/light_images.h"
#include "space/sight_line.h"
#include "world/snapshot.h"

namespace enfilade {

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

    /// Adds the sectors whose heights the answers depend on, the spots' own among them.
    void add_sectors(const Map& map, std::vector<SectorId>& sectors) const;

private:
    struct Opening {
        WallId portal;
        double at;           ///< part of the way before it
        double rise;         ///< from heights of the light's sector to those of the portal's [m]
        double rise_behind;  ///< and to those of the sector behind it [m]
    };
    struct Ray {
        std::uint32_t first = 0, count = 0;  ///< of openings_
        bool is_straight = false;            ///< there is a way
    };

    std::vector<Ray> rays_;
    std::vector<Opening> openings_;
    SightLine line_;  ///< scratch
};

}  // namespace enfilade
