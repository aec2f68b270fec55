// Everything one frame is drawn from and into, gathered so that the drawing functions need not pass it piece by piece.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "formats/dials.h"
#include "map/map.h"
#include "map/textures.h"
#include "render/built_in.h"
#include "render/column/canvas.h"
#include "render/column/flat_rows.h"
#include "render/column/kernels.h"
#include "render/column/sector_projection.h"
#include "render/frame.h"
#include "render/lighting.h"
#include "render/sampling.h"
#include "render/view.h"
#include "world/snapshot.h"

namespace enfilade::column {

/// Which way columns look, in parts of a full turn: worked out once for each, for often several viewports show a sky.
class ColumnTurns {
public:
    void start_frame(int columns) {
        turns_.assign(static_cast<std::size_t>(columns), kUnknown);
        forward_ = right_ = {};
    }

    /// ray: of column x in the pose.
    double of(const Pose& pose, int x, Vec2 ray) {
        if (pose.forward != forward_ || pose.right != right_) turn_to(pose);
        double& turn = turns_[static_cast<std::size_t>(x)];
        if (turn == kUnknown) turn = turn_of(ray);
        return turn;
    }

private:
    static constexpr double kUnknown = -1;

    void turn_to(const Pose& pose) {
        std::fill(turns_.begin(), turns_.end(), kUnknown);
        forward_ = pose.forward;
        right_ = pose.right;
    }

    std::vector<double> turns_;
    Vec2 forward_, right_;
};

/// What one column is drawn by way of.
struct ColumnScratch {
    std::vector<std::uint32_t> red_blue, green;  ///< of the light of lamps down a wall, as a LightRow has them
    std::vector<std::uint32_t> texels;           ///< by row: as painted
    std::vector<std::uint32_t> colors;           ///< by row: of what is laid over the canvas
    std::vector<FogPart> fog_parts;              ///< of a wall's rows [height + kRowsBeyond]

    /// Room for so many points of light.
    LightRow cells(int count) {
        const auto words = static_cast<std::size_t>(count + 2 * kCellsBeyond);
        if (red_blue.size() < words) {
            red_blue.resize(words);
            green.resize(words);
        }
        return {red_blue.data() + kCellsBeyond, green.data() + kCellsBeyond, count};
    }

    ColumnTurns turns;
    FlatRowsCache flat_rows;

    void start_frame(int width, int height) {
        const auto rows = static_cast<std::size_t>(height);
        texels.resize(rows);
        colors.resize(rows);
        fog_parts.resize(rows + kRowsBeyond);
        turns.start_frame(width);
        flat_rows.start_frame();
    }
};

/// What the dials of texels say, where they say anything.
struct TexelDials {
    Dials dials;
    const MipChains* mips = nullptr;  ///< where textures are to be made smaller
    double least_texels_per_m = 0;    ///< of all surfaces, along either side of their pictures
};

struct ColumnScene {
    const Map& map;
    const TextureSet& textures;
    const Snapshot& snapshot;
    const RayTables& screen;
    Canvas& canvas;
    FrameFacts* facts;   ///< null where nobody asked what the pixels show
    LightGrids* lights;  ///< null where the map has no point lights
    ColumnScratch& scratch;
    const PlainKernels& kernels;
    const Passes& passes;
    const TexelDials* dials = nullptr;  ///< null: texels are exact

    // What point lights throw on a surface, or null: nothing. Asked once for each surface.
    const LightGrid* light_on(WallId id) const { return lights ? lights->on_wall(snapshot, id) : nullptr; }
    const LightGrid* light_on(PanelId id) const { return lights ? lights->on_panel(snapshot, id) : nullptr; }
    const LightGrid* light_on(ThingId id) const { return lights ? lights->on_thing(snapshot, id) : nullptr; }
    const LightGrid* light_on_floor(SectorId id) const { return lights ? lights->on_floor(snapshot, id) : nullptr; }
    const LightGrid* light_on_ceiling(SectorId id) const { return lights ? lights->on_ceiling(snapshot, id) : nullptr; }
};

/// Notes that something with holes covers what the pixel showed. Only where facts are wanted.
inline void note_over(const ColumnScene& scene, int x, int y, PixelSurface id, double depth, double u_tiles,
                      double v_tiles) {
    const auto i =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.screen.width) + static_cast<std::size_t>(x);
    scene.facts->ids[i] = id;
    scene.facts->depths[i] = depth;
    scene.facts->texels[i] = {fraction(u_tiles), fraction(v_tiles)};
}

/// Notes what one pixel shows, and that the opaque pass wrote it. Called outside the inner loops.
inline void note(const ColumnScene& scene, int x, int y, PixelSurface id, double depth, double u_tiles,
                 double v_tiles) {
    note_over(scene, x, y, id, depth, u_tiles, v_tiles);
    ++scene.facts->writes[static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.screen.width) +
                          static_cast<std::size_t>(x)];
}

}  // namespace enfilade::column
