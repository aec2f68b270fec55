// Which columns and rows of a viewport show things, and in which order.
#pragma once
#include <cstdint>
#include <vector>

#include "render/column/masked_columns.h"
#include "render/column/nearest_walls.h"
#include "render/column/pose.h"
#include "render/sprite.h"

namespace enfilade::column {

/// What the search needs to know of the viewport that is drawn.
struct ThingsView {
    const Scene& scene;
    const Viewport& viewport;
    const Pose& pose;
    const RelativeHeights& here;
    const NearestWalls& nearest;
};

/// Notes the things of one viewport at a time. A viewport without things costs one look at an empty list.
class ThingColumns {
public:
    /// Notes every column of every thing's picture, of each column the nearest first. To be called before the
    /// viewport's masked walls are noted: they stand at the end of the room, behind all its things.
    void note(const ThingsView& view, MaskedColumns& masked);

private:
    /// A picture that is somewhere on the screen.
    struct Board {
        int begin, end;  ///< columns, within the viewport
        double depth;    ///< [m]
        double left_v;   ///< its left edge in view space [m]
        double width;    ///< [m]
        bool mirrored;   ///< its left edge is the picture's right one
        RelativeHeights rows;
        int painter;  ///< in MaskedColumns
    };

    static bool is_nearer(const Board& a, const Board& b);
    void add(const ThingsView& view, const Presence& presence, MaskedColumns& masked);
    void note_board(const ThingsView& view, const Board& board, MaskedColumns& masked) const;

    std::vector<Board> boards_;
};

}  // namespace enfilade::column
