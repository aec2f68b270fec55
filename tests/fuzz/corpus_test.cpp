// Everything in tests/fuzz/corpus, thrown at its target: what once led to a fault, and what leads far into the code.
#include <gmock/gmock.h>

#include <filesystem>

#include "base/files.h"
#include "fuzz/targets.h"

namespace enfilade::test {
namespace {

const std::string kCorpus = ENFILADE_SOURCE_DIR "/tests/fuzz/corpus";

class FuzzCorpus : public ::testing::TestWithParam<FuzzTarget> {};

TEST_P(FuzzCorpus, DoesNoHarm) {
    const std::string folder = kCorpus + "/" + std::string(GetParam().name);
    const std::vector<std::string> files = list_folder(folder);
    EXPECT_FALSE(files.empty());
    for (const std::string& file : files) {
        const auto bytes = read_file(folder + "/" + file);
        ASSERT_TRUE(bytes.ok()) << file;
        RecordProperty("last", file);
        GetParam().run(bytes.value());
    }
}

TEST_P(FuzzCorpus, CoversNothingAtAll) { GetParam().run({}); }

INSTANTIATE_TEST_SUITE_P(Targets, FuzzCorpus, ::testing::ValuesIn(fuzz_targets().begin(), fuzz_targets().end()),
                         [](const auto& target) { return std::string(target.param.name); });

TEST(FuzzCorpus, HasAFolderForEachTarget) {
    std::vector<std::string> targets;
    for (const FuzzTarget& target : fuzz_targets()) targets.emplace_back(target.name);
    EXPECT_THAT(list_folder(kCorpus), ::testing::ElementsAreArray(targets));
}

TEST(FuzzCorpus, IsSmall) {
    constexpr std::uintmax_t kMost = 200'000;  // [bytes]
    std::uintmax_t sum = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kCorpus))
        if (entry.is_regular_file()) sum += entry.file_size();
    EXPECT_LE(sum, kMost);
}

}  // namespace
}  // namespace enfilade::test
