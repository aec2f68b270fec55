// Things and panes as the column renderer draws them: in doorways, sunk into floors, through links and in mirrors.
#include <gtest/gtest.h>

#include "hard_cases/scenes.h"
#include "math/vec.h"
#include "render/stencil/agreement.h"
#include "space/trace.h"
#include "support/map_builder.h"

namespace enfilade::test {
namespace {

/// What is behind glass has edges of texels, too, which are not noted for pixels that show the glass.
constexpr double kThingsBehindGlass = 2e-5;

/// A disc with a hole in it, its upper part coloured glass.
Texture ring(const std::string& name) {
    Texture texture;
    texture.name = name;
    texture.width = texture.height = 64;
    texture.has_holes = true;
    for (int x = 0; x < 64; ++x)
        for (int y = 0; y < 64; ++y) {
            const int square = (x - 32) * (x - 32) + (y - 32) * (y - 32);
            const std::uint32_t alpha = square > 32 * 32 || square < 8 * 8 ? 0 : y < 20 ? 0x60000000u : 0xFF000000u;
            texture.pixels.push_back(alpha | static_cast<std::uint32_t>(x * 3 + y * 256 * 3 + 0x400000));
        }
    return texture;
}

/// Things anywhere in the rooms, some on a lattice so that they stand in doorways and on corners.
void scatter(MapFile& file, int count) {
    const Map rooms = built(file);
    Random random(7);
    while (count > 0) {
        const SectorId home(random.below(rooms.sectors.size()));
        const Sector& sector = rooms[home];
        Vec2 p{random.uniform(sector.min.x, sector.max.x), random.uniform(sector.min.y, sector.max.y)};
        if (random.below(2) == 0) p = {double(int(p.x * 2)) / 2, double(int(p.y * 2)) / 2};
        if (!contains(rooms, home, snap_to_point_grid(p))) continue;
        ThingRecord thing;
        thing.sector = sector.name;
        thing.position = p;
        thing.yaw_degrees = random.uniform(0, 360);
        thing.size = random.below(3) == 0 ? 100 : 40;
        thing.frames = {{"ring", 0, Vec2{32, 60}}};
        if (random.below(4) == 0) thing.z = random.uniform(sector.floor.z - 1, sector.ceiling.z);
        file.things.push_back(thing);
        --count;
    }
}

/// The picture of this name becomes a ring.
void make_ring(TextureSet& textures, const std::string& name) {
    if (const TextureId found = textures.find(name)) textures.textures[found.index] = ring(name);
}

class StencilThings : public testing::TestWithParam<NamedScene> {};

TEST_P(StencilThings, LookAsInTheColumnRenderer) {
    for (const ThingEdges edges : {ThingEdges::cut, ThingEdges::whole}) {
        MapFile file = GetParam().file();
        file.render.things = edges;
        scatter(file, 30);
        const Map map = built(file);
        TextureSet textures = textures_for(file);
        make_ring(textures, "ring");
        expect_agreement(Sight(map, textures).compare_poses(6, {160, 100}, 3), kThingsBehindGlass);
    }
}

// hard case G11
TEST_P(StencilThings, AreSeenThroughPanes) {
    MapFile file = GetParam().file();
    for (SectorRecord& sector : file.sectors)
        for (LoopRecord& loop : sector.loops)
            for (WallRecord& wall : loop.walls)
                if (!wall.next.empty()) wall.middle = spec("pane");
    scatter(file, 10);
    const Map map = built(file);
    TextureSet textures = textures_for(file);
    make_ring(textures, "ring");
    make_ring(textures, "pane");
    expect_agreement(Sight(map, textures).compare_random_poses(8, {240, 150}, 3), kThingsBehindGlass);
}

INSTANTIATE_TEST_SUITE_P(Scenes, StencilThings,
                         testing::Values(NamedScene{"SteppedRooms", stepped_rooms}, NamedScene{"OpenSteps", open_steps},
                                         NamedScene{"CrookedRooms", crooked_rooms},
                                         NamedScene{"OverlappingRooms", overlapping_rooms},
                                         NamedScene{"LinkedRooms", linked_rooms},
                                         NamedScene{"EndlessHall", endless_hall}, NamedScene{"Mirrors", mirrors}),
                         name_of_scene);

}  // namespace
}  // namespace enfilade::test
