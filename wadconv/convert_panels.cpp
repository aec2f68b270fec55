// Lines that bound no sector: fences in the middle of a room, and lines that only mean something when crossed.
#include <algorithm>
#include <cmath>
#include <optional>

#include "wadconv/workbench.h"

namespace enfilade::wadconv {
namespace {

/// Steps of the vertex grid, 1/1024 m, in a map unit: where a line may be cut.
constexpr double kGridSteps = 32;

/// A piece of a line within one part.
struct LinePiece {
    std::uint32_t part = kNone;
    Vec2 a, b;  ///< [map units], on the vertex grid
};

/// Where along a -> b, as a fraction, the line crosses the edge; nothing where it does not, or only touches.
std::optional<double> crossing(Point a, Point b, const Edge& edge) {
    const std::int64_t start = cross(edge.a, edge.b, a), end = cross(edge.a, edge.b, b);
    const std::int64_t left = cross(a, b, edge.a), right = cross(a, b, edge.b);
    if ((start > 0) == (end > 0) || (left > 0) == (right > 0) || !start || !end || !left || !right) return {};
    return static_cast<double>(start) / static_cast<double>(start - end);
}

double snapped(double x) { return std::floor(x * kGridSteps + 0.5) / kGridSteps; }

/// The point a fraction of the way along, on the vertex grid.
Vec2 point_along(Point a, Point b, double t) {
    return {snapped(a.x + t * (b.x - a.x)), snapped(a.y + t * (b.y - a.y))};
}

Point fine_middle(Vec2 a, Vec2 b) {
    return {static_cast<std::int32_t>((a.x + b.x) * (kFineSteps / 2)),
            static_cast<std::int32_t>((a.y + b.y) * (kFineSteps / 2))};
}

/// Cuts a line wherever it crosses the edge of a part, and drops what lies in none.
std::vector<LinePiece> pieces_of(const Parts& parts, Point a, Point b) {
    std::vector<double> cuts = {0, 1};
    for (std::uint32_t e = 0; e < parts.edges.size(); ++e)
        if (parts.part_of_edge[e] != kNone)
            if (const auto t = crossing(a, b, parts.edges[e])) cuts.push_back(*t);
    std::ranges::sort(cuts);
    std::vector<LinePiece> pieces;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        LinePiece piece{kNone, point_along(a, b, cuts[i]), point_along(a, b, cuts[i + 1])};
        piece.part = piece.a == piece.b ? kNone : part_at(parts, fine_middle(piece.a, piece.b));
        if (piece.part != kNone) pieces.push_back(piece);
    }
    return pieces;
}

/// Whether the side shows something on a line that stands in a sector.
const Sidedef* shown(const DoomMap& doom, std::uint16_t number) {
    const Sidedef* side = doom.side_of(number);
    return side && side->middle != "-" ? side : nullptr;
}

bool look_alike(const Sidedef& one, const Sidedef& other) {
    return one.middle == other.middle && one.x_offset == other.x_offset && one.y_offset == other.y_offset;
}

/// Hangs the picture, once from top to bottom, as Doom hangs the middle texture of such a line.
void hang_picture(const PictureFile& file, const Linedef& line, const Sidedef& side, const DoomHeights& heights,
                  PanelRecord& panel) {
    if (line.flags & kLowerUnpegged) {
        panel.bottom = metres(heights.floor + side.y_offset);
        panel.top = panel.bottom + metres(file.height);
    } else {
        panel.top = metres(heights.ceiling + side.y_offset);
        panel.bottom = panel.top - metres(file.height);
    }
    panel.texture.name = file.name;
    panel.texture.offset_tx.x = 0.0 - side.x_offset;
}

/// Flags that a panel says in words of its own, or needs no record of.
constexpr std::uint16_t kFlagsSaid = kBlocking | kTwoSided | kUpperUnpegged | kLowerUnpegged;

bool is_two_sided(const Linedef& line) { return (line.flags & kTwoSided) != 0 && line.left != kNoSide; }

/// Makes panels of lines that became no wall.
class PanelMaker {
public:
    explicit PanelMaker(Workbench& bench) : bench_(bench) {}

    void convert(std::uint32_t index) {
        const Linedef& line = bench_.doom.lines[index];
        const Point a = point_of(line.start), b = point_of(line.end);
        const Sidedef *right = shown(bench_.doom, line.right), *left = shown(bench_.doom, line.left);
        const PictureFile* right_file = right ? picture_of(*right, index) : nullptr;
        const PictureFile* left_file = left ? picture_of(*left, index) : nullptr;
        // Doom shows each side its own picture; where they are alike one panel does for both.
        one_sided_ = right_file && left_file && !look_alike(*right, *left);
        blocks_ = (line.flags & kBlocking) != 0;
        triggers_ = triggers_of(index);
        left_ = left_over(bench_, line, !triggers_.empty(), kFlagsSaid);
        // What works from one side works from the right one.
        if (right_file || !left_file || !triggers_.empty()) add_from(a, b, line, right_file, right);
        if (left_file && (!right_file || one_sided_)) add_from(b, a, line, left_file, left);
        bench_.report.note(right_file || left_file ? Kind::self_panel : Kind::self_unseen, index);
    }

private:
    Point point_of(std::uint16_t vertex) const {
        const Vertex& v = bench_.doom.vertices[vertex];
        return {v.x, -std::int32_t{v.y}};
    }

    /// Doom's lines are used from the right only, but shot at from both sides.
    std::vector<TriggerRecord> triggers_of(std::uint32_t index) {
        const Linedef& line = bench_.doom.lines[index];
        const std::optional<LineAction> line_action = line_action_of(line.special);
        if (!line_action) return {};
        const bool can_be_passed = line_action->how == How::cross ? is_two_sided(line) && !blocks_ : is_two_sided(line);
        std::vector<TriggerRecord> triggers = bench_.triggers.triggers_of(index, can_be_passed);
        for (TriggerRecord& trigger : triggers)
            if (line_action->how == How::use || line_action->how == How::push) trigger.one_way = true;
        return triggers;
    }

    void add_from(Point start, Point end, const Linedef& line, const PictureFile* file, const Sidedef* side) {
        for (const LinePiece& piece : pieces_of(bench_.parts, start, end)) add(line, piece, file, side, start);
    }

    const PictureFile* picture_of(const Sidedef& side, std::uint32_t line) {
        return texture_spec(bench_, side.middle, side, line) ? bench_.pictures.wall(side.middle) : nullptr;
    }

    void add(const Linedef& line, const LinePiece& piece, const PictureFile* file, const Sidedef* side, Point start) {
        const DoomHeights& heights = bench_.heights_of(bench_.parts.parts[piece.part]);
        PanelRecord panel;
        panel.a = {metres(piece.a.x), metres(piece.a.y)};
        panel.b = {metres(piece.b.x), metres(piece.b.y)};
        panel.bottom = metres(heights.floor);
        // One unit where the sector is closed, so that the panel has a height.
        panel.top = metres(std::max(heights.ceiling, heights.floor + 1));
        panel.texture.name = "-";
        if (file) hang_picture(*file, line, *side, own_heights(*side), panel);
        if (file) panel.texture.offset_tx.x -= distance(start, piece.a);
        panel.one_sided = one_sided_;
        panel.blocks = blocks_;
        panel.doom = left_;
        // Of a line that becomes two panels, one each way, the first does what it does.
        if (start == point_of(line.start)) panel.triggers = triggers_;
        bench_.file.sectors[piece.part].panels.push_back(std::move(panel));
        ++bench_.report.panels;
    }

    const DoomHeights& own_heights(const Sidedef& side) const { return bench_.heights[side.sector]; }

    static double distance(Point from, Vec2 to) {
        const double dx = to.x - from.x, dy = to.y - from.y;
        return std::sqrt(dx * dx + dy * dy);
    }

    Workbench& bench_;
    std::optional<DoomRecord> left_;  ///< of the line that is being converted
    std::vector<TriggerRecord> triggers_;
    bool one_sided_ = false;  ///< its two sides show different pictures
    bool blocks_ = false;
};

/// Lines between two points that became no wall: lone ones, and lines drawn over others if they mean something or
/// block.
std::vector<std::uint32_t> lines_without_walls(const Workbench& bench) {
    const std::vector<std::uint32_t> wall = first_walls(bench.doom, bench.parts);
    std::vector<bool> is_lone(bench.doom.lines.size());
    for (std::uint32_t e : bench.parts.lone) is_lone[bench.parts.edges[e].line] = true;
    std::vector<std::uint32_t> lines;
    for (std::uint32_t i = 0; i < bench.doom.lines.size(); ++i) {
        const Linedef& line = bench.doom.lines[i];
        const bool is_there = line.start < bench.doom.vertices.size() && line.end < bench.doom.vertices.size();
        const bool matters = is_lone[i] || line.special != 0 || (is_two_sided(line) && line.flags & kBlocking);
        if (wall[i] == kNone && is_there && matters) lines.push_back(i);
    }
    return lines;
}

}  // namespace

void convert_panels(Workbench& bench) {
    bench.report.sides.panels = bench.parts.lone.size();
    PanelMaker maker(bench);
    for (std::uint32_t line : lines_without_walls(bench)) maker.convert(line);
}

}  // namespace enfilade::wadconv
