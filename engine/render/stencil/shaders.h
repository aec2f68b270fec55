// The programs of the graphics card.
#pragma once
#include "base/result.h"
#include "render/stencil/gl_object.h"
#include "render/stencil/paint_params.h"

namespace enfilade::stencil {

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
};

/// Draws only depth: for masks.
struct MaskProgram {
    GlProgram program;
};

/// Compile them for the current context, for upright or tilted pictures. An error says what the driver said.
Result<void> build(SurfaceProgram& surface, Kind kind, bool is_tilted);
Result<void> build(MaskProgram& mask, bool is_tilted);

// What the graphics card is told to do, in OpenGL's shading language; put together by shaders.cpp.
//
// A program has the parts that were defined for it, and nothing else: TILTED pictures; surfaces that are WALLS, FLATS,
// SKIES or COLORS, in SMOOTH or CLASSIC light or either, LIT by lamps, BY_TABLE of colours, WITH_HOLES; LAYERED_SKY;
// WITH_RECORDS where LIT or LAYERED_SKY.

extern const char* const kVertexShader;

/// What the shaders of surfaces and of masks begin with.
extern const char* const kWallDepth;

extern const char* const kSurfaceShader;
extern const char* const kMaskShader;

}  // namespace enfilade::stencil
