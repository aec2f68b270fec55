// How long a map takes to load: `map_load MAP`: "seconds processor_seconds peak_MiB sectors walls". Once it was loaded,
// the next time it comes from the user's cache (app/open_map.h).
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <ctime>

#include "app/open_map.h"

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const auto start = std::chrono::steady_clock::now();
    const auto loaded = enfilade::open_map(argv[1], {}, {});
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    const double processor = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    if (!loaded) return 1;
    rusage used;
    getrusage(RUSAGE_SELF, &used);
    constexpr double kKibibytesPerMebibyte = 1024;
    std::printf("%.2f %.2f %.0f %zu %zu\n", took.count(), processor,
                static_cast<double>(used.ru_maxrss) / kKibibytesPerMebibyte, loaded->map.sectors.size(),
                loaded->map.walls.size());
}
