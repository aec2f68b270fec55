// Memory for lists of many megabytes: a page of 4 KiB at a time costs more to come by than what is written into it.
#pragma once
#include <cstddef>
#include <vector>

namespace enfilade {

/// Asks the system to give this memory, which is not used yet, in large pages. A wish: where there are none, nothing
/// changes but the time it takes.
void wish_for_large_pages(void* memory, std::size_t bytes);

/// Reserves room for a list that is about to be filled.
template <class T>
void reserve_large(std::vector<T>& list, std::size_t count) {
    list.reserve(count);
    wish_for_large_pages(list.data(), count * sizeof(T));
}

}  // namespace enfilade
