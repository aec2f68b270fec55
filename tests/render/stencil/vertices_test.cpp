// Poses exactly on vertices, on ends of links and on pinches of random maps, where whole walls pass through the eye.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <optional>

#include "hard_cases/comparison.h"
#include "math/vec.h"
#include "render/stencil/agreement.h"
#include "space/cells.h"
#include "space/trace.h"
#include "support/map_builder.h"

namespace enfilade::test {
namespace {

/// How much is compared: maps, and views of each.
struct VertexSample {
    int maps, views;
    PictureSize size;
};

/// A long run draws ten million pixels.
const bool kIsLong = std::getenv("ENFILADE_LONG") != nullptr;
const VertexSample kSample = kIsLong ? VertexSample{64, 32, {80, 50}} : VertexSample{24, 16, {80, 50}};

/// A square grid of this many cells a side, whose corners are strewn.
constexpr int kSide = 5;

struct Strewn {
    std::vector<Vec2> corners;
    std::vector<Cell> cells;
};

/// size: of a cell [m].
Strewn strew(double size, int labels, Random& random) {
    Strewn strewn;
    for (int i = 0; i < (kSide + 1) * (kSide + 1); ++i) {
        const Vec2 off{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)};
        strewn.corners.push_back(
            snap_to_vertex_grid((Vec2{double(i % (kSide + 1)), double(i / (kSide + 1))} + off) * size));
    }
    for (int i = 0; i < kSide * kSide; ++i) {
        const int nw = i / kSide * (kSide + 1) + i % kSide, sw = nw + kSide + 1;
        const bool is_rock = random.below(5) == 0;
        const SectorId label(static_cast<std::size_t>(random.below(std::uint64_t(labels))));
        strewn.cells.push_back({{nw, nw + 1, sw + 1, sw}, is_rock ? SectorId() : label});
    }
    return strewn;
}

struct SolidWall {
    std::string sector;
    Vec2 a, b;
};

std::vector<SolidWall> solid_walls(const MapFile& file) {
    std::vector<SolidWall> walls;
    for (const SectorRecord& sector : file.sectors)
        for (const LoopRecord& loop : sector.loops)
            for (std::size_t i = 0; i < loop.walls.size(); ++i)
                if (loop.walls[i].next.empty())
                    walls.push_back({sector.name, loop.vertices[i], loop.vertices[(i + 1) % loop.vertices.size()]});
    return walls;
}

/// Links a solid wall to a new room, turned by any angle, that lies so far to the east.
void link_room(MapFile& file, double east, Random& random) {
    const std::vector<SolidWall> walls = solid_walls(file);
    if (walls.empty()) return;
    const SolidWall from = walls[random.below(walls.size())];
    const Vec2 turn = direction(Angle{static_cast<std::uint32_t>(random.bits())}), way = from.b - from.a;
    const Vec2 turned = snap_to_vertex_grid(Vec2{dot(turn, way), dot(right_of(turn), way)});
    const Vec2 a = snap_to_vertex_grid(Vec2{east, random.uniform(-8, 8)}), b = a + turned;
    const Vec2 deep = snap_to_vertex_grid(right_of(turned) * random.uniform(0.1, 2));
    const std::string name = "linked_" + std::to_string(file.sectors.size());
    file.sectors.push_back(room(name, {a, b, b + deep, a + deep}, double(random.below(4)) / 4, 2));
    link(file, from.sector, from.a, from.b, name, a, b);
}

/// Sectors of cells that lie anywhere, so that many an outline touches itself or another of its sector in a corner.
MapFile strewn_map(double size, int links, Random& random) {
    Strewn strewn = strew(size, 6, random);
    MapFile file = map_of_cells(strewn.corners, strewn.cells, 6, {}, random);
    for (SectorRecord& sector : file.sectors) {
        sector.floor.z = double(random.below(4)) / 4;
        sector.ceiling.z = sector.floor.z + 1 + double(random.below(4)) / 4;
    }
    join_all(file);
    for (int i = 1; i <= links; ++i) link_room(file, i * 64 * size, random);
    file.render.max_depth = 4;
    return file;
}

/// On a vertex, looking along a wall or anywhere. none: on the outer side of an outer wall, under the tie rule.
std::optional<View> vertex_pose(const Map& map, Random& random) {
    const Wall& wall = map.walls[random.below(map.walls.size())];
    View view;
    view.eye = wall.a;
    view.sector = locate(map, view.eye);
    if (!view.sector) return {};
    const Sector& sector = map[view.sector];
    const bool is_tied = random.below(4) == 0;
    view.eye_z = is_tied ? sector.floor.z : random.uniform(sector.floor.z, sector.ceiling.z);
    view.forward =
        direction(random.below(2) ? angle_of(wall.b - wall.a) : Angle{static_cast<std::uint32_t>(random.bits())});
    if (random.below(2)) view.pitch_tangent = random.uniform(-1, 1);
    return view;
}

/// The same with true pitch and roll.
View tilted(View view, Random& random) {
    const auto turn = [&](double most) { return direction(Angle::from_degrees(random.uniform(-most, most))); };
    view.pitch_tangent = 0;
    const Vec2 pitch = turn(90);
    view.tilt = Tilt{pitch, random.below(2) ? turn(180) : Vec2{1, 0}};
    return view;
}

class StencilVertices : public testing::TestWithParam<std::pair<double, int>> {};

// hard cases R6, G9
TEST_P(StencilVertices, OfRandomMapsAreDrawnAsByAllRenderers) {
    const auto [size, links] = GetParam();
    Random random(7);
    Agreement sum;
    Comparison exact;
    for (int i = 0; i < kSample.maps; ++i) {
        const MapFile file = strewn_map(size, links, random);
        const Map map = built(file);
        const TextureSet textures = textures_for(file);
        Sight sight(map, textures);
        for (int j = 0; j < kSample.views; ++j) {
            const auto view = vertex_pose(map, random);
            if (!view) continue;
            sum += sight.compare(*view, kSample.size);
            exact += compare({"map " + std::to_string(i), map, textures}, sight.snapshot(), *view, kSample.size);
        }
    }
    EXPECT_TRUE(exact.is_faultless()) << describe(exact);
    expect_agreement(sum);
    if (kIsLong) std::printf("stencil and column: %s\n", describe(sum).c_str());
}

// hard case R6
TEST_P(StencilVertices, OfRandomMapsAreDrawnTiltedAsByTheReference) {
    const auto [size, links] = GetParam();
    Random random(8);
    Agreement sum;
    for (int i = 0; i < kSample.maps; ++i) {
        const MapFile file = strewn_map(size, links, random);
        const Map map = built(file);
        const TextureSet textures = textures_for(file);
        Sight sight(map, textures);
        for (int j = 0; j < kSample.views; ++j)
            if (const auto view = vertex_pose(map, random)) sum += sight.compare(tilted(*view, random), kSample.size);
    }
    expect_agreement(sum);
    if (kIsLong) std::printf("stencil and reference, tilted: %s\n", describe(sum).c_str());
}

std::string name_of(const testing::TestParamInfo<std::pair<double, int>>& info) {
    return "CellsOf" + std::to_string(int(info.param.first)) + "m" + (info.param.second ? "Linked" : "");
}

INSTANTIATE_TEST_SUITE_P(Sizes, StencilVertices,
                         testing::Values(std::pair(4.0, 0), std::pair(4.0, 3), std::pair(4096.0, 0)), name_of);

/// From a point that some sector holds, with every pitch and eighth of a turn, yaw degrees on. eye_z [m].
Agreement tilted_all_around(const MapFile& file, Vec2 eye, double eye_z, double yaw = 0) {
    const Map map = built(file);
    const TextureSet textures = textures_for(file);
    Sight sight(map, textures);
    Agreement sum;
    View view;
    view.sector = locate(map, eye);
    view.eye = eye;
    view.eye_z = eye_z;
    if (!view.sector) return sum;  // on the outer side of an outer wall, under the tie rule
    for (std::uint32_t eighth = 0; eighth < 8; ++eighth)
        for (const double pitch : {-89.0, -45.0, -20.0, 0.0, 20.0, 45.0, 90.0}) {
            view.forward = direction(Angle::from_degrees(yaw + 45 * eighth));
            view.tilt = Tilt{direction(Angle::from_degrees(pitch)), {1, 0}};
            sum += sight.compare(view, {160, 100});
        }
    return sum;
}

/// Two outlines of one sector touch in the eye's place: whole walls of both pass through it.
// hard case R6
TEST(TiltedStencilVertex, IsDrawnRightWhereTwoOutlinesTouchAtTheEye) {
    const Vec2 pinch{-44.4921875, 90.408203125};
    SectorRecord a = room(
        "a", {{-53.626953125, 82.091796875}, {-15.1630859375, 82.763671875}, pinch, {-50.8427734375, 89.4189453125}}, 0,
        0.064);
    a.loops.push_back(loop_of({{-15.2568359375, 88.1865234375}, {-15.5185546875, 103.125}, pinch}));
    expect_agreement(tilted_all_around(map_of({a}), pinch, 0.022202287266953995));
}

/// Two rooms whose floors are one level, ten kilometres wide, the eye on that level or above it.
// hard case G10
TEST(TiltedStencilVertex, IsDrawnRightAtTenKilometres) {
    const Vec2 p{16080.662109375, 13901.3623046875}, q{20820.4208984375, 17521.419921875};
    MapFile file = map_of({room("a", {p, {25506.8154296875, 21100.7197265625}, q}, 0, 5000),
                           room("b", {{4523.5625, 15771.65234375}, p, q}, 0, 5000)});
    join_all(file);
    for (SectorRecord& sector : file.sectors) {
        sector.ceiling.parallax = true;
        sector.floor.texture->tile_m = sector.ceiling.texture->tile_m = Vec2{5120, 5120};
        for (WallRecord& wall : sector.loops[0].walls) wall.texture->tile_m = Vec2{5120, 5120};
    }
    const Vec2 inside = snap_to_point_grid(Vec2{13610.798128026072, 14608.241249471204});
    Agreement sum;
    for (const Vec2 eye : {p, q, inside, (p + q) * 0.5, Vec2{21000, 17600}})
        for (const double z : {0.0, 1.7, 2500.0})
            for (const double yaw : {0.0, -10.233946047131205}) sum += tilted_all_around(file, eye, z, yaw);
    expect_agreement(sum);
}

/// On the end of a turned link: behind it the eye is rounded onto the other side of a wall.
// hard case G9
TEST(TiltedStencilVertex, IsDrawnRightOnTheEndOfATurnedLink) {
    const Vec2 end{-10.3779296875, 10};
    MapFile file = map_of({room("near", {{-11.322265625, 13.4677734375}, end, {-8.7783203125, 10}}, 0, 0.008),
                           room("far",
                                {{-11.322265625, 13.4677734375},
                                 {-17.546875, 14.591796875},
                                 {-17.546875, 13.677734375},
                                 {-17.546875, 12.078125}},
                                1, 1.008)});
    link(file, "near", end, {-8.7783203125, 10}, "far", {-17.546875, 13.677734375}, {-17.546875, 12.078125});
    expect_agreement(tilted_all_around(file, end, 0.0029575725602486117, -74.766728025596294));
}

/// On the end of a turned link: behind it the eye is rounded past a wall, and rays miss the room but for another
/// outline of it, before which another sector is in their way.
// hard case G9
TEST(TiltedStencilVertex, IsDrawnRightWhereARayMissesTheRoomButForItsOtherOutline) {
    const Vec2 end{256, -1.818359375}, to{260.7578125, -2.390625}, far_a{7.8369140625, -0.1259765625},
        far_b{12.6171875, -0.4599609375};
    SectorRecord far = room("far", {{8.611328125, 3.6220703125}, far_a, far_b, {12.1611328125, 4.4931640625}}, 0, 1.5);
    far.loops.push_back(loop_of({{7.4482421875, 12.25390625},
                                 {7.380859375, 7.5380859375},
                                 {12.4931640625, 8.2509765625},
                                 {12.30078125, 11.8046875}}));
    MapFile file =
        map_of({room("near", {end, to, {261.4833984375, 3.6435546875}, {256.7255859375, 4.2158203125}}, 0, 2), far,
                room("between",
                     {{7.380859375, 7.5380859375},
                      {8.611328125, 3.6220703125},
                      {12.1611328125, 4.4931640625},
                      {12.4931640625, 8.2509765625}},
                     0.25, 1.25)});
    join_all(file);
    link(file, "near", end, to, "far", far_a, far_b);
    expect_agreement(tilted_all_around(file, end, 0.36705407285307523));
}

}  // namespace
}  // namespace enfilade::test
