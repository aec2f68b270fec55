// What most engines do that draw portals by the graphics card, as a dial (formats/dials.h): walls and flats as polygons
// in space, told apart by a depth buffer, and what lies behind a portal cut off there.
//
// It is here to be measured. Layers, pictures and light are those of the exact way (stencil_renderer.h), and each pixel
// works out its texel in the same way; only what a pixel belongs to is left to the card: its rounding of corners to
// 1/256 pixel, its depths, and its plane or its near plane, which is moved into the portal's (Eric Lengyel, "Oblique
// View Frustum Depth Projection and Clipping", 2005).
#pragma once
#include <array>
#include <map>
#include <vector>

#include "formats/dials.h"
#include "render/stencil/mesh.h"
#include "space/triangulate.h"

namespace enfilade::stencil {

/// What is nearer to the eye of the first layer, or of any that is cut off by a plane, is drawn as near as this [m].
inline constexpr double kNearPlane = 0.01;

/// How a layer's points in space, right of the eye, above it and ahead [m], become places in the picture and depths:
/// the nearer the larger.
struct SpaceLens {
    std::array<float, 4> picture{};         ///< per right, per ahead of the columns, per up, per ahead of the rows
    std::array<float, 4> depth_row{};       ///< of right, up, ahead and 1
    std::array<float, 4> clip{0, 0, 0, 1};  ///< the same; kept is what is positive
    bool clips_at_near_plane = false;       ///< else what is nearer is as near
};

constexpr bool has_24_bits(PortalMethod method) {
    return method == PortalMethod::plane24 || method == PortalMethod::oblique24;
}
constexpr bool is_oblique(PortalMethod method) {
    return method == PortalMethod::oblique24 || method == PortalMethod::oblique32;
}

/// Of a layer. Depths of 24 bits go from -1 to 1, as OpenGL wants them. As floats they go from 0 to 1, since what is
/// far away is only finer near 0; then the card is told so (glClipControl).
SpaceLens lens_of(const Layer& layer, const RayField& rays, PortalMethod method);

/// Sectors as triangles, each cut when it is asked for the first time.
class Ground {
public:
    const std::vector<Triangle>& of(const Map& map, SectorId sector);

private:
    std::map<std::uint32_t, std::vector<Triangle>> triangles_;
};

/// As build_mesh(), in space: whole sectors, whatever of them the layers show. Not tilted.
std::vector<LayerRanges> build_mesh_in_space(Mesh& mesh, const DrawInput& scene, const Plan& plan, Ground& ground);

}  // namespace enfilade::stencil
