// How often a step ends in a wrong room.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/accuracy/motion.h"
#include "base/hash.h"
#include "math/predicates.h"
#include "space/trace.h"
#include "world/step.h"

namespace enfilade {
namespace {

// Two floors of squares, each cut into four triangles, over each other on the map. Along the seam, a straight line from
// the middle to the east, each floor goes over into the other: once round the middle one is on the other floor.

constexpr int kSide = 10;        ///< squares along a side of a floor, even
constexpr double kSquare = 0.5;  ///< [m]
constexpr double kMiddle = kSquare * kSide / 2;
constexpr int kTriangles = 4;  ///< of a square: north, east, south, west

std::string name_of(int floor, int column, int row, int triangle) {
    const std::array parts{floor, column, row, triangle};
    std::string name = "t";
    for (const int part : parts) name += "_" + std::to_string(part);
    return name;
}

int number_of(int floor, int column, int row, int triangle) {
    return ((floor * kSide + column) * kSide + row) * kTriangles + triangle;
}

/// The triangle across the outer side of a triangle; empty at the rim.
std::string name_across(int floor, int column, int row, int triangle) {
    constexpr std::array kAside{0, 1, 0, -1}, kDown{-1, 0, 1, 0};
    const auto t = static_cast<std::size_t>(triangle);
    const int other_column = column + kAside[t], other_row = row + kDown[t];
    if (other_column < 0 || other_column >= kSide || other_row < 0 || other_row >= kSide) return {};
    const bool is_seam = kDown[t] != 0 && std::max(row, other_row) == kSide / 2 && column >= kSide / 2;
    return name_of(is_seam ? 1 - floor : floor, other_column, other_row, (triangle + 2) % kTriangles);
}

SectorRecord triangle_room(int floor, int column, int row, int triangle) {
    const double x = column * kSquare, y = row * kSquare;
    const std::array corners{Vec2{x, y}, Vec2{x + kSquare, y}, Vec2{x + kSquare, y + kSquare}, Vec2{x, y + kSquare}};
    const Vec2 middle{x + kSquare / 2, y + kSquare / 2};
    const auto t = static_cast<std::size_t>(triangle);
    const int before = (triangle + kTriangles - 1) % kTriangles, after = (triangle + 1) % kTriangles;
    return plain_room(name_of(floor, column, row, triangle), {corners[t], corners[(t + 1) % 4], middle},
                      {name_across(floor, column, row, triangle), name_of(floor, column, row, after),
                       name_of(floor, column, row, before)});
}

Map two_floors() {
    std::vector<SectorRecord> rooms;
    for (int floor = 0; floor < 2; ++floor)
        for (int column = 0; column < kSide; ++column)
            for (int row = 0; row < kSide; ++row)
                for (int triangle = 0; triangle < kTriangles; ++triangle)
                    rooms.push_back(triangle_room(floor, column, row, triangle));
    return plain_map(std::move(rooms));
}

/// Of a floor, the triangle that contains the place: no path is asked.
SectorId triangle_of(const Map& map, int floor, Vec2 p) {
    // A place on the line between squares counts as a little to the right of it, and below.
    const int column = static_cast<int>(std::floor(p.x / kSquare)), row = static_cast<int>(std::floor(p.y / kSquare));
    for (int triangle = 0; triangle < kTriangles; ++triangle) {
        const SectorId id(static_cast<std::size_t>(number_of(floor, column, row, triangle)));
        if (contains(map, id, p)) return id;
    }
    ENFILADE_CHECK(false);
    return {};
}

int sign(Int128 x) { return (x > 0) - (x < 0); }

/// Whether the way, moved by (e, e^2) as the tie rule has it, goes over the seam: in whole numbers, from scratch.
bool goes_over_seam(Vec2 p, Vec2 q) {
    const bool is_below = p.y >= kMiddle, ends_below = q.y >= kMiddle;
    if (is_below == ends_below) return false;
    const Int128 dx = to_grid_units(q.x) - to_grid_units(p.x), dy = to_grid_units(q.y) - to_grid_units(p.y);
    const Int128 x = to_grid_units(kMiddle) - to_grid_units(p.x), y = to_grid_units(kMiddle) - to_grid_units(p.y);
    const int side = sign(dx * y - dy * x);  // of the middle, as seen along the way; 0: decided by e, then by e^2
    const int middle_side = side != 0 ? side : dy != 0 ? sign(dy) : -sign(dx);
    return ends_below ? middle_side > 0 : middle_side < 0;
}

// The walk.

/// One tick's way, and where it must end.
struct TickMove {
    SectorId from;
    Vec2 start, end;
    SectorId truth;
};

/// Corners and middles of squares.
Vec2 random_corner(Random& random) {
    const auto at = [&] { return kSquare * static_cast<double>(1 + random.below(kSide - 1)); };
    const Vec2 corner{at(), at()};
    return random.below(2) == 0 ? corner : corner + Vec2{kSquare / 2, kSquare / 2};
}

bool is_on_floor(Vec2 p) {
    constexpr double kLast = kSide * kSquare;
    return p.x > 0 && p.y > 0 && p.x < kLast && p.y < kLast;
}

/// Where the next leg leads: half of them straight through a corner, a quarter to one, which mostly is along walls or
/// to corners again, a quarter anywhere. Always whole steps of 2^-16 m, so that parts of a leg are on the grid.
Vec2 next_goal(Random& random, Vec2 from) {
    constexpr double kStep = 0x1p-16;
    const auto anywhere = [&] { return std::floor(random.uniform(0.01, kSide * kSquare - 0.01) / kStep) * kStep; };
    for (;;) {
        const std::uint64_t kind = random.below(4);
        const Vec2 corner = kind == 2 && random.below(4) == 0 ? Vec2{kMiddle, kMiddle} : random_corner(random);
        const Vec2 goal = kind < 2    ? corner + (corner - from) * static_cast<double>(1 + kind)
                          : kind == 2 ? corner
                                      : Vec2{anywhere(), anywhere()};
        if (is_on_floor(goal) && goal != from) return goal;
    }
}

/// Not faster than running; by how many powers of two a leg is cut is all that the rate changes.
std::vector<TickMove> walk_of(const Map& map, int rate_hz, std::uint64_t count) {
    constexpr std::uint64_t kCrossingSeed = 11;
    Random random(kCrossingSeed);
    std::vector<TickMove> moves;
    Vec2 at{0.25, 0.125};
    int floor = 0;
    while (moves.size() < count) {
        const Vec2 goal = next_goal(random, at), way = goal - at;
        int ticks = 1;
        while (std::sqrt(dot(way, way)) * rate_hz > kRunSpeed * ticks) ticks *= 2;
        for (int i = 0; i < ticks; ++i) {
            const Vec2 end = at + way * (1.0 / ticks);
            const SectorId from = triangle_of(map, floor, at);
            if (goes_over_seam(at, end)) floor = 1 - floor;
            moves.push_back({from, at, end, triangle_of(map, floor, end)});
            at = end;
        }
    }
    moves.resize(count);
    return moves;
}

// The ways to know the room at the end of a step.

SectorId by_trace(const Map& map, const TickMove& move) {
    return trace(map, {move.from, move.start}, move.end).end.sector;
}

constexpr double kEpsilon = 1e-9;  ///< as is usual [m, or of a way]

double behind(const Wall& wall, Vec2 p) { return -cross(wall.b - wall.a, p - wall.a) / wall.length; }

template <class Visit>
void each_portal(const Map& map, SectorId sector, Visit visit) {
    const Sector& s = map[sector];
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i)
        if (map.walls[i].kind == WallKind::portal && visit(map.walls[i])) return;
}

/// The room behind the first wall that the end is behind; none.
SectorId behind_first(const Map& map, SectorId sector, Vec2 end) {
    SectorId next;
    each_portal(map, sector, [&](const Wall& wall) {
        if (behind(wall, end) > kEpsilon) next = wall.behind;
        return next.index != SectorId().index;
    });
    return next;
}

/// Is the end of the step behind a wall? Then it is in the room there.
SectorId by_side_once(const Map& map, const TickMove& move) {
    const SectorId next = behind_first(map, move.from, move.end);
    return next ? next : move.from;
}

/// The same again and again, until it is behind none.
SectorId by_side(const Map& map, const TickMove& move) {
    constexpr int kMostRooms = 64;
    SectorId sector = move.from;
    for (int i = 0; i < kMostRooms; ++i) {
        const SectorId next = behind_first(map, sector, move.end);
        if (!next) break;
        sector = next;
    }
    return sector;
}

/// Randolph Franklin's test, by the sides that a ray to the right crosses.
bool is_in_polygon(const Map& map, SectorId sector, Vec2 p) {
    const Sector& s = map[sector];
    bool is_in = false;
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i) {
        const Vec2 a = map.walls[i].a, b = map.walls[i].b;
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) is_in = !is_in;
    }
    return is_in;
}

/// The room the step began in, else one beside it, else any that the end is in.
SectorId by_polygon(const Map& map, const TickMove& move) {
    if (is_in_polygon(map, move.from, move.end)) return move.from;
    SectorId found;
    each_portal(map, move.from, [&](const Wall& wall) {
        if (is_in_polygon(map, wall.behind, move.end)) found = wall.behind;
        return static_cast<bool>(found);
    });
    for (std::size_t i = 0; i < map.sectors.size() && !found; ++i) {
        const Sector& s = map.sectors[i];
        const Vec2 p = move.end;
        const bool is_near = p.x >= s.min.x && p.x <= s.max.x && p.y >= s.min.y && p.y <= s.max.y;
        if (is_near && is_in_polygon(map, SectorId(i), p)) found = SectorId(i);
    }
    return found ? found : move.from;
}

/// What the dial `crossing=naive` does.
SectorId by_place(const Map& map, const TickMove& move) {
    const SectorId found = locate_near(map, move.from, move.end);
    return found ? found : move.from;
}

/// Every wall on the way, nearest first, where both fractions are inside by an epsilon.
SectorId by_fractions(const Map& map, const TickMove& move) {
    constexpr int kMostRooms = 64;
    const Vec2 way = move.end - move.start;
    SectorId sector = move.from;
    double passed = 0;
    for (int i = 0; i < kMostRooms; ++i) {
        double nearest = 1;
        SectorId next;
        each_portal(map, sector, [&](const Wall& wall) {
            const Vec2 along = wall.b - wall.a;
            const double across = cross(way, along);
            if (across == 0) return false;
            const double t = cross(wall.a - move.start, along) / across;
            const double u = cross(wall.a - move.start, way) / across;
            const bool is_met = t > passed + kEpsilon && t < nearest && u > kEpsilon && u < 1 - kEpsilon;
            if (is_met) nearest = t, next = wall.behind;
            return false;
        });
        if (!next) break;
        sector = next;
        passed = nearest;
    }
    return sector;
}

struct WayToKnow {
    std::string name;
    SectorId (*room_of)(const Map& map, const TickMove& move);
};

const std::array<WayToKnow, 6>& all_ways() {
    static const std::array<WayToKnow, 6> ways{WayToKnow{"engine", by_trace},
                                               WayToKnow{"side of walls at the end, once", by_side_once},
                                               WayToKnow{"side of walls at the end, repeated", by_side},
                                               WayToKnow{"point in polygon at the end", by_polygon},
                                               WayToKnow{"the place alone, exactly (crossing=naive)", by_place},
                                               WayToKnow{"crossings in double, 1e-9", by_fractions}};
    return ways;
}

/// Whether the place is in the room or on its walls: triangles are convex.
bool is_in_closed(const Map& map, SectorId sector, Vec2 p) {
    const Sector& s = map[sector];
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i)
        if (exact_cross(map.walls[i].a, map.walls[i].b, p) < 0) return false;
    return true;
}

int floor_of(SectorId sector) { return static_cast<int>(sector.index) / (kSide * kSide * kTriangles); }

/// On the walls of both it may be in either. On the other floor it is nowhere, but right on the seam.
void add(const Map& map, const TickMove& move, SectorId room, CrossingRow& row) {
    ++row.moves;
    row.crossings += move.truth != move.from;
    if (room == move.truth) return;
    const bool is_on_seam = move.end.y == kMiddle && move.end.x >= kMiddle;
    const bool is_there = is_in_closed(map, room, move.end) && (floor_of(room) == floor_of(move.truth) || is_on_seam);
    ++(is_there ? row.on_line : row.wrong);
}

}  // namespace

std::vector<CrossingRow> measure_crossings(const MotionPlan& plan) {
    constexpr std::uint64_t kMostTimed = 30'000;
    const Map map = two_floors();
    std::vector<CrossingRow> rows;
    for (const int rate_hz : {35, 60, 140}) {
        const std::vector<TickMove> moves = walk_of(map, rate_hz, plan.moves);
        const std::uint64_t timed = std::min(plan.moves, kMostTimed);
        std::uint64_t sum = 0;  // so that nobody leaves the work out
        std::vector<std::function<void()>> timings;
        for (const WayToKnow& way : all_ways())
            timings.emplace_back([&, room_of = way.room_of] {
                for (std::uint64_t i = 0; i < timed; ++i) sum += room_of(map, moves[i]).index;
            });
        const std::vector<MotionPrice> prices = prices_in_turn(timings, timed, plan.rounds);
        ENFILADE_CHECK(sum > 0);
        for (std::size_t i = 0; i < prices.size(); ++i) {
            const WayToKnow& way = all_ways()[i];
            CrossingRow row{way.name, rate_hz, 0, 0, 0, 0, prices[i]};
            for (const TickMove& move : moves) add(map, move, way.room_of(map, move), row);
            rows.push_back(row);
        }
    }
    return rows;
}

}  // namespace enfilade
