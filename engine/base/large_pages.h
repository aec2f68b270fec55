// Memory of hundreds of megabytes, taken from the system in pieces of megabytes.
#pragma once
#include <cstddef>

namespace enfilade {

/// Asks the system for large pages under memory that is about to be filled for the first time: with usual ones, of
/// 4 kB, half of the time that a large file takes to read goes into getting them. Changes nothing else, and nothing at
/// all for memory of less than kLeastForLargePages or on a system that has none.
void prefer_large_pages(const void* memory, std::size_t bytes) noexcept;

/// Below this, not much is gained [bytes].
inline constexpr std::size_t kLeastForLargePages = std::size_t{8} << 20;

}  // namespace enfilade
