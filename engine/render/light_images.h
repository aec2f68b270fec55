// Where point lights shine: which sectors each reaches, and from where it seems to shine there.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "map/map.h"

namespace enfilade {

/// A light as one sector sees it: in its own place, or through a link, somewhere else.
struct LightImage {
    std::uint32_t light = 0;  ///< index into Map::lights
    Rigid passage;            ///< from the space of the light's sector into that of this one
    Vec2 from;                ///< where it seems to be, on the point grid
    double z = 0;             ///< [m]
};

/// All of them, by sector.
class LightImages {
public:
    LightImages() = default;

    /// A light is in every sector that a disc as wide as its reach overlaps (space/reach.h), whatever the heights; in
    /// one that it reaches by two ways that put it at different places, twice.
    /// Cost: the walls of the sectors reached.
    explicit LightImages(const Map& map);

    std::span<const LightImage> in(SectorId sector) const {
        if (first_.empty()) return {};
        return std::span(images_).subspan(first_[sector.index], first_[sector.index + 1] - first_[sector.index]);
    }

private:
    std::vector<LightImage> images_;
    std::vector<std::uint32_t> first_;  ///< those of sector i are images_[first_[i]] to images_[first_[i + 1]]
};

/// Images of one light nearer to each other than this are one: links that lead round a pillar agree but for rounding
/// [m].
inline constexpr double kSameImage = 0x1p-10;

inline bool is_same_place(Vec2 p, Vec2 q) { return dot(p - q, p - q) < kSameImage * kSameImage; }

}  // namespace enfilade
