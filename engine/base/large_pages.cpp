#include "base/large_pages.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace enfilade {
namespace {

/// Below this, large pages would leave more memory unused than they save time [bytes].
constexpr std::size_t kLeast = std::size_t{16} << 20;

/// What the system counts memory in [bytes]; that of all machines we know is no larger.
constexpr std::uintptr_t kPage = 1 << 16;

}  // namespace

void wish_for_large_pages([[maybe_unused]] void* memory, std::size_t bytes) {
    if (bytes < kLeast) return;
#ifdef __linux__
    const std::uintptr_t begin = (reinterpret_cast<std::uintptr_t>(memory) + kPage - 1) / kPage * kPage;
    const std::uintptr_t end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / kPage * kPage;
    static_cast<void>(::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE));
#endif
}

}  // namespace enfilade
