// A million moves on the authored maps, many of them aimed where moves go wrong: at vertices, along walls, across many
// rooms at once. ENFILADE_LONG=1: a hundred million.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/hash.h"
#include "map/load.h"
#include "math/vec.h"
#include "space/trace.h"
#include "support/trials.h"

namespace enfilade {
namespace {

const int kMovesPerMap = std::getenv("ENFILADE_LONG") ? 14'300'000 : 143'000;  // seven maps: a million

class AuthoredMoves : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        const std::string path = std::string(ENFILADE_SOURCE_DIR) + "/maps/" + GetParam() + ".toml";
        LoadedMap loaded = load_map(path, {}, read_file);
        ASSERT_TRUE(loaded.map) << path;
        map_ = std::move(*loaded.map);
    }

    const Wall& any_wall(Random& random) const { return map_.walls[random.below(map_.walls.size())]; }

    Vec2 anywhere_near(Vec2 p, double reach, Random& random) const {
        return snap_to_point_grid(p + Vec2{random.uniform(-reach, reach), random.uniform(-reach, reach)});
    }

    /// A place to start from: inside a room, on one of its vertices, or on one of its walls.
    Place start(Random& random) const {
        while (true) {
            const Wall& wall = any_wall(random);
            const Vec2 points[] = {anywhere_near(wall.a, 4, random), wall.a, (wall.a + wall.b) * 0.5};
            const Vec2 p = points[random.below(3)];
            if (contains(map_, wall.sector, p)) return {wall.sector, p};
        }
    }

    /// Half a move, so that a move can be split exactly: at random, onto or through a vertex, along a wall, far, none.
    Vec2 half_move(const Place& from, Random& random) const {
        const Sector& sector = map_[from.sector];
        const Wall& wall = map_.walls[sector.first_wall + random.below(sector.wall_count)];
        switch (random.below(6)) {
            case 0: return {};
            case 1: return wall.a - from.point;          // ends as far behind the vertex as it starts before
            case 2: return (wall.a - from.point) * 0.5;  // ends on the vertex
            case 3: return wall.b - wall.a;              // along a wall, or beside one
            case 4: return snap_to_point_grid(direction(Angle{static_cast<std::uint32_t>(random.bits())}) * 40);
            default: return anywhere_near({}, 3, random);
        }
    }

    std::vector<WallId> way_back(const Trace& trace) const {
        std::vector<WallId> walls;
        for (const Crossing& crossing : trace.crossings) walls.push_back(map_[crossing.portal].exit);
        std::reverse(walls.begin(), walls.end());
        return walls;
    }

    static std::vector<WallId> way(const Trace& trace) {
        std::vector<WallId> walls;
        for (const Crossing& crossing : trace.crossings) walls.push_back(crossing.portal);
        return walls;
    }

    void check_move(const Place& from, Vec2 half) const {
        const Vec2 middle = snap_to_point_grid(from.point + half),
                   to = snap_to_point_grid(middle + (middle - from.point));
        const Trace whole = trace(map_, from, to);
        ASSERT_TRUE(contains(map_, whole.end.sector, whole.end.point));
        if (whole.stopped) return;
        const Trace back = trace(map_, whole.end, from.point);
        ASSERT_EQ(back.end, from);
        ASSERT_EQ(way(back), way_back(whole));
        const Trace first = trace(map_, from, middle), second = trace(map_, first.end, to);
        ASSERT_EQ(second.end, whole.end);
        std::vector<WallId> joined = way(first), rest = way(second);
        joined.insert(joined.end(), rest.begin(), rest.end());
        ASSERT_EQ(joined, way(whole));
    }

    Map map_;
};

// hard cases C25, C26
TEST_P(AuthoredMoves, EndInTheirSectorReverseAndSplitExactly) {
    Random random(2026);
    Place at = start(random);
    test::count_trials(kMovesPerMap, "moves");
    for (int move = 0; move < kMovesPerMap; ++move) {
        if (random.below(4) == 0) at = start(random);
        const Vec2 half = half_move(at, random);
        check_move(at, half);
        ASSERT_FALSE(HasFatalFailure()) << "move " << move << " from " << at.point.x << "," << at.point.y << " in "
                                        << map_[at.sector].name << " by twice " << half.x << "," << half.y;
        at = trace(map_, at, snap_to_point_grid(at.point + half)).end;
    }
}

INSTANTIATE_TEST_SUITE_P(Maps, AuthoredMoves,
                         testing::Values("cave", "courtyard", "enfilade", "pillar_hall", "rooms", "step_window",
                                         "tutorial"));

}  // namespace
}  // namespace enfilade
