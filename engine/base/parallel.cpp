#include "base/parallel.h"

#include <sched.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "base/attempt.h"
#include "base/result.h"

namespace enfilade {
namespace {

/// The indices that are left, and what stopped the work before there were none.
class Work {
public:
    Work(std::size_t count, const ParallelTask& task) : count_(count), task_(task), is_attempt_(is_attempting()) {}

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
    const ParallelTask& task_;
    const bool is_attempt_;
    std::atomic<std::size_t> next_{0};
    std::atomic_flag has_failed_;
    std::exception_ptr failure_;  ///< written once, by whoever set the flag
};

}  // namespace

/// The cores that a thread may use.
class Cores {
public:
    Cores() : are_known_(sched_getaffinity(0, sizeof all_, &all_) == 0 && CPU_COUNT(&all_) > 1) {}

    /// Leaves a core to whoever works there. Systems like to wake a thread beside the one that woke it, and some leave
    /// both there for several milliseconds, while another core does nothing. The thread stays away from it for good,
    /// but where it is told to leave another one.
    void leave(int core) const {
        if (!are_known_ || core < 0 || core >= CPU_SETSIZE || sched_getcpu() != core) return;
        cpu_set_t others = all_;
        CPU_CLR(core, &others);
        sched_setaffinity(0, sizeof others, &others);  // it may be refused: then both share the core
    }

private:
    cpu_set_t all_;
    bool are_known_;
};

/// The helpers of a pool, and the work that they share with its owner.
class ThreadPool::Crew {
public:
    /// Calls `count` helpers; where the machine gives fewer threads, fewer do the same.
    explicit Crew(std::size_t count) {
        try {
            helpers_.reserve(count);
            for (std::size_t worker = 1; worker <= count; ++worker)
                helpers_.emplace_back([this, worker] { serve(worker); });
        } catch (const std::system_error&) {
        } catch (const std::bad_alloc&) {
        }
    }

    ~Crew() {
        {
            const std::lock_guard held(mutex_);
            is_over_ = true;
        }
        begins_.notify_all();
    }

    /// Does the work together with the helpers. One who wakes when it is done has nothing to do with it any more.
    void share(Work& work) {
        {
            const std::lock_guard held(mutex_);
            work_ = &work;
            ++number_;
            owner_core_ = sched_getcpu();
        }
        begins_.notify_all();
        work.help(0);
        yield_while([this] { return busy_ > 0; });
        std::unique_lock held(mutex_);
        work_ = nullptr;
        ends_.wait(held, [this] { return busy_ == 0; });
    }

private:
    /// How often somebody looks before he sleeps whether there is reason not to: some 50 microseconds long. Being woken
    /// takes 20. Helpers end soon after their owner where they shared well, and where pictures follow each other at
    /// once, so does the next work. Where others use the core meanwhile it takes longer.
    static constexpr int kYields = 100;

    template <class Reason>
    static void yield_while(Reason is_to_wait) {
        for (int i = 0; i < kYields && is_to_wait(); ++i) std::this_thread::yield();
    }

    /// What one helper does as long as the pool lives.
    void serve(std::size_t worker) {
        const Cores cores;
        std::uint64_t last = 0;
        std::unique_lock held(mutex_);
        for (;;) {
            held.unlock();
            yield_while([&] { return number_ == last && !is_over_; });
            held.lock();
            begins_.wait(held, [&] { return is_over_ || (work_ && number_ != last); });
            if (is_over_) return;
            last = number_;
            const int owner_core = owner_core_;
            held.unlock();
            cores.leave(owner_core);
            held.lock();
            if (!work_ || number_ != last) continue;  // it was little, and is done
            Work& work = *work_;
            ++busy_;
            held.unlock();
            work.help(worker);
            held.lock();
            if (--busy_ == 0) ends_.notify_one();
        }
    }

    std::mutex mutex_;  ///< held to change what follows, and to read what is not atomic
    std::condition_variable begins_, ends_;
    Work* work_ = nullptr;                   ///< in which helpers may join
    std::atomic<std::uint64_t> number_ = 0;  ///< of the work, so that nobody joins twice
    std::atomic<std::size_t> busy_ = 0;      ///< helpers at work
    int owner_core_ = -1;                    ///< that the work was begun on
    std::atomic<bool> is_over_ = false;
    std::vector<std::jthread> helpers_;  ///< the last member: they end before what they use
};

ThreadPool::ThreadPool(std::size_t workers) : workers_(workers) { ENFILADE_CHECK(workers >= 1); }
ThreadPool::~ThreadPool() = default;

void ThreadPool::run(std::size_t count, const ParallelTask& task) {
    Work work(count, task);
    if (workers_ > 1 && count > 1) {
        if (!crew_) crew_ = std::make_unique<Crew>(workers_ - 1);
        crew_->share(work);
    } else {
        work.help(0);
    }
    work.end();
}

void parallel_for(std::size_t count, std::size_t workers, const ParallelTask& task) {
    ENFILADE_CHECK(workers >= 1);
    ThreadPool(std::clamp<std::size_t>(count, 1, workers)).run(count, task);
}

std::size_t hardware_threads() { return std::max(std::thread::hardware_concurrency(), 1u); }

}  // namespace enfilade
