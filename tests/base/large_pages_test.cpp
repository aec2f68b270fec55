// Asking for large pages: what is in the memory stays there.
#include "base/files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace enfilade {
namespace {

TEST(LargePages, LeaveWhatIsThere) {
    std::vector<char> memory(2 * kLeastForLargePages, 'x');
    for (const std::size_t begin : {0u, 1u, 4095u}) {
        prefer_large_pages(memory.data() + begin, kLeastForLargePages);
        prefer_large_pages(memory.data() + begin, 1);
    }
    EXPECT_EQ(std::ranges::count(memory, 'x'), static_cast<std::ptrdiff_t>(memory.size()));
}

TEST(LargePages, AreNoneForNoMemory) { prefer_large_pages(nullptr, 0); }

}  // namespace
}  // namespace enfilade
