#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "base/check.h"

namespace enfilade {

void parallel_for(std::size_t count, std::size_t workers,
                  const std::function<void(std::size_t index, std::size_t worker)>& task) {
    ENFILADE_CHECK(workers >= 1);
    std::atomic<std::size_t> next{0};
    const auto work = [&](std::size_t worker) {
        for (std::size_t i; (i = next.fetch_add(1, std::memory_order_relaxed)) < count;) task(i, worker);
    };
    std::vector<std::jthread> others;
    for (std::size_t w = 1; w < std::min(workers, count); ++w) others.emplace_back(work, w);
    work(0);
}

std::size_t hardware_threads() { return std::max(std::thread::hardware_concurrency(), 1u); }

}  // namespace enfilade
