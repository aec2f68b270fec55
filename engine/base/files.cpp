#include "base/files.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "base/output_file.h"

namespace enfilade {
namespace {

struct Closer {
    void operator()(std::FILE* f) const { std::fclose(f); }
};
using File = std::unique_ptr<std::FILE, Closer>;

Error system_error(const std::string& path, const char* doing) {
    return {path, std::string("cannot ") + doing + ": " + std::generic_category().message(errno)};
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

Status write_and_flush(const std::string& path, std::span<const std::byte> bytes, OutputFile::Flush flush) {
    Result<OutputFile> file = OutputFile::open(path);
    if (!file) return file.error();
    if (Status failed = file.value().write(bytes)) return failed;
    return file.value().commit(flush);
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
    return write_and_flush(path, bytes, OutputFile::Flush::file_and_folder);
}

Status write_one_of_many(const std::string& path, std::span<const std::byte> bytes) {
    return write_and_flush(path, bytes, OutputFile::Flush::file);
}

Status write_file(const std::string& path, std::string_view text) {
    return write_file(path, std::as_bytes(std::span(text.data(), text.size())));
}

}  // namespace enfilade
