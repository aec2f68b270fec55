// The sweep over a sector's edges, against small drawings and against looking at every pair.
#include "map/edge_sweep.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "base/hash.h"
#include "math/predicates.h"

namespace enfilade {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Wall edge(Vec2 a, Vec2 b) {
    Wall wall;
    wall.a = a;
    wall.b = b;
    return wall;
}

void append_loop(std::vector<Wall>& edges, const std::vector<Vec2>& vertices) {
    for (std::size_t i = 0; i < vertices.size(); ++i)
        edges.push_back(edge(vertices[i], vertices[(i + 1) % vertices.size()]));
}

std::vector<Wall> loops(const std::vector<std::vector<Vec2>>& all) {
    std::vector<Wall> edges;
    for (const auto& vertices : all) append_loop(edges, vertices);
    return edges;
}

const std::vector<Vec2> kSquare{{0, 0}, {8, 0}, {8, 8}, {0, 8}};

TEST(MeetingOf, IsNoneForEdgesThatShareAnEnd) {
    EXPECT_EQ(meeting_of(edge({0, 0}, {4, 4}), edge({4, 4}, {8, 0})), Meeting::none);
    EXPECT_EQ(meeting_of(edge({0, 0}, {4, 4}), edge({4, 4}, {8, 8})), Meeting::none);
}

TEST(MeetingOf, TellsCrossingFromTouching) {
    EXPECT_EQ(meeting_of(edge({0, 0}, {4, 4}), edge({0, 4}, {4, 0})), Meeting::crossing);
    EXPECT_EQ(meeting_of(edge({0, 0}, {4, 4}), edge({2, 2}, {4, 0})), Meeting::touching);
    EXPECT_EQ(meeting_of(edge({2, 2}, {4, 0}), edge({0, 0}, {4, 4})), Meeting::touching);
}

TEST(MeetingOf, KnowsEdgesOnOneLine) {
    EXPECT_EQ(meeting_of(edge({0, 0}, {4, 0}), edge({6, 0}, {8, 0})), Meeting::none);
    EXPECT_EQ(meeting_of(edge({0, 0}, {4, 0}), edge({3, 0}, {8, 0})), Meeting::overlapping);
    EXPECT_EQ(meeting_of(edge({0, 0}, {4, 0}), edge({8, 0}, {3, 0})), Meeting::overlapping);
    EXPECT_EQ(meeting_of(edge({0, 0}, {0, 4}), edge({0, 0}, {0, 4})), Meeting::overlapping);
    EXPECT_EQ(meeting_of(edge({0, 0}, {0, 4}), edge({0, 4}, {0, 0})), Meeting::back_to_back);
}

// hard case T10
TEST(MeetingOf, MissesByOneGridStepOverTheWholeWorld) {
    // The far end of the second edge is one step beside the first, 65536 m long: no double is in doubt.
    const Wall across = edge({-32768, -32768}, {32768, 32767});
    const Vec2 on_it{0, -0.5};
    EXPECT_EQ(meeting_of(across, edge(on_it, {0, 100})), Meeting::touching);
    EXPECT_EQ(meeting_of(across, edge(on_it + Vec2{0, kVertexGrid}, {0, 100})), Meeting::none);
    EXPECT_EQ(meeting_of(across, edge(on_it - Vec2{0, kVertexGrid}, {0, 100})), Meeting::crossing);
}

TEST(SweepEdges, AcceptsAnOutlineWithAHoleAndAnIslandInIt) {
    const auto found =
        sweep_edges(loops({kSquare, {{1, 1}, {1, 7}, {7, 7}, {7, 1}}, {{2, 2}, {6, 2}, {6, 6}, {2, 6}}}));
    EXPECT_THAT(found.clashes, IsEmpty());
    EXPECT_THAT(found.wrong_sided, IsEmpty());
}

TEST(SweepEdges, AcceptsLoopsThatTouchInAVertex) {
    const auto found = sweep_edges(loops({kSquare, {{8, 8}, {12, 8}, {12, 12}, {8, 12}}, {{0, 0}, {2, 4}, {4, 2}}}));
    EXPECT_THAT(found.clashes, IsEmpty());
    EXPECT_THAT(found.wrong_sided, IsEmpty());
}

TEST(SweepEdges, AcceptsPartsBackToBack) {
    for (int turn = 0; turn < 4; ++turn) {
        auto edges = loops({kSquare, {{8, 0}, {12, 0}, {12, 8}, {8, 8}}});
        for (Wall& w : edges)
            for (int i = 0; i < turn; ++i) w = edge(right_of(w.a), right_of(w.b));
        const auto found = sweep_edges(edges);
        EXPECT_THAT(found.clashes, IsEmpty());
        EXPECT_THAT(found.wrong_sided, IsEmpty()) << turn;
        EXPECT_TRUE(found.is_paired[1] && found.is_paired[7]);
    }
}

TEST(SweepEdges, FindsTheCrossingOfABowTie) {
    const auto found = sweep_edges(loops({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}));
    ASSERT_THAT(found.clashes, SizeIs(1));
    EXPECT_EQ(found.clashes[0].kind, Meeting::crossing);
    EXPECT_EQ(found.clashes[0].first, 0u);
    EXPECT_EQ(found.clashes[0].second, 2u);
}

TEST(SweepEdges, NamesTheEdgeThatIsTouchedAsTheSecond) {
    const auto found = sweep_edges(loops({kSquare, {{4, 0}, {3, 2}, {5, 2}}}));
    ASSERT_THAT(found.clashes, SizeIs(1));
    EXPECT_EQ(found.clashes[0].kind, Meeting::touching);
    EXPECT_EQ(found.clashes[0].second, 0u);
}

TEST(SweepEdges, FindsWalledUpOutlines) {
    const auto found = sweep_edges(loops({{{0, 0}, {0, 8}, {8, 8}, {8, 0}}}));
    EXPECT_THAT(found.wrong_sided, SizeIs(4));
}

// hard case T7
TEST(SweepEdges, FindsEveryBowTieOfMany) {
    std::vector<Wall> edges;
    for (int i = 0; i < 100; ++i) {
        const double x = 5.0 * (i % 10), y = 5.0 * static_cast<double>(i / 10);
        append_loop(edges, {{x, y}, {x + 4, y + 4}, {x + 4, y}, {x, y + 4}});
    }
    EXPECT_THAT(sweep_edges(edges).clashes, SizeIs(100));
}

TEST(SweepEdges, ReportsAnEdgeThatCutsManyOnce) {
    std::vector<Wall> edges;
    for (int i = 0; i < 100; ++i) append_loop(edges, {{2.0 * i, 0}, {2.0 * i + 1, 0}, {2.0 * i + 1, 9}});
    append_loop(edges, {{-5, 5}, {300, 5}, {300, 20}, {-5, 20}});
    const auto found = sweep_edges(edges);
    ASSERT_THAT(found.clashes, SizeIs(1));
    EXPECT_EQ(found.clashes[0].second, 300u);
}

TEST(SweepEdges, LeavesOutEdgesWithoutLength) {
    auto edges = loops({kSquare});
    edges.insert(edges.begin() + 1, edge({8, 0}, {8, 0}));
    const auto found = sweep_edges(edges);
    EXPECT_THAT(found.clashes, IsEmpty());
    EXPECT_THAT(found.wrong_sided, IsEmpty());
}

// ---- against looking at every pair ----

bool has_clash(const std::vector<Wall>& edges) {
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = i + 1; j < edges.size(); ++j) {
            if (edges[i].a == edges[i].b || edges[j].a == edges[j].b) continue;
            const Meeting m = meeting_of(edges[i], edges[j]);
            if (m != Meeting::none && m != Meeting::back_to_back) return true;
        }
    return false;
}

/// True where an odd number of edges lies on the right of the edge's middle, seen along the edge.
bool is_odd_on_the_right(const std::vector<Wall>& edges, const Wall& e) {
    const Vec2 middle = (e.a + e.b) * 0.5;
    const bool vertical = e.a.x == e.b.x;
    bool odd = false;
    for (const Wall& f : edges) {
        if (&f == &e) continue;
        // A ray from the middle towards +y, or towards -x from a vertical edge.
        const double a = vertical ? f.a.y : f.a.x, b = vertical ? f.b.y : f.b.x, m = vertical ? middle.y : middle.x;
        if ((a <= m) == (b <= m)) continue;
        const Vec2 low = a < b ? f.a : f.b, high = a < b ? f.b : f.a;
        if (corner(low, high, middle) < 0) odd = !odd;
    }
    const bool ray_is_right = vertical ? e.b.y > e.a.y : e.b.x > e.a.x;
    return ray_is_right ? odd : !odd;
}

/// Loops of random vertices on a grid so coarse that nearly everything coincides.
std::vector<Wall> random_loops(Random& random) {
    std::vector<Wall> edges;
    const std::uint64_t side = 2 + random.below(6);
    for (std::uint64_t loop = 1 + random.below(3); loop > 0; --loop) {
        std::vector<Vec2> vertices(3 + random.below(4));
        for (Vec2& v : vertices)
            v = {2.0 * static_cast<double>(random.below(side)), 2.0 * static_cast<double>(random.below(side))};
        append_loop(edges, vertices);
    }
    return edges;
}

// hard case T10
TEST(SweepEdges, AgreesWithEveryPairOnTenThousandTangles) {
    Random random(7);
    int sound = 0;
    for (int i = 0; i < 10'000; ++i) {
        const auto edges = random_loops(random);
        const auto found = sweep_edges(edges);
        ASSERT_EQ(found.clashes.empty(), !has_clash(edges)) << i;
        if (!found.clashes.empty()) continue;
        ++sound;
        std::vector<std::uint8_t> is_wrong(edges.size());
        for (std::uint32_t edge : found.wrong_sided) is_wrong[edge] = 1;
        for (std::size_t k = 0; k < edges.size(); ++k) {
            if (edges[k].a == edges[k].b || found.is_paired[k]) continue;
            ASSERT_EQ(is_wrong[k] != 0, !is_odd_on_the_right(edges, edges[k])) << i << " edge " << k;
        }
    }
    EXPECT_GT(sound, 1000);
}

}  // namespace
}  // namespace enfilade
