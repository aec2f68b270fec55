#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "base/attempt.h"
#include "base/check.h"

namespace enfilade {
namespace {

/// The indices that are left, and what stopped the work before there were none.
class Work {
public:
    Work(std::size_t count, const std::function<void(std::size_t, std::size_t)>& task)
        : count_(count), task_(task), is_attempt_(is_attempting()) {}

    /// Does what is left, together with others who do.
    void help(std::size_t worker) {
        const Attempting as_the_caller(is_attempt_);
        try {
            for (std::size_t i; (i = next_.fetch_add(1, std::memory_order_relaxed)) < count_;) task_(i, worker);
        } catch (...) {
            next_ = count_;
            if (!has_failed_.test_and_set()) failure_ = std::current_exception();
        }
    }

    /// When everybody is done.
    void end() const {
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    const std::size_t count_;
    const std::function<void(std::size_t, std::size_t)>& task_;
    const bool is_attempt_;
    std::atomic<std::size_t> next_{0};
    std::atomic_flag has_failed_;
    std::exception_ptr failure_;  ///< written once, by whoever set the flag
};

/// Threads that help, up to `count`; where the machine gives fewer, fewer do the same.
std::vector<std::jthread> call_help(Work& work, std::size_t count) {
    std::vector<std::jthread> helpers;
    try {
        helpers.reserve(count);
        for (std::size_t worker = 1; worker <= count; ++worker)
            helpers.emplace_back([&work, worker] { work.help(worker); });
    } catch (const std::system_error&) {
    } catch (const std::bad_alloc&) {
    }
    return helpers;
}

}  // namespace

void parallel_for(std::size_t count, std::size_t workers,
                  const std::function<void(std::size_t index, std::size_t worker)>& task) {
    ENFILADE_CHECK(workers >= 1);
    Work work(count, task);
    {
        const std::size_t most = std::min(workers, count);
        const std::vector<std::jthread> helpers = call_help(work, most > 1 ? most - 1 : 0);
        work.help(0);
    }
    work.end();
}

std::size_t hardware_threads() { return std::max(std::thread::hardware_concurrency(), 1u); }

}  // namespace enfilade
