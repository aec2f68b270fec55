// What is drawn through which portal, and in which order.
#include "render/stencil/plan.h"

#include <gtest/gtest.h>

#include "hard_cases/poses.h"
#include "hard_cases/scenes.h"
#include "space/triangulate.h"
#include "support/map_builder.h"

namespace enfilade::stencil {
namespace {

using namespace test;

/// How often one exit of a layer follows another that is farther; `exits` counts those with a neighbour.
struct Order {
    int exits = 0, wrong = 0;
};

Order order_of_exits(const Map& map, const TextureSet& textures, const View& view, PictureSize size) {
    const Projection projection(view, size.width, size.height);
    const RayField rays(view, projection);
    const MapFacts facts{overlapping_sectors(map)};
    const Snapshot snapshot = at_rest(map);
    Order order;
    for (const Layer& layer : make_plan({map, facts, textures, snapshot}, Screen(projection), rays, view).layers)
        for (std::size_t i = 1; i < layer.exits.size(); ++i) {
            ++order.exits;
            order.wrong += layer.exits[i - 1].nearest < layer.exits[i].nearest;
        }
    return order;
}

// Where layers run out, what is left undrawn is far away.
TEST(Plan, FollowsTheNearestPortalsFirst) {
    Order all;
    for (const NamedScene& scene : {NamedScene{"LinkedRooms", linked_rooms}, NamedScene{"Mirrors", mirrors}}) {
        const MapFile file = scene.file();
        const Map map = built(file);
        const TextureSet textures = textures_for(file);
        Random random(5);
        for (int pose = 0; pose < 20; ++pose) {
            const Order order = order_of_exits(map, textures, random_pose(map, random), {160, 100});
            all.exits += order.exits;
            all.wrong += order.wrong;
        }
    }
    EXPECT_GT(all.exits, 20);
    EXPECT_EQ(all.wrong, 0);
}

}  // namespace
}  // namespace enfilade::stencil
