#include "base/files.h"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

namespace enfilade {

Error system_error(const std::string& path, const char* doing) {
    return {path, std::string("cannot ") + doing + ": " + std::generic_category().message(errno)};
}

namespace {

namespace fs = std::filesystem;

/// Names of temporary files, where a signal's handler finds them: it may take no lock and no memory, so these are of
/// fixed size, and each belongs to whoever last changed its state.
struct NameSlot {
    enum State : int { free, taken, in_use, removed };
    std::atomic<int> state{free};
    char name[4096] = {};  ///< the longest path that Linux takes [bytes]
};

/// More than threads write files at the same time.
constexpr int kSlots = 1100;
NameSlot slots[kSlots];  // a handler of signals can reach nothing but globals

/// A slot with the name in it, or -1.
int take_slot(const std::string& name) {
    if (name.size() >= sizeof NameSlot::name) return -1;
    for (int i = 0; i < kSlots; ++i) {
        int expected = NameSlot::free;
        if (!slots[i].state.compare_exchange_strong(expected, NameSlot::taken)) continue;
        std::memcpy(slots[i].name, name.c_str(), name.size() + 1);
        slots[i].state = NameSlot::in_use;
        return i;
    }
    return -1;
}

/// Takes the name out of the handler's reach; false where its file was removed already.
bool take_back(int slot) {
    int expected = NameSlot::in_use;
    return slots[slot].state.compare_exchange_strong(expected, NameSlot::taken);
}

void give_slot_back(int slot) { slots[slot].state = NameSlot::free; }

void end_by_signal(int signal) {
    const int error_before = errno;
    remove_temporary_files();
    errno = error_before;
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

/// Sixteen letters that nobody can foresee; an error where the system has none.
Result<std::string> unforeseen_letters() {
    constexpr char kLetters[] = "abcdefghijklmnopqrstuvwxyz234567";
    unsigned char bytes[16];
    if (getentropy(bytes, sizeof bytes) != 0) return system_error("", "get random numbers");
    std::string letters;
    for (const unsigned char byte : bytes) letters += kLetters[byte % 32];
    return letters;
}

/// The file itself where the path is a link, or a link to a link…, whether it exists or not.
Result<std::string> behind_links(const std::string& path) {
    constexpr int kMostLinks = 40;  // as many as Linux follows
    fs::path file = path;
    std::error_code failed;
    for (int i = 0; fs::is_symlink(file, failed); ++i) {
        if (i == kMostLinks) return Error{path, "cannot create the file: its links lead to each other"};
        const fs::path target = fs::read_symlink(file, failed);
        if (failed) return Error{path, "cannot follow the link: " + failed.message()};
        file = file.parent_path() / target;  // an absolute target stands for itself
    }
    return file.string();
}

Error error_of(const std::string& path, const char* doing) {
    return path == kStandardOutput ? system_error("", "write to standard output") : system_error(path, doing);
}

bool is_standard_output(const struct stat& file) {
    struct stat out;
    return fstat(STDOUT_FILENO, &out) == 0 && out.st_dev == file.st_dev && out.st_ino == file.st_ino;
}

/// Where something that is no file, or that this process writes to already, is opened as it is; -1: it is not.
Result<int> open_what_is_no_file(const std::string& path) {
    struct stat found;
    const bool is_there = stat(path.c_str(), &found) == 0;
    if (path == kStandardOutput || (is_there && is_standard_output(found))) {
        const int copy = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
        if (copy < 0) return error_of(path, "write the file");
        return copy;
    }
    if (!is_there || S_ISREG(found.st_mode)) return -1;
    if (S_ISDIR(found.st_mode)) return Error{path, "expected a file, found a folder"};
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
    if (descriptor < 0) return system_error(path, "write to the device or pipe");
    return descriptor;
}

/// What replaces a file is as open to others as that was. Another owner's file can only be given away by root.
void take_over_permissions(int descriptor, const std::string& path) {
    struct stat before;
    if (stat(path.c_str(), &before) != 0) return;
    if (fchown(descriptor, before.st_uid, before.st_gid) != 0) errno = 0;
    fchmod(descriptor, before.st_mode & 0777);
}

}  // namespace

OutputFile::OutputFile(std::string path, int descriptor, int slot)
    : path_(std::move(path)), descriptor_(descriptor), slot_(slot) {}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      slot_(std::exchange(other.slot_, -1)) {}

OutputFile& OutputFile::operator=(OutputFile&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(descriptor_, other.descriptor_);
    std::swap(slot_, other.slot_);
    return *this;
}

OutputFile::~OutputFile() { close(); }

Result<OutputFile> OutputFile::open(const std::string& path) {
    const Result<int> as_it_is = open_what_is_no_file(path);
    if (!as_it_is) return as_it_is.error();
    if (as_it_is.value() >= 0) return OutputFile(path, as_it_is.value(), -1);
    Result<std::string> file = behind_links(path);
    if (!file) return file.error();
    OutputFile output(std::move(file).value(), -1, -1);
    if (const Result<void> done = output.create_beside(); !done.ok()) return done.error();
    return output;
}

/// What could run out of memory comes before the file is there.
Result<void> OutputFile::create_beside() {
    do {
        const Result<std::string> letters = unforeseen_letters();
        if (!letters) return letters.error();
        slot_ = take_slot((fs::path(path_).parent_path() / (".enfilade-" + letters.value() + ".part")).string());
        if (slot_ < 0)
            return Error{path_, "cannot create the file: its path is too long, or too many are being written"};
        descriptor_ = ::open(slots[slot_].name, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (descriptor_ >= 0) break;
        const int error = errno;
        if (take_back(slot_)) give_slot_back(slot_);
        slot_ = -1;
        errno = error;
        if (error != EEXIST) return failed_to("create the file");
    } while (true);
    take_over_permissions(descriptor_, path_);
    return {};
}

Result<void> OutputFile::failed_to(const char* doing) const { return error_of(path_, doing); }

Result<void> OutputFile::write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return failed_to("write the file");
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return {};
}

Result<void> OutputFile::cut_to(std::size_t size) {
    const auto offset = static_cast<off_t>(size);
    if (ftruncate(descriptor_, offset) != 0 || lseek(descriptor_, offset, SEEK_SET) != offset)
        return failed_to("write the file");
    return {};
}

Result<void> flush_folder(const std::string& path) {
    const int descriptor = ::open(path.empty() ? "." : path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0 && errno == EACCES) return {};  // it may be written to and not read
    if (descriptor >= 0 && (fsync(descriptor) == 0 || errno == EINVAL)) {
        ::close(descriptor);
        return {};
    }
    const Error error = system_error(path, "see to it that the files in the folder last");
    if (descriptor >= 0) ::close(descriptor);
    return error;
}

Result<void> OutputFile::put_in_place(Flush flush) {
    if (slot_ < 0) return {};
    // Some file systems cannot flush, and say so.
    if (flush != Flush::nothing && fsync(descriptor_) != 0 && errno != EINVAL) return failed_to("write the file");
    const int slot = std::exchange(slot_, -1);
    if (!take_back(slot)) return Error{path_, "the file was given up: the program is being ended"};
    Result<void> renamed;
    if (std::rename(slots[slot].name, path_.c_str()) != 0) {
        renamed = failed_to("put the finished file in its place");
        unlink(slots[slot].name);
    }
    give_slot_back(slot);
    if (!renamed.ok() || flush != Flush::file_and_folder) return renamed;
    return flush_folder(fs::path(path_).parent_path().string());
}

Result<void> OutputFile::commit(Flush flush) {
    const bool was_in_place = slot_ < 0;
    Result<void> written = put_in_place(flush);
    const bool must_flush = written.ok() && was_in_place && flush != Flush::nothing;
    if (must_flush && fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP)
        written = failed_to("write the file");
    if (::close(std::exchange(descriptor_, -1)) != 0 && written.ok()) written = failed_to("write the file");
    close();
    return written;
}

void OutputFile::close() {
    if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
    if (slot_ < 0) return;
    const int slot = std::exchange(slot_, -1);
    if (!take_back(slot)) return;
    unlink(slots[slot].name);
    give_slot_back(slot);
}

std::string OutputFile::name_for_children() const { return "/dev/fd/" + std::to_string(descriptor_); }

void OutputFile::share_with_children(bool is_shared) const { fcntl(descriptor_, F_SETFD, is_shared ? 0 : FD_CLOEXEC); }

void remove_temporary_files() noexcept {
    for (NameSlot& slot : slots) {
        int expected = NameSlot::in_use;
        if (slot.state.compare_exchange_strong(expected, NameSlot::removed)) unlink(slot.name);
    }
}

void remove_temporary_files_on(std::initializer_list<int> signals) {
    for (const int signal : signals)
        if (std::signal(signal, end_by_signal) == SIG_IGN) std::signal(signal, SIG_IGN);
}

void guard_standard_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

bool names_stream(const std::string& path) {
    struct stat found;
    return path == kStandardOutput || (stat(path.c_str(), &found) == 0 && !S_ISDIR(found.st_mode) &&
                                       (!S_ISREG(found.st_mode) || is_standard_output(found)));
}

}  // namespace enfilade
