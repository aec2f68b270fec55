// Doom's maps and sounds as ours: one map, and a whole run.
#pragma once
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "base/result.h"
#include "formats/map_file.h"
#include "wadconv/pictures.h"
#include "wadconv/report.h"
#include "wadconv/wad.h"

namespace enfilade::wadconv {

// Doom's sounds as WAV files: those that what lines and sectors do is heard by.
// Source: the Doom Wiki, "Sound" (the format that the DMX library plays).

/// The folder of WAV files beside the maps.
inline constexpr std::string_view kSoundFolder = "sounds/";

/// A sound lump, 8 bits a sample, as a WAV file. Any bytes; an Error where it is not one, or is cut off.
Result<Bytes> wav_of(const Lump& lump);

/// A pile's sounds of doors, lifts, floors, switches, teleports and pick-ups.
class Sounds {
public:
    /// Those that the pile lacks are left out; so are broken ones, and told.
    static Sounds list(const WadPile& pile);

    /// By Doom's name in lower case, without "ds", as "doropn".
    bool has(std::string_view name) const { return files_.contains(name); }
    /// The same, as maps refer to it: "sounds/doropn.wav".
    static std::string file_of(std::string_view name);
    const std::vector<Error>& problems() const { return problems_; }

    /// Writes every one below the folder of the maps.
    Result<void> write(const std::string& folder) const;

private:
    std::map<std::string, Bytes, std::less<>> files_;
    std::vector<Error> problems_;
};

// One Doom map as one map of ours.

struct ConvertOptions {
    bool open_doors = false;  ///< raise the ceiling of every closed door, so that the whole map can be walked
};

/// What came of a map: the file, or none and report.refused says why.
struct Conversion {
    std::optional<MapFile> file;
    Report report;
};

/// Converts geometry, textures, light, things, and what lines and sectors do; x/32, -y/32, z/32, exactly. Specials that
/// have no word here, and flags that say more than the wall itself, are kept as `doom`: a line's on the wall of its
/// right side, a sector's on all of its parts. Cost: O(n log n) in the lines.
Conversion convert_map(const DoomMap& doom, const Pictures& pictures, const Sounds& sounds,
                       const ConvertOptions& options);

// A whole run: WADs in, a folder with maps, pictures and a report out.

struct RunOptions {
    std::vector<std::string> wads;  ///< paths, the IWAD first, PWADs on top of it in this order
    std::vector<std::string> maps;  ///< names in any case; empty: all there are
    std::string out;                ///< folder; made if it is not there
    std::size_t jobs = 1;           ///< threads, >= 1
    bool strict = false;            ///< refuse maps in which something had to be guessed
    ConvertOptions convert;
};

/// Called by any of the threads (worker, from 0) as work gets done: done of total steps. done reaches total.
using StepListener = std::function<void(std::size_t done, std::size_t total, std::size_t worker)>;

struct RunResult {
    std::vector<Report> reports;        ///< one for each map, in the order of the WADs
    std::vector<std::string> problems;  ///< pictures that could not be made; one sentence each
    std::string light;                  ///< how COLORMAP's levels of light compare with classic light; one line

    bool is_complete() const;  ///< no map refused, no problem
};

/// Writes OUT/NAME.toml for every map (name in lower case), OUT/textures with all pictures and OUT/sounds, both unless
/// every map is refused, and OUT/report.txt. Every converted map is checked by build_map before it is written; one that
/// does not pass is refused, like one that cannot be converted, and leaves no file. The same input gives the same bytes
/// with any number of jobs. An Error where an archive cannot be read, a map that was asked for is not there, or a file
/// cannot be written; the report is written last, so where there is a new one, everything else is there.
Result<RunResult> convert_wads(const RunOptions& options, const StepListener& listener);

/// What lies in the folder OUT now, and what to do with it: a line or two.
std::string written_text(const RunResult& result, const std::string& out);

/// The whole report as text: totals, then map by map.
std::string to_text(const RunResult& result);

}  // namespace enfilade::wadconv
