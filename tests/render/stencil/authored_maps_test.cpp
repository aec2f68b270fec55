// Every map that ships, as the column renderer draws it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "base/files.h"
#include "map/load.h"
#include "render/stencil/agreement.h"

namespace enfilade::test {
namespace {

std::vector<std::string> authored_maps() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(ENFILADE_SOURCE_DIR "/maps"))
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

class StencilMap : public testing::TestWithParam<std::string> {};

TEST_P(StencilMap, LooksAsInTheColumnRenderer) {
    const LoadedMap loaded = load_map(ENFILADE_SOURCE_DIR "/maps/" + GetParam() + ".toml", {}, read_file);
    ASSERT_TRUE(loaded.map);
    const Agreement agreement = Sight(*loaded.map, loaded.textures).compare_poses(20, {320, 200}, 1);
    expect_agreement(agreement);
    RecordProperty("agreement", describe(agreement));
}

std::string name_of_map(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::erase(name, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Maps, StencilMap, testing::ValuesIn(authored_maps()), name_of_map);

}  // namespace
}  // namespace enfilade::test
