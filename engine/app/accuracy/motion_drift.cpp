// How far a body drifts that goes through turned links over and over.
#include <algorithm>
#include <cmath>

#include "app/accuracy/motion.h"
#include "app/accuracy/true_texels.h"
#include "base/hash.h"
#include "space/trace.h"

namespace enfilade {
namespace {

constexpr long double kTurn = 2 * 3.14159265358979323846264338327950288L;  ///< [rad]

/// One pass of the walk.
struct LinkPass {
    Vec2 step;  ///< since the pass before, in the space before the link [m]
    WallId portal;
    bool is_arrived;  ///< the way ended behind it
    Vec2 place;       ///< if so: where the engine says the body is
};

struct Walked {
    Map map;
    std::vector<LinkPass> passes;
};

constexpr Vec2 kStart{3, 1.5};

/// A room with a wall turned by `slant` and a wall along y that is as long, each leading to the other.
Map linked_room(Vec2 slant, double length) {
    SectorRecord room = plain_room("a", {{0, 0}, {6, 0}, Vec2{6, 0} + slant, {0, slant.y + 4}, {0, length}}, {});
    WallRecord &there = room.loops[0].walls[1], &back = room.loops[0].walls[4];
    there.name = back.via = "there";
    back.name = there.via = "back";
    there.next = back.next = "a";
    return plain_map({room});
}

Walked walk_through(Map map, std::uint64_t passes) {
    constexpr double kReach = 5;
    constexpr std::uint64_t kDriftSeed = 2;
    Random random(kDriftSeed);
    Walked walked{std::move(map), {}};
    Place place{SectorId(0u), kStart};
    Vec2 step;
    while (walked.passes.size() < passes) {
        const Vec2 way = snap_to_point_grid({random.uniform(-kReach, kReach), random.uniform(-kReach, kReach)});
        const Trace trace = enfilade::trace(walked.map, place, place.point + way);
        if (trace.is_stopped()) continue;
        step = step + way;
        for (const Crossing& crossing : trace.crossings) {
            walked.passes.push_back({step, crossing.portal, false, {}});
            step = {};
        }
        if (!trace.crossings.empty()) {
            walked.passes.back().is_arrived = true;
            walked.passes.back().place = trace.end.point;
        }
        place = trace.end;
    }
    walked.passes.resize(passes);
    return walked;
}

/// Never far from the true root: two steps of Newton's from a double double its digits twice.
Quad root(Quad x) {
    Quad root = std::sqrt(static_cast<double>(x));
    for (int i = 0; i < 2; ++i) root = (root + x / root) / 2;
    return root;
}

/// The truth, from the corners of the map alone.
struct TruePose {
    Quad x = kStart.x, y = kStart.y, ahead = 1, right = 0;

    void move(Vec2 step) {
        x += step.x;
        y += step.y;
    }
    void pass(const Map& map, const Wall& portal) {
        const Wall& exit = map[portal.exit];
        const Vec2 from = portal.b - portal.a, onto = exit.a - exit.b;
        const Quad along = Quad(from.x) * onto.x + Quad(from.y) * onto.y;
        const Quad across = Quad(from.x) * onto.y - Quad(from.y) * onto.x;
        const Quad length = root(along * along + across * across), c = along / length, s = across / length;
        const Quad dx = x - (Quad(portal.a.x) + portal.b.x) / 2, dy = y - (Quad(portal.a.y) + portal.b.y) / 2;
        x = (Quad(exit.a.x) + exit.b.x) / 2 + c * dx - s * dy;
        y = (Quad(exit.a.y) + exit.b.y) / 2 + s * dx + c * dy;
        const Quad turned = c * ahead - s * right;
        right = s * ahead + c * right;
        ahead = turned;
    }
};

/// The engine's: a bijection of the grid, and angles in steps of 2^-64 turn.
class GridCarrier {
public:
    explicit GridCarrier(const Map& map) : map_(map) {
        for (const Rigid& link : map.links) turns_.push_back(fine_turn_of({link.c, link.s}));
    }
    void pass(const LinkPass& pass) {
        const Wall& portal = map_[pass.portal];
        place_ = map_.carried(portal, place_ + pass.step);
        turn_ += turns_[portal.link];
    }
    Vec2 place() const { return place_; }
    long double heading() const { return static_cast<long double>(turn_) * 0x1p-64L * kTurn; }

private:
    const Map& map_;
    std::vector<std::uint64_t> turns_;
    Vec2 place_ = kStart;
    std::uint64_t turn_ = 0;
};

/// A matrix and a shift for each link, as most engines have them; the heading is turned by the same matrix.
template <class Real>
class MatrixCarrier {
public:
    explicit MatrixCarrier(const Map& map) : map_(map) {
        for (const Rigid& link : map.links)
            links_.push_back({static_cast<Real>(link.c), static_cast<Real>(link.s), static_cast<Real>(link.shift.x),
                              static_cast<Real>(link.shift.y)});
    }
    void pass(const LinkPass& pass) {
        const RealLink& link = links_[map_[pass.portal].link];
        const Real x = x_ + static_cast<Real>(pass.step.x), y = y_ + static_cast<Real>(pass.step.y);
        x_ = link.c * x - link.s * y + link.x;
        y_ = link.s * x + link.c * y + link.y;
        const Real ahead = link.c * ahead_ - link.s * right_;
        right_ = link.s * ahead_ + link.c * right_;
        ahead_ = ahead;
    }
    Vec2 place() const { return {static_cast<double>(x_), static_cast<double>(y_)}; }
    long double heading() const {
        return std::atan2(static_cast<long double>(right_), static_cast<long double>(ahead_));
    }

private:
    struct RealLink {
        Real c, s, x, y;
    };
    const Map& map_;
    std::vector<RealLink> links_;
    Real x_ = static_cast<Real>(kStart.x), y_ = static_cast<Real>(kStart.y), ahead_ = 1, right_ = 0;
};

/// Whole numbers of 1/65536, products cut down, and angles of 2^-32 turn: as in 1993.
class FixedCarrier {
public:
    explicit FixedCarrier(const Map& map) : map_(map) {
        for (const Rigid& link : map.links)
            links_.push_back(
                {in_steps(link.c), in_steps(link.s), in_steps(link.shift.x), in_steps(link.shift.y), turn(link)});
    }
    void pass(const LinkPass& pass) {
        const FixedLink& link = links_[map_[pass.portal].link];
        const std::int64_t x = x_ + in_steps(pass.step.x), y = y_ + in_steps(pass.step.y);
        x_ = product(link.c, x) - product(link.s, y) + link.x;
        y_ = product(link.s, x) + product(link.c, y) + link.y;
        turn_ += link.turn;
    }
    Vec2 place() const { return {static_cast<double>(x_) / kSteps, static_cast<double>(y_) / kSteps}; }
    long double heading() const { return static_cast<long double>(turn_) * 0x1p-32L * kTurn; }

private:
    struct FixedLink {
        std::int64_t c, s, x, y;
        std::uint32_t turn;
    };
    static constexpr double kSteps = 65536;
    static std::int64_t in_steps(double x) { return std::llround(x * kSteps); }
    static std::int64_t product(std::int64_t a, std::int64_t b) { return a * b >> 16; }
    static std::uint32_t turn(const Rigid& link) { return angle_of({link.c, link.s}).steps; }

    const Map& map_;
    std::vector<FixedLink> links_;
    std::int64_t x_ = in_steps(kStart.x), y_ = in_steps(kStart.y);
    std::uint32_t turn_ = 0;
};

double distance(const TruePose& truth, Vec2 place) {
    return std::hypot(static_cast<double>(Quad(place.x) - truth.x), static_cast<double>(Quad(place.y) - truth.y));
}

/// The angle between, by the sine and cosine of the difference: both headings are unit vectors, or almost.
double angle_from(const TruePose& truth, long double heading) {
    const Quad c = std::cos(heading), s = std::sin(heading);
    return std::fabs(std::atan2(static_cast<double>(truth.ahead * s - truth.right * c),
                                static_cast<double>(truth.ahead * c + truth.right * s)));
}

/// Whether one who goes back and comes again is where he was, to the last bit.
template <class Carrier>
bool is_same_again(const Map& map, const LinkPass& pass, Carrier carrier) {
    const Vec2 before = carrier.place();
    carrier.pass({{}, map[pass.portal].exit, false, {}});
    carrier.pass({{}, pass.portal, false, {}});
    return carrier.place() == before;
}

/// What one way was off by, at each power of ten.
template <class Carrier>
void add_rows(const Walked& walked, const std::string& way, const std::string& link, bool is_engine,
              std::vector<DriftRow>& rows) {
    constexpr std::uint64_t kFirst = 1000;
    Carrier carrier(walked.map);
    TruePose truth;
    DriftRow row{way, link, 0, 0, 0, 0, {}};
    std::uint64_t same = 0;
    std::uint64_t next = kFirst;
    for (const LinkPass& pass : walked.passes) {
        carrier.pass(pass);
        truth.move(pass.step);
        truth.pass(walked.map, walked.map[pass.portal]);
        ++row.passes;
        const bool is_told = is_engine && pass.is_arrived;  // by its traces, which do more than carry
        row.position_m = std::max(row.position_m, distance(truth, is_told ? pass.place : carrier.place()));
        row.heading_rad = std::max(row.heading_rad, angle_from(truth, carrier.heading()));
        same += is_same_again(walked.map, pass, carrier);
        if (row.passes != next) continue;
        row.same_again = static_cast<double>(same) / static_cast<double>(row.passes);
        rows.push_back(row);
        next *= 10;
    }
}

template <class Carrier>
std::function<void()> all_passes(const Walked& walked, std::uint64_t count, Vec2& end) {
    return [&walked, count, &end] {
        Carrier carrier(walked.map);
        for (std::uint64_t i = 0; i < count; ++i) carrier.pass(walked.passes[i]);
        end = end + carrier.place();  // so that nobody leaves the work out
    };
}

std::vector<DriftRow> drift_through(const std::string& link, Map map, const MotionPlan& plan) {
    constexpr std::uint64_t kMostTimed = 100'000;  // a few MB, which stay in cache
    const Walked walked = walk_through(std::move(map), plan.passes);
    std::vector<DriftRow> by_way[4];
    add_rows<GridCarrier>(walked, "engine", link, true, by_way[0]);
    add_rows<MatrixCarrier<double>>(walked, "matrix in double", link, false, by_way[1]);
    add_rows<MatrixCarrier<float>>(walked, "matrix in float", link, false, by_way[2]);
    add_rows<FixedCarrier>(walked, "16.16", link, false, by_way[3]);
    const std::uint64_t count = std::min(plan.passes, kMostTimed);
    Vec2 end;
    const std::vector<MotionPrice> prices = prices_in_turn(
        {all_passes<GridCarrier>(walked, count, end), all_passes<MatrixCarrier<double>>(walked, count, end),
         all_passes<MatrixCarrier<float>>(walked, count, end), all_passes<FixedCarrier>(walked, count, end)},
        count, plan.rounds);
    ENFILADE_CHECK(std::isfinite(end.x));
    std::vector<DriftRow> rows;
    for (std::size_t way = 0; way < prices.size(); ++way)
        for (DriftRow& row : by_way[way]) {
            row.price = prices[way];
            rows.push_back(row);
        }
    return rows;
}

}  // namespace

std::vector<DriftRow> measure_drift(const MotionPlan& plan) {
    constexpr double kOddDegrees = 37, kOddLength = 4;
    // 2.5 : 2.625 : 3.625 are 20 : 21 : 29, so that sine and cosine are fractions of whole numbers.
    std::vector<DriftRow> rows = drift_through("20/21/29", linked_room({2.5, 2.625}, 3.625), plan);
    const Vec2 slant = snap_to_vertex_grid(direction(Angle::from_degrees(90 - kOddDegrees)) * kOddLength);
    const std::vector<DriftRow> odd = drift_through("37 degrees", linked_room(slant, kOddLength), plan);
    rows.insert(rows.end(), odd.begin(), odd.end());
    return rows;
}

double most_drift_m(std::uint64_t passes) { return 1.5 * kPointGrid * static_cast<double>(passes); }

double most_drift_rad(std::uint64_t passes) { return 1e-15 * static_cast<double>(passes); }

}  // namespace enfilade
