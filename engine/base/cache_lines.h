// Memory that begins where a cache line does, wherever the heap has room: what takes whole lines at a time works in the
// same steps in every run.
#pragma once
#include <cstddef>
#include <new>

namespace enfilade {

/// As all x86-64 and most others have.
inline constexpr std::size_t kCacheLineBytes = 64;

/// An allocator for containers.
template <class T>
struct OnCacheLines {
    using value_type = T;

    OnCacheLines() = default;
    template <class Other>
    OnCacheLines(const OnCacheLines<Other>&) {}

    T* allocate(std::size_t count) {
        return static_cast<T*>(::operator new(count * sizeof(T), std::align_val_t{kCacheLineBytes}));
    }
    void deallocate(T* first, std::size_t) { ::operator delete(first, std::align_val_t{kCacheLineBytes}); }

    bool operator==(const OnCacheLines&) const = default;
};

}  // namespace enfilade
