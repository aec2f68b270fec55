// What cannot be drawn in order: fences and things are noted while the viewports are drawn, together with the rows that
// were open, and laid over the finished picture back to front. A frame without such pictures keeps nothing here.
#pragma once
#include <vector>

#include "render/column/viewport.h"
#include "render/column/wall_painter.h"

namespace enfilade::column {

class MaskedColumns {
public:
    void clear();

    /// A picture that columns may be noted of.
    int add(const WallPainter& painter);

    /// Rows of column x that show the picture. Of two that share a pixel the nearer one is to be noted first: a
    /// viewport is drawn before those seen through its portals, so its own pictures come before theirs.
    void note(int painter, int x, OpenRows rows, const WallHit& hit) {
        if (!rows.is_closed()) columns_.push_back({painter, x, rows, hit});
    }

    /// Lays all of them over the picture, the last noted first.
    void draw(const Scene& scene) const;

private:
    struct Column {
        int painter;
        int x;
        OpenRows rows;
        WallHit hit;
    };

    std::vector<WallPainter> painters_;
    std::vector<Column> columns_;
};

}  // namespace enfilade::column
