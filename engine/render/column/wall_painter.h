// Walls, steps and pictures of things: which texel does a row of a column show?
#pragma once
#include "render/column/scene.h"
#include "render/column/viewport.h"
#include "render/lighting.h"
#include "render/view.h"

namespace enfilade::column {

/// One part of a wall (a solid wall, or a step), ready to be drawn column by column.
class WallPainter {
public:
    /// What the next calls of paint() draw.
    /// peg_height: of the texture's anchor above the eye [m]. light: of the sector, 0..1.
    void start(const ColumnScene& scene, const Wall& wall, const Surface& surface, double peg_height, double light,
               PixelSurface id);

    /// Point lights on it, too. grid: null: none, which is so after each start. eye_z: height of the eye [m].
    void light_up(const LightGrid* grid, double length, double eye_z);

    /// The same for a panel. top: above the eye [m].
    void start_panel(const ColumnScene& scene, const Panel& panel, double top, double light, PixelSurface id);

    /// The same for a thing's picture, which is shown once: a hit is `along` it from its left edge.
    /// top: above the eye [m]. height: [m].
    void start_picture(const ColumnScene& scene, const Texture& texture, double top, double height,
                       const Lighting& lighting, PixelSurface id);

    /// Shows its picture once from top to bottom, as start_picture() does, instead of over and over.
    void show_once() { is_once_ = true; }

    /// Rows [tops[i], bottoms[i]) of the columns that look at the wall.
    void paint(const ColumnScene& scene, const WallLooks& looks, const int* tops, const int* bottoms) const;

    /// The same for a picture with holes, laid over what is there already.
    void lay_over(const ColumnScene& scene, int x, int top, int bottom, const WallHit& hit) const;

private:
    /// Where on the picture the rows of some columns are, and how dark they are there.
    struct Placed {
        std::uint32_t first_texels[WallLooks::kMost];
        TileSteps v_at_row_0[WallLooks::kMost], v_per_row[WallLooks::kMost];
        Shade shades[WallLooks::kMost];
    };
    /// The same of one column, as numbers.
    struct ColumnTexels {
        double u, v_at_row_0, v_per_row;  ///< [tiles]
    };
    ColumnTexels texels_at(const ColumnScene& scene, const WallHit& hit) const;
    bool is_near(const ColumnScene& scene, double farthest) const;
    void place(const ColumnScene& scene, const double* depths, const double* along, int count, Placed& placed) const;
    void place_one(const ColumnTexels& at, double depth, Placed& placed, int i) const;
    PlainWalls walls_at(const ColumnRuns& runs, const Placed& placed, int i) const;
    void fill(const ColumnScene& scene, const ColumnRuns& runs, Placed& placed, const double* depths,
              const double* along) const;
    void fill_lit(const ColumnScene& scene, const ColumnRuns& runs, Placed& placed, const double* depths,
                  const double* along) const;
    void light(const ColumnScene& scene, PlainWalls wall, Shade shade, const WallHit& hit) const;
    double across_at(const WallHit& hit) const;
    bool is_dark_at(const WallHit& hit) const;
    void add_fog(const ColumnScene& scene, const Run& run, double depth) const;
    void note_column(const ColumnScene& scene, int x, int top, int bottom, const WallHit& hit) const;
    WallLamplight lamplight_at(const ColumnScene& scene, int top, int bottom, Shade shade, const WallHit& hit) const;
    void hang(const ColumnScene& scene, const Surface& surface, double length, double peg);
    int end_of_picture(const ColumnTexels& at, int top, int bottom) const;
    void lay_rows(const ColumnScene& scene, int x, OpenRows rows, const ColumnTexels& at, const WallHit& hit) const;
    void shade_by(const ColumnScene& scene, const Lighting& lighting);

    const Texture* texture_ = nullptr;
    const ColorTable* color_table_ = nullptr;  ///< that it goes by, if it does
    PixelSurface id_ = kNothing;
    Dimming dimming_;
    Fog fog_;
    double u_per_along_ = 1, u_offset_ = 0;  ///< [tiles]
    double v_at_peg_ = 0, v_per_m_ = 1;      ///< v at the eye's height, and tiles per metre downwards
    bool is_once_ = false;
    const LightGrid* light_grid_ = nullptr;  ///< of point lights
    double length_ = 0, eye_z_ = 0;          ///< [m]; where there is a grid
};

/// The height of a wall texture's anchor above the eye [m]. behind: null for a solid wall, whose opening is its own
/// room.
double peg_height(Peg peg, const RelativeHeights& here, const RelativeHeights* behind);

}  // namespace enfilade::column
