// One function for many indices, on several cores.
#pragma once
#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>

namespace enfilade {

/// What is done for one index by one worker.
using ParallelTask = std::function<void(std::size_t index, std::size_t worker)>;

/// Threads that sleep between runs, where the next one does not follow at once: for work of a millisecond, of
/// which starting threads would be a good part. They start with the first run that has something for them, and end with
/// the pool.
class ThreadPool {
public:
    /// workers: how many work at the same time, the calling thread among them, >= 1.
    explicit ThreadPool(std::size_t workers);
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;
    ~ThreadPool();

    /// As parallel_for(). One run at a time; a task must not start another one of the same pool.
    /// Cost beside the tasks': with one worker or one index none, else that of waking the others, some microseconds.
    void run(std::size_t count, const ParallelTask& task);

private:
    class Crew;
    std::size_t workers_;
    std::unique_ptr<Crew> crew_;  ///< none before it is needed
};

/// Calls task(index, worker) once for every index in [0, count), on at most `workers` threads (>= 1), and returns
/// when all are done. worker is in [0, workers) and no two calls with the same worker run at the same time, so it
/// may choose scratch memory. The order of indices is not defined: results must not depend on it.
/// With one worker everything runs in order on the calling thread. count may be 0. Where the machine has no more
/// threads to give, fewer do all of it. What ends an attempt (base/attempt.h) in one of them ends it for the caller.
void parallel_for(std::size_t count, std::size_t workers, const ParallelTask& task);

/// How many threads this machine runs at the same time, >= 1.
std::size_t hardware_threads();

// A lock for what several threads share.

/// One thread at a time. Whoever waits sleeps.
class Lock {
public:
    void acquire() {
        while (is_held_.test_and_set(std::memory_order_acquire)) is_held_.wait(true, std::memory_order_relaxed);
    }
    void release() {
        is_held_.clear(std::memory_order_release);
        is_held_.notify_one();
    }

private:
    std::atomic_flag is_held_;
};

/// Holds a lock for as long as it lives.
class Held {
public:
    explicit Held(Lock& lock) : lock_(lock) { lock_.acquire(); }
    ~Held() { lock_.release(); }
    Held(const Held&) = delete;
    Held& operator=(const Held&) = delete;

private:
    Lock& lock_;
};

}  // namespace enfilade
