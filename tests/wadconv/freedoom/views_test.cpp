// What players see of FreeDoom: every map from everywhere, drawn as the reference draws it.
#include <gtest/gtest.h>

#include <cstdio>

#include "hard_cases/comparison.h"
#include "wadconv/freedoom/wads.h"

namespace enfilade::test {
namespace {

constexpr int kViewPoses = 100;                          ///< of each kind and map
constexpr PictureSize kSmall{40, 25}, kLarge{160, 100};  ///< in CI, and where there is time

class FreeDoomViews : public ::testing::TestWithParam<FreeDoomWad> {};

/// One row of the table.
Comparison compare_map(const std::string& name, const LoadedMap& loaded) {
    const PictureSize size = is_long_run() ? kLarge : kSmall;
    const Subject subject{name + ".toml", *loaded.map, loaded.textures};
    const Comparison random = compare_poses(subject, PoseKind::random, kViewPoses, size, 1);
    const Comparison lattice = compare_poses(subject, PoseKind::lattice, kViewPoses, size, 2);
    Comparison sum = random;
    sum += lattice;
    std::printf("%-6s %3d + %3d poses %9llu pixels %4llu unwritten %4llu twice %4llu wrong %4llu of a wrong colour\n",
                name.c_str(), kViewPoses, kViewPoses, static_cast<unsigned long long>(sum.pixels),
                static_cast<unsigned long long>(sum.unwritten), static_cast<unsigned long long>(sum.written_twice),
                static_cast<unsigned long long>(sum.wrong), static_cast<unsigned long long>(sum.wrong_color));
    return sum;
}

// hard cases W14, I1, I2
TEST_P(FreeDoomViews, LookAsInTheReferenceInEveryMap) {
    if (is_missing(GetParam())) GTEST_SKIP() << kMissing;
    const ConvertedWad wad(GetParam(), Doors::open);
    ASSERT_EQ(wad.maps().size(), GetParam().maps) << wad.error();
    for (const std::string& name : wad.maps()) {
        const LoadedMap loaded = wad.load(name);
        for (const Finding& finding : loaded.findings) ADD_FAILURE() << to_text(name, finding);
        ASSERT_TRUE(loaded.map) << name;
        const Comparison sum = compare_map(name, loaded);
        EXPECT_TRUE(sum.is_faultless()) << name << ": " << describe(sum);
    }
}

// hard cases W14, R2, I1
TEST_P(FreeDoomViews, LookAsInTheReferenceAtTheStartOfEveryMap) {
    if (is_missing(GetParam())) GTEST_SKIP() << kMissing;
    const ConvertedWad wad(GetParam(), Doors::as_they_are);
    ASSERT_EQ(wad.maps().size(), GetParam().maps) << wad.error();
    for (const std::string& name : wad.maps()) {
        const LoadedMap loaded = wad.load(name);
        ASSERT_TRUE(loaded.map) << name;
        const Comparison sum = compare_at_start({name + ".toml", *loaded.map, loaded.textures}, {320, 200});
        EXPECT_TRUE(sum.is_faultless()) << name << ": " << describe(sum);
    }
}

INSTANTIATE_TEST_SUITE_P(Wads, FreeDoomViews, freedoom_wads(), name_of);

}  // namespace
}  // namespace enfilade::test
