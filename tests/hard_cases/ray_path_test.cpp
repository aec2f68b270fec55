// The reference's rays against the paths that bodies take: two codes that were written apart, one answer.
#include "render/reference/ray_path.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "hard_cases/poses.h"
#include "hard_cases/scenes.h"
#include "math/vec.h"
#include "space/trace.h"
#include "support/map_builder.h"

namespace enfilade::test {
namespace {

constexpr double kFar = 8192;  ///< beyond every wall of the scenes [m]

/// What a ray meets until something solid stops it.
struct Met {
    std::vector<WallId> portals;
    WallId stopped;
};

Met follow_ray(const Map& map, const View& view, double slope) {
    RayPath path(map, nullptr, view, slope);
    Met met;
    for (std::size_t i = 0;; ++i) {
        const RayHit& hit = path[i];
        if (map[hit.wall].kind != WallKind::portal) {
            met.stopped = hit.wall;
            return met;
        }
        met.portals.push_back(hit.wall);
    }
}

Met follow_path(const Map& map, const View& view, Vec2 to) {
    const Trace path = trace(map, {view.sector, view.eye}, to);
    Met met;
    for (const Crossing& crossing : path.crossings) met.portals.push_back(crossing.portal);
    met.stopped = path.stopped;
    return met;
}

class RaysAndPaths : public testing::TestWithParam<NamedScene> {};

TEST_P(RaysAndPaths, MeetTheSameWallsFromAnywhere) {
    const Map map = built(GetParam().file());
    Random random(41);
    for (int i = 0; i < 2000; ++i) {
        const View view = random_pose(map, random);
        const double slope = random.uniform(-1, 1);
        const Vec2 ray = view.forward + right_of(view.forward) * slope;
        const Met ray_met = follow_ray(map, view, slope);
        const Met path_met = follow_path(map, view, snap_to_point_grid(view.eye + ray * kFar));
        ASSERT_EQ(ray_met.portals, path_met.portals) << i;
        ASSERT_EQ(ray_met.stopped, path_met.stopped) << i;
    }
}

TEST_P(RaysAndPaths, MeetTheSameWallsWhereEyesAndVerticesCoincide) {
    const Map map = built(GetParam().file());
    if (!map.links.empty()) return;  // behind a link each is put onto the grid in its own way
    Random random(42);
    for (int i = 0; i < 2000; ++i) {
        View view = lattice_pose(map, {64, 48}, random);
        const auto eighth = static_cast<std::uint32_t>(random.below(8));
        view.forward = direction(Angle{eighth << 29});
        const Vec2 step{static_cast<double>((view.forward.x > 0) - (view.forward.x < 0)),
                        static_cast<double>((view.forward.y > 0) - (view.forward.y < 0))};
        const Met ray_met = follow_ray(map, view, 0);
        const Met path_met = follow_path(map, view, view.eye + step * kFar);
        // A path ends where a point of the grid is inside; portals passed in the stopping wall's own vertex it gives
        // back.
        const auto common = std::min(path_met.portals.size(), ray_met.portals.size());
        const std::vector<WallId> begun(ray_met.portals.begin(), ray_met.portals.begin() + static_cast<long>(common));
        ASSERT_EQ(begun, path_met.portals) << i;
        ASSERT_EQ(ray_met.stopped, path_met.stopped) << i;
    }
}

std::vector<NamedScene> scenes_without_mirrors() {
    std::vector<NamedScene> scenes = plain_scenes();
    scenes.push_back({"LinkedRooms", linked_rooms});
    return scenes;
}

INSTANTIATE_TEST_SUITE_P(Scenes, RaysAndPaths, testing::ValuesIn(scenes_without_mirrors()),
                         [](const auto& scene) { return std::string(scene.param.name); });

}  // namespace
}  // namespace enfilade::test
