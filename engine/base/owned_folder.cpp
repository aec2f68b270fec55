#include "base/owned_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "base/files.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kScratchBeginning = "scratch-";

std::string mark_path(const std::string& folder) { return (fs::path(folder) / kFolderMark).string(); }

std::string parent_of(const std::string& path) { return fs::path(path).parent_path().string(); }

Error failure(const std::string& path, const char* doing, const std::error_code& why) {
    return {path, std::string("cannot ") + doing + ": " + why.message()};
}

bool is_anything_there(const std::string& path) {
    struct stat found;
    return lstat(path.c_str(), &found) == 0;
}

/// The mark goes last, so that who is stopped leaves a folder that is still known.
void remove_all_but_mark(const std::string& folder) {
    std::error_code unremovable;
    for (const std::string& name : list_folder(folder))
        if (name != kFolderMark) fs::remove_all(fs::path(folder) / name, unremovable);
}

/// Each has the other's name, in one step; false where the system or its files cannot do that.
bool swap_names([[maybe_unused]] const std::string& a, [[maybe_unused]] const std::string& b) {
#ifdef RENAME_EXCHANGE
    return renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
#else
    return false;
#endif
}

/// Another name for the file, which it has beside its own where files may have two; 0 or the system's error. A pipe
/// that kept its name would be written to, not replaced.
int name_otherwise(const std::string& file, const std::string& aside) {
    if (is_anything_there(aside)) return EEXIST;
    std::error_code unknown;
    if (fs::is_regular_file(file, unknown)) {
        if (link(file.c_str(), aside.c_str()) == 0) return 0;
        if (errno == EEXIST) return errno;
    }
    return std::rename(file.c_str(), aside.c_str()) == 0 ? 0 : errno;
}

/// By three names: at the worst, when the machine stops in between, both folders are there under other names.
Result<void> swap_names_in_steps(const std::string& fresh, const std::string& place) {
    auto aside = ScratchFolder::make(parent_of(place));
    if (!aside.ok()) return aside.error();
    const std::string before = (fs::path(aside.value().path()) / "before").string();
    if (std::rename(place.c_str(), before.c_str()) != 0) return system_error(place, "move the folder away");
    if (std::rename(fresh.c_str(), place.c_str()) == 0) return {};
    const Error error = system_error(place, "put the finished folder in its place");
    std::rename(before.c_str(), place.c_str());
    return error;
}

}  // namespace

Result<ScratchFolder> ScratchFolder::make(const std::string& beside) {
    std::error_code failed;
    fs::create_directories(beside, failed);
    if (failed) return failure(beside, "make the folder", failed);
    std::string path = (fs::path(beside) / (std::string(kScratchBeginning) + "XXXXXX")).string();
    if (mkdtemp(path.data()) == nullptr) return system_error(path, "make the folder");
    ScratchFolder folder(path);
    if (const Result<void> done = write_file(mark_path(path), std::string_view()); !done.ok()) return done.error();
    return folder;
}

ScratchFolder::ScratchFolder(ScratchFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}

ScratchFolder& ScratchFolder::operator=(ScratchFolder&& other) noexcept {
    std::swap(path_, other.path_);
    return *this;
}

/// Its name was made by this process, which is as good as a mark where that could not be written.
ScratchFolder::~ScratchFolder() {
    if (path_.empty()) return;
    remove_all_but_mark(path_);
    std::error_code unremovable;
    fs::remove_all(path_, unremovable);
}

Result<void> ScratchFolder::take_place(const std::string& path, std::string_view mark) {
    if (const Result<void> done = write_file(mark_path(path_), mark); !done.ok()) return done.error();
    if (std::rename(path_.c_str(), path.c_str()) == 0) {  // of folders, only one that is empty can be in the way
        path_.clear();
        return flush_folder(parent_of(path));
    }
    if (!is_anything_there(path)) return system_error(path, "put the finished folder here");
    if (!mark_of(path)) return Error{path, "what lies here is not this program's own; move it away"};
    if (!swap_names(path_, path)) {
        if (const Result<void> done = swap_names_in_steps(path_, path); !done.ok()) return done.error();
        path_.clear();
    }
    return flush_folder(parent_of(path));
}

std::optional<std::string> mark_of(const std::string& folder) {
    std::error_code unknown;
    if (!fs::is_directory(fs::symlink_status(folder, unknown))) return {};
    const auto mark = read_file(mark_path(folder));
    if (!mark.ok()) return {};
    return std::string(as_text(mark.value()));
}

Result<void> remove_owned_folder(const std::string& path) {
    if (!mark_of(path)) return Error{path, "the folder is not this program's own, so it is not removed"};
    remove_all_but_mark(path);
    std::error_code failed;
    fs::remove_all(path, failed);
    if (failed) return failure(path, "remove the folder", failed);
    return {};
}

void remove_left_scratch_folders(const std::string& folder) {
    for (const std::string& name : list_folder(folder))
        if (name.starts_with(kScratchBeginning))
            static_cast<void>(remove_owned_folder((fs::path(folder) / name).string()));
}

Result<void> remove_superseded(const std::vector<std::string>& files, const std::string& successor) {
    if (!is_anything_there(successor)) return Error{successor, "it is not there, so what it stands for is not removed"};
    if (const Result<void> done = flush_folder(parent_of(successor)); !done.ok()) return done.error();
    for (const std::string& file : files)
        if (std::remove(file.c_str()) != 0 && errno != ENOENT && errno != ENOTDIR && errno != ENOTEMPTY)
            return system_error(file, "remove it");
    return {};
}

Result<std::string> set_aside(const std::string& path) {
    std::error_code failed;
    const std::string file = fs::canonical(path, failed).string();  // what a link leads to is what would be replaced
    if (failed) return failure(path, "find the file", failed);
    constexpr int kMostAside = 1000;  // nobody has so many of them by accident
    for (int number = 1; number <= kMostAside; ++number) {
        const std::string aside = file + ".unreadable" + (number == 1 ? "" : "-" + std::to_string(number));
        errno = name_otherwise(file, aside);
        if (errno == 0) return aside;
        if (errno != EEXIST) return system_error(path, "set the file aside");
    }
    return Error{path, "there are " + std::to_string(kMostAside) + " files that were set aside; remove some"};
}

Result<FileLock> FileLock::take(const std::string& path, const std::function<void()>& on_wait) {
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NOCTTY, 0666);
    if (descriptor < 0) return system_error(path, "open the lock");
    FileLock lock(descriptor);
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) return lock;
    if (errno == EWOULDBLOCK && on_wait) on_wait();
    while (flock(descriptor, LOCK_EX) != 0)
        if (errno != EINTR) return system_error(path, "lock the file");
    return lock;
}

FileLock::FileLock(FileLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

FileLock::~FileLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace enfilade
