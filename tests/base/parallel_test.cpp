// parallel_for and the pool behind it: every index once, any number of workers, and a worker's number is a safe index
// to scratch memory.
#include "base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <numeric>
#include <set>
#include <thread>
#include <vector>

#include "base/attempt.h"
#include "base/result.h"

namespace enfilade {
namespace {

TEST(ParallelFor, OfNothingCallsNothing) {
    for (std::size_t workers : {1u, 2u, 7u})
        parallel_for(0, workers, [](std::size_t, std::size_t) { FAIL() << "called"; });
}

TEST(ParallelFor, CallsEveryIndexOnceForAnyNumberOfWorkers) {
    for (std::size_t workers : {1u, 2u, 3u, 8u, 33u})
        for (std::size_t count : {1u, 2u, 7u, 1000u}) {
            std::vector<int> calls(count, 0);
            parallel_for(count, workers, [&](std::size_t i, std::size_t) { ++calls[i]; });
            EXPECT_EQ(calls, std::vector<int>(count, 1)) << workers << " workers";
        }
}

TEST(ParallelFor, WithOneWorkerRunsInOrderOnTheCallersThread) {
    std::vector<std::size_t> order;
    parallel_for(5, 1, [&](std::size_t i, std::size_t worker) {
        order.push_back(i);
        EXPECT_EQ(worker, 0u);
    });
    EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
}

/// Long enough for the other workers to start and take a task of their own.
void dwell() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

TEST(ParallelFor, NeverRunsTwoCallsOfOneWorkerAtTheSameTime) {
    constexpr std::size_t kWorkers = 4;
    std::vector<std::atomic<int>> busy(kWorkers);
    std::vector<std::uint64_t> scratch(kWorkers, 0);  // without locks: the thread sanitizer sees a broken promise
    parallel_for(100, kWorkers, [&](std::size_t i, std::size_t worker) {
        ASSERT_LT(worker, kWorkers);
        EXPECT_EQ(busy[worker].fetch_add(1, std::memory_order_relaxed), 0);
        dwell();
        scratch[worker] += i;
        busy[worker].fetch_sub(1, std::memory_order_relaxed);
    });
    EXPECT_EQ(std::accumulate(scratch.begin(), scratch.end(), std::uint64_t{0}), 4950u);
}

TEST(ParallelFor, IsDoneWhenItReturns) {
    std::atomic<int> done{0};
    parallel_for(8, 8, [&](std::size_t, std::size_t) {
        dwell();
        done.fetch_add(1, std::memory_order_relaxed);
    });
    EXPECT_EQ(done.load(), 8);
}

TEST(ParallelForDeathTest, WithoutWorkersIsABrokenContract) {
    EXPECT_DEATH(parallel_for(1, 0, [](std::size_t, std::size_t) {}), "workers >= 1");
}

TEST(ThreadPool, DoesRunAfterRunOfAnyLength) {
    for (std::size_t workers : {1u, 2u, 3u, 8u}) {
        ThreadPool pool(workers);
        for (std::size_t run = 0; run < 200; ++run) {
            std::vector<int> calls(run % 13,
                                   0);  // without locks: a helper that came late to the run before would be seen
            pool.run(calls.size(), [&](std::size_t i, std::size_t worker) {
                EXPECT_LT(worker, workers);
                ++calls[i];
            });
            ASSERT_EQ(calls, std::vector<int>(run % 13, 1)) << workers << " workers, run " << run;
        }
    }
}

TEST(ThreadPool, KeepsItsThreadsFromRunToRun) {
    ThreadPool pool(2);
    std::set<std::thread::id> seen;
    Lock lock;
    for (int run = 0; run < 20; ++run)
        pool.run(8, [&](std::size_t, std::size_t) {
            dwell();
            const Held held(lock);
            seen.insert(std::this_thread::get_id());
        });
    EXPECT_EQ(seen.size(), 2u);
}

TEST(ThreadPool, SleepsBetweenRuns) {
    ThreadPool pool(4);
    pool.run(8, [](std::size_t, std::size_t) { dwell(); });
    const std::clock_t before = std::clock();  // processor time of all threads
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    EXPECT_LT(std::clock() - before, CLOCKS_PER_SEC / 20);
}

TEST(ThreadPool, CanBeUsedAgainAfterAnAttemptThatFailed) {
    ThreadPool pool(4);
    for (int run = 0; run < 50; ++run) {
        const Result<void> result =
            attempt([&] { pool.run(100, [](std::size_t i, std::size_t) { ENFILADE_CHECK(i != 50); }); });
        EXPECT_FALSE(result.ok());
        std::vector<int> calls(100, 0);
        pool.run(calls.size(), [&](std::size_t i, std::size_t) { ++calls[i]; });
        ASSERT_EQ(calls, std::vector<int>(100, 1));
    }
}

TEST(ThreadPoolDeathTest, WithoutWorkersIsABrokenContract) { EXPECT_DEATH(ThreadPool(0), "workers >= 1"); }

TEST(Lock, LetsOneThreadInAtATime) {
    Lock lock;
    std::size_t sum = 0;  // not atomic
    parallel_for(8, 8, [&](std::size_t, std::size_t) {
        for (int i = 0; i < 10'000; ++i) {
            const Held held(lock);
            ++sum;
        }
    });
    EXPECT_EQ(sum, 80'000u);
}

}  // namespace
}  // namespace enfilade
