// Floors, ceilings and skies: which texel does a row of a column show?
#pragma once
#include <vector>

#include "render/column/kernels.h"
#include "render/column/scene.h"
#include "render/lighting.h"
#include "render/pose.h"

namespace enfilade::column {

enum class FlatSide : unsigned char { floor, ceiling };

/// Draws one flat of one viewport, column by column. What depends on the row alone (depth and light of a level plane)
/// is worked out once for all columns, for those rows that are really seen.
class FlatPainter {
public:
    /// What the next calls of paint() draw. height: of the flat above the eye [m]. glow: of point lights; null: none.
    void start(const Scene& scene, const Pose& pose, const Flat& flat, FlatSide side, double height,
               const Lighting& lighting, const LightGrid* glow, SurfaceId id);

    /// Rows [top, bottom) of column x. wall_depth: of the wall behind, nothing of the flat is farther [m].
    void paint(const Scene& scene, int x, int top, int bottom, double wall_depth);

private:
    void paint_level(const Scene& scene, int x, int top, int bottom, double wall_depth);
    void fill_rich(const Run& run, const FlatRun& flat, Vec2 ray) const;
    void paint_sky(const Scene& scene, int x, int top, int bottom);
    SkyRun sky_run(const Scene& scene, const Surface& surface, Vec2 ray) const;
    void prepare_rows(const Scene& scene, int top, int bottom);
    void prepare_row(const Scene& scene, int row);
    void shade_row(int row, double depth);
    void shade_extended_rows(int top, int bottom, double wall_depth);

    const Pose* pose_ = nullptr;
    Flat flat_;
    std::vector<Surface> layers_;  ///< over a sky, the farthest first
    const Texture* texture_ = nullptr;
    const ColorTable* color_table_ = nullptr;  ///< that it goes by, if it does
    SurfaceId id_ = kNothing;
    double height_ = 0;
    Lighting lighting_;
    const LightGrid* glow_ = nullptr;
    Fog fog_;
    bool is_extended_ = false;        ///< a floor not below the eye, or a ceiling not above it
    double base_u_ = 0, base_v_ = 0;  ///< tile position under the eye, in [0, 1)
    std::vector<double> row_depths_;  ///< valid for rows [prepared_top_, prepared_bottom_)
    std::vector<Shade> row_shades_;
    std::vector<Mist> row_mists_;  ///< where there is fog
    int prepared_top_ = 0, prepared_bottom_ = 0;
};

}  // namespace enfilade::column
