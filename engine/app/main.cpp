// Where the program starts.
#if defined(__GLIBC__) || __has_include(<malloc.h>)
#include <malloc.h>
#include <sys/resource.h>
#endif

#include "app/commands.h"
#include "base/attempt.h"

namespace {

constexpr const char* kName = "enfilade";

/// Reading a large map takes and gives back some ten MiB in small pieces. By default every few KiB of it are a system
/// call; this many bytes at once, kept until the end, make a map load in three quarters of the time. Memory that is
/// not touched is not taken; but it counts where addresses are limited (ulimit -v), and there small pieces do.
void take_memory_in_large_pieces() {
#if defined(__GLIBC__)
    rlimit addresses;
    if (getrlimit(RLIMIT_AS, &addresses) != 0 || addresses.rlim_cur != RLIM_INFINITY) return;
    constexpr int kMiB = 1 << 20;
    mallopt(M_TOP_PAD, 64 * kMiB);
    mallopt(M_TRIM_THRESHOLD, 1024 * kMiB);
    mallopt(M_MMAP_THRESHOLD, 32 * kMiB);
#endif
}

[[gnu::constructor(enfilade::kBeforeAllConstants)]] void begin() { enfilade::end_in_a_sentence(kName); }

}  // namespace

int main(int argc, char** argv) {
    take_memory_in_large_pieces();
    return enfilade::run_program(kName, [&] { return enfilade::run_command_line(argc, argv); });
}
