// Whole files in, whole files out. The only part of base that needs a file system; everything else takes bytes.
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace enfilade {

using Bytes = std::vector<std::byte>;

/// How a module below platform/ gets at files: a function from a path to the file's bytes.
using FileReader = std::function<Result<Bytes>(const std::string& path)>;

/// How such a module gets at the names of a folder's files: a function from the folder's path to them, sorted.
using FolderLister = std::function<std::vector<std::string>(const std::string& path)>;

/// Largest file that is read [bytes]. The biggest honest input is a WAD (under 100 MB); anything above this is
/// refused before memory is taken for it.
inline constexpr std::size_t kMaxFileBytes = std::size_t{512} << 20;

/// The file's bytes, or an error naming the path. Directories, devices and files over kMaxFileBytes are errors.
Result<Bytes> read_file(const std::string& path);

/// The names of what lies in a folder, sorted; none where it cannot be read.
std::vector<std::string> list_folder(const std::string& path);

/// Writes an OutputFile (base/output_file.h): a reader finds the old file or the new one, never half of one, and what
/// was written is on disk.
Result<void> write_file(const std::string& path, std::span<const std::byte> bytes);
Result<void> write_file(const std::string& path, std::string_view text);

/// The same for one of many files in a folder: after the last of them, flush_folder() (base/output_file.h).
Result<void> write_one_of_many(const std::string& path, std::span<const std::byte> bytes);

/// The bytes seen as text, without a copy. Valid as long as the bytes are.
inline std::string_view as_text(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Memory of hundreds of megabytes, taken from the system in pieces of megabytes.

/// Asks the system for large pages under memory that is about to be filled for the first time: with usual ones, of
/// 4 kB, half of the time that a large file takes to read goes into getting them. Changes nothing else, and nothing at
/// all for memory of less than kLeastForLargePages or on a system that has none.
void prefer_large_pages(const void* memory, std::size_t bytes) noexcept;

/// Below this, not much is gained [bytes].
inline constexpr std::size_t kLeastForLargePages = std::size_t{8} << 20;

}  // namespace enfilade
