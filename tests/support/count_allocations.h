// Counts what a piece of code takes from the heap. A test program that links count_allocations.cpp replaces operator
// new for itself.
#pragma once
#include <cstddef>

namespace enfilade::test {

/// Calls of operator new since the program started, by all threads.
std::size_t allocations();

}  // namespace enfilade::test
