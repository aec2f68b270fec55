// Folders and files that this program made itself: how they come into being, take each other's place, and go. Nothing
// is removed anywhere before what stands for it is in its place and on disk.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace enfilade {

// Whole folders.

/// The file that marks a folder as this program's own. What lies in a folder without one is somebody else's and never
/// removed. Its text says what the folder is.
inline constexpr std::string_view kFolderMark = "made-by-enfilade";

/// A new folder beside others, under a name that nobody can foresee, marked. It goes with this object, with all that
/// lies in it, unless it took a place.
class ScratchFolder {
public:
    /// beside : the folder that it is made in; made, too, where it is not there
    static Result<ScratchFolder> make(const std::string& beside);

    ScratchFolder(ScratchFolder&& other) noexcept;
    ScratchFolder& operator=(ScratchFolder&& other) noexcept;
    ~ScratchFolder();

    const std::string& path() const { return path_; }

    /// Renames it to `path`, with `mark` as the text of its mark, on disk; the files in it have been flushed. A folder
    /// of this program that is there goes after that, and an empty one. An error, and nothing is changed, where `path`
    /// is anything else.
    Result<void> take_place(const std::string& path, std::string_view mark);

private:
    explicit ScratchFolder(std::string path) : path_(std::move(path)) {}

    std::string path_;  ///< empty: none
};

/// The text of the folder's mark; none where it is not this program's.
std::optional<std::string> mark_of(const std::string& folder);

/// Removes the folder and all that lies in it. An error, and nothing is removed, where it has no mark, or is a link.
Result<void> remove_owned_folder(const std::string& path);

/// Removes the scratch folders that were left in `folder` by who was stopped. Nobody may be making one meanwhile:
/// whoever calls this holds a lock.
void remove_left_scratch_folders(const std::string& folder);

// Files.

/// Removes files that `successor` now stands for, and folders where they are empty; those that are not there are no
/// error. Where `successor` is not there or not known to be on disk, nothing is removed.
Result<void> remove_superseded(const std::vector<std::string>& files, const std::string& successor);

/// Gives what lies at `path` another name, so that a new file may take its place: "PATH.unreadable", or with a number
/// where there is such a file already. Nothing is overwritten, and a file stays under its old name as well until its
/// successor is there. The other name is returned.
Result<std::string> set_aside(const std::string& path);

// Who may change them.

/// Held by one process at a time, and by one holder within it; who is killed loses it.
class FileLock {
public:
    /// Waits until it is free. path : a file, made where it is not there; on_wait : called once if there is a wait
    static Result<FileLock> take(const std::string& path, const std::function<void()>& on_wait = {});

    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&& other) noexcept;
    ~FileLock();

private:
    explicit FileLock(int descriptor) : descriptor_(descriptor) {}

    int descriptor_;  ///< -1: none
};

}  // namespace enfilade
