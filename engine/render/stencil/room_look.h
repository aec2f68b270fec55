// One sector seen through one chain of plain doorways: which of its walls, how near, and what is open behind them.
#pragma once
#include <span>
#include <vector>

#include "render/openings.h"
#include "render/stencil/wall_on_screen.h"

namespace enfilade::stencil {

// Which pixels something may be seen in.

/// By column a range of rows. Closed columns are allowed anywhere.
struct ClipWindow {
    int begin = 0;  ///< columns [begin, begin + rows.size())
    std::vector<OpenRows> rows;

    int end() const { return begin + static_cast<int>(rows.size()); }
    bool is_empty() const { return rows.empty(); }
    OpenRows& at(int x) { return rows[static_cast<std::size_t>(x - begin)]; }
    const OpenRows& at(int x) const { return rows[static_cast<std::size_t>(x - begin)]; }
    /// Opens these rows of column x besides those that are open; what lies between opens, too.
    void open(int x, OpenRows more);
    /// Opens all that is open in the other.
    void open(const ClipWindow& other);
    /// Whether all that is open in the other is open here, too.
    bool holds(const ClipWindow& other) const;
};

/// Columns and rows [begin, end) [px].
struct ScreenBox {
    int begin_x = 0, end_x = 0, begin_y = 0, end_y = 0;
    bool is_empty() const { return begin_x >= end_x || begin_y >= end_y; }
};

/// The smallest around the window.
ScreenBox box_around(const ClipWindow& window);

/// A look into a sector. Past a plain doorway nothing is transformed.
struct Visit {
    SectorId sector;
    WallId entry;          ///< none for the eye's own sector
    WallOnScreen doorway;  ///< the portal looked through, from its other side; where there is an entry
    ClipWindow window;
    std::size_t face = 0;     ///< of the panorama
    int depth = 0;            ///< portals looked through
    std::uint32_t spent = 0;  ///< on the looks into this sector and those before it (render/openings.h)
};

/// Holds the scratch memory for one visit at a time.
class RoomLook {
public:
    RoomLook(const Map& map, const Screen& screen) : map_(map), screen_(screen) {}

    /// Looks into the visit's sector, which is valid as long as questions are asked.
    void look(const Visit& visit, const Pose& pose);

    const Visit& visit() const { return *visit_; }

    /// Those walls of the sector that face the eye beyond the visit's entry in its columns; then those that stand in
    /// for columns which all walls miss.
    std::span<const WallOnScreen> walls() const { return walls_; }

    /// The wall that column x meets first, and its inverse depth there; of ranges, one that all their rays meet, and
    /// the inverse depth where it is farthest. none, 0: no wall, or the column is closed.
    WallId nearest_at(int x) const {
        const int place = nearest_[index_of(x)].place;
        return place == kNothing ? WallId() : walls_[static_cast<std::size_t>(place)].wall;
    }
    double inverse_depth_at(int x) const { return nearest_[index_of(x)].inverse_depth; }
    double doubt_at(int x) const { return nearest_[index_of(x)].doubt; }

    /// Adds every run of columns that meet one wall first, as that wall in these columns; a column beside whose middle
    /// the wall's line vanishes on its own, as the wall is in its middle. Not of ranges.
    void add_met(std::vector<WallOnScreen>& met) const;

    /// What of the visit's window is open through the portal, one of walls(); empty: nothing. Of ranges never less than
    /// what is seen. nearest: becomes the portal's largest inverse depth there [1/m].
    ClipWindow open_behind(const WallOnScreen& portal, const RelativeHeights& opening, double& nearest) const;

private:
    static constexpr int kNothing = -1;
    struct Nearest {
        int place = kNothing;  ///< in walls_
        double inverse_depth = 0;
        double doubt = 0;  ///< how far rounding may take it from the true one [1/m]
    };

    std::size_t index_of(int x) const { return static_cast<std::size_t>(x - visit_->window.begin); }
    void offer(const WallOnScreen& wall);
    void find_stand_ins(const Pose& pose);
    void stand_in(const Pose& pose, int x);
    bool is_nearer_at(const WallOnScreen& wall, const Nearest& offered, const Nearest& other) const;
    void add_run(std::vector<WallOnScreen>& met, int place, int begin, int end) const;
    bool may_meet(const WallOnScreen& portal, double inverse, int x) const;
    OpenRows rows_behind(const WallOnScreen& portal, const RelativeHeights& opening, int x) const;

    const Map& map_;
    const Screen& screen_;
    const Visit* visit_ = nullptr;
    std::vector<WallOnScreen> walls_;
    std::size_t first_stand_in_ = 0;
    std::vector<Nearest> nearest_;
};

}  // namespace enfilade::stencil
