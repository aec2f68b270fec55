// What chains of links cost follows the pixels in which they are seen, not the depth that is allowed. Counted, not
// timed.
#include <gtest/gtest.h>

#include <algorithm>

#include "hard_cases/linked_maps.h"
#include "render/column/column_renderer.h"

namespace enfilade::test {
namespace {

constexpr int kWidth = 80, kHeight = 50;  // [px]: with a field of 90 degrees something 2 m wide is a pixel at 80 m

/// Levels after which a doorway of 2 m is smaller than a pixel where rooms are 4 m long.
constexpr int kEnough = 24;

struct Work {
    std::size_t viewports = 0;
    std::size_t pixels = 0;  ///< open when their viewport was drawn, viewport by viewport
    int deepest = 0;
    std::size_t cut = 0;

    bool operator==(const Work&) const = default;
};

/// The look along which the links of a map stand one behind the other.
struct Vista {
    const char* map;
    const char* sector;
    Vec2 eye;
    Vec2 forward;
};

Work work_of(LoadedMap& loaded, const Vista& vista, int max_depth) {
    Map& map = *loaded.map;
    map.render.max_depth = max_depth;
    View view;
    view.sector = sector_called(map, vista.sector);
    view.eye = vista.eye;
    view.eye_z = map[view.sector].floor.z + 1.55;
    view.forward = vista.forward;
    Frame frame;
    frame.resize(kWidth, kHeight);
    ColumnRenderer renderer(map, loaded.textures);
    renderer.render(frame, nullptr, at_rest(map), view);
    Work work{renderer.counts().viewports, 0, renderer.counts().deepest, renderer.counts().cut};
    for (const ViewportOutline& outline : renderer.viewports())
        for (std::size_t i = 0; i < outline.top.size(); ++i)
            work.pixels += static_cast<std::size_t>(std::max(outline.bottom[i] - outline.top[i], 0));
    return work;
}

class LinkCost : public testing::TestWithParam<Vista> {};

// hard case R23
TEST_P(LinkCost, StaysTheSameOnceNewLevelsFallBelowAPixel) {
    LoadedMap loaded = load_linked_map(GetParam().map);
    const Work enough = work_of(loaded, GetParam(), kEnough);
    EXPECT_EQ(enough.cut, 0u);
    EXPECT_GT(enough.deepest, kEnough / 2) << "links in a row are what this is about";
    for (const int depth : {32, 64, 256, 1024}) EXPECT_EQ(work_of(loaded, GetParam(), depth), enough) << depth;
}

TEST_P(LinkCost, IsPaidInTheFirstFewLevels) {
    LoadedMap loaded = load_linked_map(GetParam().map);
    const Work few = work_of(loaded, GetParam(), 8), all = work_of(loaded, GetParam(), kEnough);
    EXPECT_GE(few.pixels * 100, all.pixels * 98);
}

// hard case R23
TEST_P(LinkCost, GrowsByTheSameForEachLevelAtMost) {
    LoadedMap loaded = load_linked_map(GetParam().map);
    const Work one = work_of(loaded, GetParam(), 1);
    for (const int depth : {2, 4, 8, 16, kEnough})
        EXPECT_LE(work_of(loaded, GetParam(), depth).viewports, one.viewports * static_cast<std::size_t>(depth));
}

INSTANTIATE_TEST_SUITE_P(Vistas, LinkCost,
                         testing::Values(Vista{"facing_doors", "salon", {-1.75, 0}, {1, 0}},
                                         Vista{"mirrors", "carpet", {0.5, 0}, {0, -1}},
                                         Vista{"cells", "cell_44", {22.5, 24.25}, {1, 0}},
                                         Vista{"into_itself", "high_end", {-1.75, -2}, {0, -1}}),
                         [](const auto& vista) {
                             std::string name = vista.param.map;
                             std::erase(name, '_');
                             return name;
                         });

}  // namespace
}  // namespace enfilade::test
