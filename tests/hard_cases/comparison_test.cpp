// The column renderer shows what the reference shows, wherever one stands. ENFILADE_LONG=1 looks at 10^9 pixels, in
// some ten minutes.
#include "hard_cases/comparison.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "hard_cases/scenes.h"
#include "support/map_builder.h"

namespace enfilade::test {
namespace {

/// Of each kind and size; a fault in a rule of ties shows in one of ten.
const int kPosesOfAKind = std::getenv("ENFILADE_LONG") ? 720 : 60;
constexpr PictureSize kEven{320, 200}, kOdd{117, 83};  ///< an odd side has a ray exactly along the look

struct Case {
    NamedScene scene;
    PoseKind kind;
    PictureSize size;
};

class ColumnRendererInScenes : public testing::TestWithParam<Case> {};

// hard cases R3, R23, R28, I1, I2
TEST_P(ColumnRendererInScenes, ShowsWhatTheReferenceShows) {
    const auto& [scene, kind, size] = GetParam();
    const MapFile file = scene.file();
    const Map map = built(file);
    const TextureSet textures = textures_for(file);
    const Comparison sum = compare_poses({scene.name, map, textures}, kind, kPosesOfAKind, size, 1);
    EXPECT_TRUE(sum.is_faultless()) << describe(sum);
}

std::vector<Case> cases_of(const std::vector<NamedScene>& scenes) {
    std::vector<Case> cases;
    for (const NamedScene& scene : scenes)
        for (PoseKind kind : {PoseKind::random, PoseKind::lattice})
            for (PictureSize size : {kEven, kOdd}) cases.push_back({scene, kind, size});
    return cases;
}

std::string case_name(const testing::TestParamInfo<Case>& info) {
    return std::string(info.param.scene.name) + (info.param.kind == PoseKind::random ? "Random" : "Lattice") +
           std::to_string(info.param.size.width);
}

INSTANTIATE_TEST_SUITE_P(Plain, ColumnRendererInScenes, testing::ValuesIn(cases_of(plain_scenes())), case_name);
INSTANTIATE_TEST_SUITE_P(Linked, ColumnRendererInScenes, testing::ValuesIn(cases_of(linked_scenes())), case_name);

}  // namespace
}  // namespace enfilade::test
