// Counts what a piece of code takes from the heap. A test program that links count_allocations.cpp replaces operator
// new for itself.
#pragma once
#include <cstddef>

namespace enfilade::test {

/// Calls of operator new since the program started, by all threads.
std::size_t allocations();

/// Bytes those calls asked for since the program started, given back or not.
std::size_t allocated_bytes();

/// Most bytes that were in use at one time since the last call of restart_peak().
std::size_t peak_bytes();

/// From now on the peak counts from what is in use now, which is returned [bytes].
std::size_t restart_peak();

}  // namespace enfilade::test
