// The programs of the graphics card.
#pragma once
#include "base/result.h"
#include "render/stencil/gl_object.h"
#include "render/stencil/surfaces.h"

namespace enfilade::stencil {

/// How the vertices of a picture's polygons are put into it.
enum class VertexPlacing : std::uint8_t {
    upright,   ///< they are where they are drawn
    tilted,    ///< the same, and each pixel asks which wall it shows
    in_space,  ///< they are in space (in_space.h)
};
inline constexpr std::size_t kVertexPlacings = 3;

/// Where points in space are told how they are placed (SpaceLens).
struct LensUniforms {
    GLint picture = -1, depth_row = -1, clip = -1;
};

/// Draws surfaces: colours to output 0, facts (id, depth, texel) to output 1.
struct SurfaceProgram {
    GlProgram program;
    GLint entry = -1, entry_span = -1;  ///< of the layer: the doorway one looks in through, see shaders.cpp
    GLint level = -1;                   ///< a point at or near the horizon [px]
    GLint climb = -1;                   ///< what the ray climbs there, per column, per row
    GLint is_sky_round = -1;            ///< its rows are
    GLint fog = -1;                     ///< its colour and reach
    GLint least_alpha = -1;             ///< with holes: pixels of a picture with less are left out, 1..255
    GLint texels = -1;
    GLint records = -1;                          ///< where there is more to know than PaintParams
    GLint color_numbers = -1, color_table = -1;  ///< where pictures may go by one
    LensUniforms lens;
};

/// Draws only depth: for masks.
struct MaskProgram {
    GlProgram program;
    LensUniforms lens;
};

/// Compile them for the current context. An error says what the driver said.
Result<void> build(SurfaceProgram& surface, Kind kind, VertexPlacing placing);
Result<void> build(MaskProgram& mask, VertexPlacing placing);

// What the graphics card is told to do, in OpenGL's shading language; put together by shaders.cpp.
//
// A program has the parts that were defined for it, and nothing else: TILTED pictures, or polygons IN_SPACE; surfaces
// that are WALLS, FLATS, SKIES or COLORS, in SMOOTH or CLASSIC light or either, LIT by lamps, BY_TABLE of colours,
// WITH_HOLES; LAYERED_SKY; WITH_RECORDS where LIT or LAYERED_SKY.

extern const char* const kVertexShader;

/// What the shaders of surfaces and of masks begin with.
extern const char* const kWallDepth;

extern const char* const kSurfaceShader;
extern const char* const kMaskShader;

}  // namespace enfilade::stencil
