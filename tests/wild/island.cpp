#include "wild/island.h"

#include <algorithm>

namespace enfilade::test {
namespace {

constexpr std::int64_t kLattice = 8;  ///< of so many cells a side

}  // namespace

Island::Island(GridPoint corner, std::int64_t width, std::int64_t height, bool is_triangle)
    : corner_(corner), width_(width), height_(height) {
    points_ = {corner, {corner.x + width, corner.y}, {corner.x + width, corner.y + height}};
    triangles_ = {{0, 1, 2}};
    if (is_triangle) return;
    points_.push_back({corner.x, corner.y + height});
    triangles_.push_back({0, 2, 3});
}

void Island::strew(Choices& choices) { insert(hard_point(choices)); }

GridPoint Island::hard_point(Choices& choices) const {
    const auto on_lattice = [&](std::int64_t length) {
        return length * static_cast<std::int64_t>(choices.below(kLattice + 1)) / kLattice;
    };
    const auto along = [&](std::int64_t length) {
        return static_cast<std::int64_t>(choices.below(static_cast<std::uint64_t>(length) + 1));
    };
    const auto off = [&](GridPoint p) {
        const auto step = [&] { return static_cast<std::int64_t>(choices.below(3)) - 1; };
        return GridPoint{p.x + step(), p.y + step()};
    };
    const GridPoint p = choices.any(points_), q = choices.any(points_);
    switch (choices.below(5)) {
        case 0: return {corner_.x + on_lattice(width_), corner_.y + on_lattice(height_)};
        case 1: return {corner_.x + along(width_), corner_.y + along(height_)};
        case 2: return off(p);
        case 3: return off({(p.x + q.x) / 2, (p.y + q.y) / 2});
        default: return {(p.x + q.x) / 2, (p.y + q.y) / 2};
    }
}

void Island::insert(GridPoint p) {
    const int number = static_cast<int>(points_.size());
    for (std::size_t i = triangles_.size(); i-- > 0;) {
        const auto& t = triangles_[i];
        const std::array<std::int64_t, 3> areas{doubled_area(at(t[0]), at(t[1]), p),
                                                doubled_area(at(t[1]), at(t[2]), p),
                                                doubled_area(at(t[2]), at(t[0]), p)};
        if (*std::ranges::min_element(areas) < 0 || p == at(t[0]) || p == at(t[1]) || p == at(t[2])) continue;
        if (points_.size() == static_cast<std::size_t>(number)) points_.push_back(p);
        cut(i, number);
    }
}

/// Into the triangles between the point and each edge that it is not on.
void Island::cut(std::size_t triangle, int number) {
    const auto t = triangles_[triangle];
    triangles_.erase(triangles_.begin() + static_cast<std::ptrdiff_t>(triangle));
    for (std::size_t i = 0; i < 3; ++i)
        if (doubled_area(at(t[i]), at(t[(i + 1) % 3]), at(number)) > 0)
            triangles_.push_back({t[i], t[(i + 1) % 3], number});
}

void Island::fan(Choices& choices, std::uint64_t count) {
    const auto t = choices.any(triangles_);
    const GridPoint a = at(t[0]), b = at(t[1]);
    for (std::uint64_t i = 1; i <= count; ++i) {
        const auto part = static_cast<std::int64_t>(i), all = static_cast<std::int64_t>(count) + 1;
        insert({a.x + (b.x - a.x) * part / all, a.y + (b.y - a.y) * part / all});
    }
}

void Island::turn(Choices& choices) {
    auto& t = triangles_[choices.below(triangles_.size())];
    const std::size_t i = choices.below(3);
    const int a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
    for (auto& u : triangles_)
        for (std::size_t k = 0; k < 3; ++k) {
            if (u[k] != b || u[(k + 1) % 3] != a) continue;
            const int d = u[(k + 2) % 3];
            if (doubled_area(at(a), at(d), at(c)) <= 0 || doubled_area(at(d), at(b), at(c)) <= 0) return;
            t = {a, d, c};
            u = {d, b, c};
            return;
        }
}

}  // namespace enfilade::test
