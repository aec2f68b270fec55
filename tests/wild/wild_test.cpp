// Worlds as wild as the rules allow, and everything that runs on a map on each of them. A fault is made smaller, then
// left behind as files with the command that shows it again. ENFILADE_SEED=N begins elsewhere, ENFILADE_LONG=1 goes on
// for hours.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "base/files.h"
#include "formats/map_toml.h"
#include "support/map_builder.h"
#include "support/temp_dir.h"
#include "wild/saved_fault.h"
#include "wild/shrink.h"
#include "wild/worlds.h"

namespace enfilade::test {
namespace {

const bool kIsLong = std::getenv("ENFILADE_LONG") != nullptr;

std::uint64_t first_seed() {
    const char* given = std::getenv("ENFILADE_SEED");
    return given ? std::strtoull(given, nullptr, 10) : 1;
}

/// Smaller, as files, with the command that shows it again.
std::string report(const MapFile& file, const Map& map, Fault fault, const TrialPlan& plan) {
    FaultyWorld world{file, std::move(fault), "", plan};
    if (world.fault.pose) world.sector = map[world.fault.pose->view.sector].name;
    world = shrunk(std::move(world));
    const std::string folder = "fault-" + std::to_string(plan.seed);
    const Result<void> result = save(world, folder);
    return world.fault.what + "\n  of seed " + std::to_string(plan.seed) +
           "; to see it again: ENFILADE_FAULT=" + (result.ok() ? folder : result.error().text()) +
           " wild_tests --gtest_filter=SavedFault.IsMended";
}

void try_world(const MapFile& file, const TrialPlan& plan) {
    ASSERT_FALSE(has_errors(findings_of(file))) << "seed " << plan.seed << ": " << text_of(findings_of(file));
    const std::string text = write_map(file);
    ASSERT_EQ(write_map(read_map(text).map), text) << "seed " << plan.seed;
    const Map map = built(file);
    const TextureSet textures = textures_for(file);
    if (auto fault = first_fault({map, textures}, plan)) FAIL() << report(file, map, std::move(*fault), plan);
}

// hard cases I1, I2, I11, R6, T8
TEST(WildWorlds, HaveNoFault) {
    const std::uint64_t worlds = kIsLong ? 100'000 : 250;
    for (std::uint64_t seed = first_seed(); seed < first_seed() + worlds && !HasFatalFailure(); ++seed)
        try_world(wild_world(seed), {.seed = seed});
}

TEST(WildWorlds, AreMadeOfAnyBytes) {
    Choices nothing({});
    try_world(wild_world(nothing), {.seed = 1});
    const std::vector<std::byte> bytes = random_bytes(3, 40);
    Choices few(bytes);
    try_world(wild_world(few), {.seed = 1});
}

/// What is to be met in worlds.
std::set<std::string> wonders_of(const MapFile& file) {
    std::set<std::string> found;
    const Map map = built(file);
    for (const Wall& wall : map.walls) {
        if (wall.kind == WallKind::mirror) found.insert("mirror");
        if (wall.kind == WallKind::way_back) found.insert("way back");
        if (wall.one_way_exit) found.insert("one way");
        if (wall.length < 2 * kVertexGrid) found.insert("wall of a grid step");
        if (wall.length > 5000) found.insert("wall of five kilometres");
        if (wall.kind == WallKind::portal && wall.link != Wall::kNoLink && map[wall.exit].exit == wall.exit)
            found.insert("link to itself");
        if (wall.kind == WallKind::portal && wall.link != Wall::kNoLink) {
            const Rigid& link = map.links[wall.link];
            if (link.c != 0 && link.s != 0) found.insert("link by an odd angle");
            if (link.rise != 0) found.insert("raised link");
        }
        if (std::max(std::fabs(wall.a.x), std::fabs(wall.a.y)) == kWorldLimit) found.insert("edge of the world");
    }
    for (const SectorRecord& sector : file.sectors) {
        if (sector.loops.size() > 1) found.insert("several loops");
        if (sector.floor.z == sector.ceiling.z) found.insert("closed room");
        if (!sector.panels.empty()) found.insert("panel");
        if (!sector.triggers.empty()) found.insert("mover");
        if (sector.floor.bob) found.insert("bob");
        const Vec2 span = sector.loops[0].vertices[0] - sector.loops[0].vertices[1];
        if (dot(span, span) < 0.0001) found.insert("room of a centimetre");
    }
    if (!file.things.empty()) found.insert("thing");
    if (!file.lights.empty()) found.insert("lamp");
    return found;
}

TEST(WildWorlds, AreWild) {
    std::set<std::string> found;
    for (std::uint64_t seed = 0; seed < 250; ++seed) found.merge(wonders_of(wild_world(seed)));
    const std::set<std::string> all{"bob",
                                    "closed room",
                                    "edge of the world",
                                    "lamp",
                                    "link by an odd angle",
                                    "link to itself",
                                    "mirror",
                                    "mover",
                                    "one way",
                                    "panel",
                                    "raised link",
                                    "room of a centimetre",
                                    "several loops",
                                    "thing",
                                    "wall of a grid step",
                                    "wall of five kilometres",
                                    "way back"};
    EXPECT_EQ(found, all);
}

TEST(Shrinking, LeavesWhatMatters) {
    const auto has_mirror = [](const MapFile& file) {
        if (has_errors(findings_of(file))) return false;
        const Map map = built(file);
        return std::ranges::any_of(map.walls, [](const Wall& wall) { return wall.kind == WallKind::mirror; });
    };
    std::uint64_t seed = 0;
    while (!has_mirror(wild_world(seed)) || wild_world(seed).sectors.size() < 8) ++seed;
    const MapFile smallest = shrunk(wild_world(seed), has_mirror);
    ASSERT_EQ(smallest.sectors.size(), 1u);
    EXPECT_LE(built(smallest).walls.size(), 24u) << write_map(smallest);  // of hundreds
    EXPECT_TRUE(smallest.things.empty());
}

TEST(SavedFault, ComesBack) {
    const test::TempDir dir;
    FaultyWorld world{wild_world(7), {"", HardPose{}, {}}, "s0", {.seed = 7}};
    world.fault.pose->view.eye = {0.1, 1e-9};
    world.fault.pose->view.fov_degrees = 179;
    world.fault.pose->size = {3, 5};
    ASSERT_TRUE(save(world, dir.path("fault")).ok());
    const FaultyWorld again = load_fault(dir.path("fault")).value();
    EXPECT_EQ(write_map(again.file), write_map(world.file));
    ASSERT_TRUE(again.fault.pose);
    EXPECT_EQ(again.fault.pose->view.eye, world.fault.pose->view.eye);
    EXPECT_EQ(again.fault.pose->view.fov_degrees, 179);
    EXPECT_EQ(again.fault.pose->size.height, 5);
    EXPECT_EQ(again.sector, "s0");
    EXPECT_EQ(again.plan.seed, 7u);
}

/// Faults that were found and mended, one a folder.
std::vector<std::string> mended_faults() { return list_folder(ENFILADE_SOURCE_DIR "/tests/wild/mended"); }

class MendedFault : public testing::TestWithParam<std::string> {};

// hard cases I1, I11
TEST_P(MendedFault, StaysMended) {
    const auto world = load_fault(ENFILADE_SOURCE_DIR "/tests/wild/mended/" + GetParam());
    ASSERT_TRUE(world.ok()) << world.error().text();
    ASSERT_FALSE(has_errors(findings_of(world.value().file))) << "no such map may be any more";
    EXPECT_EQ(world.value().fault.what, "");
}

INSTANTIATE_TEST_SUITE_P(Found, MendedFault, testing::ValuesIn(mended_faults()),
                         [](const auto& fault) { return fault.param; });

/// ENFILADE_FAULT: a folder that HaveNoFault left behind.
TEST(SavedFault, IsMended) {
    const char* folder = std::getenv("ENFILADE_FAULT");
    if (!folder) GTEST_SKIP() << "no ENFILADE_FAULT names a folder";
    const auto world = load_fault(folder);
    ASSERT_TRUE(world.ok()) << world.error().text();
    EXPECT_EQ(world.value().fault.what, "");
}

}  // namespace
}  // namespace enfilade::test
