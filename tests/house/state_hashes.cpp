#include "house/state_hashes.h"

#include <cstdio>

#include "base/hash.h"
#include "math/angle.h"
#include "math/predicates.h"
#include "math/vec.h"

namespace enfilade::house {
namespace {

constexpr int kRounds = 20'000;

Vec2 random_point(Random& random) {
    return snap_to_point_grid(Vec2{random.uniform(-1000, 1000), random.uniform(-1000, 1000)});
}

std::uint64_t hash_of_angles() {
    Random random(1);
    Hash hash;
    for (int i = 0; i < kRounds; ++i) {
        const Angle angle = Angle::from_degrees(random.uniform(-1e6, 1e6));
        const Vec2 ahead = direction(angle);
        hash.add(angle.steps);
        hash.add(ahead.x);
        hash.add(ahead.y);
        hash.add(tangent(angle));
        hash.add(turn_of(ahead));
    }
    return hash.value();
}

std::uint64_t hash_of_decisions() {
    Random random(2);
    Hash hash;
    for (int i = 0; i < kRounds; ++i) {
        const Vec2 p = random_point(random), q = random_point(random), a = random_point(random),
                   b = random_point(random);
        hash.add(side_of_line(a, b, p));
        hash.add(exact_cross(a, b, p));
        hash.add(path_leaves_through(p, q, a, b));
        if (side_of_line(a, b, p) != side_of_line(a, b, q)) hash.add(fraction_along_path(p, q, a, b).value());
    }
    return hash.value();
}

/// Walks a point through a thousand turned doorways at a time, snapped after each as the engine does.
std::uint64_t hash_of_rigid_maps() {
    Random random(3);
    Hash hash;
    for (int walk = 0; walk < kRounds / 1000; ++walk) {
        Vec2 here = random_point(random);
        Rigid home;
        for (int i = 0; i < 1000; ++i) {
            const Vec2 turn = direction(Angle::from_degrees(random.uniform(0, 360)));
            const Rigid doorway{turn.x, turn.y, i % 7 == 0 ? -1.0 : 1.0, random_point(random) * 0x1p-4, 0.25};
            here = snap_to_point_grid(doorway.apply(here) * 0.5);
            home = then(home, inverse(doorway));
            hash.add(here.x);
            hash.add(here.y);
        }
        hash.add(home.shift.x);
        hash.add(home.s);
    }
    return hash.value();
}

std::uint64_t hash_of_grids() {
    Random random(4);
    Hash hash;
    for (int i = 0; i < kRounds; ++i) {
        const double x = random.uniform(-kWorldLimit, kWorldLimit);
        hash.add(snap_to_vertex_grid(x));
        hash.add(to_grid_units(snap_to_point_grid(x / 3)));
    }
    return hash.value();
}

}  // namespace

std::vector<NamedHash> state_hashes() {
    return {{"angles", hash_of_angles()},
            {"decisions", hash_of_decisions()},
            {"grids", hash_of_grids()},
            {"rigid_maps", hash_of_rigid_maps()}};
}

std::string to_text(const NamedHash& hash) {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llX", static_cast<unsigned long long>(hash.value));
    return hash.name + " " + digits;
}

}  // namespace enfilade::house
