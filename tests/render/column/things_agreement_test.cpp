// Things drawn by the column renderer, against the reference: in doorways, on steps, sunk into floors, behind fences,
// through links and in mirrors.
#include <gtest/gtest.h>

#include "math/vec.h"
#include "render/column/agreement.h"
#include "render/column/column_renderer.h"
#include "render/reference/reference_renderer.h"
#include "space/trace.h"

namespace enfilade {
namespace {

using namespace test;

/// A disc with a hole in it; what is around it is clear, a part of it coloured glass.
Texture ring_picture(std::uint32_t color) {
    Texture texture;
    texture.name = "ring";
    texture.width = texture.height = 64;
    texture.has_holes = true;
    for (int x = 0; x < 64; ++x)
        for (int y = 0; y < 64; ++y) {
            const int square = (x - 32) * (x - 32) + (y - 32) * (y - 32);
            const std::uint32_t alpha = square > 32 * 32 || square < 8 * 8 ? 0 : y < 20 ? 0x60000000u : 0xFF000000u;
            texture.pixels.push_back(alpha | (color + static_cast<std::uint32_t>(x * 2 + y * 256 * 2)));
        }
    return texture;
}

/// A thing with eight pictures of 64 x 64 texels, 2 m each way, that stands on its middle texel column.
ThingRecord thing_at(Vec2 position, double yaw = 0, double size = 32) {
    ThingRecord thing;
    thing.position = position;
    thing.yaw_degrees = yaw;
    thing.rotations = 8;
    thing.size = size;
    thing.frames = {{"ring", 0, Vec2{32, 60}}};  // four texels of it are below the floor it stands on
    return thing;
}

/// `count` things anywhere in the rooms, some on a lattice so that they stand in doorways and on corners.
void scatter(MapFile& file, int count, std::uint64_t seed) {
    const Map rooms = built(file);
    Random random(seed);
    while (count > 0) {
        const SectorId home(random.below(rooms.sectors.size()));
        const Sector& sector = rooms[home];
        Vec2 p{random.uniform(sector.min.x, sector.max.x), random.uniform(sector.min.y, sector.max.y)};
        if (random.below(2) == 0) p = {double(int(p.x * 2)) / 2, double(int(p.y * 2)) / 2};
        if (!contains(rooms, home, snap_to_point_grid(p))) continue;
        ThingRecord thing = thing_at(p, random.uniform(0, 360), random.below(3) == 0 ? 100 : 40);
        thing.sector = sector.name;
        if (random.below(4) == 0) thing.z = random.uniform(sector.floor.z - 1, sector.ceiling.z);
        if (random.below(4) == 0) thing.light = random.uniform(0, 1);
        file.things.push_back(thing);
        --count;
    }
}

TexturedMap world_with_things(MapFile file, int count, std::uint64_t seed) {
    scatter(file, count, seed);
    TexturedMap world(file);
    for (std::uint32_t i = 0; i < 8; ++i) {
        const std::string name = "ring" + std::to_string(i + 1);
        Texture& texture = world.textures.textures[world.textures.find(name).index];
        texture = ring_picture(0x101010u * i);
        texture.name = name;
    }
    return world;
}

MapFile fenced_palace() {
    MapFile file = palace();
    int count = 0;
    for (SectorRecord& s : file.sectors)
        for (WallRecord& w : s.loops[0].walls)
            if (!w.next.empty()) {
                w.middle = spec("lattice");
                w.middle->offset_tx = {5.0 * count, 7.0 * (count++ % 9) - 20};  // rims not on the lattice of the eyes
            }
    return file;
}

/// Agreement with the reference, whether things are cut or not.
class ThingColumnsAgree : public testing::TestWithParam<ThingEdges> {
protected:
    static TexturedMap world_with_things(MapFile file, int count, std::uint64_t seed) {
        file.render.things = GetParam();
        return enfilade::world_with_things(std::move(file), count, seed);
    }
};

INSTANTIATE_TEST_SUITE_P(Edges, ThingColumnsAgree, testing::Values(ThingEdges::cut, ThingEdges::whole),
                         [](const auto& edges) { return edges.param == ThingEdges::cut ? "Cut" : "Whole"; });

TEST_P(ThingColumnsAgree, InAPalace) { expect_agreement(world_with_things(palace(), 60, 1), 11, 100); }

TEST_P(ThingColumnsAgree, BehindFences) {
    TexturedMap world = world_with_things(fenced_palace(), 60, 2);
    world.textures.textures[world.textures.find("lattice").index] = lattice();
    expect_agreement(world, 12, 100);
}

// hard case R28
TEST_P(ThingColumnsAgree, ThroughLinksAndInMirrors) {
    MapFile file = map_of({box_room("a", 0, 0, 5, 5, 0, 3), box_room("b", 20, 0, 26, 5, 1, 4),
                           room("c", {{40, 0}, {44, 3}, {41, 7}, {37, 4}}, -1, 2)});
    link(file, "a", {5, 0}, {5, 5}, "c", {44, 3}, {41, 7});
    link(file, "a", {0, 5}, {0, 0}, "b", {26, 0}, {26, 5});
    wall(file, "a", {0, 0}, {5, 0}).mirror = true;
    wall(file, "b", {26, 5}, {20, 5}).mirror = true;
    file.render.max_depth = 4;
    expect_agreement(world_with_things(file, 30, 3), 13, 100);
}

TEST_P(ThingColumnsAgree, WhereAllThingsStandInDoorways) {
    MapFile file = map_of({box_room("a", 0, 0, 4, 4), box_room("b", 4, 0, 8, 4, 0.25), box_room("c", 0, 4, 4, 8, -0.25),
                           box_room("d", 4, 4, 8, 8, 0, 1.5)});
    join_all(file);
    for (double t = 0.5; t < 8; t += 1) {
        file.things.push_back(thing_at({4, t}, 45 * t));
        file.things.push_back(thing_at({t, 4}, 45 * t));
    }
    file.things.push_back(thing_at({4, 4}));
    expect_agreement(world_with_things(file, 4, 4), 14, 100);
}

/// The middle of row 120 meets the very foot of the picture: there it ends, and does not begin again.
TEST(ThingColumns, EndWithTheLastRowOfTheirPicture) {
    MapFile file = map_of({box_room("hall", 0, 0, 20, 4, 0, 3)});
    file.things.push_back(thing_at({9, 2}));
    file.things[0].frames = {{"ring", 0, Vec2{32, 64}}};
    TexturedMap world(file);
    for (Texture& texture : world.textures.textures)
        for (std::size_t i = 0; i < texture.pixels.size(); ++i)
            texture.pixels[i] = 0xFF000000u | static_cast<std::uint32_t>(i % texture.height);
    View view;
    view.sector = SectorId(std::size_t{0});
    view.eye = {1, 2};
    view.eye_z = 1.025;  // 20.5 rows of 160 to the metre, 8 m away
    for (const bool is_column : {true, false}) {
        Frame frame;
        frame.resize(320, 200);
        if (is_column)
            ColumnRenderer(world.map, world.textures).render(frame, nullptr, world.snapshot, view);
        else
            render_reference(frame, nullptr, world.map, world.textures, world.snapshot, view);
        EXPECT_EQ(frame.pixels[120 * 320 + 150] & 0xFF, 63u) << is_column;
        EXPECT_EQ(frame.pixels[81 * 320 + 150] & 0xFF, 1u) << is_column;  // row 80 meets the very top, and passes it
    }
}

// hard case I8
TEST(ThingColumns, DrawStripsThatEqualTheWholePicture) {
    expect_strips_equal_the_whole(world_with_things(fenced_palace(), 60, 5), 5, 20);
}

TEST(ThingColumns, AllocateNothingOnceTheViewHasBeenDrawn) {
    expect_no_allocations(world_with_things(fenced_palace(), 60, 6), 7, 20);
}

}  // namespace
}  // namespace enfilade
