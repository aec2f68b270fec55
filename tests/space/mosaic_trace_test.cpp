// What must hold for every path, tried on generated maps whose corners and lines the paths are aimed at.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "base/hash.h"
#include "math/vec.h"
#include "space/mosaic.h"
#include "space/trace.h"
#include "support/trials.h"

namespace enfilade {
namespace {

using test::lay_mosaic;
using test::Mosaic;
using test::MosaicPlan;

/// Points that a careless tracer gets wrong: corners, points on lines, whole numbers, and a grid step beside those.
class NastyPoints {
public:
    NastyPoints(const Mosaic& mosaic, std::uint64_t seed) : mosaic_(mosaic), random_(seed) {}

    Vec2 next() {
        const Vec2 p = base();
        const auto beside = [&] { return (static_cast<double>(random_.below(3)) - 1) * kPointGrid; };
        if (random_.below(4) == 0) return {p.x + beside(), p.y + beside()};
        return p;
    }

    /// A point inside some sector.
    Place next_place() {
        while (true) {
            const Vec2 p = next();
            const SectorId sector = mosaic_.sector_at(p);
            if (sector) return {sector, p};
        }
    }

    std::uint64_t below(std::uint64_t count) { return random_.below(count); }

private:
    Vec2 corner() {
        const int column = static_cast<int>(random_.below(std::uint64_t(mosaic_.plan.columns + 1)));
        const int row = static_cast<int>(random_.below(std::uint64_t(mosaic_.plan.rows + 1)));
        return mosaic_.corner(column, row);
    }

    Vec2 base() {
        const MosaicPlan& plan = mosaic_.plan;
        const Vec2 size{plan.columns * plan.spacing, plan.rows * plan.spacing};
        switch (random_.below(4)) {
            case 0: return corner();
            case 1: return (corner() + corner()) * 0.5;
            case 2:
                return plan.origin + Vec2{double(random_.below(std::uint64_t(size.x) + 1)),
                                          double(random_.below(std::uint64_t(size.y) + 1))};
            default:
                return plan.origin + snap_to_point_grid(Vec2{random_.uniform(0, size.x), random_.uniform(0, size.y)});
        }
    }

    const Mosaic& mosaic_;
    Random random_;
};

/// The kinds of mosaic the properties are tried on: lattices full of ties, and bent ones; open and with rock; near the
/// origin and at the edge of the world.
std::vector<MosaicPlan> plans(double solid) {
    return {{.labels = 4, .solid = solid},
            {.labels = 100, .solid = solid},
            {.jitter = 0.9, .labels = 3, .solid = solid},
            {.jitter = 0.75, .jitter_step = 0.25, .labels = 20, .solid = solid},
            {.columns = 2, .rows = 30, .spacing = 1, .labels = 9, .solid = solid},
            {.jitter = 0.5, .jitter_step = 0.5, .origin = {32736, -32768}, .labels = 6, .solid = solid}};
}

Crossings backward(const Map& map, Crossings crossings) {
    std::reverse(crossings.begin(), crossings.end());
    for (Crossing& c : crossings) c.portal = map[c.portal].exit;
    return crossings;
}

constexpr int kMapsPerPlan = 4;
constexpr int kPathsPerMap = 3000;  // a million traces in all

/// Calls check(mosaic, points) kPathsPerMap times on each of some mosaics.
template <class Check>
void try_mosaics(double solid, Check check) {
    std::uint64_t seed = 0;
    for (const MosaicPlan& plan : plans(solid))
        for (int i = 0; i < kMapsPerPlan; ++i) {
            const Mosaic mosaic = lay_mosaic(plan, ++seed);
            NastyPoints points(mosaic, seed);
            test::count_trials(kPathsPerMap, "paths");
            for (int k = 0; k < kPathsPerMap && !testing::Test::HasFatalFailure(); ++k) {
                SCOPED_TRACE(testing::Message() << "mosaic " << seed << ", path " << k);
                check(mosaic, points);
            }
        }
}

// hard case C1
TEST(TraceOverMosaics, EndsInTheSectorOfTheCellTheEndIsIn) {
    try_mosaics(0, [](const Mosaic& mosaic, NastyPoints& points) {
        const Place from = points.next_place();
        const Place to = points.next_place();
        const Trace path = trace(mosaic.map, from, to.point);
        ASSERT_EQ(path.end, to);
        ASSERT_TRUE(path.stopped.is_none());
    });
}

TEST(TraceOverMosaics, EndsInsideItsSectorWhateverStopsIt) {
    try_mosaics(0.3, [](const Mosaic& mosaic, NastyPoints& points) {
        const Place from = points.next_place();
        const Vec2 to = points.next();
        const Trace path = trace(mosaic.map, from, to);
        ASSERT_EQ(mosaic.sector_at(path.end.point), path.end.sector);
        ASSERT_TRUE(path.stopped || path.end.point == to);
    });
}

// hard case C25
TEST(TraceOverMosaics, CrossesTheSamePortalsBackward) {
    try_mosaics(0.2, [](const Mosaic& mosaic, NastyPoints& points) {
        const Place from = points.next_place();
        const Trace there = trace(mosaic.map, from, points.next());
        if (there.stopped) return;
        const Trace back = trace(mosaic.map, there.end, from.point);
        ASSERT_EQ(back.crossings, backward(mosaic.map, there.crossings));
        ASSERT_EQ(back.end, from);
    });
}

// hard case C26
TEST(TraceOverMosaics, IsTheSumOfItsParts) {
    try_mosaics(0.2, [](const Mosaic& mosaic, NastyPoints& points) {
        // Seven equal parts that lie on the point grid: the whole is seven times a part.
        const Place from = points.next_place();
        const Vec2 part = snap_to_point_grid((points.next() - from.point) * (1.0 / 7));
        const Trace whole = trace(mosaic.map, from, from.point + part * 7);
        if (whole.stopped) return;
        Crossings joined;
        Place at = from;
        for (int i = 0; i < 7; ++i) {
            const Trace step = trace(mosaic.map, at, at.point + part);
            joined.append(step.crossings);
            at = step.end;
        }
        ASSERT_EQ(joined, whole.crossings);
        ASSERT_EQ(at, whole.end);
    });
}

// hard case C3
TEST(TraceOverMosaics, ReturnsFromManyMovesInARow) {
    try_mosaics(0, [](const Mosaic& mosaic, NastyPoints& points) {
        const Place from = points.next_place();
        const Vec2 stops[] = {points.next_place().point, points.next_place().point, from.point};
        Place at = from;
        for (Vec2 stop : stops) at = trace(mosaic.map, at, stop).end;
        ASSERT_EQ(at, from);
    });
}

/// Some of the portals, and for each a panel on its line that blocks, in the room on one side of it.
struct Fenced {
    Map map;
    std::vector<bool> is_fenced;  ///< by wall: both sides of a portal

    Fenced(const Map& plain, std::uint64_t seed) : map(plain), is_fenced(plain.walls.size()) {
        Random random(seed);
        std::vector<bool> has_panel(plain.walls.size());
        for (std::size_t i = 0; i < plain.walls.size(); ++i) {
            const Wall& wall = plain.walls[i];
            if (wall.kind != WallKind::portal || wall.exit.index < i || random.below(3) > 0) continue;
            is_fenced[i] = is_fenced[wall.exit.index] = true;
            has_panel[random.below(2) == 0 ? i : wall.exit.index] = true;
        }
        for (Sector& sector : map.sectors) {
            sector.first_panel = static_cast<std::uint32_t>(map.panels.size());
            for (std::uint32_t w = sector.first_wall; w < sector.first_wall + sector.wall_count; ++w)
                if (has_panel[w]) add(map.walls[w], random.below(2) == 0);
            sector.panel_count = sector.active_panels =
                static_cast<std::uint32_t>(map.panels.size()) - sector.first_panel;
        }
    }

    Trace trace_panels(const Place& from, Vec2 to) const {
        return trace(map, from, to, {}, [](const MetPanel&) { return false; });
    }
    Trace trace_portals(const Place& from, Vec2 to) const {
        return trace(map, from, to, [this](WallId w, const Rigid&) { return !is_fenced[w.index]; });
    }

private:
    void add(const Wall& wall, bool turned) {
        Panel panel;
        panel.a = turned ? wall.b : wall.a;
        panel.b = turned ? wall.a : wall.b;
        panel.length = wall.length;
        panel.sector = wall.sector;
        panel.blocks = true;
        map.panels.push_back(panel);
    }
};

/// Calls check(fenced, points) kPathsPerMap times on one fenced mosaic of each plan.
template <class Check>
void try_fenced_mosaics(double solid, Check check) {
    std::uint64_t seed = 100;
    for (const MosaicPlan& plan : plans(solid)) {
        const Mosaic mosaic = lay_mosaic(plan, ++seed);
        const Fenced fenced(mosaic.map, seed);
        NastyPoints points(mosaic, seed);
        for (int k = 0; k < kPathsPerMap && !testing::Test::HasFatalFailure(); ++k) {
            SCOPED_TRACE(testing::Message() << "mosaic " << seed << ", path " << k);
            check(fenced, points);
        }
    }
}

TEST(TraceOverMosaics, IsStoppedByPanelsAsByThePortalsTheyStandIn) {
    std::size_t stops = 0;
    try_fenced_mosaics(0.1, [&](const Fenced& fenced, NastyPoints& points) {
        const Place from = points.next_place();
        const Vec2 to = points.next();
        const Trace by_panels = fenced.trace_panels(from, to), by_portals = fenced.trace_portals(from, to);
        ASSERT_EQ(by_panels.end, by_portals.end);
        ASSERT_EQ(by_panels.crossings, by_portals.crossings);
        ASSERT_EQ(by_panels.is_stopped(), by_portals.is_stopped());
        const bool is_at_portal = by_portals.stopped && fenced.is_fenced[by_portals.stopped.index];
        ASSERT_EQ(!by_panels.barrier.panel.is_none(), is_at_portal);
        stops += is_at_portal;
    });
    EXPECT_GT(stops, 3000u);
}

// hard case C25
TEST(TraceOverMosaics, CrossesTheSamePanelsBackward) {
    try_fenced_mosaics(0, [](const Fenced& fenced, NastyPoints& points) {
        const auto pass = [](const MetPanel&) { return true; };
        const Place from = points.next_place();
        const Trace there = trace(fenced.map, from, points.next_place().point, {}, pass);
        const Trace back = trace(fenced.map, there.end, from.point, {}, pass);
        ASSERT_EQ(there.crossings.size(), back.crossings.size());
        for (std::size_t i = 0; i < back.crossings.size(); ++i) {
            const MetPanel one = there.crossings[there.crossings.size() - 1 - i].through;
            const MetPanel other = back.crossings[i].through;
            ASSERT_EQ(one.panel, other.panel);
            ASSERT_TRUE(one.panel.is_none() || one.from_behind != other.from_behind);
        }
    });
}

TEST(TraceOverMosaics, StopsWithinAGridStepOfAWallMetSquarely) {
    const Mosaic mosaic = lay_mosaic({.columns = 3, .rows = 3, .labels = 1}, 1);
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec2 p = snap_to_point_grid({random.uniform(1, 11), random.uniform(1, 11)});
        const Trace right = trace(mosaic.map, {SectorId(0u), p}, {p.x + 20, p.y});
        ASSERT_EQ(right.end.point, (Vec2{12 - kPointGrid, p.y}));
        const Trace left = trace(mosaic.map, {SectorId(0u), p}, {p.x - 20, p.y});
        ASSERT_EQ(left.end.point, (Vec2{0, p.y})) << "the tie rule counts the line at x = 0 as inside";
    }
}

}  // namespace
}  // namespace enfilade
