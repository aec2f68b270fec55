// Every map that ships, and every small one with links, as all three renderers draw it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "base/files.h"
#include "hard_cases/comparison.h"
#include "hard_cases/scenes.h"
#include "map/load.h"
#include "render/stencil/agreement.h"
#include "support/map_builder.h"
#include "support/shipped_maps.h"

namespace enfilade::test {
namespace {

/// How much is compared: views anywhere and as many where things coincide; of each kind so many by the reference, too.
struct Sample {
    int poses;
    int by_reference;
    PictureSize size;
};

/// A long run takes an hour.
const bool kIsLong = std::getenv("ENFILADE_LONG") != nullptr;
const Sample kSample = kIsLong ? Sample{100, 100, {640, 400}} : Sample{20, 2, {320, 200}};

std::vector<std::string> names_of_maps() {
    std::vector<std::string> names;
    for (const std::string& path : test::shipped_maps()) names.push_back(std::filesystem::path(path).stem().string());
    return names;
}

void expect_three_agree(const std::string& name, const Map& map, const TextureSet& textures) {
    Sight sight(map, textures);
    Random random(1);
    Agreement sum;
    Comparison exact;
    for (int i = 0; i < kSample.poses; ++i)
        for (const View& view : {random_pose(map, random), lattice_pose(map, kSample.size, random)}) {
            sum += sight.compare(view, kSample.size);
            if (i < kSample.by_reference) exact += compare({name, map, textures}, sight.snapshot(), view, kSample.size);
        }
    expect_agreement(sum);
    EXPECT_TRUE(exact.is_faultless()) << describe(exact);
    if (kIsLong)
        std::printf("%s: stencil and column: %s\n  column and reference: %s\n", name.c_str(), describe(sum).c_str(),
                    describe(exact).c_str());
    testing::Test::RecordProperty("agreement", describe(sum));
}

class StencilMap : public testing::TestWithParam<std::string> {};

// hard cases G14, I2
TEST_P(StencilMap, LooksTheSameInAllThreeRenderers) {
    const LoadedMap loaded = load_map(ENFILADE_SOURCE_DIR "/maps/" + GetParam() + ".toml", {}, read_file);
    ASSERT_TRUE(loaded.map);
    expect_three_agree("maps/" + GetParam() + ".toml", *loaded.map, loaded.textures);
}

std::string name_of_map(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::erase(name, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Maps, StencilMap, testing::ValuesIn(names_of_maps()), name_of_map);

class StencilScene : public testing::TestWithParam<NamedScene> {};

// hard cases W3, G7, G8, G14, I1
TEST_P(StencilScene, LooksTheSameInAllThreeRenderers) {
    const MapFile file = GetParam().file();
    expect_three_agree(GetParam().name, built(file), textures_for(file));
}

INSTANTIATE_TEST_SUITE_P(Linked, StencilScene, testing::ValuesIn(linked_scenes()), name_of_scene);

}  // namespace
}  // namespace enfilade::test
