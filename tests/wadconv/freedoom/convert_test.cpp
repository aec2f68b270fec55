// The real thing: all 100 maps of FreeDoom, from the Debian packages freedoom and freedm.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>
#include <set>

#include "formats/map_toml.h"
#include "map/load.h"
#include "wadconv/convert.h"
#include "wadconv/freedoom/wads.h"
#include "wadconv/parts.h"

namespace enfilade::wadconv {
namespace {

using namespace test;

/// One WAD with its maps, read once for all tests of it.
class FreeDoom : public ::testing::TestWithParam<FreeDoomWad> {
protected:
    void SetUp() override {
        if (is_missing(GetParam())) GTEST_SKIP() << kMissing;
        wad_.emplace(GetParam());
    }

    std::optional<ReadWad> wad_;
};

void print_report_row(const Report& r) {
    std::printf(
        "%-6s %6zu lines %5zu -> %5zu sectors %6zu walls %3zu panels %5zu things;"
        " %4zu converted %3zu repaired %3zu guessed %2zu dropped\n",
        lower(r.map).c_str(), r.lines, r.sectors, r.parts, r.walls, r.panels, r.placed_things, r.count(Fate::converted),
        r.count(Fate::repaired), r.count(Fate::guessed), r.count(Fate::dropped));
}

// hard case W14
TEST_P(FreeDoom, ConvertsEveryMapSoThatItPassesTheCheck) {
    EXPECT_EQ(wad_->maps.size(), GetParam().maps);
    const TextureSet sizes = wad_->pictures.sizes();
    for (const DoomMap& map : wad_->maps) {
        const Conversion conversion = convert_map(map, wad_->pictures, wad_->sounds, {});
        ASSERT_TRUE(conversion.file) << map.name << ": " << conversion.report.refused;
        MapReading reading = read_map(write_map(*conversion.file));
        EXPECT_TRUE(build_map(reading.map, sizes, reading.findings)) << map.name;
        for (const Finding& finding : reading.findings) ADD_FAILURE() << to_text(map.name, finding);
        EXPECT_TRUE(conversion.report.sides.is_complete()) << map.name;
        print_report_row(conversion.report);
    }
}

TEST_P(FreeDoom, OpensItsDoorsToMapsThatPassTheCheckToo) {
    const TextureSet sizes = wad_->pictures.sizes();
    for (const DoomMap& map : wad_->maps) {
        const Conversion conversion = convert_map(map, wad_->pictures, wad_->sounds, {.open_doors = true});
        Findings findings;
        EXPECT_TRUE(build_map(conversion.file.value(), sizes, findings)) << map.name;
    }
}

/// Twice each sector's area by its edges [map units^2].
std::vector<std::int64_t> areas_of(const std::vector<Edge>& edges, std::size_t sectors) {
    std::vector<std::int64_t> areas(sectors);
    for (const Edge& e : edges) areas[e.sector] += cross({0, 0}, e.a, e.b);
    return areas;
}

TEST_P(FreeDoom, GivesEverySectorTheAreaOfItsParts) {
    for (const DoomMap& map : wad_->maps) {
        Report report;
        const std::vector<Edge> edges = collect_edges(map, report);
        const Parts parts = make_parts(edges, map.sectors.size(), report).value();
        // What a deep water ring encloses changes hands on purpose, and only that.
        const std::vector<std::int64_t> before = areas_of(edges, map.sectors.size());
        const std::vector<std::int64_t> after = areas_of(parts.edges, map.sectors.size());
        if (!report.found.contains(Kind::deep_water)) {
            EXPECT_EQ(before, after) << map.name;
        }
        std::vector<std::int64_t> of_parts(map.sectors.size());
        for (const Part& part : parts.parts) of_parts[part.sector] += double_area(part);
        EXPECT_EQ(of_parts, after) << map.name;
    }
}

// hard case W15
TEST_P(FreeDoom, KeepsEveryVertexExactly) {
    for (const DoomMap& map : wad_->maps) {
        const Conversion conversion = convert_map(map, wad_->pictures, wad_->sounds, {});
        const MapFile back = read_map(write_map(*conversion.file)).map;
        std::set<std::pair<double, double>> doom, ours;
        for (const Linedef& line : map.lines)
            for (std::uint16_t v : {line.start, line.end}) doom.emplace(map.vertices[v].x, map.vertices[v].y);
        for (const SectorRecord& sector : back.sectors) {
            for (const LoopRecord& loop : sector.loops)
                for (const Vec2& v : loop.vertices) ours.emplace(v.x * 32, 0 - v.y * 32);
            for (const PanelRecord& panel : sector.panels)
                for (const Vec2& v : {panel.a, panel.b}) ours.emplace(v.x * 32, 0 - v.y * 32);
        }
        for (const auto& v : doom) EXPECT_TRUE(ours.contains(v)) << map.name << " " << v.first << ", " << v.second;
    }
}

/// How many walls and panels do something.
std::size_t walls_with_effects(const MapFile& file) {
    std::size_t count = 0;
    for (const SectorRecord& sector : file.sectors) {
        for (const LoopRecord& loop : sector.loops)
            for (const WallRecord& wall : loop.walls) count += !wall.triggers.empty() || wall.scroll != Vec2{};
        for (const PanelRecord& panel : sector.panels) count += !panel.triggers.empty();
    }
    return count;
}

std::size_t sum(const std::map<int, std::size_t>& counts) {
    std::size_t sum = 0;
    for (const auto& [number, count] : counts) sum += count;
    return sum;
}

/// What wadconv/README.md names: teleports of monsters, and what Boom added.
TEST_P(FreeDoom, TurnsTheSpecialsOfAllLinesAndSectorsIntoWords) {
    Report total;
    for (const DoomMap& map : wad_->maps) {
        const Conversion conversion = convert_map(map, wad_->pictures, wad_->sounds, {});
        const Report& report = conversion.report;
        EXPECT_GE(walls_with_effects(*conversion.file) + sum(report.lines_left), sum(report.line_specials)) << map.name;
        for (const auto& [special, count] : report.lines_left) total.lines_left[special] += count;
        for (const auto& [special, count] : report.sectors_left) total.sectors_left[special] += count;
    }
    EXPECT_TRUE(total.sectors_left.empty());
    for (const auto& [special, count] : total.lines_left)
        std::printf("%s: %zu lines of special %d left over\n", GetParam().name, count, special);
}

TEST_P(FreeDoom, DrawsEveryPicture) {
    for (const PictureFile& file : wad_->pictures.files()) {
        const Result<Picture> picture = file.draw();
        EXPECT_TRUE(picture.ok()) << file.name << ": " << picture.error().text();
    }
    EXPECT_TRUE(wad_->pictures.problems().empty());
}

INSTANTIATE_TEST_SUITE_P(Wads, FreeDoom, freedoom_wads(), name_of);

}  // namespace
}  // namespace enfilade::wadconv
