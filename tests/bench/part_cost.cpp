// What the parts of the engine cost, each alone: inner loops by the length of a run, questions about a map by its size,
// loading, conversion. Timed by Google Benchmark; `part_cost --help` says how to choose.
#include <benchmark/benchmark.h>

#include <functional>

#include "base/hash.h"
#include "formats/map_toml.h"
#include "math/vec.h"
#include "render/column/kernels.h"
#include "space/trace.h"
#include "support/generate_map.h"
#include "wadconv/freedoom/wads.h"

using namespace enfilade;

namespace {

constexpr int kLongestRun = 800;     ///< a picture's height [px]
constexpr std::uint32_t kSide = 64;  ///< of a texture, as most of Doom's have [px]

Texture texture_of_noise() {
    Random random(1);
    Texture texture;
    texture.width = texture.height = kSide;
    for (std::uint32_t i = 0; i < kSide * kSide; ++i)
        texture.pixels.push_back(0xFF000000u | static_cast<std::uint32_t>(random.below(1u << 24)));
    return texture;
}

/// A column of `state.range(0)` rows, drawn over and over.
struct Column {
    std::vector<std::uint32_t> pixels = std::vector<std::uint32_t>(kLongestRun);
    int top = 0, bottom;

    explicit Column(const benchmark::State& state) : bottom(static_cast<int>(state.range(0))) {}
    column::ColumnRuns runs() { return {pixels.data(), kLongestRun, 1, &top, &bottom}; }
};

/// Times fill(), and tells pixels per second.
void time_runs(benchmark::State& state, const std::function<void()>& fill) {
    for (auto round : state) {
        fill();
        benchmark::ClobberMemory();
    }
    state.SetLabel(std::string(column::chosen_kernels().name));
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * state.range(0));
}

void fill_wall(benchmark::State& state) {
    const Texture texture = texture_of_noise();
    Column drawn(state);
    const std::uint32_t first_texel = 0;
    const column::TileSteps at_row_0 = 0, per_row = column::tile_steps(0.7 / kSide);
    const Shade shade = 200;
    const column::PlainWalls wall{drawn.runs(), &texture, &first_texel, &at_row_0, &per_row, &shade, nullptr};
    time_runs(state, [&, fill = column::chosen_kernels().fill_walls] { fill(wall); });
}

void fill_flat(benchmark::State& state) {
    const Texture texture = texture_of_noise();
    Column drawn(state);
    std::vector<double> depths;
    for (int row = 0; row < kLongestRun + column::kRowsBeyond; ++row) depths.push_back(400.0 / (row + 1));
    const std::vector<std::uint32_t> darkness(depths.size(), column::darkness_of(nullptr, 200));
    const double step_u = 0.5, step_v = 0.3, farthest = 1000;
    const column::PlainFlats flat{drawn.runs(),  &texture,        0,      0, &step_u, &step_v, &farthest,
                                  depths.data(), darkness.data(), nullptr};
    time_runs(state, [&, fill = column::chosen_kernels().fill_flats] { fill(flat); });
}

void read_flat(benchmark::State& state) {
    const Texture texture = texture_of_noise();
    Column drawn(state);
    std::vector<double> depths;
    for (int row = 0; row < kLongestRun + column::kRowsBeyond; ++row) depths.push_back(400.0 / (row + 1));
    const double step_u = 0.5, step_v = 0.3, farthest = 1000;
    const column::PlainFlats flat{drawn.runs(), &texture,      0,       0,      &step_u, &step_v,
                                  &farthest,    depths.data(), nullptr, nullptr};
    time_runs(state, [&, fill = column::chosen_kernels().read_flats] { fill(flat); });
}

/// A grid of 10 m each way that gets brighter from one corner on.
LightGrid grid_of_light() {
    constexpr int kPoints = 40;
    LightGrid grid;
    grid.columns = grid.rows = kPoints;
    for (std::uint32_t i = 0; i < kPoints * kPoints; ++i) grid.cells.push_back(light_cell(i, i / 2, i / 3));
    return grid;
}

/// Below an eye 1.6 m high, from 0.8 m away on.
void light_flat(benchmark::State& state) {
    constexpr double kEyeTimesFocal = 1.6 * 640;  // of 1280 columns that show 90 degrees [m px]
    const LightGrid grid = grid_of_light();
    Column drawn(state);
    std::vector<double> depths;
    for (int row = 0; row < kLongestRun + column::kRowsBeyond; ++row) depths.push_back(kEyeTimesFocal / (row + 100));
    const std::vector<std::uint32_t> shades(depths.size(), column::darkness_of(nullptr, 200));
    const column::FlatLamplight lamplight{&grid, 2 + kGridShift, 3 + kGridShift, 3.1, 2.4,
                                          9,     depths.data(),  shades.data()};
    const column::LitRun lit{{drawn.pixels.data(), 0, drawn.bottom}};
    time_runs(state,
              [&, light = column::passes_beside(column::chosen_kernels()).lamps.light_flat] { light(lit, lamplight); });
}

/// 3 m away.
void light_wall(benchmark::State& state) {
    constexpr int kPoints = 40;
    std::vector<std::uint32_t> cells(kPoints + 2 * column::kCellsBeyond, 0x01000200);
    Column drawn(state);
    const column::LightRow row{cells.data() + column::kCellsBeyond, cells.data() + column::kCellsBeyond, kPoints};
    const auto in_steps = [](double points) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(points * 0x1p32));
    };
    const column::WallLamplight lamplight{200, row, in_steps(kPoints - 2), in_steps(-3 / 640.0 * kUsualLightPoints)};
    const column::LitRun lit{{drawn.pixels.data(), 0, drawn.bottom}};
    time_runs(state,
              [&, light = column::passes_beside(column::chosen_kernels()).lamps.light_wall] { light(lit, lamplight); });
}

MapFile grid_of(const benchmark::State& state) {
    return test::RoomGrid(static_cast<std::size_t>(state.range(0)), 1).take();
}

constexpr std::size_t kPlaces = 1024;

/// Somewhere in rooms anywhere in the map.
std::vector<Place> places_in(const Map& map) {
    Random random(2);
    std::vector<Place> places;
    while (places.size() < kPlaces) {
        const Sector& sector = map.sectors[random.below(map.sectors.size())];
        const Vec2 middle = snap_to_point_grid((sector.min + sector.max) * 0.5);
        if (const SectorId found = ::enfilade::locate(map, middle)) places.push_back({found, middle});
    }
    return places;
}

void locate(benchmark::State& state) {
    const Map map = test::built(grid_of(state));
    const std::vector<Place> places = places_in(map);
    std::size_t i = 0;
    for (auto round : state) benchmark::DoNotOptimize(::enfilade::locate(map, places[i++ % kPlaces].point));
}

/// A look ahead of 20 m: through doors, or to the next wall.
void cross(benchmark::State& state) {
    const Map map = test::built(grid_of(state));
    const std::vector<Place> places = places_in(map);
    std::size_t i = 0;
    for (auto round : state) {
        const Place& place = places[i++ % kPlaces];
        benchmark::DoNotOptimize(trace(map, place, place.point + Vec2{20, 0}));
    }
}

void read(benchmark::State& state) {
    const std::string text = write_map(grid_of(state));
    for (auto round : state) benchmark::DoNotOptimize(read_map(text));
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * text.size()));
}

void build(benchmark::State& state) {
    const MapFile file = grid_of(state);
    const TextureSet textures = test::textures_for(file);
    for (auto round : state) {
        Findings findings;
        benchmark::DoNotOptimize(build_map(file, textures, findings));
    }
}

/// All maps of a game, without writing them.
void convert(benchmark::State& state) {
    const test::FreeDoomWad wad{"freedoom1", 36};
    if (test::is_missing(wad)) {
        state.SkipWithError(test::kMissing);
        return;
    }
    const test::ReadWad read(wad);
    for (auto round : state)
        for (const wadconv::DoomMap& doom : read.maps)
            benchmark::DoNotOptimize(wadconv::convert_map(doom, read.pictures, read.sounds, {}));
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * read.maps.size()));
}

BENCHMARK(fill_wall)->Arg(7)->Arg(64)->Arg(kLongestRun);
BENCHMARK(fill_flat)->Arg(7)->Arg(64)->Arg(kLongestRun);
BENCHMARK(read_flat)->Arg(64)->Arg(kLongestRun);
BENCHMARK(light_wall)->Arg(64)->Arg(kLongestRun);
BENCHMARK(light_flat)->Arg(64)->Arg(kLongestRun);
BENCHMARK(locate)->Arg(1000)->Arg(100'000);
BENCHMARK(cross)->Arg(1000)->Arg(100'000);
BENCHMARK(read)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(build)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(convert)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
