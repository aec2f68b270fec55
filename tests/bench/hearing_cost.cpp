// What hearing costs a tick: `hearing_cost MAP [SOURCES]`: the ears in the middle of every sector in turn, the SOURCES
// (by default 4) nearest sectors with sounds of their own in a straight line all sounding. Prints mean, 99th percentile
// and longest time [us] of a search for all sectors, of one for these, and of a slice of that, of as many beams as a
// game follows a tick.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "app/open_map.h"
#include "space/hearing.h"
#include "space/trace.h"

using namespace enfilade;

namespace {

constexpr int kSlices = 10;

Vec2 middle_of(const Sector& sector) { return (sector.min + sector.max) * 0.5; }

/// What each sector that makes sounds is heard as.
std::vector<SoundSource> sources_of(const Map& map) {
    std::vector<SoundSource> sources;
    for (std::size_t i = 0; i < map.sectors.size(); ++i)
        for (const SoundId sound : {map.sectors[i].up_sound, map.sectors[i].stop_sound})
            if (sound) sources.push_back({SectorId(i), {}, map[sound].reach_m});
    return sources;
}

void print_times(const char* name, std::vector<double> times_us) {
    std::sort(times_us.begin(), times_us.end());
    double sum = 0;
    for (const double time : times_us) sum += time;
    std::printf("%s: mean %.1f, 99 %% %.1f, most %.1f us\n", name, sum / static_cast<double>(times_us.size()),
                times_us[times_us.size() * 99 / 100], times_us.back());
}

double time_us(auto& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
}

/// Of work that is the same each time.
double least_time_us(auto work) { return std::min({time_us(work), time_us(work), time_us(work)}); }

}  // namespace

int main(int count, char** words) {
    if (count < 2) return 2;
    const auto open = open_map(words[1], {}, {});
    if (!open) return 1;
    const Map& map = open->map;
    std::vector<SoundSource> all = sources_of(map);
    const std::size_t sounding = std::min<std::size_t>(all.size(), count > 2 ? std::strtoul(words[2], nullptr, 10) : 4);
    Hearing hearing(map);
    std::vector<double> full_us, seeking_us, slice_us;
    Hearing sliced[] = {Hearing(map), Hearing(map), Hearing(map)};  // all do the same
    const auto is_open = [&](WallId id, const Rigid&) {
        const Wall& wall = map[id];
        return std::max(map[wall.sector].floor.z, map[wall.behind].floor.z) <
               std::min(map[wall.sector].ceiling.z, map[wall.behind].ceiling.z);
    };
    for (const Sector& sector : map.sectors) {
        const Vec2 ear = snap_to_point_grid(middle_of(sector));
        const SectorId inside = locate(map, ear);
        if (!inside) continue;
        const auto far = [&](const SoundSource& source) {
            const Vec2 away = middle_of(map[source.sector]) - ear;
            return dot(away, away);
        };
        std::ranges::sort(all, {}, far);
        const std::span<const SoundSource> near = std::span(all).first(sounding);
        full_us.push_back(least_time_us([&] { hearing.listen({inside, ear}, map.farthest_sound_m, is_open); }));
        for (int slice = 0; slice < kSlices; ++slice)
            slice_us.push_back(least_time_us(
                [&, i = 0]() mutable { sliced[i++].listen({inside, ear}, near, is_open, Hearing::kBeamsATick); }));
        seeking_us.push_back(least_time_us([&] { hearing.listen({inside, ear}, near, is_open); }));
    }
    std::printf("%zu sounds of sectors, %zu of them at a time, %zu ears\n", all.size(), sounding, full_us.size());
    print_times("all", std::move(full_us));
    print_times("these", std::move(seeking_us));
    print_times("a slice", std::move(slice_us));
}
