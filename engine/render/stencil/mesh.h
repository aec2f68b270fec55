// Polygons for the graphics card. What a pixel of one shows is computed from the pixel's own place (shaders.cpp), so
// a vertex carries only where it is on the screen and, the same in all vertices of a polygon, what the polygon is.
#pragma once
#include <array>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <vector>

#include "formats/dials.h"
#include "render/stencil/panorama.h"
#include "render/stencil/surfaces.h"
#include "space/triangulate.h"

namespace enfilade::stencil {

struct MeshVertex {
    float x = 0, y = 0;  ///< in the picture, -1..1, y down
    PaintParams params;
};

/// A corner in space (in_space.cpp): x to the right of the eye and y ahead, and how far above it [m]. A vertex of it
/// has what is above in its y, and ahead in the order of its params.
struct SpacePoint {
    Vec2 v;
    double up = 0;
};

/// Indices [begin, end) of a mesh: whole triangles.
struct IndexRange {
    std::size_t begin = 0, end = 0;
    bool is_empty() const { return begin == end; }
};

/// Those that one program draws.
struct KindRange {
    Kind kind = 0;
    IndexRange range;
};

/// All polygons of one frame.
class Mesh {
public:
    void clear();

    /// The part of a wall between two heights above the eye [m]; infinite ones reach the picture's edge. It adds
    /// nothing where there is no such part.
    void add_strip(const RayField& rays, const WallOnScreen& wall, const RelativeHeights& heights,
                   const PaintParams& params);

    /// A convex polygon in space.
    void add_polygon(std::initializer_list<SpacePoint> corners, const PaintParams& params);

    /// All of the picture, without PaintParams. Once for each picture.
    void add_sheet();
    /// The same in space, a metre ahead.
    void add_sheet_in_space(const RayField& rays);
    const IndexRange& sheet() const { return sheet_; }  ///< empty: none was added

    /// Puts the triangles from index `begin` on in the order of their kinds, and says where those of each kind are.
    std::vector<KindRange> sort_by_kind(std::size_t begin);

    /// A kind that can draw all of a range of walls and pictures with holes, which stay in their order.
    KindRange with_holes(const IndexRange& range);

    /// Whether a range of that kind was asked for.
    bool has(Kind kind) const { return has_[kind]; }

    std::size_t index_count() const { return indices_.size(); }
    const std::vector<MeshVertex>& vertices() const { return vertices_; }
    const std::vector<std::uint32_t>& indices() const { return indices_; }

private:
    void add_half(const RayField& rays, const WallOnScreen& wall, const RelativeHeights& heights,
                  const PaintParams& params, double up);
    void add_outline(const RayField& rays, const PaintParams& params);

    std::vector<MeshVertex> vertices_;
    std::vector<std::uint32_t> indices_;
    std::array<bool, kKinds> has_{};
    IndexRange sheet_;
    std::array<std::vector<std::uint32_t>, kKinds> sorted_;  ///< while they are put in order
    Outline outline_;
};

// The polygons of one frame, layer by layer.

/// Where one layer's polygons are in the mesh.
struct LayerRanges {
    std::vector<KindRange> surfaces;  ///< what hides everything behind it
    std::vector<IndexRange> exits;    ///< by Layer::exits: the portal's opening
    KindRange panes;                  ///< farthest first
};

/// Adds the polygons of all layers to the mesh. Cost: the walls of the layers' sectors.
std::vector<LayerRanges> build_mesh(Mesh& mesh, const DrawInput& scene, const Plan& plan);

// What most engines do that draw portals by the graphics card, as a dial (formats/dials.h): walls and flats as polygons
// in space, told apart by a depth buffer, and what lies behind a portal cut off there.
//
// It is here to be measured. Layers, pictures and light are those of the exact way (stencil_renderer.h), and each pixel
// works out its texel in the same way; only what a pixel belongs to is left to the card: its rounding of corners to
// 1/256 pixel, its depths, and its plane or its near plane, which is moved into the portal's (Eric Lengyel, "Oblique
// View Frustum Depth Projection and Clipping", 2005).

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
