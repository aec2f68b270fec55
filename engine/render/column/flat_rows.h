// What a row of a level flat has whichever column it is in: how far away the flat is there, and how dark.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "render/built_in.h"
#include "render/column/kernels.h"
#include "render/column/sector_projection.h"
#include "render/lighting.h"
#include "render/openings.h"
#include "render/shade.h"

namespace enfilade::column {

/// Fog before a surface: decided once for each surface, so that a map without fog has none in its loops.
struct Fog {
    double reach = 0;         ///< depth at which it hides half; 0: no fog [m]
    FogPart step = 1;         ///< by which it grows [1/256]
    std::uint32_t color = 0;  ///< as a pixel
    bool operator==(const Fog&) const = default;
};

/// The fog of a map; none where this build knows none.
inline Fog fog_of(const Map& map) {
    if (!built_in::kFog || map.render.fog_reach == 0) return {};
    return {map.render.fog_reach, map.render.fog_step, pixel_of(map.render.fog_color)};
}

inline bool is_there(const Fog& fog) { return built_in::kFog && fog.reach > 0; }

/// All that its rows depend on beside the picture's size and look, so that flats with the same key share them.
struct FlatRowsKey {
    double height = 0;  ///< above the eye [m]
    Lighting lighting;
    const ColorTable* color_table = nullptr;  ///< that the flat's picture goes by, if it does
    Fog fog;
    bool operator==(const FlatRowsKey&) const = default;
};

/// depth_on_plane() of the rays of a row [m], 0 where that is behind the eye.
double level_depth(const RayTables& screen, double height, int row);

/// The rows of flats with one key, worked out as they are seen.
class FlatRows {
public:
    /// Forgets all rows.
    void start(const FlatRowsKey& key, const RayTables& screen);

    const FlatRowsKey& key() const { return key_; }

    /// Works out rows [top, bottom), and those between them and the ones that are known. top <= bottom.
    void prepare(const RayTables& screen, int top, int bottom);

    /// Which rows are known.
    OpenRows known() const { return known_; }

    /// Lights rows [top, bottom) as if they were this far away. depths: from row `top` on, [bottom - top] [m].
    void shade(int top, int bottom, const double* depths);

    // By row [height + kRowsBeyond], valid for those that are known.
    const double* depths() const { return depths_.data(); }             ///< [m]
    const std::uint32_t* shades() const { return shades_.data(); }      ///< in both halves of each word
    const std::uint32_t* darkness() const { return darkness_.data(); }  ///< the same as kernels want it
    const FogPart* fog_parts() const { return fog_parts_.data(); }      ///< where there is fog

private:
    void prepare_more(const RayTables& screen, int top, int bottom);

    FlatRowsKey key_;
    Dimming dimming_;
    OpenRows known_;
    std::vector<double> depths_;
    std::vector<std::uint32_t> shades_;
    std::vector<std::uint32_t> darkness_;
    std::vector<FogPart> fog_parts_;
};

/// The rows of the flats of a picture that were seen last: of most rooms several parts are seen, and neighbouring rooms
/// often have floors or ceilings of one height in one light.
class FlatRowsCache {
public:
    /// Another picture is begun: nothing is known.
    void start_frame() { used_ = 0; }

    /// What is known for the key, maybe in place of what was asked for longest ago. Valid until kKept other keys were
    /// asked for.
    FlatRows& of(const FlatRowsKey& key, const RayTables& screen);

private:
    /// 32 flats of which all of 800 rows are seen take 400 KiB, which a core's second-level cache has room for; most
    /// are seen in part.
    static constexpr std::size_t kKept = 32;

    std::array<FlatRows, kKept> rows_;
    std::array<std::uint64_t, kKept> asked_{};  ///< when last
    std::uint64_t now_ = 0;
    std::size_t used_ = 0;
};

}  // namespace enfilade::column
