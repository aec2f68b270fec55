// A map that is being played: the world in it, what was seen of it, and the tape of what was pressed.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/draw/overlay.h"
#include "app/open_map.h"
#include "app/play/player_input.h"
#include "app/play/saved_game.h"
#include "app/play/settings.h"
#include "base/files.h"
#include "base/result.h"
#include "formats/tape.h"
#include "map/map.h"
#include "render/view.h"
#include "space/trace.h"
#include "world/snapshot.h"
#include "world/step.h"

namespace enfilade {

// Tab: the rooms one has been in or seen, as lines over the picture. Rooms are laid out as one would walk to them from
// where the player stands, so a doorway that leads elsewhere joins what it joins, and nothing jumps when one goes
// through.

/// What else there is to know for drawing it.
struct AutomapLook {
    AutomapColors colors = AutomapColors::usual;
    std::span<const ThingId> taken{};  ///< things that are gone, in the order of their numbers
    std::string_view keys{};           ///< a line that says how it is moved; empty: neither that nor the legend
};

class Automap {
public:
    Automap() = default;
    explicit Automap(const Map& map);

    /// The player is in this sector: its walls are drawn brightly from now on.
    void visit(SectorId sector) { known_[sector.index] = Known::visited; }
    /// The player has looked into this sector: its walls are drawn dimly until it is visited.
    void see(SectorId sector);

    bool is_open() const { return open_; }
    void toggle() { open_ = !open_; }
    /// steps > 0 shows a smaller part, larger.
    void zoom(int steps);

    /// Moves what is shown by so many steps, an eighth of the picture's height each, right and up.
    void pan(int right, int up);
    /// The player is in the middle again.
    void follow() { panned_m_ = {}; }

    /// The player in the middle, unless it was moved, looking up. Draws nothing while closed.
    /// Cost: the walls of the rooms near the player, each room once.
    void draw(Overlay& overlay, const Map& map, const Place& player, Vec2 forward, const AutomapLook& look = {}) const;

private:
    enum class Known : std::uint8_t { unknown, seen, visited };

    double half_height_m() const;

    std::vector<Known> known_;
    std::vector<bool> is_door_;  ///< by sector
    Vec2 panned_m_;              ///< to the right of the player, and ahead
    bool open_ = false;
    int zoom_steps_ = 0;
};

// Notices when a map or one of its pictures is saved, so that an author sees the change at once.

/// Remembers every file that was read through it, and those that were looked for in vain.
class MapWatch {
public:
    /// A reader for load_map. What was remembered before is forgotten. Must not outlive the watch.
    FileReader start_reading();

    /// True where a file has changed, appeared or gone since it was read. Cost: one look at each file.
    bool changed() const;

private:
    /// When the file was last written, or the smallest time where there is none.
    static std::filesystem::file_time_type written(const std::string& path);

    std::map<std::string, std::filesystem::file_time_type> files_;
};

class Game {
public:
    /// Loads a map and puts the player at its start. An error where the map is refused: all its findings, a line each.
    /// skill : 1..kMostSkill
    /// motion: how the world moves, until a game is loaded that was saved by other dials
    static Result<std::unique_ptr<Game>> start(const std::string& map_path, std::vector<std::string> texture_folders,
                                               int skill = kUsualSkill, const MotionDials& motion = {});

    /// Lets a tick pass and, while recording, writes it down.
    void tick(const TickInput& input);

    /// The player is at the start again, and a tape that is recorded begins again.
    void restart();

    /// Leaves the map for the start of another; a recording ends here. An error leaves everything as it was.
    Result<void> enter(const std::string& map_path);

    /// Goes back in time by some ticks, or to the beginning; what came later is forgotten, by a tape as well.
    void rewind(std::size_t ticks);

    /// Writes down how the game stands, as the tape of all that led there. The two files that were saved there before
    /// are kept beside it, with .1 and .2 behind their names. An error where it cannot be written, and where it could
    /// not be loaded again: the map was loaded again on the way, so that it does not begin at its start, or the map's
    /// file is no longer the one that is played. Then what was saved before stays as it is.
    Result<void> save(const std::string& path) const;
    /// Why the game cannot be saved anywhere, if so: the map's file is no longer the one that is played, or it was
    /// loaded again meanwhile.
    Result<void> check_savable() const;

    /// Goes on where a game was saved, or where a recording ends, by its dials of motion; one that is being recorded
    /// ends here. An error where there is none, or it is of another map, or of this one as it was before it was
    /// changed; then everything is as it was. Cost: all ticks that were played.
    Result<void> load_saved(const std::string& path);

    /// True where the map or one of its pictures was saved since it was loaded.
    bool map_changed() const { return watch_.changed(); }

    /// Loads the map again. The player stays where he is, or where that is no longer inside the map, begins at its
    /// start. An error, with all findings, leaves everything as it was. A recording ends here: it belongs to the map
    /// before.
    Result<void> reload();

    /// What `check` would warn of in the map, a line each, such as pictures that are nowhere. Nothing of a map that
    /// came compiled from the cache.
    const std::vector<std::string>& warnings() const { return warnings_; }

    /// What the player sees, `part` of the way from the tick before to this one, the head turned further by `ahead`.
    View view(double part, const LookSteps& ahead, const Lens& lens) const;
    /// The world as renderers see it at that moment.
    const Snapshot& snapshot(double part);

    const Map& map() const { return map_.map; }
    const TextureSet& textures() const { return map_.textures; }
    const World& world() const { return timeline_.world(); }
    const Player& player() const { return world().player; }
    TickRate tick_rate() const { return world().history.rate(); }
    const OpenMap& open_map() const { return map_; }
    const std::string& path() const { return path_; }
    /// Where the map's parts are written; nowhere where its file is no longer the map that is played.
    /// Cost: that of reading the map, the first time.
    const MapPlaces& places();
    Automap& automap() { return automap_; }

    /// From now on everything is written to the tape at `path`, tick by tick; only right after start or restart.
    Result<void> record(const std::string& path);
    bool is_recording() const { return recorder_.has_value(); }
    /// Ends the recording, where there is one.
    void end_recording();
    /// Why the last recording could not be written to its end, once.
    std::optional<Error> take_recording_fault() { return std::exchange(recording_fault_, {}); }

    /// All that was pressed since the start, and how the world is now.
    Tape tape() const;

private:
    Game(std::string path, std::vector<std::string> texture_folders, int skill);
    void begin(const MotionDials& motion);

    /// A map as it is on disk now.
    struct Loaded {
        OpenMap open;
        std::uint64_t hash = 0;             ///< of the map's text
        std::vector<std::string> warnings;  ///< a line each
    };
    /// watch : remembers what was read, also for a map that is refused
    Result<Loaded> load(const std::string& map_path, MapWatch& watch) const;
    void take(Loaded loaded);
    /// Ends the recording where writing it failed.
    void heed(const Result<void>& recorded);
    /// The player of before in the map of now.
    void keep_player(const Player& before, const std::string& sector_name);

    std::string path_;
    std::vector<std::string> texture_folders_;
    int skill_;
    MapWatch watch_;
    std::uint64_t map_hash_ = 0;  ///< of the map's text, as it is played
    std::vector<std::string> warnings_;
    OpenMap map_;
    std::optional<MapPlaces> places_;  ///< none: nobody asked yet
    Timeline timeline_;
    Snapshot snapshot_;
    Automap automap_;
    bool from_start_ = true;  ///< the timeline begins as the map does
    std::optional<TapeRecorder> recorder_;
    std::optional<Error> recording_fault_;
};

}  // namespace enfilade
