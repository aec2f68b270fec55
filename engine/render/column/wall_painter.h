// Walls and steps: which texel does a row of a column show?
#pragma once
#include "render/column/pose.h"
#include "render/column/row_split.h"
#include "render/column/scene.h"
#include "render/column/sector_projection.h"

namespace enfilade::column {

/// One part of a wall (a solid wall, or a step), ready to be drawn column by column.
class WallPainter {
public:
    /// What the next calls of paint() draw.
    /// peg_height: of the texture's anchor above the eye [m]. light: of the sector, 0..1.
    void start(const Scene& scene, const Wall& wall, const Surface& surface, double peg_height, double light,
               SurfaceId id);

    /// Rows [top, bottom) of column x, where the look meets the wall at `hit`.
    void paint(const Scene& scene, int x, int top, int bottom, const WallHit& hit) const;

private:
    const Texture* texture_ = nullptr;
    SurfaceId id_ = kNothing;
    LightModel model_ = LightModel::smooth;
    double light_ = 1, contrast_ = 1;
    double u_per_along_ = 1, u_offset_ = 0;  ///< [tiles]
    double v_at_peg_ = 0, v_per_m_ = 1;      ///< v at the eye's height, and tiles per metre downwards
};

/// The height of a wall texture's anchor above the eye [m]. behind: null for a solid wall, whose opening is its own
/// room.
double peg_height(Peg peg, const RelativeHeights& here, const RelativeHeights* behind);

}  // namespace enfilade::column
