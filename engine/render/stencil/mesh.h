// Polygons for the graphics card. What a pixel of one shows is computed from the pixel's own place (shaders.cpp), so
// a vertex carries only where it is on the screen and, the same in all vertices of a polygon, what the polygon is.
#pragma once
#include <array>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "render/stencil/panorama.h"
#include "render/stencil/surfaces.h"

namespace enfilade::stencil {

struct MeshVertex {
    float x = 0, y = 0;  ///< in the picture, -1..1, y down
    PaintParams params;
};

/// A corner in space (in_space.h): x to the right of the eye and y ahead, and how far above it [m]. A vertex of it has
/// what is above in its y, and ahead in the order of its params.
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

}  // namespace enfilade::stencil
