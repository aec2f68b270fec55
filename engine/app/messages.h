// What every command of enfilade says on the terminal: why it ends, what a picture does not show, and what a file is
// that is no map or script.
#pragma once
#include <atomic>
#include <cstddef>
#include <string>
#include <vector>

#include "base/result.h"
#include "command/command.h"
#include "render/frame.h"

namespace enfilade {

/// Prints "enfilade: error" and gives kFailed.
int fail(const Error& error);

/// How a command ends: kDone, or as fail() says.
int status_of(const Result<void>& done);

/// Prints "enfilade: error" and gives kUsage.
int refuse_usage(const Error& error);

// Says on stderr that pictures do not show all there is to see.

/// What is said of a picture that is_cut_short (render/frame.h).
inline constexpr const char* kCutShort =
    "looks through doorways went too far and end in the recursion color; link fewer walls of large rooms, or give the "
    "map a smaller max_depth";

/// Counts the pictures that are cut short, and says in its last moment how many they were, if any.
class CutShortNote {
public:
    /// out: where the pictures go.
    explicit CutShortNote(std::string out, Talk talk = Talk::usual) : out_(std::move(out)), talk_(talk) {}
    ~CutShortNote();
    CutShortNote(const CutShortNote&) = delete;
    CutShortNote& operator=(const CutShortNote&) = delete;

    /// A picture is drawn. May be called from any thread.
    void look_at(const Frame& frame) { count_ += frame.is_cut_short; }

private:
    std::string out_;
    Talk talk_;
    std::atomic<std::size_t> count_{0};
};

// What somebody named where a map or a script was wanted, and which command takes it.

/// Whether the path leads to a file, not to a folder or nowhere.
bool is_file(const std::string& path);

/// Whether the file begins as a WAD of Doom does.
bool is_wad_file(const std::string& path);

/// An error where the path leads to something that is no map and is not meant to be one: a folder, a flythrough script,
/// a tape or saved game, a WAD, or nothing at all. It says what it is and which command takes it; of what is not there,
/// which file is called nearly so. None for everything else, whose own findings say more.
/// Cost: reads the file, so ask only where it was refused as a map.
Result<void> refuse_as_map(const std::string& path);

/// The same where a script was wanted: a map is one of the others there.
Result<void> refuse_as_script(const std::string& path);

/// "found a map; …": what a file is and which command takes it, for where neither was wanted.
std::string about_file(const std::string& path);

/// The paths, with every folder replaced by the maps in it (*.toml), in the order of their names and without the
/// scripts. A folder without maps stays.
std::vector<std::string> maps_in_folders(const std::vector<std::string>& paths);

}  // namespace enfilade
