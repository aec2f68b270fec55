#include "base/files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
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
    return {path, std::string("cannot ") + doing + ": " + std::strerror(errno)};
}

/// A name beside the path, so that the rename stays on one file system.
std::string temporary_beside(const std::string& path) { return path + ".part"; }

Status write_all(std::FILE* f, const std::string& path, std::span<const std::byte> bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), f) != bytes.size() || std::fflush(f) != 0)
        return system_error(path, "write the file");
    return {};
}

}  // namespace

Result<Bytes> read_file(const std::string& path) {
    std::error_code failed;
    if (!std::filesystem::is_regular_file(path, failed))
        return Error{path, failed || !std::filesystem::exists(path, failed) ? "no such file"
                                                                            : "expected a file, found something else"};
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
