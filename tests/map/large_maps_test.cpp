// Large maps: everything is found, and the work grows no faster than n log n. Times are printed, not asserted: a
// machine may be busy, the work done is the same on all.
#include <gmock/gmock.h>

#include <cstdio>
#include <ctime>

#include "formats/map_toml.h"
#include "map/edge_sweep.h"
#include "map/load.h"
#include "support/generate_map.h"

namespace enfilade {
namespace {

using namespace test;

/// Prints how much processor time passed in its life: on a busy machine the clock on the wall says little.
class Stopwatch {
public:
    explicit Stopwatch(const char* what) : what_(what), start_(std::clock()) {}
    ~Stopwatch() { std::printf("  %s: %.3f s\n", what_, static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC); }

private:
    const char* what_;
    std::clock_t start_;
};

Map built_in_time(const MapFile& file, const char* what) {
    const TextureSet textures = textures_for(file);
    Findings findings;
    std::optional<Map> map;
    {
        const Stopwatch stopwatch(what);
        map = build_map(file, textures, findings);
    }
    EXPECT_TRUE(map) << text_of(findings);
    return map ? std::move(*map) : Map();
}

std::size_t portals_in(const Map& map) {
    return static_cast<std::size_t>(
        std::count_if(map.walls.begin(), map.walls.end(), [](const Wall& w) { return w.kind == WallKind::portal; }));
}

TEST(LargeMaps, OfFiftyThousandSectorsAreBuilt) {
    const Map map = built_in_time(grid_of_rooms(50'000), "building 50 000 sectors");
    EXPECT_EQ(map.sectors.size(), 50'000u);
    EXPECT_EQ(portals_in(map), 98'876u);
}

TEST(LargeMaps, OfFiftyThousandSectorsAreLoadedFromText) {
    const std::string text = write_map(grid_of_rooms(50'000));
    const FileReader reader = [&](const std::string& path) -> Result<Bytes> {
        if (!path.ends_with(".toml")) return Error{path, "no such file"};
        const auto bytes = std::as_bytes(std::span(text));
        return Bytes(bytes.begin(), bytes.end());
    };
    std::printf("  %zu bytes\n", text.size());
    const Stopwatch stopwatch("loading 50 000 sectors");
    const LoadedMap loaded = load_map("grid.toml", {}, reader);
    ASSERT_TRUE(loaded.map) << text_of(loaded.findings);
    EXPECT_EQ(loaded.map->sectors.size(), 50'000u);
}

// hard case T15
TEST(LargeMaps, MayHaveAHundredThousandSectorsAroundOneVertex) {
    const Map map = built_in_time(fan_of_sectors(100'000), "building a fan of 100 000 sectors");
    EXPECT_EQ(portals_in(map), 200'000u);
}

TEST(LargeMaps, MayHaveASectorOfTwentyThousandWalls) {
    const Map map = built_in_time(comb(5'000), "building a sector of 20 000 walls");
    EXPECT_EQ(map.walls.size(), 20'003u);
}

TEST(LargeMaps, LookAtEachEdgesNeighboursOnly) {
    const Map map = built(comb(5'000));
    const SweepFindings found = sweep_edges(map.walls);
    EXPECT_LE(found.pairs_looked_at, 3 * map.walls.size());
}

TEST(LargeMaps, ReportAThousandErrorsAndThatThereAreMore) {
    MapFile file = map_of({});
    for (int i = 0; i < 3'000; ++i) file.sectors.push_back(box_room("room" + std::to_string(i), 0, 0, 1, 1, 1, 0));
    const Findings findings = findings_of(file);
    EXPECT_EQ(std::count_if(findings.begin(), findings.end(), [](auto& f) { return f.code == "ceiling-below-floor"; }),
              1000);
    EXPECT_EQ(std::count_if(findings.begin(), findings.end(), [](auto& f) { return f.code == "too-many-errors"; }), 1);
}

TEST(LargeMaps, ReportAThousandWarningsAndThatThereAreMore) {
    MapFile file = map_of({});
    for (int i = 0; i < 3'000; ++i) {
        file.sectors.push_back(box_room("room" + std::to_string(i), 0, 0, 1, 1));
        file.sectors.back().floor.texture.reset();
    }
    Findings findings;
    EXPECT_TRUE(build_map(file, textures_for(file), findings));
    EXPECT_EQ(findings.size(), 1001u);
}

TEST(LargeMaps, WithAnErrorInEveryNameTakeNoLonger) {
    MapFile file = grid_of_rooms(20'000);
    for (SectorRecord& s : file.sectors)
        for (WallRecord& wall : s.loops.front().walls)
            if (!wall.next.empty()) wall.next += "x";
    const Stopwatch stopwatch("refusing 40 000 unknown names");
    EXPECT_TRUE(has_errors(findings_of(file)));
}

TEST(LargeMaps, WithEveryTwinMissingTakeNoLonger) {
    MapFile file = map_of({comb(5'000).sectors[0], box_room("other", 0, -10, 1, -5)});
    for (WallRecord& wall : file.sectors[0].loops[0].walls) wall.next = "comb";
    const Stopwatch stopwatch("refusing 20 000 portals without twins");
    EXPECT_TRUE(has_errors(findings_of(file)));
}

}  // namespace
}  // namespace enfilade
