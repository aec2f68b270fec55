// Whole files in, whole files out, and the numbers in their bytes. With owned_folder.h the only part of base that needs
// a file system; everything else takes bytes.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace enfilade {

using Bytes = std::vector<std::byte>;

/// How a module below platform/ gets at files: a function from a path to the file's bytes. It may be
/// called in another thread than the one that handed it over, but by one at a time.
using FileReader = std::function<Result<Bytes>(const std::string& path)>;

/// How such a module gets at the names of a folder's files: a function from the folder's path to them, sorted.
using FolderLister = std::function<std::vector<std::string>(const std::string& path)>;

/// Largest file that is read [bytes]. The biggest honest input is a WAD (under 100 MB); anything above this is
/// refused before memory is taken for it.
inline constexpr std::size_t kMaxFileBytes = std::size_t{512} << 20;

// Files are opened and read here and nowhere else.

/// The file's bytes, or an error naming the path. Directories, devices, pipes and files over kMaxFileBytes are errors;
/// nothing is ever waited for.
Result<Bytes> read_file(const std::string& path);

/// The first `most` bytes of a file of any size, all where it has fewer: for a look at what it is. The same errors.
Result<Bytes> read_beginning(const std::string& path, std::size_t most);

/// The names of what lies in a folder, sorted; none where it cannot be read.
std::vector<std::string> list_folder(const std::string& path);

/// Writes an OutputFile: a reader finds the old file or the new one, never half of one, and what was written is on
/// disk.
Result<void> write_file(const std::string& path, std::span<const std::byte> bytes);
Result<void> write_file(const std::string& path, std::string_view text);

/// The same for one of many files in a folder: after the last of them, flush_folder().
Result<void> write_one_of_many(const std::string& path, std::span<const std::byte> bytes);

/// The bytes seen as text, without a copy. Valid as long as the bytes are.
inline std::string_view as_text(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Little-endian numbers out of bytes nobody trusts, and back into bytes.

/// Reads forward through bytes. A read past the end gives zeros and sets failed(); nothing is ever read outside.
class ByteReader {
public:
    explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    std::uint8_t u8() { return static_cast<std::uint8_t>(little_endian(1)); }
    std::uint16_t u16() { return static_cast<std::uint16_t>(little_endian(2)); }
    std::uint32_t u32() { return static_cast<std::uint32_t>(little_endian(4)); }
    std::uint64_t u64() { return little_endian(8); }
    std::int16_t i16() { return static_cast<std::int16_t>(u16()); }
    std::int32_t i32() { return static_cast<std::int32_t>(u32()); }

    /// The next count bytes, or an empty span (and failed()) if there are fewer.
    std::span<const std::byte> take(std::size_t count) {
        if (count > remaining()) {
            failed_ = true;
            at_ = bytes_.size();
            return {};
        }
        auto part = bytes_.subspan(at_, count);
        at_ += count;
        return part;
    }

    /// How many bytes are still to be read, and how many were; of a reader that failed: none, and all.
    std::size_t remaining() const { return bytes_.size() - at_; }
    std::size_t position() const { return at_; }
    bool failed() const { return failed_; }

private:
    std::uint64_t little_endian(std::size_t count) {
        std::uint64_t value = 0;
        const auto part = take(count);
        for (std::size_t i = 0; i < part.size(); ++i) value |= std::uint64_t(part[i]) << (8 * i);
        return value;
    }

    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
    bool failed_ = false;
};

/// Appends little-endian numbers to bytes.
class ByteWriter {
public:
    void u8(std::uint8_t v) { little_endian(v, 1); }
    void u16(std::uint16_t v) { little_endian(v, 2); }
    void u32(std::uint32_t v) { little_endian(v, 4); }
    void u64(std::uint64_t v) { little_endian(v, 8); }
    /// Its bytes alone: neither their number nor an end.
    void text(std::string_view s) {
        for (char c : s) bytes_.push_back(static_cast<std::byte>(c));
    }

    /// What was written; valid until more is.
    std::span<const std::byte> bytes() const { return bytes_; }

private:
    void little_endian(std::uint64_t v, int count) {
        for (int i = 0; i < count; ++i) bytes_.push_back(static_cast<std::byte>(v >> (8 * i)));
    }

    std::vector<std::byte> bytes_;
};

// Memory of hundreds of megabytes, taken from the system in pieces of megabytes.

/// Asks the system for large pages under memory that is about to be filled for the first time: with usual ones, of
/// 4 kB, half of the time that a large file takes to read goes into getting them. Changes nothing else, and nothing at
/// all for memory of less than kLeastForLargePages or on a system that has none.
void prefer_large_pages(const void* memory, std::size_t bytes) noexcept;

/// Below this, not much is gained [bytes].
inline constexpr std::size_t kLeastForLargePages = std::size_t{8} << 20;

// Files on their way to disk: whole or not at all.

/// "PATH: cannot DOING: REASON", with the reason of the system call that failed last (errno).
Error system_error(const std::string& path, const char* doing);

/// The name of this process's standard output among paths.
inline constexpr const char* kStandardOutput = "-";

/// Where bytes go that shall become the file `path`: into a temporary file beside it, under a name that nobody can
/// foresee. commit() puts it in the place of `path`; a file that is not committed goes with this object. So a reader
/// finds the old file or the new one, however many write it at once and wherever one of them is stopped.
///
/// What is no file is written to and never replaced: devices, pipes, this process's standard output, also by the name
/// kStandardOutput. A link is followed; a file that is replaced hands on its permissions.
class OutputFile {
public:
    /// What is on disk when the file is in its place. Flushing a folder after each of the many files that are written
    /// into it takes twice as long, so that is done once, by flush_folder(), after the last. `nothing`: words that are
    /// read as they come.
    enum class Flush { file_and_folder, file, nothing };

    /// An error where `path` is a folder or nothing can be created beside it.
    static Result<OutputFile> open(const std::string& path);

    OutputFile(OutputFile&& other) noexcept;
    OutputFile& operator=(OutputFile&& other) noexcept;
    ~OutputFile();

    Result<void> write(std::span<const std::byte> bytes);
    /// Forgets what was written from the byte `size` on, and goes on there. Not for devices and pipes.
    Result<void> cut_to(std::size_t size);
    /// What was written takes the place of `path`, and what is written from now on is seen there at once.
    Result<void> put_in_place(Flush flush = Flush::file_and_folder);
    /// Ends the file: on disk, in its place, closed. Nothing may be written after it, failed or not.
    Result<void> commit(Flush flush = Flush::file_and_folder);

    /// "/dev/fd/N": how a program that this one starts can write into the file, if `is_shared`.
    std::string name_for_children() const;
    /// Lets programs that are started from now on have the file, too, or no longer.
    void share_with_children(bool is_shared) const;

private:
    OutputFile(std::string path, int descriptor, int slot);
    Result<void> create_beside();
    Result<void> failed_to(const char* doing) const;
    void close();

    std::string path_;     ///< the file itself, not a link to it
    int descriptor_ = -1;  ///< -1: closed
    int slot_ = -1;        ///< of the temporary file's name; -1: there is none
};

/// The names of the files that were put into the folder are on disk; an error where they may not be.
Result<void> flush_folder(const std::string& path);

/// Whether what is written to `path` goes into a stream instead of a file: "-" and whatever else is standard output, a
/// device, a pipe.
bool names_stream(const std::string& path);

/// Where standard input, output or error is closed, puts something into its place that can be neither read nor written:
/// else the next file that is opened gets its number, and words that are meant for somebody go into that file.
void guard_standard_streams();

/// From now on each of these signals (SIGTERM, …) removes temporary files before it ends the process as it does anyway.
/// One that is ignored stays ignored.
void remove_temporary_files_on(std::initializer_list<int> signals);

/// Removes the temporary files of all OutputFiles, which can then not be committed. For a process that is about to end
/// without tidying up. Safe in a signal's handler and in any thread.
void remove_temporary_files() noexcept;

}  // namespace enfilade
