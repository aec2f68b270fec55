// The only place with threads: run one function for many indices on several cores.
#pragma once
#include <cstddef>
#include <functional>

namespace enfilade {

/// Calls task(index, worker) once for every index in [0, count), on at most `workers` threads (>= 1), and returns
/// when all are done. worker is in [0, workers) and no two calls with the same worker run at the same time, so it
/// may choose scratch memory. The order of indices is not defined: results must not depend on it.
/// With one worker everything runs in order on the calling thread. count may be 0. Where the machine has no more
/// threads to give, fewer do all of it. What ends an attempt (base/attempt.h) in one of them ends it for the caller.
void parallel_for(std::size_t count, std::size_t workers,
                  const std::function<void(std::size_t index, std::size_t worker)>& task);

/// How many threads this machine runs at the same time, >= 1.
std::size_t hardware_threads();

}  // namespace enfilade
