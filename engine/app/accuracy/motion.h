// What exactness of motion gives and costs: how far one drifts through a million turned links, how often one stands in
// the wrong room, and how long a step takes. By the engine's way and by ways that are usual elsewhere.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "map/map.h"

namespace enfilade {

/// Of the rounds, in which all ways had their turn [ns].
struct MotionPrice {
    double least_ns = 0, median_ns = 0;
};

/// One way to carry a body through links, after so many passes.
struct DriftRow {
    std::string way;           ///< the first is the engine's
    std::string link;          ///< by how much it turns
    std::uint64_t passes = 0;  ///< a power of ten
    double position_m = 0;     ///< largest distance from the truth so far [m]
    double heading_rad = 0;    ///< largest angle from the true heading so far [rad]
    double same_again =
        0;              ///< share of passes after which one who goes back and comes again is where he was, to the bit
    MotionPrice price;  ///< of a pass
};

/// One way to know which room one is in, at one rate of ticks.
struct CrossingRow {
    std::string way;              ///< the first is the engine's
    int rate_hz = 0;              ///< ticks of a second
    std::uint64_t moves = 0;      ///< of one tick each, each from the right room
    std::uint64_t crossings = 0;  ///< of walls, by the truth's count of rooms that are left; the same for all ways
    std::uint64_t wrong = 0;      ///< ended in a room that the place is not in, nor on its walls
    std::uint64_t on_line = 0;    ///< ended in a room on whose wall the place is, and which is not its own
    MotionPrice price;            ///< of a move

    /// [parts per million]
    double wrong_ppm() const { return moves > 0 ? 1e6 * static_cast<double>(wrong) / static_cast<double>(moves) : 0; }
};

/// How much is tried.
struct MotionPlan {
    std::uint64_t passes = 1'000'000;  ///< through each link, >= 1000
    std::uint64_t moves = 300'000;     ///< at each rate, >= 1
    std::size_t rounds = 7;            ///< of timing, >= 1
};

/// A body walks at random in a room with a turned link, whose every pass is carried by each way. The truth is carried
/// in numbers of 113 bits, from the corners of the map; where a wall stops the body the step is left out. All ways are
/// told by the engine which links are passed, so that they differ by what they round alone.
/// Rows: links, then ways, then 10^3, 10^4, … passes.
std::vector<DriftRow> measure_drift(const MotionPlan& plan);

/// A body walks through triangles of two floors that lie over each other and go over into each other round a point,
/// half of its ways through corners, a quarter along walls. The truth is where the place is, found without any path:
/// by which floor, counted in whole numbers, and which of its triangles contains it under the tie rule.
/// Rows: rates, then ways.
std::vector<CrossingRow> measure_crossings(const MotionPlan& plan);

/// The most that the engine may drift by what its headers say: GridMap (math/vec.h), one and a half grid steps a
/// pass [m]; fine_turn_of() (math/angle.h), 1e-15 rad a pass [rad].
double most_drift_m(std::uint64_t passes);
double most_drift_rad(std::uint64_t passes);

/// Both tables, in Markdown.
std::string motion_page(const std::vector<DriftRow>& drifts, const std::vector<CrossingRow>& crossings);

/// The same as lines of values, each table with its names above.
std::string motion_csv(const std::vector<DriftRow>& drifts, const std::vector<CrossingRow>& crossings);

/// Nothing where the engine's drift is within its bounds, and none of its moves ends in a wrong room; else what is not.
Result<void> check_motion(const std::vector<DriftRow>& drifts, const std::vector<CrossingRow>& crossings);

// What both experiments need: maps made by a rule, and times of several ways in turn.

/// A room without pictures, clockwise on the drawing; each side leads to the room named, if any.
SectorRecord plain_room(std::string name, std::vector<Vec2> outline, const std::vector<std::string>& behind);

/// The map of these rooms, which are sound.
Map plain_map(std::vector<SectorRecord> rooms);

/// Lets each way do all of its `count` steps, one way after the other, round after round. Times are of a step.
std::vector<MotionPrice> prices_in_turn(const std::vector<std::function<void()>>& ways, std::uint64_t count,
                                        std::size_t rounds);

}  // namespace enfilade
