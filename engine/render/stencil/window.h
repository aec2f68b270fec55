// Which pixels something may be seen in.
#pragma once
#include <vector>

namespace enfilade::stencil {

/// Open rows [top, bottom) of one column.
struct OpenRows {
    int top = 0;
    int bottom = 0;
    bool is_closed() const { return top >= bottom; }
};

/// By column a range of rows. Closed columns are allowed anywhere.
struct Window {
    int begin = 0;  ///< columns [begin, begin + rows.size())
    std::vector<OpenRows> rows;

    int end() const { return begin + static_cast<int>(rows.size()); }
    bool is_empty() const { return rows.empty(); }
    OpenRows& at(int x) { return rows[static_cast<std::size_t>(x - begin)]; }
    const OpenRows& at(int x) const { return rows[static_cast<std::size_t>(x - begin)]; }
    /// Opens these rows of column x besides those that are open; what lies between opens, too.
    void open(int x, OpenRows more);
    /// Opens all that is open in the other.
    void open(const Window& other);
};

/// Columns and rows [begin, end) [px].
struct Box {
    int begin_x = 0, end_x = 0, begin_y = 0, end_y = 0;
    bool is_empty() const { return begin_x >= end_x || begin_y >= end_y; }
};

/// The smallest around the window.
Box box_around(const Window& window);

}  // namespace enfilade::stencil
