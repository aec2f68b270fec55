// A straight corridor in four pieces that lie anywhere, each linked to the next and the last to the first: looked along
// for 128 links, thirty-two times around, it is as straight as one without links.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "hard_cases/world.h"
#include "support/looks.h"

namespace enfilade::test {
namespace {

constexpr double kPieceLength = 1.25,
                 kPieceWidth = 2.5;  ///< of a piece [m]: turned by the triangle 3, 4, 5 it is on the grid
constexpr int kLinks = 128;
constexpr double kSeen = kLinks * kPieceLength;  ///< [m]
constexpr PictureSize kLoopSize{320, 200};

/// Where a piece lies: turned, then shifted.
struct Piece {
    Vec2 turn;  ///< (cos, sin)
    Vec2 corner;

    Vec2 at(double x, double y) const { return corner + turn * x + right_of(turn) * y; }
};

using Loop = std::array<Piece, 4>;

MapFile corridor_of(const Loop& pieces) {
    MapFile file = map_of({});
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Piece& p = pieces[i];
        file.sectors.push_back(
            room(std::to_string(i),
                 {p.at(0, 0), p.at(kPieceLength, 0), p.at(kPieceLength, kPieceWidth), p.at(0, kPieceWidth)}, 0, 3));
    }
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Piece &p = pieces[i], &next = pieces[(i + 1) % pieces.size()];
        link(file, std::to_string(i), p.at(kPieceLength, 0), p.at(kPieceLength, kPieceWidth),
             std::to_string((i + 1) % pieces.size()), next.at(0, kPieceWidth), next.at(0, 0));
    }
    file.render.max_depth = kLinks;
    return file;
}

View along(const MadeWorld& world, double pitch_tangent) {
    View view = look_from(world.map, {0.25, 1.125}, 1.5, 0);
    view.sector = SectorId(0u);
    view.fov_degrees = 12;
    view.pitch_tangent = pitch_tangent;
    return view;
}

/// The largest difference of depths, in parts of the depth, wherever the corridor of links is not cut.
double worst_depth(const Loop& pieces) {
    const MadeWorld linked(corridor_of(pieces));
    const MadeWorld straight(map_of({box_room("straight", 0, 0, 2 * kSeen, kPieceWidth, 0, 3)}));
    double worst = 0, deepest = 0;
    for (const double pitch : {-0.02, 0.0, 0.0125}) {
        const Drawn drawn = linked.draw(along(linked, pitch), kLoopSize),
                    truth = straight.draw(along(straight, pitch), kLoopSize);
        for (std::size_t i = 0; i < drawn.facts.ids.size(); ++i) {
            EXPECT_EQ(drawn.facts.writes[i], 1);
            if (drawn.facts.ids[i] == kRecursionEnd) continue;
            deepest = std::max(deepest, drawn.facts.depths[i]);
            worst = std::max(worst, std::fabs(drawn.facts.depths[i] / truth.facts.depths[i] - 1));
        }
        const Comparison result = linked.compare_with_reference(along(linked, pitch), kLoopSize);
        EXPECT_TRUE(result.is_faultless()) << describe(result);
    }
    EXPECT_GT(deepest, 0.8 * kSeen) << "the last links are seen";
    note_deviation(worst, "of the depth");
    return worst;
}

// hard case R25
TEST(LoopOfLinks, OfQuarterTurnsIsAsStraightAfter128LinksAsWithoutAny) {
    const Loop quarters{{{{1, 0}, {0, 0}}, {{0, 1}, {40, 7}}, {{-1, 0}, {-13, 60}}, {{0, -1}, {25, -30}}}};
    EXPECT_LE(worst_depth(quarters), 1e-12);
}

// Behind each link the eye is put onto the grid of points: at most 1.5 steps of it aside, 2.5 m from wall to wall.
// hard case R25
TEST(LoopOfLinks, OfOtherTurnsIsAsStraightAfter128LinksAsTheGridOfPointsAllows) {
    const Vec2 t{0.8, 0.6};
    const Loop others{{{{1, 0}, {0, 0}}, {t, {40, 7}}, {-t, {-13, 60}}, {right_of(t), {25, -30}}}};
    EXPECT_LE(worst_depth(others), kLinks * 1.5 * kPointGrid / (kPieceWidth / 2));
}

}  // namespace
}  // namespace enfilade::test
