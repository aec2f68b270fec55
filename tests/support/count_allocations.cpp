#include "support/count_allocations.h"

#include <malloc.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {
std::atomic<std::size_t> count{0}, asked_for{0}, in_use{0}, peak{0};

void* counted(std::size_t size, std::size_t alignment = alignof(std::max_align_t)) noexcept {
    count.fetch_add(1, std::memory_order_relaxed);
    asked_for.fetch_add(size, std::memory_order_relaxed);
    void* const p = memalign(alignment, size ? size : 1);
    const std::size_t usable = p ? malloc_usable_size(p) : 0;
    const std::size_t now = in_use.fetch_add(usable, std::memory_order_relaxed) + usable;
    for (std::size_t old = peak.load(std::memory_order_relaxed);
         now > old && !peak.compare_exchange_weak(old, now, std::memory_order_relaxed);) {
    }
    return p;
}

void give_back(void* p) noexcept {
    in_use.fetch_sub(p ? malloc_usable_size(p) : 0, std::memory_order_relaxed);
    std::free(p);
}

void* counted_or_throw(std::size_t size, std::size_t alignment = alignof(std::max_align_t)) {
    if (void* p = counted(size, alignment)) return p;
    throw std::bad_alloc();
}
}  // namespace

// All of them that can meet: a sanitizer's own `new` beside our `delete` would be a mismatch (std::stable_sort takes
// its buffer from the nothrow one).
void* operator new(std::size_t size) { return counted_or_throw(size); }
void* operator new[](std::size_t size) { return counted_or_throw(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return counted(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return counted(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
    return counted_or_throw(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* p, std::align_val_t) noexcept { give_back(p); }
void operator delete(void* p) noexcept { give_back(p); }
void operator delete[](void* p) noexcept { give_back(p); }
void operator delete(void* p, std::size_t) noexcept { give_back(p); }
void operator delete[](void* p, std::size_t) noexcept { give_back(p); }
void operator delete(void* p, const std::nothrow_t&) noexcept { give_back(p); }
void operator delete[](void* p, const std::nothrow_t&) noexcept { give_back(p); }

namespace enfilade::test {
std::size_t allocations() { return count.load(std::memory_order_relaxed); }
std::size_t allocated_bytes() { return asked_for.load(std::memory_order_relaxed); }
std::size_t peak_bytes() { return peak.load(std::memory_order_relaxed); }

std::size_t restart_peak() {
    const std::size_t now = in_use.load(std::memory_order_relaxed);
    peak.store(now, std::memory_order_relaxed);
    return now;
}
}  // namespace enfilade::test
