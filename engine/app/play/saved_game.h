// Where games are saved.
#pragma once
#include <string>

#include "base/files.h"
#include "base/result.h"
#include "formats/tape.h"
#include "render/frame.h"

namespace enfilade {

// A tape that is written while it is played.

/// Each tick is in the file as soon as it is played, so that a game that is stopped, by whatever, leaves the tape of
/// all that led there. An error leaves the tape as far as it was written; the recorder is of no use then.
class TapeRecorder {
public:
    /// Begins the tape at `path`, in place of what was there, with the ticks of `tape`; its end is not looked at.
    static Result<TapeRecorder> begin(const std::string& path, const Tape& tape);

    Result<void> add(const InputRecord& tick);
    /// Forgets all but the first so many ticks.
    Result<void> cut_to(std::size_t ticks);
    Result<void> finish(std::uint64_t final_hash);

private:
    TapeRecorder(OutputFile file, std::size_t beginning_bytes)
        : file_(std::move(file)), beginning_bytes_(beginning_bytes) {}

    OutputFile file_;
    std::size_t beginning_bytes_;
};

/// The file for a map's saved game: in the user's folder for data (app/user_folders.h), named after the map and the
/// folder it lies in; empty where there is no such folder.
std::string saved_game_of(const std::string& map_path);

class Game;

// What "Continue" goes on with: the map that was played last, and the game as it was left.

/// Keeps both. A game that cannot be saved (Game::check_savable) leaves the one that was kept before: its map begins
/// anew. An error says why nothing was kept; what was kept before is still there then.
Result<void> keep_last_game(const Game& game);
/// The map; empty where there is none, or it has gone.
std::string last_map();
/// The saved game; empty where there is no folder for it.
std::string last_game_path();

// F12: the picture on the screen as a file in the user's folder for pictures.

/// $XDG_PICTURES_DIR, as the environment or the user's user-dirs.dirs says, or ~/Pictures; the working folder where
/// neither is there.
std::string pictures_folder();

/// Writes the frame as the first of enfilade-0001.png, enfilade-0002.png, … that `folder` does not have yet; gives the
/// file's name.
Result<std::string> save_screenshot(const Frame& frame, const std::string& folder);

}  // namespace enfilade
