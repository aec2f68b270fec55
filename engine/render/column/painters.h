// Which texel does a row of a column show? Of walls, steps and pictures of things, and of floors, ceilings and skies.
#pragma once
#include <optional>
#include <vector>

#include "render/column/flat_rows.h"
#include "render/column/scene.h"
#include "render/column/texel_dials.h"
#include "render/column/viewport.h"
#include "render/lighting.h"
#include "render/sprite.h"
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

    /// The same for a picture with holes, laid over what is there already. The wall of the looks may be
    /// null, and their inverse depths may be anything.
    void lay_over(const ColumnScene& scene, const WallLooks& looks, const int* tops, const int* bottoms) const;

private:
    /// Where on the picture the rows of some columns are, and how dark they are there.
    struct Placed {
        const Texture* texture;
        std::uint32_t first_texels[WallLooks::kMost];
        TileSteps v_at_row_0[WallLooks::kMost], v_per_row[WallLooks::kMost];
        Shade shades[WallLooks::kMost];
    };
    /// The same of one column, as numbers.
    struct ColumnTexels {
        double u, v_at_row_0, v_per_row;  ///< [tiles]
    };
    /// Neighbouring columns that are drawn alike, by dials.
    struct AlikeColumns {
        ColumnGroup columns;
        ColumnTexels at;
        MipPlace mip;
    };
    /// Some columns with one picture, by dials.
    struct DialledColumns;
    ColumnTexels texels_at(const ColumnScene& scene, const WallHit& hit) const;
    /// What some columns look at, exactly.
    struct ExactColumns;
    bool may_any_be_alike(const ColumnScene& scene, const WallLooks& looks) const;
    void paint_by_dials(const ColumnScene& scene, const WallLooks& looks, const int* tops, const int* bottoms) const;
    void fill_by_dials(const ColumnScene& scene, const ColumnRuns& runs, DialledColumns& dialled,
                       const WallLooks& looks, int first) const;
    ColumnTexels texels_in_span(const ColumnScene& scene, const ExactColumns& exact, int x) const;
    bool may_be_alike(const ColumnScene& scene, const ExactColumns& exact, ColumnGroup columns) const;
    AlikeColumns alike_at(const ColumnScene& scene, const ExactColumns& exact, int x) const;
    MipPlace mip_at(const ColumnScene& scene, const ExactColumns& exact, int x) const;
    ColumnTexels in_numbers(const ColumnScene& scene, const ExactColumns& exact, int x, const ColumnTexels& at) const;
    ColumnTexels by_vanilla(const ColumnScene& scene, const ExactColumns& exact, int x) const;
    bool is_near(const ColumnScene& scene, double farthest) const;
    void place(const ColumnScene& scene, const WallLooks& looks, int first, int end, Placed& placed) const;
    void place_near(const ColumnScene& scene, const double* depths, const double* along, int count,
                    Placed& placed) const;
    void place_one(const ColumnTexels& at, double depth, Placed& placed, int i) const;
    PlainWalls walls_at(const ColumnRuns& runs, const Placed& placed, int i) const;
    void fill(const ColumnScene& scene, const ColumnRuns& runs, Placed& placed, const double* depths,
              const double* along) const;
    void fill_blended(const ColumnScene& scene, const WallBlend& blend, const ColumnRuns& runs, Placed& placed,
                      const double* depths, const double* along) const;
    template <class Texels>
    void fill_lit(const ColumnScene& scene, const Texels& texels, const ColumnRuns& runs, Placed& placed,
                  const double* depths, const double* along) const;
    double across_at(const WallHit& hit) const;
    bool is_dark_at(const WallHit& hit) const;
    void add_fog(const ColumnScene& scene, const Run& run, double depth) const;
    void note_column(const ColumnScene& scene, int x, OpenRows rows, double depth, const ColumnTexels& at) const;
    WallLamplight lamplight_at(const ColumnScene& scene, int top, int bottom, Shade shade, const WallHit& hit) const;
    void hang(const ColumnScene& scene, const Surface& surface, double length, double peg);
    int end_of_picture(const ColumnTexels& at, int top, int bottom) const;
    void lay_plain(const ColumnScene& scene, const WallLooks& looks, const int* tops, const int* bottoms) const;
    void lay_column(const ColumnScene& scene, int x, OpenRows rows, const ColumnTexels& at, const WallHit& hit) const;
    void note_laid(const ColumnScene& scene, int x, OpenRows rows, const ColumnTexels& at, double depth) const;
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

// Floors, ceilings and skies.

enum class FlatSide : unsigned char { floor, ceiling };

/// Draws one flat of one viewport, some columns at a time. What depends on the row alone (depth and light of a level
/// plane) is worked out once for all columns, for those rows that are really seen.
class FlatPainter {
public:
    /// What the next calls of paint() draw. height: of the flat above the eye [m]. lamplight: of point lights; null:
    /// none.
    void start(const ColumnScene& scene, const Pose& pose, const FlatNow& flat, FlatSide side, double height,
               const Lighting& lighting, const LightGrid* lamplight, PixelSurface id);

    /// Rows [tops[i], bottoms[i]) of the columns that look at a wall: nothing of the flat is farther than that.
    void paint(const ColumnScene& scene, const WallLooks& looks, const int* tops, const int* bottoms);

private:
    /// How a picture lies on the flat: its own, or a layer over it.
    struct LevelPicture {
        const Texture* texture = nullptr;
        const ColorTable* color_table = nullptr;  ///< that it goes by, if it does
        Vec2 tile_m;
        double base_u = 0, base_v = 0;  ///< tile position under the eye, in [0, 1)
        double near_limit = 0;          ///< up to here all positions are below kNearTiles [m]
        bool is_exact = false;          ///< whatever the dials say
    };
    /// How a row is drawn by dials.
    struct RowDials {
        int held = 1;   ///< columns that are drawn alike
        int level = 0;  ///< as MipChains::at
        bool operator==(const RowDials&) const = default;
    };
    /// What rows that are drawn as one are drawn from, by dials.
    struct TexelSource {
        int first_column;
        int level;     ///< as MipChains::at
        bool is_near;  ///< no position is farther than kNearTiles
    };
    /// One column of the flat.
    struct FlatColumn {
        int x;
        Vec2 ray;         ///< per metre of depth
        double farthest;  ///< where the wall behind it stands [m]
        OpenRows rows;
    };
    /// Where it is drawn, and in which light.
    struct LevelTarget {
        std::uint32_t* row_0;
        const std::uint32_t* darkness;  ///< by row, as the picture wants it
    };
    LevelPicture picture_of(const ColumnScene& scene, const Surface& surface) const;
    void start_layers(const ColumnScene& scene);
    void start_rows(const ColumnScene& scene, const Lighting& lighting);
    /// Tiles per metre of depth along the rays of some columns.
    struct FlatSteps {
        double u[WallLooks::kMost], v[WallLooks::kMost];
    };
    static OpenRows rows_of_any(const ColumnScene& scene, const WallLooks& looks, const int* tops, const int* bottoms);
    void find_steps(const ColumnScene& scene, const WallLooks& looks, FlatSteps& steps) const;
    PlainFlats flats_at(const ColumnScene& scene, const WallLooks& looks, const FlatSteps& steps, const int* tops,
                        const int* bottoms) const;
    void paint_plain(const ColumnScene& scene, const WallLooks& looks, const int* tops, const int* bottoms);
    void paint_plainly_lit(const ColumnScene& scene, const WallLooks& looks, const int* tops, const int* bottoms);
    void add_fog(const ColumnScene& scene, int x, OpenRows rows) const;
    void note_level(const ColumnScene& scene, const FlatColumn& column, bool is_alike) const;
    void note_plain(const ColumnScene& scene, const WallLooks& looks, const int* tops, const int* bottoms) const;
    TexelPosition drawn_at(const ColumnScene& scene, const FlatColumn& column, int row, bool is_alike) const;
    Vec2 steps_at(const ColumnScene& scene, int x, int held) const;
    int end_of_alike_rows(int row, int end) const;
    bool is_exact_in(const ColumnScene& scene, int top, int bottom) const;
    void start_dials(const ColumnScene& scene);
    RowDials dials_at(const ColumnScene& scene, double depth) const;
    TexelPosition by_vanilla(const ColumnScene& scene, int x, int row) const;
    MipPlace mip_at(const ColumnScene& scene, double depth) const;
    void fill_texels(const ColumnScene& scene, PlainFlats flats, const TexelSource& from) const;
    double depth_in_span(const ColumnScene& scene, int row) const;
    void prepare_dials(const ColumnScene& scene, OpenRows rows);
    void paint_by_dials(const ColumnScene& scene, const WallLooks& looks, const int* tops, const int* bottoms) const;
    void paint_alike(const ColumnScene& scene, const WallLooks& looks, const ColumnRuns& runs, RowDials dials) const;
    void fill_by_dials(const ColumnScene& scene, const LevelPicture& picture, const FlatColumn& column,
                       const LevelTarget& to) const;
    FlatColumn column_at(const ColumnScene& scene, int x, OpenRows rows, double wall_depth) const;
    void paint_level(const ColumnScene& scene, const FlatColumn& column);
    void paint_picture(const ColumnScene& scene, const LevelPicture& picture, const FlatColumn& column,
                       const LevelTarget& to) const;
    template <class Draw>
    void with_flats(const LevelPicture& picture, const FlatColumn& column, const LevelTarget& to, Draw draw) const;
    void fill(const ColumnScene& scene, const LevelPicture& picture, const FlatColumn& column,
              const LevelTarget& to) const;
    void read(const ColumnScene& scene, const LevelPicture& picture, const FlatColumn& column,
              const LevelTarget& to) const;
    void paint_lit(const ColumnScene& scene, const LevelPicture& picture, const FlatColumn& column,
                   const LevelTarget& to) const;
    bool goes_one_way(const OpenRows& rows) const;
    void paint_lit_one_way(const ColumnScene& scene, const LevelPicture& picture, const FlatColumn& column,
                           const LevelTarget& to) const;
    void lay_layer(const ColumnScene& scene, const LevelPicture& layer, const FlatColumn& column);
    FlatLamplight lamplight_at(const FlatColumn& column) const;
    OpenRows lit_rows(const FlatLamplight& lamplight, const OpenRows& rows) const;
    void paint_sky(const ColumnScene& scene, int x, int top, int bottom);
    /// One column of a sky.
    struct SkyColumn {
        double turn;          ///< which way it looks [1]
        double rise_per_row;  ///< as rows of the sky lie
    };
    SkyRun sky_run(const ColumnScene& scene, const Surface& surface, const SkyColumn& column) const;
    void prepare_rows(const ColumnScene& scene, int top, int bottom);
    void shade_extended_rows(int top, int bottom, double wall_depth);

    const Pose* pose_ = nullptr;
    FlatNow flat_;
    LevelPicture picture_;                    ///< of a floor or ceiling
    std::vector<LevelPicture> level_layers_;  ///< over it, the farthest first
    std::vector<Surface> sky_layers_;         ///< over a sky, the farthest first
    PixelSurface id_ = kNothing;
    double height_ = 0;
    bool is_plain_ = false;  ///< nothing but its picture and its light: no sky, layers, fog, lamps, or view from the
                             ///< wrong side
    bool is_plainly_lit_ = false;  ///< its picture, which has no table, in its light and that of lamps, maybe in fog
    const LightGrid* lamplight_ = nullptr;
    Fog fog_;
    bool is_extended_ = false;  ///< a floor not below the eye, or a ceiling not above it
    /// Of its height and light. Shared ones stay while a viewport is drawn, in which only its floor and its ceiling ask
    /// for some.
    FlatRows* rows_ = nullptr;
    FlatRows own_rows_;                          ///< where the rows of each column have another light, or dials
    std::vector<std::uint32_t> layer_darkness_;  ///< the same for a layer, of its column's rows
    std::vector<std::uint32_t> full_light_;      ///< the same of rows as painted; where there are lamps
    bool is_dialled_ = false;
    std::vector<double> texel_depths_;  ///< by row, as FlatRows::depths: of which texels are; where dials say so
    std::vector<RowDials> row_dials_;   ///< where there are dials
    std::vector<std::uint32_t> row_mip_parts_;  ///< of the way to the next smaller picture, likewise
    std::optional<VanillaFlat> vanilla_;        ///< where dials want its positions
    double texels_across_ = 0;                  ///< per metre of depth, from a column to the next
    double texels_down_ = 0;                    ///< per square metre of depth, from a row to the next
};

}  // namespace enfilade::column
