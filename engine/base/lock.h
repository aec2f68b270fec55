// A lock for what several threads share.
#pragma once
#include <atomic>

namespace enfilade {

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
