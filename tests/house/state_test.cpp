// The engine's arithmetic has the same bits in every build: the recorded hashes hold for g++ and clang, optimised or
// not, with and without sanitizers, because CI runs this test in each.
#include <gtest/gtest.h>

#include <string>

#include "house/state_hashes.h"

namespace enfilade::house {
namespace {

/// One line for each hash, as state_probe prints them.
std::string probed() {
    std::string lines;
    for (const NamedHash& hash : state_hashes()) lines += to_text(hash) + "\n";
    return lines;
}

// hard cases D4, I13
TEST(State, HasTheSameBitsInEveryBuild) {
    EXPECT_EQ(probed(),
              "angles 09363939F75D1421\n"
              "decisions 35B86E4B75B5AFAB\n"
              "grids 454B6FE14CD17928\n"
              "rigid_maps 5B68E8D6AA4C82A4\n");
}

}  // namespace
}  // namespace enfilade::house
