// What a polygon shows, as the graphics card is told.
#pragma once
#include <cstddef>
#include <cstdint>

namespace enfilade::stencil {

/// How a polygon's pixels are painted; numbers known to the shader.
enum class Paint : std::uint32_t { wall, flat, sky, color, picture };

/// Beside the paint: the surface is in classic light; else in smooth. Known to the shader, too.
inline constexpr std::uint32_t kClassicLight = 1u << 31;
/// Beside the paint: the picture goes by the map's color table. Known to the shader, too.
inline constexpr std::uint32_t kByTable = 1u << 30;

/// Beside the paint: layers are laid over the floor or ceiling; its record begins with them.
inline constexpr std::uint32_t kLayered = 1u << 29;

/// Numbers that change evenly over the picture are given as three: at the point `from`, per column and per row.
struct PaintParams {
    float from[2]{}, cross = 0;
    float order = 0;                  ///< the nearer the larger
    float span[3]{};                  ///< depth = cross / span
    float nearest = 0, farthest = 0;  ///< bounds of that depth [m]
    float light = 1, contrast = 1;
    float a[4]{};  ///< by Paint, see shaders.cpp
    float b[4]{};
    float c[4]{};
    std::uint32_t id_and_paint = 0;    ///< id in the low 24 bits; kClassicLight, kByTable
    std::uint32_t texels = 0;          ///< where the picture begins in the texel store; Paint::color: 0xAABBGGRR
    std::uint32_t size = 1 | 1 << 16;  ///< of the picture (texel_store.h)
    std::uint32_t record = 0;          ///< what it needs beyond this (texel_store.h); 0: nothing
    float left_edge[3]{1, 0, 0}, right_edge[3]{-1, 0, 0};  ///< tilted: shown where left >= 0 > right; from the corner
};

/// Which program draws a surface: chosen once for each, so that what it does not use is in no pixel's way (graphics
/// cards that draw many pixels in step take all branches of a program). A set of what the program can draw:
using Kind = std::uint8_t;
inline constexpr Kind kFlats = 1, kSkies = 2, kColors = 3;  ///< one of these, or none: walls and pictures
inline constexpr Kind kWithRecords = 4;                     ///< light of lamps, or a sky's layers
inline constexpr Kind kGoingByTable = 8;                    ///< and others
inline constexpr Kind kInSmoothLight = 16, kInClassicLight = 32;
inline constexpr Kind kWithHoles = 64;    ///< pixels that are not there, or hide only a part
inline constexpr Kind kWithLayers = 128;  ///< over floors and ceilings
inline constexpr std::size_t kKinds = 256;

inline Kind paints(Kind kind) { return kind & kColors; }

inline Kind kind_of(const PaintParams& params) {
    constexpr Kind kByPaint[] = {0, kFlats, kSkies, kColors, 0};
    const Kind paint = kByPaint[params.id_and_paint >> 24 & 7];
    Kind kind = paint;
    if (params.record != 0) kind |= kWithRecords;
    if ((params.id_and_paint & kByTable) != 0) kind |= kGoingByTable;
    if ((params.id_and_paint & kLayered) != 0) kind |= kWithLayers;
    const bool is_lit = paint == 0 || paint == kFlats;
    if (is_lit) kind |= (params.id_and_paint & kClassicLight) != 0 ? kInClassicLight : kInSmoothLight;
    return kind;
}

}  // namespace enfilade::stencil
