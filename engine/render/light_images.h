// Where point lights shine: which sectors each reaches, and from where it seems to shine there.
#pragma once
#include <cstdint>
#include <optional>
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

}  // namespace enfilade
