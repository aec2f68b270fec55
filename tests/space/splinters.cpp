// A square with points strewn into it, cut into triangles any way that is right, and put together again at random. It
// is small enough to look at every triangle for every point.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/hash.h"
#include "math/predicates.h"
#include "math/vec.h"
#include "space/mosaic.h"
#include "support/map_builder.h"

namespace enfilade::test {
namespace {

/// By the numbers of corners, clockwise.
using Splinter = std::array<int, 3>;

class Shattering {
public:
    Shattering(double size, Random& random) : size_(size), random_(random) {
        const double half = size / 2;
        corners = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
        splinters_ = {{0, 1, 2}, {0, 2, 3}};
    }

    void strew_point(double rim) {
        const Vec2 p = snap_to_vertex_grid(random_.uniform(0, 1) < rim ? rim_point() : point());
        if (std::max(std::fabs(p.x), std::fabs(p.y)) <= size_ / 2) insert(p);
    }

    void turn_edge() { turn(random_.below(splinters_.size()), random_.below(3)); }

    std::vector<Cell> cells() const {
        std::vector<Cell> cells;
        for (const Splinter& s : splinters_) cells.push_back({{s.begin(), s.end()}, {}});
        return cells;
    }

    std::vector<Vec2> corners;

private:
    Vec2 at(int number) const { return corners[static_cast<std::size_t>(number)]; }
    Vec2 any_corner() { return corners[random_.below(corners.size())]; }

    Vec2 rim_point() {
        const double side = random_.below(2) == 0 ? -size_ / 2 : size_ / 2,
                     along = random_.uniform(-size_ / 2, size_ / 2);
        return random_.below(2) == 0 ? Vec2{side, along} : Vec2{along, side};
    }

    Vec2 point() {
        const auto lattice = [&] { return size_ / 8 * static_cast<double>(random_.below(9)) - size_ / 2; };
        const auto step = [&] { return kVertexGrid * (static_cast<double>(random_.below(3)) - 1); };
        switch (random_.below(4)) {
            case 0: return {lattice(), lattice()};
            case 1: return any_corner() + Vec2{step(), step()};
            case 2: return (any_corner() + any_corner()) * 0.5 + Vec2{step(), step()};
            default: return {random_.uniform(-size_ / 2, size_ / 2), random_.uniform(-size_ / 2, size_ / 2)};
        }
    }

    /// Cuts the splinter it lies in into three; on an edge, those on both sides into two.
    void insert(Vec2 p) {
        if (std::find(corners.begin(), corners.end(), p) != corners.end()) return;
        const int number = static_cast<int>(corners.size());
        corners.push_back(p);
        for (std::size_t s = 0, count = splinters_.size(); s < count; ++s) {
            const auto [a, b, c] = splinters_[s];
            const int ab = corner(at(a), at(b), p), bc = corner(at(b), at(c), p), ca = corner(at(c), at(a), p);
            if (std::min({ab, bc, ca}) < 0) continue;
            std::vector<Splinter> parts;
            if (ab > 0) parts.push_back({a, b, number});
            if (bc > 0) parts.push_back({b, c, number});
            if (ca > 0) parts.push_back({c, a, number});
            splinters_[s] = parts.back();
            splinters_.insert(splinters_.end(), parts.begin(), parts.end() - 1);
        }
    }

    /// Edge i of a splinter becomes the other diagonal of what is on both sides of it, where that is convex.
    void turn(std::size_t s, std::size_t i) {
        const int a = splinters_[s][i], b = splinters_[s][(i + 1) % 3], c = splinters_[s][(i + 2) % 3];
        for (Splinter& other : splinters_)
            for (std::size_t k = 0; k < 3; ++k) {
                if (other[k] != b || other[(k + 1) % 3] != a) continue;
                const int d = other[(k + 2) % 3];
                if (corner(at(c), at(a), at(d)) <= 0 || corner(at(d), at(b), at(c)) <= 0) return;
                splinters_[s] = {c, a, d};
                other = {c, d, b};
                return;
            }
    }

    double size_;
    Random& random_;
    std::vector<Splinter> splinters_;
};

}  // namespace

Mosaic lay_splinters(const SplinterPlan& plan, std::uint64_t seed) {
    Random random(seed);
    Shattering shattering(plan.size, random);
    for (int i = 0; i < plan.points; ++i) shattering.strew_point(plan.rim);
    for (int i = 0; i < plan.points; ++i) shattering.turn_edge();
    Mosaic mosaic;
    mosaic.corners = shattering.corners;
    mosaic.cells = shattering.cells();
    for (Cell& cell : mosaic.cells)
        if (random.uniform(0, 1) >= plan.solid)
            cell.sector = SectorId(static_cast<std::size_t>(random.below(std::uint64_t(plan.labels))));
    mosaic.map = built(map_of_cells(mosaic.corners, mosaic.cells, plan.labels, plan.loops, random));
    return mosaic;
}

}  // namespace enfilade::test
