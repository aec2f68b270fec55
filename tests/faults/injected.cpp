#include "faults/injected.h"

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdlib>

namespace enfilade::test {
namespace {

std::atomic<Call> chosen{Call::allocate};
std::atomic<std::size_t> count{0}, first_to_fail{0}, last_to_fail{0};

bool must_fail(Call call) {
    if (call != chosen.load(std::memory_order_relaxed)) return false;
    const std::size_t number = count.fetch_add(1, std::memory_order_relaxed) + 1;
    return number >= first_to_fail.load(std::memory_order_relaxed) &&
           number <= last_to_fail.load(std::memory_order_relaxed);
}

}  // namespace

void fail_call(Call call, std::size_t nth, bool all_after) {
    first_to_fail = last_to_fail = 0;
    chosen = call;
    count = 0;
    last_to_fail = all_after ? ~std::size_t{0} : nth;
    first_to_fail = nth == 0 ? ~std::size_t{0} : nth;
}

std::size_t calls_since() { return count; }

}  // namespace enfilade::test

using enfilade::test::Call;
using enfilade::test::must_fail;

// glibc's own, under the names that stay when the others are taken.
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

void* malloc(std::size_t size) {
    if (!must_fail(Call::allocate)) return __libc_malloc(size);
    errno = ENOMEM;
    return nullptr;
}

void* calloc(std::size_t count, std::size_t size) {
    if (!must_fail(Call::allocate)) return __libc_calloc(count, size);
    errno = ENOMEM;
    return nullptr;
}

void* realloc(void* before, std::size_t size) {
    if (!must_fail(Call::allocate)) return __libc_realloc(before, size);
    errno = ENOMEM;
    return nullptr;
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
    if (!must_fail(Call::allocate)) return __libc_memalign(alignment, size);
    errno = ENOMEM;
    return nullptr;
}

int open(const char* path, int flags, ...) {
    va_list more;
    va_start(more, flags);
    const int mode = (flags & O_CREAT) ? va_arg(more, int) : 0;
    va_end(more);
    if ((flags & O_ACCMODE) != O_RDONLY && must_fail(Call::open)) return errno = EMFILE, -1;
    return static_cast<int>(syscall(SYS_openat, AT_FDCWD, path, flags, mode));
}

ssize_t write(int file, const void* bytes, std::size_t size) {
    if (file > STDERR_FILENO && must_fail(Call::write)) return errno = ENOSPC, -1;
    return syscall(SYS_write, file, bytes, size);
}

int fsync(int file) {
    if (must_fail(Call::flush)) return errno = EIO, -1;
    return static_cast<int>(syscall(SYS_fsync, file));
}

int rename(const char* from, const char* to) noexcept {
    if (must_fail(Call::rename)) return errno = EACCES, -1;
    return static_cast<int>(syscall(SYS_renameat, AT_FDCWD, from, AT_FDCWD, to));
}
}
