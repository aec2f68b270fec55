// Every map that ships: sound, and drawn as the reference draws it from everywhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>

#include "hard_cases/comparison.h"
#include "map/load.h"
#include "support/shipped_maps.h"

namespace enfilade::test {
namespace {

/// Poses of each kind and size: 200 in a long run; fewer show nearly as much in CI.
const int kPoses = std::getenv("ENFILADE_LONG") ? 200 : 60;
constexpr PictureSize kAuthoredEven{320, 200}, kAuthoredOdd{117, 83};  ///< an odd side has a ray exactly along the look

class AuthoredMap : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        loaded_ = load_map(GetParam(), {}, read_file);
        std::string findings;
        for (const Finding& finding : loaded_.findings) findings += to_text(GetParam(), finding) + "\n";
        ASSERT_TRUE(loaded_.map) << findings;
    }

    void expect_agreement(PoseKind kind) {
        const std::string name = "maps/" + std::filesystem::path(GetParam()).filename().string();
        for (PictureSize size : {kAuthoredEven, kAuthoredOdd}) {
            const Comparison sum = compare_poses({name, *loaded_.map, loaded_.textures}, kind, kPoses, size, 1);
            EXPECT_TRUE(sum.is_faultless()) << describe(sum);
            RecordProperty("agreement" + std::to_string(size.width), describe(sum));
        }
    }

    LoadedMap loaded_;
};

// hard cases I1, I2
TEST_P(AuthoredMap, LooksAsInTheReferenceFromAnywhere) { expect_agreement(PoseKind::random); }

// hard case I1
TEST_P(AuthoredMap, LooksAsInTheReferenceWhereThingsCoincide) { expect_agreement(PoseKind::lattice); }

std::string stem(const testing::TestParamInfo<std::string>& info) {
    std::string name = std::filesystem::path(info.param).stem().string();
    name.erase(std::remove_if(name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }), name.end());
    return name;
}

INSTANTIATE_TEST_SUITE_P(Maps, AuthoredMap, testing::ValuesIn(shipped_maps()), stem);

}  // namespace
}  // namespace enfilade::test
