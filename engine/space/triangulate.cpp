// A line sweeps over the sector from left to right. Between two neighbouring edges under it that have the sector
// between them lies ground whose left part is cut off already; a chain of nodes, from the start of the one edge to the
// start of the other, bounds what is left. Two things hold for every chain, and each point the line meets keeps them
// up:
//
// - It runs to the right as far as its latest node, then to the left.
// - Nothing can be cut off it: in all its inner nodes the ground has an angle of 180 degrees or more.
//
// A point that the line meets between the two edges, or at the right end of one of them, sees the latest node and every
// node between that and the end of the chain it is put to: so it can be joined to them, and to those beyond as long as
// the angle between is less than 180 degrees; then nothing can be cut off again. No other vertex lies in the
// triangles made, because none lies between the chain and the line.
#include "space/triangulate.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <span>

#include "base/result.h"
#include "map/edge_sweep.h"
#include "math/predicates.h"

namespace enfilade {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFu;

/// Of a chain. Its neighbours are named as the edges at its ends are: before and after along the sweep line.
struct ChainNode {
    Vec2 p;
    WallId wall;  ///< that starts there and bounds the ground around it
    std::uint32_t before = kNone, after = kNone;
};

/// Edges have the numbers of the sector's walls, from 0.
class Triangulator {
public:
    Triangulator(const Map& map, const Sector& sector)
        : first_wall_(sector.first_wall),
          edges_(swept(std::span(map.walls).subspan(sector.first_wall, sector.wall_count))),
          line_(SweepOrder{&edges_}),
          places_(edges_.size(), line_.end()),
          end_(edges_.size(), kNone),
          latest_(edges_.size(), kNone) {
        nodes_.reserve(edges_.size());  // more only where the ground parts or closes around holes
        triangles_.reserve(edges_.size());
    }

    std::vector<Triangle> run() && {
        const std::vector<SweepEvent> events = sweep_events(edges_);
        for (std::size_t i = 0; i < events.size();) i = pass(events, i);
        return std::move(triangles_);
    }

private:
    using Line = std::set<std::uint32_t, SweepOrder>;

    /// Everything that happens at one point; gives the index of the next event.
    std::size_t pass(const std::vector<SweepEvent>& events, std::size_t i) {
        point_ = events[i].point;
        ending_.clear();
        starting_.clear();
        for (; i < events.size() && events[i].point == point_; ++i)
            (events[i].starts ? starting_ : ending_).push_back(events[i].edge);
        std::sort(ending_.begin(), ending_.end(), SweepOrder{&edges_});
        std::sort(starting_.begin(), starting_.end(), SweepOrder{&edges_});
        close_between_ending();
        const auto [before, after] = exchange();
        go_on(before, after);
        open_between_starting();
        return i;
    }

    struct SweepNeighbours {
        std::uint32_t before, after;
    };

    /// Puts the starting edges in the place of the ending ones. Gives the edges on both sides of that place; kNone
    /// where there is none.
    SweepNeighbours exchange() {
        auto before = line_.end(), after = line_.end();
        for (const std::uint32_t edge : ending_) after = line_.erase(places_[edge]);
        before = after;
        for (const std::uint32_t edge : starting_) places_[edge] = line_.insert(edge).first;
        if (!starting_.empty()) {
            before = places_[starting_.front()];
            after = std::next(places_[starting_.back()]);
        }
        return {before == line_.begin() ? kNone : *std::prev(before), after == line_.end() ? kNone : *after};
    }

    /// The ground between two ending edges ends with them.
    void close_between_ending() {
        for (std::size_t i = 0; i + 1 < ending_.size(); ++i) {
            if (!edges_[ending_[i]].forward) continue;
            const std::uint32_t last = add_node(ending_[i + 1]);
            cut_before(end_[ending_[i + 1]], last);
            ENFILADE_CHECK(nodes_[last].before == end_[ending_[i]]);  // checked on load: no ground without width
        }
    }

    void open_between_starting() {
        for (std::size_t i = 0; i + 1 < starting_.size(); ++i)
            if (edges_[starting_[i]].forward)
                end_[starting_[i]] = end_[starting_[i + 1]] = latest_[starting_[i]] = add_node(starting_[i]);
    }

    /// The ground before and after all edges of the point, where there is any, goes on beyond it.
    void go_on(std::uint32_t before, std::uint32_t after) {
        const std::vector<std::uint32_t>& any = ending_.empty() ? starting_ : ending_;
        const bool is_ground_before = !edges_[any.front()].forward, is_ground_after = edges_[any.back()].forward;
        if (ending_.empty() && is_ground_before) {
            split(before, after);
        } else if (starting_.empty() && is_ground_before) {
            merge(before);
        } else {
            if (is_ground_before) go_on_before(before);
            if (is_ground_after) go_on_after();
        }
    }

    /// The point lies between two edges: what is between them is two grounds from there on.
    void split(std::uint32_t before, std::uint32_t after) {
        const std::uint32_t latest = latest_[before], again = add(ChainNode(nodes_[latest]));
        const std::uint32_t beyond = nodes_[latest].after;
        (beyond == kNone ? end_[after] : nodes_[beyond].before) = again;
        const std::uint32_t low = add_node(starting_.back()), high = add_node(starting_.back());
        cut_before(latest, low);
        cut_after(again, high);
        end_[starting_.front()] = latest_[before] = low;
        end_[starting_.back()] = latest_[starting_.back()] = high;
    }

    /// The ground on both sides of the ending edges is one from there on.
    void merge(std::uint32_t before) {
        const std::uint32_t node = latest_[before] = add_node(ending_.front());
        cut_before(end_[ending_.front()], node);
        cut_after(end_[ending_.back()], node);
    }

    void go_on_before(std::uint32_t before) {
        const std::uint32_t node = add_node(ending_.front());
        cut_before(end_[ending_.front()], node);
        end_[starting_.front()] = latest_[before] = node;
    }

    void go_on_after() {
        const std::uint32_t node = add_node(starting_.back());
        cut_after(end_[ending_.back()], node);
        end_[starting_.back()] = latest_[starting_.back()] = node;
    }

    /// Puts a node of the point after the end of a chain, and cuts off what it sees of it.
    void cut_before(std::uint32_t end, std::uint32_t node) {
        for (std::uint32_t next; (next = nodes_[end].before) != kNone && turn(node, end, next) > 0; end = next)
            cut(node, end, next);
        nodes_[node].before = end;
        nodes_[end].after = node;
    }

    /// The same before the beginning of a chain.
    void cut_after(std::uint32_t end, std::uint32_t node) {
        for (std::uint32_t next; (next = nodes_[end].after) != kNone && turn(next, end, node) > 0; end = next)
            cut(next, end, node);
        nodes_[node].after = end;
        nodes_[end].before = node;
    }

    int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        return corner(nodes_[a].p, nodes_[b].p, nodes_[c].p);
    }
    void cut(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        triangles_.push_back({nodes_[a].wall, nodes_[b].wall, nodes_[c].wall});
    }

    /// A node at the point, with one of the edges that start there as walls.
    std::uint32_t add_node(std::uint32_t edge) { return add({point_, WallId(first_wall_ + edge)}); }
    std::uint32_t add(const ChainNode& node) {
        nodes_.push_back(node);
        return static_cast<std::uint32_t>(nodes_.size() - 1);
    }

    std::uint32_t first_wall_;
    std::vector<SweptEdge> edges_;
    Line line_;                                     ///< the edges under the sweep line, in its order
    std::vector<Line::iterator> places_;            ///< of each edge in line_
    std::vector<std::uint32_t> end_;                ///< of the chain beside each edge under the line, there
    std::vector<std::uint32_t> latest_;             ///< node of the chain after each edge with ground after it
    std::vector<std::uint32_t> ending_, starting_;  ///< at the point, in their order along the line
    Vec2 point_;                                    ///< where the sweep is
    std::vector<ChainNode> nodes_;
    std::vector<Triangle> triangles_;
};

}  // namespace

std::vector<Triangle> triangulate(const Map& map, SectorId sector) { return Triangulator(map, map[sector]).run(); }

}  // namespace enfilade
