// Ways back: while one stands open all three renderers look through it, and else draw its wall.
#include <gtest/gtest.h>

#include <algorithm>

#include "render/stencil/agreement.h"
#include "support/looks.h"
#include "world/one_way_maps.h"

namespace enfilade::test {
namespace {

constexpr PictureSize kWayBackSize{160, 100};

/// A pair of rooms, furnished, the far one lower, so that its way back has a step.
MapFile rooms_with_way_back(bool is_link) {
    OneWayPair pair;
    pair.is_link = is_link;
    pair.way_back = true;
    pair.drop = 0.5;
    if (is_link) pair.far_turn = {0, 65};
    MapFile file = OneWayMap(pair).file();
    return file;
}

struct Rooms {
    MapFile file;
    Map map;
    TextureSet textures;
    Sight sight;

    explicit Rooms(bool is_link)
        : file(rooms_with_way_back(is_link)), map(built(file)), textures(textures_for(file)), sight(map, textures) {}

    WallId way_back() const {
        const auto it = std::ranges::find(map.walls, WallKind::way_back, &Wall::kind);
        return WallId(static_cast<std::size_t>(it - map.walls.begin()));
    }

    /// From the far room straight at the way back.
    View look_at_it() const {
        const Wall& wall = map[way_back()];
        const Vec2 middle = (wall.a + wall.b) * 0.5, inward = right_of(wall.b - wall.a);
        View view = look_from(map, middle + inward, map[wall.sector].floor.z + 1.5, 0);
        view.forward = inward * (-1 / wall.length);
        return view;
    }
};

/// The rooms whose surfaces a picture shows.
std::vector<SectorId> rooms_in(const Map& map, const StencilPicture& picture) {
    std::vector<SectorId> rooms;
    for (std::size_t i = 0; i < map.sectors.size(); ++i)
        for (const PixelSurface flat : {floor_id(SectorId(i)), ceiling_id(SectorId(i))})
            if (std::ranges::find(picture.facts.ids, flat) != picture.facts.ids.end()) rooms.emplace_back(i);
    return rooms;
}

TEST(WaysBack, AreLookedThroughOnlyWhileTheyStandOpen) {
    for (const bool is_link : {true, false})
        for (const bool is_open : {true, false}) {
            Rooms rooms(is_link);
            if (is_open) rooms.sight.snapshot().way_back = rooms.way_back();
            const View view = rooms.look_at_it();
            const SectorId near = sector_named(rooms.map, "near");
            for (const StencilPicture& picture :
                 {rooms.sight.by_column(view, kWayBackSize), rooms.sight.by_stencil(view, kWayBackSize),
                  rooms.sight.by_reference(view, kWayBackSize)}) {
                const std::vector<SectorId> seen = rooms_in(rooms.map, picture);
                EXPECT_EQ(std::ranges::find(seen, near) != seen.end(), is_open) << is_link;
            }
        }
}

TEST(WaysBack, LookTheSameInAllRenderers) {
    for (const bool is_link : {true, false})
        for (const bool is_open : {true, false}) {
            Rooms rooms(is_link);
            if (is_open) rooms.sight.snapshot().way_back = rooms.way_back();
            expect_agreement(rooms.sight.compare_poses(10, kWayBackSize, 1));
            const View view = rooms.look_at_it();
            EXPECT_EQ(rooms.sight.by_column(view, kWayBackSize).facts.ids,
                      rooms.sight.by_reference(view, kWayBackSize).facts.ids);
        }
}

}  // namespace
}  // namespace enfilade::test
