// Which columns and rows of a viewport show panels, and in which order.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "render/column/masked_columns.h"
#include "render/column/nearest_walls.h"
#include "render/column/room_view.h"

namespace enfilade::column {

/// The panels of one viewport, column by column from left to right. Panels cross nothing, so of two that share a column
/// the same one is the nearer in all of them: a row of those that cover the present column is kept in order, and a
/// panel is put in where it begins and taken out where it ends.
class PanelColumns {
public:
    /// Finds the panels that are somewhere on the screen. False: there are none.
    bool gather(const RoomView& view, MaskedColumns& masked);

    /// What column x shows of a panel.
    struct Look {
        int panel;  ///< number of this search
        WallHit hit;
    };

    /// Those in column x that are met between the entry to the room and the wall behind, the nearest first; their
    /// depths never fall. Valid until the next call. x grows from call to call after gather().
    std::span<const Look> at(const RoomView& view, int x);

    /// Notes what column x shows of the panel.
    void note(const RoomView& view, const Look& look, int x, MaskedColumns& masked) const;

private:
    /// A panel that is somewhere on the screen.
    struct Board {
        Segment facing;       ///< turned so that it faces the eye
        ProjectedWall place;  ///< `swapped` says whether its left end is the panel's b
        RelativeHeights rows;
        int painter;  ///< in MaskedColumns
    };

    void add(const RoomView& view, PanelId id, MaskedColumns& masked);
    bool is_before(int a, int b) const;
    void move_to(int x);
    bool is_before_wall(const RoomView& view, const Board& board, int x) const;

    std::vector<Board> boards_;  ///< by where they begin, from left to right
    std::size_t next_ = 0;       ///< the first that begins to the right of the present column
    std::vector<int> row_;       ///< those that cover the present column, the nearest first
    std::vector<Look> looks_;
};

}  // namespace enfilade::column
