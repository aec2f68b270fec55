// The column renderer shows what the reference shows, wherever one stands.
#include "hard_cases/comparison.h"

#include <gtest/gtest.h>

#include "support/rooms.h"

namespace enfilade::test {
namespace {

constexpr int kPoses = 100;  ///< of each kind and size; with a fault in a rule of ties one in ten shows it
constexpr PictureSize kEven{320, 200}, kOdd{117, 83};  ///< an odd side has a ray exactly along the look

/// Rooms on a lattice with steps up and down between all of them, and one with many corners beside them.
Rooms stepped_rooms() {
    Rooms rooms;
    for (int x = 0; x < 4; ++x)
        for (int y = 0; y < 4; ++y) {
            const SectorId room = rooms.add_box(x * 4, y * 4, x * 4 + 4, y * 4 + 4);
            rooms.set_heights(room, 0.25 * ((x * 7 + y * 3) % 5), 2.5 + 0.25 * ((x * 5 + y) % 4));
        }
    rooms.add({{0, 16}, {4, 16}, {8, 16}, {12, 16}, {16, 16}, {20, 20}, {8, 19}, {-3, 25}});
    rooms.join();
    return rooms;
}

/// A ring of wedges around a point, seen along rays that run through that vertex and through many others.
Rooms wheel() {
    Rooms rooms;
    const Corners rim{{0, -6}, {4, -4}, {6, 0}, {4, 4}, {0, 6}, {-4, 4}, {-6, 0}, {-4, -4}};
    for (std::size_t i = 0; i < rim.size(); ++i) {
        const SectorId wedge = rooms.add({{0, 0}, rim[i], rim[(i + 1) % rim.size()]});
        rooms.set_heights(wedge, static_cast<double>(i % 3) / 2, 3 - static_cast<double>(i % 2));
    }
    rooms.join();
    return rooms;
}

/// A room in the shape of a U whose arms see each other only through the next room, pillars, and a niche of no height.
Rooms crooked_rooms() {
    Rooms rooms;
    const Corners pillar{{3, 1}, {3, 2}, {4, 2}, {4, 1}};
    const Corners lozenge{{1, 6}, {0.5, 6.5}, {1, 7}, {1.5, 6.5}};
    rooms.add({{0, 0}, {8, 0}, {8, 8}, {6, 8}, {6, 4}, {2, 4}, {2, 8}, {0, 8}}, {pillar, lozenge});
    rooms.add({{0, 8}, {2, 8}, {6, 8}, {8, 8}, {4, 11}});
    const SectorId niche = rooms.add_box(8, 0, 9, 8);
    rooms.set_heights(niche, 1, 1);
    rooms.join();
    return rooms;
}

struct Case {
    const char* name;
    Rooms (*build)();
    PoseKind kind;
    PictureSize size;
};

class ColumnRendererInRooms : public testing::TestWithParam<Case> {};

TEST_P(ColumnRendererInRooms, ShowsWhatTheReferenceShows) {
    const Rooms rooms = GetParam().build();
    const TextureSet textures = tile_textures();
    const Comparison sum =
        compare_poses({GetParam().name, rooms.map, textures}, GetParam().kind, kPoses, GetParam().size, 1);
    EXPECT_TRUE(sum.is_faultless()) << describe(sum);
}

std::vector<Case> all_cases() {
    std::vector<Case> cases;
    for (PoseKind kind : {PoseKind::random, PoseKind::lattice})
        for (PictureSize size : {kEven, kOdd}) {
            cases.push_back({"SteppedRooms", stepped_rooms, kind, size});
            cases.push_back({"Wheel", wheel, kind, size});
            cases.push_back({"CrookedRooms", crooked_rooms, kind, size});
        }
    return cases;
}

std::string case_name(const testing::TestParamInfo<Case>& info) {
    return std::string(info.param.name) + (info.param.kind == PoseKind::random ? "Random" : "Lattice") +
           std::to_string(info.param.size.width);
}

INSTANTIATE_TEST_SUITE_P(Views, ColumnRendererInRooms, testing::ValuesIn(all_cases()), case_name);

}  // namespace
}  // namespace enfilade::test
