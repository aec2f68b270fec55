// Which columns and rows of a viewport show things, and in which order.
#pragma once
#include <cstddef>
#include <vector>

#include "render/column/masked_columns.h"
#include "render/column/room_view.h"
#include "render/sprite.h"

namespace enfilade::column {

/// The things of one viewport at a time.
class ThingColumns {
public:
    /// Finds the things that are somewhere on the screen and puts them in order, the nearest first. False: there are
    /// none.
    bool gather(const RoomView& view, MaskedColumns& masked);

    std::size_t count() const { return boards_.size(); }

    /// Of the i-th of them. All of a picture has one depth, so the order is the same in all columns [m].
    double depth(std::size_t i) const { return boards_[i].depth; }

    /// Notes what column x shows of the i-th of them, if it does.
    void note(const RoomView& view, std::size_t i, int x, MaskedColumns& masked) const;

    /// Notes every column of all of them.
    void note_all(const RoomView& view, MaskedColumns& masked) const;

private:
    /// A picture that is somewhere on the screen.
    struct Board {
        int begin, end;  ///< columns, within the viewport
        double depth;    ///< [m]
        double left_v;   ///< its left edge in view space [m]
        double width;    ///< [m]
        bool mirrored;   ///< its left edge is the picture's right one
        RelativeHeights rows;
        Vec2 place;   ///< of the thing
        int painter;  ///< in MaskedColumns
    };

    static bool is_nearer(const Board& a, const Board& b);
    void add(const RoomView& view, const Presence& presence, MaskedColumns& masked);
    static bool is_met(const RoomView& view, const Board& board, int x);

    std::vector<Board> boards_;
};

}  // namespace enfilade::column
