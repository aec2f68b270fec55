// The longest ticks: `worst_tick [TICKS]`: random walks of TICKS (by default 20000; a hundred times as many in random
// maps) in maps that make walking hard: rooms at many heights, doorways that are links all round, wedges whose two
// sides are one, ramps of fine steps, and maps named on the command line. Prints, for each kind, the mean and the
// longest processor time of a tick [us], each the least of three times, and how many took over a millisecond.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <numbers>

#include "app/open_map.h"
#include "support/map_builder.h"
#include "world/random_walks.h"

using namespace enfilade;

namespace {

double processor_us() {
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) * 1e-3;
}

struct Times {
    double sum_us = 0, most_us = 0;
    int ticks = 0, over_a_millisecond = 0;
};

/// Does one tick. Its time is the least of some, for what else the machine does makes ticks longer; so memory that only
/// the first of them asks for is left out [us].
double time_tick(const Map& map, World& world, const TickInput& input) {
    constexpr int kRepeats = 3;
    double least = std::numeric_limits<double>::infinity();
    World next;
    for (int i = 0; i < kRepeats; ++i) {
        next = world;
        const double begin = processor_us();
        step(map, next, input);
        least = std::min(least, processor_us() - begin);
    }
    world = std::move(next);
    return least;
}

void walk_for(const Map& map, World world, std::uint64_t seed, int ticks, Times& times) {
    test::RandomKeys keys(seed);
    for (int i = 0; i < ticks; ++i) {
        const double took = time_tick(map, world, keys.next());
        world.health = kFullHealth;
        times.sum_us += took;
        times.most_us = std::max(times.most_us, took);
        times.over_a_millisecond += took > 1000;
        ++times.ticks;
    }
}

void print(const char* name, const Times& times) {
    std::printf("%-24s mean %7.1f us, longest %8.1f us, %d of %d over 1 ms\n", name, times.sum_us / times.ticks,
                times.most_us, times.over_a_millisecond, times.ticks);
}

/// A wedge whose two sides are one: around its tip there is only its own angle.
Map wedge(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    const Vec2 tip{0, 0}, right{8, 0}, left = snap_to_vertex_grid({8 * std::cos(angle), 8 * std::sin(angle)});
    MapFile file = test::map_of({test::room("wedge", {tip, right, left})});
    test::link(file, "wedge", tip, right, "wedge", left, tip);
    return test::built(file);
}

/// A ramp of steps as narrow as there are [m], 2 m long.
Map ramp(double step) {
    std::vector<SectorRecord> rooms;
    for (double x = 0; x < 2; x += step) {
        rooms.push_back(test::box_room(std::to_string(x), x, 0, x + step, 4));
        rooms.back().floor.z = x / 4;
    }
    MapFile file = test::map_of(std::move(rooms));
    test::join_all(file);
    return test::built(file);
}

}  // namespace

int main(int count, char** words) {
    const int ticks = count > 1 ? std::atoi(words[1]) : 20000;
    Times steps, octagons;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        Random random(seed);
        const Map of_steps = test::mosaic_of_steps(seed), of_links = test::octagons_of_links(seed);
        walk_for(of_steps, test::start_somewhere(of_steps, random), seed, ticks / 20, steps);
        walk_for(of_links, test::start_somewhere(of_links, random), seed, ticks / 20, octagons);
    }
    print("rooms at many heights", steps);
    print("octagons of links", octagons);
    for (const double degrees : {30.0, 3.0, 0.3, 0.1, 0.03, 0.01}) {
        Times times;
        Random random(1);
        const Map map = wedge(degrees);
        World world = test::start_somewhere(map, random);
        world.player.place.point = snap_to_point_grid(map.walls[0].a + Vec2{0.5, 0.25 * degrees / 57});
        walk_for(map, world, 1, ticks / 10, times);
        print(("wedge of " + std::to_string(degrees).substr(0, 5) + " degrees").c_str(), times);
    }
    for (const double step : {0x1p-4, 0x1p-7, 0x1p-8, 0x1p-10}) {
        Times times;
        Random random(1);
        const Map map = ramp(step);
        walk_for(map, test::start_somewhere(map, random), 1, ticks / 10, times);
        print(("ramp of steps of 1/" + std::to_string(static_cast<int>(1 / step)) + " m").c_str(), times);
    }
    for (int i = 2; i < count; ++i) {
        const auto open = open_map(words[i], {}, {});
        if (!open) return 1;
        Times times;
        walk_for(open->map, *start_of(open->map), 1, ticks, times);
        print(words[i], times);
    }
}
