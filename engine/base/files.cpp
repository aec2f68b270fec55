#include "base/files.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <filesystem>

namespace enfilade {

namespace {

/// Closes with the scope.
struct Descriptor {
    explicit Descriptor(int opened) : number(opened) {}
    Descriptor(const Descriptor&) = delete;
    ~Descriptor() {
        if (number >= 0) ::close(number);
    }
    const int number;
};

Result<void> check_is_file(const std::string& path, const struct stat& found) {
    if (S_ISREG(found.st_mode)) return {};
    return Error{
        path, S_ISDIR(found.st_mode) ? "expected a file, found a folder" : "expected a file, found a device or a pipe"};
}

/// Why the path cannot be read as a file, without opening it: to open a device may already change it.
Result<void> look_at(const std::string& path) {
    struct stat found;
    if (::stat(path.c_str(), &found) == 0) return check_is_file(path, found);
    if (errno == ENOENT || errno == ENOTDIR) return Error{path, "no such file"};
    return system_error(path, "look at the file");
}

/// The bytes of the open file, as many as it had when it was opened.
Result<Bytes> read_bytes(const std::string& path, int file, std::size_t size) {
    Bytes bytes;
    bytes.reserve(size);
    prefer_large_pages(bytes.data(), size);
    bytes.resize(size);
    for (std::size_t done = 0; done < size;) {
        const ssize_t more = ::read(file, bytes.data() + done, size - done);
        if (more < 0 && errno == EINTR) continue;
        if (more < 0) return system_error(path, "read the file");
        if (more == 0) return Error{path, "the file became shorter while it was read"};
        done += static_cast<std::size_t>(more);
    }
    return bytes;
}

Result<void> write_and_flush(const std::string& path, std::span<const std::byte> bytes, OutputFile::Flush flush) {
    Result<OutputFile> file = OutputFile::open(path);
    if (!file) return file.error();
    if (const Result<void> done = file.value().write(bytes); !done.ok()) return done.error();
    return file.value().commit(flush);
}

}  // namespace

// Whoever writes may put another file in the path's place at any time, so all but the first look is at what was opened.
Result<Bytes> read_file(const std::string& path) {
    if (const Result<void> valid = look_at(path); !valid.ok()) return valid.error();
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
    if (file.number < 0) return system_error(path, "open the file");
    struct stat found;
    if (::fstat(file.number, &found) != 0) return system_error(path, "tell the file's size");
    if (const Result<void> valid = check_is_file(path, found); !valid.ok()) return valid.error();
    const auto size = static_cast<std::size_t>(found.st_size);
    if (size > kMaxFileBytes)
        return Error{path, "the file has " + std::to_string(size) + " bytes; at most " + std::to_string(kMaxFileBytes) +
                               " are read"};
    return read_bytes(path, file.number, size);
}

std::vector<std::string> list_folder(const std::string& path) {
    std::vector<std::string> names;
    std::error_code failed;
    std::filesystem::directory_iterator entry(path, failed), end;
    for (; !failed && entry != end; entry.increment(failed)) names.push_back(entry->path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

Result<void> write_file(const std::string& path, std::span<const std::byte> bytes) {
    return write_and_flush(path, bytes, OutputFile::Flush::file_and_folder);
}

Result<void> write_one_of_many(const std::string& path, std::span<const std::byte> bytes) {
    return write_and_flush(path, bytes, OutputFile::Flush::file);
}

Result<void> write_file(const std::string& path, std::string_view text) {
    return write_file(path, std::as_bytes(std::span(text.data(), text.size())));
}

void prefer_large_pages(const void* memory, std::size_t bytes) noexcept {
    if (bytes < kLeastForLargePages) return;
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    const auto begin = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) / page * page;
    const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / page * page;
    // It may be refused: then the pages are small.
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
}

}  // namespace enfilade
