// Where walls stand on the screen, and which of them a look into a sector meets.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "map/map.h"
#include "render/openings.h"
#include "render/segment.h"
#include "render/view.h"
#include "world/snapshot.h"

namespace enfilade::stencil {

// Where one wall stands on the screen: in which columns, how far away, and where its heights are drawn.

// The columns and rows that a picture is planned in.

/// From slopes and heights to columns and rows, as real numbers: column x reaches from x to x + 1.
struct Screen {
    int width = 0, height = 0;
    std::vector<double> slopes;  ///< [width] at the columns' middles
    double slope_per_px = 1;
    double middle_px = 0;  ///< where the slope is 0 [px]
    double focal_y = 1;    ///< [px]
    double horizon = 0;    ///< [px] from the top
    /// False: these are the picture's own columns and rows, each one with a ray in its middle. True: each stands for
    /// all rays that are in it (panorama.h), and what may be seen by any of them is planned.
    bool has_ranges = false;

    Screen() = default;
    explicit Screen(const Projection& projection);

    double per_slope() const { return 1 / slope_per_px; }
    double px_of(double slope) const { return slope / slope_per_px + middle_px; }
    double slope_at(double px) const { return (px - middle_px) * slope_per_px; }
};

/// Graphics cards put vertices on a grid of 1/256 px or finer. Edges between rows are drawn for rays that climb this
/// much more [px], so that what goes exactly through a pixel's centre, as often happens where maps and players are
/// lined up, falls on the side that the other renderers' rule says. Between columns nothing is left to the card.
inline constexpr double kTieShift = 1.0 / 256;

/// How far beyond the picture's edges shapes are kept [px].
inline constexpr double kMargin = 1;

/// Where a wall that stands in for a column whose ray misses it is met (render/segment.h).
struct Missed {
    double depth = 0;    ///< [m]
    double along = 0;    ///< from the wall's a to its b, 0..1
    Vec2 ahead_v{0, 1};  ///< the depth is measured in this direction of the view
    bool operator==(const Missed&) const = default;
};

/// An upright edge that faces the eye: a wall, a panel or a thing's picture (render/segment.h).
struct WallOnScreen {
    WallId wall;                       ///< none: a panel or a thing
    Vec2 left_v, right_v;              ///< L and R, its ends in view space
    Vec2 shown_left_v, shown_right_v;  ///< tilted pictures show only what is between these, on the same line
    FacingWall ends;                   ///< of a wall or a panel, as columns are decided by
    double cross = 0;                  ///< of R and L, >= 0: exactly 0 where the eye is on the wall's line [m^2]
    bool swapped = false;              ///< L is the wall's b: it is seen in a mirror, or a panel from behind
    bool is_open_left = false, is_open_right = false;  ///< tilted pictures show up to a pixel more there
    std::optional<Missed> missed;                      ///< its columns see it there, all at one depth
    int rank = 0;            ///< grows along every ray: upright from room to room, tilted from each to the next
    bool is_pane = false;    ///< upright: it stands or hangs before the wall of its rank
    int begin = 0, end = 0;  ///< columns: those that show it, decided exactly; or of ranges those that may
    double begin_px = 0, end_px = 0;  ///< its ends, within the margin of the picture

    /// e_L - e_R: positive where the wall is seen.
    double span(double slope) const { return slope * (left_v.y - right_v.y) - (left_v.x - right_v.x); }

    /// 1 / depth, linear in the slope; finite but beyond all bounds where the eye is on the wall's line [1/m].
    double inverse_depth(double slope) const;

    /// How far rounding may take it from the true one [1/m].
    double doubt(double slope) const { return inverse_depth_doubt(left_v, right_v, cross, slope); }

    double nearest() const;  ///< bounds of its depth anywhere [m], >= 0
    double farthest() const;
};

/// The edge, which faces the eye, in no column yet.
WallOnScreen in_view(const Segment& facing, const Pose& pose);

/// none: the wall does not face the eye, decided exactly.
std::optional<WallOnScreen> in_view(const Map& map, WallId wall, const Pose& pose);

/// Finds its columns. False: there are none.
bool put_on_screen(WallOnScreen& wall, const Pose& pose, const Screen& screen);

/// none: the wall does not face the eye, or is in no column.
/// doorway: null, or what one looks in through, from its other side. Of ranges, walls are extended beyond it.
std::optional<WallOnScreen> on_screen(const Map& map, WallId wall, const Pose& pose, const Screen& screen,
                                      const WallOnScreen* doorway);

/// The wall in columns [begin, end), all of which it is seen in; not of ranges. A column in which the lines of all its
/// heights meet, because the wall's line vanishes there beside the middle, is a part of its own, with the wall as it is
/// in the middle: the parts of the wall by height would share no corners, and between them a pixel might be left out.
std::vector<WallOnScreen> parts_of_run(const WallOnScreen& wall, const Pose& pose, const Screen& screen, int begin,
                                       int end);

/// Whether two vertices in view space are as good as in one direction.
bool are_in_line(Vec2 p_v, Vec2 q_v);

/// A doorway's ends are authoritative: in tilted pictures, which have no columns of which to say that all walls miss
/// them, a wall behind it that ends there, or in line with it, is extended by a column, which the doorway hides unless
/// rounding left it to nobody.
void extend_beyond(WallOnScreen& wall, const WallOnScreen& doorway);

/// Columns in which all rays meet the wall.
CoveredColumns surely_covered(const WallOnScreen& wall, const Screen& screen);

/// Row of a height above the eye on the wall [px], real; may lie far outside of the picture, but is always finite.
double row_of(const Screen& screen, const WallOnScreen& wall, double height, double px);

// The parts of a wall by height: what of it is drawn, and what one sees through.

/// How high the parts of a wall are.
struct WallParts {
    RelativeHeights room;
    RelativeHeights behind;             ///< of the room behind a portal; of a solid wall or a mirror, its own
    RelativeHeights opening;            ///< what one sees through: empty for a solid wall or a closed portal
    bool lower = false, upper = false;  ///< the steps that are drawn
};
WallParts parts_of(const Map& map, const Snapshot& snapshot, WallId wall, double eye_z);

/// A room's heights above the eye.
RelativeHeights heights_of(const Snapshot& snapshot, SectorId room, double eye_z);

/// Height above the eye that a surface hangs from [m].
double peg_height(const WallParts& parts, Peg peg);

/// How high the picture in a portal hangs or stands, which is shown once from top to bottom.
RelativeHeights picture_in(const WallParts& parts, const Surface& middle);

// One sector seen through one chain of plain doorways: which of its walls, how near, and what is open behind them.

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

    /// Looks into the visit's sector. The visit stays where it is as long as questions are asked.
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
    void find_stand_ins();
    void stand_in(int x);
    bool is_nearer_at(const WallOnScreen& wall, const Nearest& offered, const Nearest& other) const;
    void add_run(std::vector<WallOnScreen>& met, int place, int begin, int end) const;
    bool may_meet(const WallOnScreen& portal, double inverse, int x) const;
    OpenRows rows_behind(const WallOnScreen& portal, const RelativeHeights& opening, int x) const;

    const Map& map_;
    const Screen& screen_;
    const Visit* visit_ = nullptr;
    Pose pose_;
    std::vector<WallOnScreen> walls_;
    std::size_t first_stand_in_ = 0;
    std::vector<Nearest> nearest_;
};

}  // namespace enfilade::stencil
