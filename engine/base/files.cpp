#include "base/files.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <utility>

#include "base/file_name.h"

namespace enfilade {

namespace {

/// A file that is open to be read. Closes it with the scope.
struct OpenedFile {
    explicit OpenedFile(int opened) : descriptor(opened) {}
    OpenedFile(OpenedFile&& other) noexcept : descriptor(std::exchange(other.descriptor, -1)), size(other.size) {}
    OpenedFile& operator=(OpenedFile&&) = delete;
    ~OpenedFile() {
        if (descriptor >= 0) ::close(descriptor);
    }
    int descriptor;
    std::size_t size = 0;  ///< when it was opened [bytes]; of files that the system makes up, 0
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

/// Whoever writes may put another file in the path's place at any time, so all but the first look is at what was
/// opened.
Result<OpenedFile> open_file(const std::string& path) {
    if (const Result<void> valid = look_at(path); !valid.ok()) return valid.error();
    OpenedFile file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
    if (file.descriptor < 0) return system_error(path, "open the file");
    struct stat found;
    if (::fstat(file.descriptor, &found) != 0) return system_error(path, "tell the file's size");
    if (const Result<void> valid = check_is_file(path, found); !valid.ok()) return valid.error();
    file.size = static_cast<std::size_t>(found.st_size);
    return file;
}

/// The next `most` bytes of the file; fewer where it ends before.
Result<Bytes> read_bytes(const std::string& path, const OpenedFile& file, std::size_t most) {
    Bytes bytes;
    bytes.reserve(most);
    prefer_large_pages(bytes.data(), most);
    bytes.resize(most);
    std::size_t done = 0;
    while (done < most) {
        const ssize_t more = ::read(file.descriptor, bytes.data() + done, most - done);
        if (more < 0 && errno == EINTR) continue;
        if (more < 0) return system_error(path, "read the file");
        if (more == 0) break;
        done += static_cast<std::size_t>(more);
    }
    bytes.resize(done);
    return bytes;
}

Result<void> write_and_flush(const std::string& path, std::span<const std::byte> bytes, OutputFile::Flush flush) {
    Result<OutputFile> file = OutputFile::open(path);
    if (!file) return file.error();
    if (const Result<void> done = file.value().write(bytes); !done.ok()) return done.error();
    return file.value().commit(flush);
}

}  // namespace

Result<Bytes> read_file(const std::string& path) {
    const Result<OpenedFile> file = open_file(path);
    if (!file) return file.error();
    const std::size_t size = file.value().size;
    if (size > kMaxFileBytes)
        return Error{path, "the file has " + std::to_string(size) + " bytes; at most " + std::to_string(kMaxFileBytes) +
                               " are read"};
    auto bytes = read_bytes(path, file.value(), size);
    if (bytes.ok() && bytes.value().size() < size) return Error{path, "the file became shorter while it was read"};
    return bytes;
}

Result<Bytes> read_beginning(const std::string& path, std::size_t most) {
    const Result<OpenedFile> file = open_file(path);
    if (!file) return file.error();
    return read_bytes(path, file.value(), most);
}

std::vector<std::string> list_folder(const std::string& path) {
    std::vector<std::string> names;
    std::error_code failed;
    std::filesystem::directory_iterator entry(path, failed), end;
    for (; !failed && entry != end; entry.increment(failed)) names.push_back(file_name_of(entry->path()));
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
