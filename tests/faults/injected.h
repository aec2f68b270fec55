// Calls of the C library that fail when a test says so: in this program they come here first.
#pragma once
#include <cstddef>

namespace enfilade::test {

/// Memory of any size (malloc, calloc, realloc, aligned_alloc, and so `new`); opening a file to write; writing to a
/// file other than the three standard ones; flushing it to disk; renaming it.
enum class Call { allocate, open, write, flush, rename };

/// Of the calls from now on, the nth (1, 2, …) fails, or all from the nth on do; none with nth = 0. In all threads.
void fail_call(Call call, std::size_t nth, bool all_after = false);

/// How many such calls there were since fail_call.
std::size_t calls_since();

}  // namespace enfilade::test
