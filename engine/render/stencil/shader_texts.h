// What the graphics card is told to do, in OpenGL's shading language; put together by shaders.cpp.
//
// A program has the parts that were defined for it, and nothing else: TILTED pictures; surfaces that are WALLS, FLATS,
// SKIES or COLORS, in SMOOTH or CLASSIC light or either, LIT by lamps, BY_TABLE of colours, WITH_HOLES; LAYERED_SKY;
// WITH_RECORDS where LIT or LAYERED_SKY.
#pragma once

namespace enfilade::stencil {

extern const char* const kVertexShader;

/// What the shaders of surfaces and of masks begin with.
extern const char* const kWallDepth;

extern const char* const kSurfaceShader;
extern const char* const kMaskShader;

}  // namespace enfilade::stencil
