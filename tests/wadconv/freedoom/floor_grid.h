// Where a body can walk: a lattice of points that spreads over the floors from wherever one begins, step by step, each
// step tried with the engine's own walk. So it leads around pillars, holes and solid things, and through nothing that
// a body does not fit through.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "map/map.h"
#include "world/body.h"

namespace enfilade::test {

/// Between neighbouring points, along an axis [m]. Doom's maps are drawn in multiples of 8 units, which are as much,
/// and in a corridor of a metre the middle of a body has 0.3 m.
inline constexpr double kGridSpacing = 0.25;

/// A point of the lattice where a body has stood.
struct FloorPoint {
    Place place;
    double feet_z = 0, ceiling_z = 0;   ///< of a body that stands there, or crouches [m]
    double clear_m = 0;                 ///< at least so far away is anything that could be in the way [m]
    std::uint8_t tried = 0;             ///< bit d: direction d has been tried
    std::array<std::uint32_t, 8> next;  ///< by direction: the point a step leads to, or kNowhere
    std::vector<std::pair<std::uint32_t, SectorId>> passed;  ///< sectors that steps in a direction jump over

    /// Every step stays in the sector and touches nothing.
    bool is_free() const { return clear_m > kBodyRadius + 1.5 * kGridSpacing; }
    bool is_low() const { return !is_at_most(kStandingHeight, ceiling_z - feet_z); }

    static constexpr std::uint32_t kNowhere = 0xFFFFFFFFu;
};

/// Whether a way may lead down where nobody gets up again.
enum class Drops : std::uint8_t { avoided, taken };

/// Spreads where searches lead it and remembers; one for each map. Plain portals only: the lattice knows no links.
class FloorGrid {
public:
    explicit FloorGrid(const Map& map) : map_(map) {}

    const FloorPoint& operator[](std::uint32_t point) const { return points_[point]; }
    std::size_t size() const { return points_.size(); }

    /// A point near the body that it gets to straight away; none where it is wedged in.
    std::optional<std::uint32_t> point_near(const Body& body);

    /// The points of the shortest way from `start` to where the first wanted sector is entered or passed over, start
    /// first; empty where there is none. `reached`, if given, gets all points looked at, nearest first.
    std::vector<std::uint32_t> way_to(std::uint32_t start, const std::function<bool(SectorId)>& is_wanted,
                                      Drops drops = Drops::taken, std::vector<std::uint32_t>* reached = nullptr);

    /// The way to a point that the last search looked at.
    std::vector<std::uint32_t> way_back(std::uint32_t point) const;

    /// From now on there is no step from the one to the other.
    void close(std::uint32_t from, std::uint32_t to);

private:
    bool is_drop(std::uint32_t from, std::uint32_t to) const;
    std::uint32_t step(std::uint32_t from, std::uint32_t direction);
    std::optional<Place> walked(const FloorPoint& from, Vec2 to) const;
    void note_passed(std::uint32_t from, std::uint32_t direction, const Place& to);
    std::uint32_t add(const FloorPoint& point);

    const Map& map_;
    std::vector<FloorPoint> points_;
    std::unordered_map<std::uint64_t, std::uint32_t> known_;  ///< by place; only ever looked up
    std::vector<std::uint32_t> came_from_;                    ///< by point, of the last search; kNowhere: not seen
};

}  // namespace enfilade::test
