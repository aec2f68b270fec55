// Looks that miss every wall of a room: behind a link the eye is rounded onto the grid, and may come to lie a step
// outside of the room it looks into.
#include <gtest/gtest.h>

#include "formats/map_toml.h"
#include "hard_cases/linked_maps.h"
#include "hard_cases/world.h"
#include "render/reference/ray_path.h"

namespace enfilade::test {
namespace {

constexpr PictureSize kPicture{64, 40};

/// Found by soaking. The eye is in s11, on the end of its link to s3. Behind it the looks to the right miss all walls
/// of s3, s1 and s2, and would go round through the three for ever.
MapFile rooms_that_a_look_goes_round_in() {
    MapReading reading = read_map(R"(format = 1
[render]
max_depth = 1
[[sectors]]
name = "s1"
floor = { z = 0.0567626953125 }
ceiling = { z = 0.9649658203125 }
[[sectors.loops]]
v = [20.8486328125, 14436.865234375,  14, 14435.6650390625,  23, 14435.6640625]
walls = [{}, {}, {}]
[[sectors.loops]]
v = [20.8486328125, 14436.865234375,  22.9990234375, 14435.6650390625,  18.7001953125, 14438.068359375]
walls = [{}, { next = "s3" }, {}]
[[sectors]]
name = "s2"
floor = { z = 0.02838134765625 }
ceiling = { z = 0.93658447265625 }
[[sectors.loops]]
v = [18.7001953125, 14438.068359375,  23, 14447.6640625,  11, 14447.6640625]
walls = [{ next = "s3" }, {}, {}]
[[sectors]]
name = "s3"
floor = { z = 0.08514404296875 }
ceiling = { z = 0.99334716796875 }
[[sectors.loops]]
v = [20.8486328125, 14436.865234375,  18.7001953125, 14438.068359375,  14, 14435.6650390625]
walls = [{}, {}, { next = "s1" }]
[[sectors.loops]]
v = [20.8486328125, 14436.865234375,  23, 14435.6640625,  23, 14447.6640625,  18.7001953125, 14438.068359375, 22.9990234375, 14435.6650390625]
walls = [{}, {}, {}, {}, {}]
[[sectors.loops]]
v = [18.7001953125, 14438.068359375,  11, 14447.6640625,  11, 14435.6640625]
walls = [{ next = "s2", blocks = true }, { name = "a", next = "s11", via = "b" }, {}]
[[sectors]]
name = "s11"
floor = { z = 0.0567626953125 }
ceiling = { z = 0.14190673828125 }
[[sectors.loops]]
v = [-3471.302734375, 11446.9248046875,  -3471.30078125, 11458.9248046875,  -3487.3798828125, 11456.4150390625]
walls = [{ name = "b", next = "s3", via = "a" }, {}, {}]
)");
    EXPECT_FALSE(has_errors(reading.findings)) << text_of(reading.findings);
    return std::move(reading.map);
}

View look_along_the_link(const Map& map) {
    View view;
    view.sector = sector_called(map, "s11");
    view.eye = {-0x1.b1e9bp+11, 0x1.65b76600002p+13};
    view.eye_z = 0x1.96ep-4;
    view.forward = {0x1.071d5da6ce4b6p-2, -0x1.eecf4a075d972p-1};
    view.pitch_tangent = 0x1.b3267a927bbap-1;
    return view;
}

// hard cases R6, R23, I1
TEST(StrayLook, EndsWhereItComesRoundInAllRenderers) {
    const MadeWorld world(rooms_that_a_look_goes_round_in());
    const View view = look_along_the_link(world.map);
    const Comparison compared = world.compare_with_reference(view, kPicture);
    EXPECT_TRUE(compared.is_faultless()) << describe(compared);
    const std::size_t most = 4 * world.map.walls.size();
    std::size_t rings = 0;
    const Projection projection(view, kPicture.width, kPicture.height);
    for (int x = 0; x < kPicture.width; ++x) {
        RayPath path(world.map, nullptr, view, projection.slope(x));
        std::size_t i = 0;
        while (i <= most && !path[i].comes_round && world.map[path[i].wall].kind != WallKind::solid) ++i;
        ASSERT_LE(i, most) << x;
        rings += path[i].comes_round;
    }
    EXPECT_GT(rings, 0u) << "the case is none";
    Frame frame;
    frame.resize(kPicture.width, kPicture.height);
    ColumnRenderer renderer(world.map, world.textures);
    renderer.render(frame, nullptr, world.snapshot, view);
    EXPECT_FALSE(frame.is_cut_short);
    EXPECT_LE(renderer.counts().viewports, most * std::size_t(kPicture.width));
}

}  // namespace
}  // namespace enfilade::test
