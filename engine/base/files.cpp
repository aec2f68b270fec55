#include "base/files.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

namespace enfilade {
namespace {

struct Closer {
    void operator()(std::FILE* f) const { std::fclose(f); }
};
using File = std::unique_ptr<std::FILE, Closer>;

Error system_error(const std::string& path, const char* doing) {
    return {path, std::string("cannot ") + doing + ": " + std::generic_category().message(errno)};
}

/// A name beside the path, so that the rename stays on one file system.
std::string temporary_beside(const std::string& path) { return path + ".part"; }

Status write_all(std::FILE* f, const std::string& path, std::span<const std::byte> bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), f) != bytes.size() || std::fflush(f) != 0)
        return system_error(path, "write the file");
    return {};
}

/// Why the path cannot be read as a file, without opening it: opening a pipe could wait for ever.
Status not_a_file(const std::string& path) {
    std::error_code failed;
    switch (std::filesystem::status(path, failed).type()) {
        case std::filesystem::file_type::regular: return {};
        case std::filesystem::file_type::not_found: return Error{path, "no such file"};
        case std::filesystem::file_type::none: return Error{path, "cannot look at the file: " + failed.message()};
        case std::filesystem::file_type::directory: return Error{path, "expected a file, found a folder"};
        default: return Error{path, "expected a file, found a device or a pipe"};
    }
}

}  // namespace

Result<Bytes> read_file(const std::string& path) {
    if (auto wrong = not_a_file(path)) return *wrong;
    std::error_code failed;
    const auto size = std::filesystem::file_size(path, failed);
    if (failed) return Error{path, "cannot tell the file's size: " + failed.message()};
    if (size > kMaxFileBytes)
        return Error{path, "the file has " + std::to_string(size) + " bytes; at most " + std::to_string(kMaxFileBytes) +
                               " are read"};
    File f(std::fopen(path.c_str(), "rb"));
    if (!f) return system_error(path, "open the file");
    Bytes bytes(static_cast<std::size_t>(size));
    if (std::fread(bytes.data(), 1, bytes.size(), f.get()) != bytes.size()) return system_error(path, "read the file");
    return bytes;
}

std::vector<std::string> list_folder(const std::string& path) {
    std::vector<std::string> names;
    std::error_code failed;
    std::filesystem::directory_iterator entry(path, failed), end;
    for (; !failed && entry != end; entry.increment(failed)) names.push_back(entry->path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

Status write_file(const std::string& path, std::span<const std::byte> bytes) {
    const std::string part = temporary_beside(path);
    {
        File f(std::fopen(part.c_str(), "wb"));
        if (!f) return system_error(path, "create the file");
        if (Status failed = write_all(f.get(), path, bytes)) {
            std::remove(part.c_str());
            return failed;
        }
    }
    if (std::rename(part.c_str(), path.c_str()) != 0) {
        Error error = system_error(path, "put the finished file in its place");
        std::remove(part.c_str());
        return error;
    }
    return {};
}

Status write_file(const std::string& path, std::string_view text) {
    return write_file(path, std::as_bytes(std::span(text.data(), text.size())));
}

}  // namespace enfilade
