#include "wadconv/parts.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace enfilade::wadconv {
namespace {

Point point_of(const Vertex& v) { return {v.x, -std::int32_t{v.y}}; }

/// Lists the edges of one line after another, noting what is wrong with them.
class Collector {
public:
    Collector(const DoomMap& map, Report& report) : map_(map), report_(report) {}

    std::vector<Edge> collect() {
        for (std::size_t i = 0; i < map_.lines.size(); ++i) add_line(i);
        return std::move(edges_);
    }

private:
    void add_line(std::size_t index) {
        const Linedef& line = map_.lines[index];
        const auto referred = static_cast<std::size_t>((line.right != kNoSide) + (line.left != kNoSide));
        report_.sides.referred += referred;
        if (line.start >= map_.vertices.size() || line.end >= map_.vertices.size())
            return drop(Kind::bad_vertex, index);
        const Point a = point_of(map_.vertices[line.start]), b = point_of(map_.vertices[line.end]);
        if (a == b) return drop(Kind::zero_length_line, index);
        const auto right = sector_of(line.right, index), left = sector_of(line.left, index);
        note_sidedness(line, index, right.has_value(), left.has_value());
        const bool is_open = right && left && (line.flags & kTwoSided);
        if (right) edges_.push_back({a, b, *right, std::uint32_t(index), line.right, false, is_open});
        if (left) edges_.push_back({b, a, *left, std::uint32_t(index), line.left, true, is_open});
        report_.sides.dropped += referred - right.has_value() - left.has_value();
    }

    void drop(Kind kind, std::size_t index) {
        const Linedef& line = map_.lines[index];
        report_.note(kind, index);
        report_.sides.dropped += static_cast<std::size_t>((line.right != kNoSide) + (line.left != kNoSide));
    }

    /// The sector of a side; nothing for "no side" and for numbers that lead nowhere.
    std::optional<std::uint32_t> sector_of(std::uint16_t side, std::size_t line) {
        if (side == kNoSide) return {};
        if (side >= map_.sides.size()) {
            report_.note(Kind::bad_side, line);
            return {};
        }
        if (map_.sides[side].sector >= map_.sectors.size()) {
            report_.note(Kind::bad_sector, line);
            return {};
        }
        return map_.sides[side].sector;
    }

    void note_sidedness(const Linedef& line, std::size_t index, bool has_right, bool has_left) {
        const bool marked = line.flags & kTwoSided;
        if (!has_right && !has_left)
            report_.note(Kind::no_side, index);
        else if (!has_right)
            report_.note(Kind::left_side_only, index);
        else if (has_left && !marked)
            report_.note(Kind::two_sides_unmarked, index);
        else if (!has_left && marked)
            report_.note(Kind::one_side_marked_two, index);
    }

    const DoomMap& map_;
    Report& report_;
    std::vector<Edge> edges_;
};

/// Between which points an edge runs, whichever way.
using Ends = std::pair<Point, Point>;
Ends ends_of(const Edge& e) { return std::minmax(e.a, e.b); }

/// The edges that share two ends, by direction: indices in rising order.
struct Bundle {
    std::vector<std::uint32_t> there, back;
};

/// Lines drawn over each other of which facing pairs are looked for; more are no map but an attack, and the search
/// takes quadratic time. Honest maps have two or three.
constexpr std::size_t kMaxBundle = 64;

/// The rule for lines drawn twice. Sides that face each other with the same sector behind both enclose nothing and
/// cancel, so that the outer two become neighbours:   A | S   S | B   ->   A | B.
/// Of sides that look the same way the first stays.
class Unbundler {
public:
    Unbundler(std::vector<Edge>& edges, Report& report) : edges_(edges), report_(report), gone_(edges.size()) {}

    void run() {
        std::map<Ends, Bundle> bundles;
        for (std::uint32_t i = 0; i < edges_.size(); ++i) {
            const Ends ends = ends_of(edges_[i]);
            (edges_[i].a == ends.first ? bundles[ends].there : bundles[ends].back).push_back(i);
        }
        for (auto& [ends, bundle] : bundles) settle(bundle);
        remove_gone();
    }

private:
    void settle(Bundle& bundle) {
        if (bundle.there.size() > 1 || bundle.back.size() > 1) {
            if (bundle.there.size() + bundle.back.size() <= kMaxBundle) cancel_facing(bundle);
            keep_first(bundle.there);
            keep_first(bundle.back);
        }
        if (!bundle.there.empty() && !bundle.back.empty()) join(bundle.there[0], bundle.back[0]);
    }

    /// Cancels pairs of two lines that face each other across nothing.
    void cancel_facing(Bundle& bundle) {
        for (std::size_t i = 0; i < bundle.there.size();) {
            const auto partner = std::ranges::find_if(bundle.back, [&](std::uint32_t other) {
                const Edge &e = edges_[bundle.there[i]], &f = edges_[other];
                return e.sector == f.sector && e.line != f.line && (e.is_open || f.is_open);
            });
            if (partner == bundle.back.end()) {
                ++i;
                continue;
            }
            remove(*partner);
            remove(bundle.there[i]);
            bundle.back.erase(partner);
            bundle.there.erase(bundle.there.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }

    void keep_first(std::vector<std::uint32_t>& same_way) {
        for (std::size_t i = 1; i < same_way.size(); ++i) remove(same_way[i]);
        same_way.resize(std::min<std::size_t>(same_way.size(), 1));
    }

    void join(std::uint32_t there, std::uint32_t back) {
        edges_[there].opposite = back;
        edges_[back].opposite = there;
        edges_[there].is_open = edges_[back].is_open = edges_[there].is_open && edges_[back].is_open;
    }

    void remove(std::uint32_t edge) {
        gone_[edge] = true;
        ++report_.sides.doubled;
        report_.note(Kind::doubled_line, edges_[edge].line);
    }

    void remove_gone() {
        std::vector<std::uint32_t> new_index(edges_.size(), kNone);
        std::vector<Edge> kept;
        for (std::uint32_t i = 0; i < edges_.size(); ++i)
            if (!gone_[i]) {
                new_index[i] = static_cast<std::uint32_t>(kept.size());
                kept.push_back(edges_[i]);
            }
        for (Edge& e : kept)
            if (e.opposite != kNone)
                e.opposite = new_index[e.opposite];
            else
                e.is_open = false;
        edges_ = std::move(kept);
    }

    std::vector<Edge>& edges_;
    Report& report_;
    std::vector<bool> gone_;
};

void note_shared_sides(const DoomMap& map, Report& report) {
    std::vector<std::uint32_t> uses(map.sides.size());
    for (std::size_t i = 0; i < map.lines.size(); ++i)
        for (std::uint16_t side : {map.lines[i].right, map.lines[i].left})
            if (side < uses.size() && uses[side]++ == 1) report.note(Kind::shared_side, side);
}

}  // namespace

std::vector<Edge> collect_edges(const DoomMap& map, Report& report) {
    note_shared_sides(map, report);
    std::vector<Edge> edges = Collector(map, report).collect();
    Unbundler(edges, report).run();
    return edges;
}

}  // namespace enfilade::wadconv
