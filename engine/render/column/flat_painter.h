// Floors, ceilings and skies: which texel does a row of a column show?
#pragma once
#include <vector>

#include "render/column/scene.h"
#include "render/column/viewport.h"
#include "render/lighting.h"
#include "render/sprite.h"
#include "render/view.h"

namespace enfilade::column {

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
    void paint_plain(const ColumnScene& scene, const WallLooks& looks, const int* tops, const int* bottoms);
    void note_level(const ColumnScene& scene, int x, int top, int bottom, double wall_depth) const;
    FlatColumn column_at(const ColumnScene& scene, int x, OpenRows rows, double wall_depth) const;
    void paint_level(const ColumnScene& scene, const FlatColumn& column);
    void paint_picture(const ColumnScene& scene, const LevelPicture& picture, const FlatColumn& column,
                       const LevelTarget& to) const;
    template <class Draw>
    void with_flats(const LevelPicture& picture, const FlatColumn& column, const LevelTarget& to, Draw draw) const;
    void fill(const ColumnScene& scene, const LevelPicture& picture, const FlatColumn& column,
              const LevelTarget& to) const;
    void paint_lit(const ColumnScene& scene, const LevelPicture& picture, const FlatColumn& column,
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
    void prepare_more_rows(const ColumnScene& scene, int top, int bottom);
    void shade_rows(int top, int bottom, const double* depths);
    void shade_extended_rows(int top, int bottom, double wall_depth);

    const Pose* pose_ = nullptr;
    FlatNow flat_;
    LevelPicture picture_;                    ///< of a floor or ceiling
    std::vector<LevelPicture> level_layers_;  ///< over it, the farthest first
    std::vector<Surface> sky_layers_;         ///< over a sky, the farthest first
    PixelSurface id_ = kNothing;
    double height_ = 0;
    Dimming dimming_;
    bool is_plain_ = false;  ///< nothing but its picture and its light: no sky, layers, fog, lamps, or view from the
                             ///< wrong side
    const LightGrid* lamplight_ = nullptr;
    Fog fog_;
    bool is_extended_ = false;        ///< a floor not below the eye, or a ceiling not above it
    std::vector<double> row_depths_;  ///< valid for rows [prepared_top_, prepared_bottom_)
    std::vector<Shade> row_shades_;
    std::vector<std::uint32_t> row_darkness_;    ///< the same as kernels want it
    std::vector<std::uint32_t> layer_darkness_;  ///< the same for a layer, of its column's rows
    std::vector<std::uint32_t> full_light_;      ///< the same of rows as painted; where there are lamps
    std::vector<FogPart> row_fog_parts_;         ///< where there is fog
    int prepared_top_ = 0, prepared_bottom_ = 0;
};

}  // namespace enfilade::column
