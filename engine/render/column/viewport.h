// What is seen through one chain of portals, and the pool and stack that viewports live in.
#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "base/id.h"

namespace enfilade::column {

/// The rows of one column that are still open: nothing has been drawn there yet.
struct OpenRows {
    int top = 0;
    int bottom = 0;  ///< top >= bottom: closed

    bool is_closed() const { return top >= bottom; }
};

/// A sector seen through one chain of portals: which columns, which rows of them, and from how deep on.
struct Viewport {
    SectorId sector;
    WallId entry;                  ///< the wall of `sector` the look comes in through; none for the eye's own sector
    int pose = 0;                  ///< index of the eye in the frame's list of poses
    int depth = 0;                 ///< portals looked through so far
    std::uint32_t spent = 0;       ///< on the looks into this sector and those before it (render/look_budget.h)
    int begin = 0, end = 0;        ///< columns
    std::vector<OpenRows> rows;    ///< occlusion bounds [end - begin]
    std::vector<double> boundary;  ///< 1 / depth of the portal looked through [end - begin]; what is drawn lies beyond.
                                   ///< Infinite in the eye's own sector

    OpenRows& rows_at(int x) { return rows[static_cast<std::size_t>(x - begin)]; }
    double& boundary_at(int x) { return boundary[static_cast<std::size_t>(x - begin)]; }
    const OpenRows& rows_at(int x) const { return rows[static_cast<std::size_t>(x - begin)]; }
    double boundary_at(int x) const { return boundary[static_cast<std::size_t>(x - begin)]; }

    /// Gives up the closed columns at both ends. True if any is left open.
    bool trim();
};

/// Hands viewports out and takes them all back at the end of a frame. Grows as needed and never gives memory back, so
/// that nothing is allocated once the hardest frame has been seen.
class ViewportPool {
public:
    /// A viewport of columns [begin, end), all closed.
    Viewport& take(int begin, int end);
    void take_all_back() { used_ = 0; }

    std::size_t used() const { return used_; }
    const Viewport& operator[](std::size_t i) const { return viewports_[i]; }

private:
    std::deque<Viewport> viewports_;  ///< a deque, so that viewports stay where they are when it grows
    std::size_t used_ = 0;
};

/// Viewports that are still to be drawn. Which comes first does not change the picture, for no two of them have an
/// open pixel in common; last in, first out keeps the stack as short as the chains are.
using ViewportStack = std::vector<Viewport*>;

}  // namespace enfilade::column
