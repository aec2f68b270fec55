// Polygons for the graphics card. What a pixel of one shows is computed from the pixel's own place (shaders.cpp), so
// a vertex carries only where it is on the screen and, the same in all vertices of a polygon, what the polygon is.
#pragma once
#include <cstdint>
#include <vector>

#include "map/textures.h"
#include "render/stencil/wall_on_screen.h"
#include "render/surface_id.h"

namespace enfilade::stencil {

/// How a polygon's pixels are painted; numbers known to the shader.
enum class Paint : std::uint32_t { wall, flat, sky, color, picture };

/// What a polygon shows. `t` is a pixel's column counted from from_px.
struct Look {
    float from_px = 0, cross = 0, span[2]{};  ///< depth = cross / (span[0] + span[1] t)
    float nearest = 0, farthest = 0;          ///< bounds of that depth [m]
    float light = 1, contrast = 1;
    float a[4]{};  ///< by Paint, see shaders.cpp
    float b[4]{};
    std::uint32_t id_and_paint = 0;       ///< id in the low 24 bits
    std::uint32_t texels = 0;             ///< where the picture begins in the texel store; Paint::color: 0xAABBGGRR
    std::uint32_t width = 1, height = 1;  ///< of the picture [px]
};

struct Vertex {
    float x = 0, y = 0;  ///< in the picture, -1..1, y down
    Look look;
};

/// Indices [begin, end) of a mesh: whole triangles.
struct Range {
    std::size_t begin = 0, end = 0;
    bool is_empty() const { return begin == end; }
};

/// All polygons of one frame.
class Mesh {
public:
    void clear();

    /// The part of a wall between two heights above the eye [m]; infinite ones reach the picture's edge. It adds
    /// nothing where there is no such part.
    void add_strip(const Screen& screen, const WallOnScreen& wall, double floor, double ceiling, const Look& look);

    std::size_t index_count() const { return indices_.size(); }
    const std::vector<Vertex>& vertices() const { return vertices_; }
    const std::vector<std::uint32_t>& indices() const { return indices_; }

private:
    struct Corner {
        double x, y;
    };
    void clip(double edge_y, double keep);

    std::vector<Vertex> vertices_;
    std::vector<std::uint32_t> indices_;
    std::vector<Corner> corners_, clipped_;
};

}  // namespace enfilade::stencil
