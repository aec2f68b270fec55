// What the steps of build_map hand on to each other: the map as far as it is built, and where each part was written.
// Private to map/.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "base/finding.h"
#include "map/map.h"
#include "map/textures.h"
#include "math/vec.h"

namespace enfilade {

// Names of sectors and walls: finding one, and the nearest one where there is none.

/// A name within a scope (walls are named within their sector; sectors all have scope 0).
struct ScopedName {
    std::uint32_t scope;
    std::string_view name;
    std::uint32_t id;
};

/// Looks names up. The texts must outlive it.
class NameIndex {
public:
    explicit NameIndex(std::vector<ScopedName> names);

    /// The lowest id of that name. Cost: log of the number of names.
    std::optional<std::uint32_t> find(std::uint32_t scope, std::string_view name) const;

    /// "; did you mean 'X'?" with the nearest name of the scope, or nothing. Gives up after a fixed number of
    /// comparisons in the index's life, so that a file full of unknown names cannot cost more than linear time.
    std::string suggestion(std::uint32_t scope, std::string_view name) const;

    /// Every name after the first that is equal to another of its scope: (the first, the further one).
    std::vector<std::pair<std::uint32_t, std::uint32_t>> duplicates() const;

private:
    std::vector<ScopedName> names_;  ///< by scope, name, id
    mutable std::size_t comparisons_left_;
};

/// "(x, y)-(x, y)", as an edge appears in findings.
std::string edge_text(Vec2 a, Vec2 b);

// The map as far as it is built.

/// A closed loop of a sector: its walls are [first_wall, first_wall + wall_count) of Map::walls.
struct DraftLoop {
    const LoopRecord* record;
    std::uint32_t first_wall;
    std::uint32_t wall_count;
};

/// What is known beside a sector while it is built.
struct SectorDraft {
    const SectorRecord* record;
    std::uint32_t first_loop = 0;  ///< its loops are [first_loop, first_loop + loop_count) of Draft::loops
    std::uint32_t loop_count = 0;
    bool measurable = true;   ///< nothing was found wrong with its shape so far, so that geometry may be asked
    bool is_only_one = true;  ///< no other sector has its name
};

/// Where a wall was written.
struct WallDraft {
    const WallRecord* record;
    TextPlace place;  ///< of its first vertex, or the nearest place that is known
};

struct Draft {
    const MapFile& file;
    const TextureSet& textures;
    Findings& findings;
    Map map;
    std::vector<SectorDraft> sectors;  ///< indexed by SectorId
    std::vector<DraftLoop> loops;
    std::vector<WallDraft> walls;              ///< indexed by WallId
    std::vector<const ThingRecord*> things{};  ///< indexed by ThingId

    const PanelRecord& record_of(PanelId id) const {
        const Panel& panel = map[id];
        return sectors[panel.sector.index].record->panels[id.index - map[panel.sector].first_panel];
    }

    bool was_sound = true;  ///< the reader found no error

    /// Whether the reader could not make out some sector's name: a name that is unknown may be meant for it.
    bool has_nameless_sectors = false;

    /// True for the enfilade dialect: what was ambiguous in the tutorial's is an error here.
    bool is_strict() const { return file.format != 0; }
    void error(TextPlace place, std::string_view code, std::string sentence);
    /// Said only where the reader found no error: what is missing may be what could not be read.
    void warning(TextPlace place, std::string_view code, std::string sentence);

    /// The same at the value of a record's key, or at the record where the key is not given. Nothing is said of a key
    /// that the reader complained about: this would be a consequence.
    template <class Record>
    void error(const Record& record, std::string_view key, std::string_view code, std::string sentence) {
        if (record.places.is_sound(key)) error(key_place(record, key), code, std::move(sentence));
    }
    template <class Record>
    void warning(const Record& record, std::string_view key, std::string_view code, std::string sentence) {
        if (record.places.is_sound(key)) warning(key_place(record, key), code, std::move(sentence));
    }

    std::size_t error_count = 0, warning_count = 0;
};

/// The first of two places, if it is known.
inline TextPlace known(TextPlace place, TextPlace otherwise) { return place.line != 0 ? place : otherwise; }

/// Where something is missing from the file as a whole.
inline constexpr TextPlace kTopOfFile{1, 1};

/// Errors, and warnings, that the builder notes of one map; one more says that there are more. [findings]
inline constexpr std::size_t kMostErrors = 1000, kMostWarnings = 1000;

// The steps, in order. Each reports what it finds and leaves the draft fit for the next.

/// Sectors, loops and walls, their vertices on the grid (place_walls.cpp).
void place_walls(Draft& draft);
/// Heights and names (check_sectors.cpp).
void check_sectors(Draft& draft);
/// Which sectors move as one (check_sectors.cpp).
void gather_groups(Draft& draft);
/// No two edges of a sector cross, and every edge has its sector on its right (check_loops.cpp).
void check_loops(Draft& draft);
/// Panels, on the grid and inside their sectors (place_walls.cpp).
void place_panels(Draft& draft);
/// Which sector each portal leads into and which wall it comes out of (resolve_portals.cpp).
void resolve_portals(Draft& draft);
/// What linked portals and mirrors do to whatever passes, and which walls are exits of one-way portals (links.cpp).
void link_walls(Draft& draft);
/// How pictures lie on walls and flats (surfaces.cpp).
void lay_surfaces(Draft& draft);
/// What can be seen has a texture (check_sectors.cpp).
void check_textures(Draft& draft);
/// The player and the things (inhabitants.cpp).
void place_inhabitants(Draft& draft);
/// Triggers find what they are about (place_triggers.cpp).
void place_triggers(Draft& draft);
/// Keys, which triggers ask for and things give (things.cpp).
void place_keys(Draft& draft);
/// Things, sectors and triggers find their sounds (place_sounds.cpp).
void place_sounds(Draft& draft);
/// Suns, and which sectors they shine on (place_sounds.cpp).
void place_suns(Draft& draft);
/// Animations and switches (surfaces.cpp).
void note_picture_changes(Draft& draft);

// What may be large in a map that is small as a file.

/// Sectors that may be changed at once: by the triggers of one wall, sector, panel or thing, and by the start of the
/// map [1]. A game keeps each change as long as it goes on: these take 100 MB.
inline constexpr std::size_t kMostSetOff = std::size_t{1} << 20;

/// What lamps together may reach [m^2]: each holds 16 numbers for a square metre of every surface that it lights, and a
/// file must not fill the memory with them. 4096 lamps of 8 m.
inline constexpr double kMostLitArea = 0x1p20;

/// What a lamp of that reach counts for [m^2].
double lit_area(double reach_m);

// Things and what they look like: from records to values.

/// Makes sprites of records, each only once: a hundred barrels share one.
class SpriteShelf {
public:
    explicit SpriteShelf(Draft& draft) : draft_(draft) {}

    /// What the thing looks like; none where it has no frames.
    SpriteId sprite_of(const ThingRecord& thing);

private:
    using OriginKey = std::optional<std::pair<double, double>>;
    using FrameKey = std::tuple<std::string, double, OriginKey>;       ///< picture, seconds, origin
    using SpriteKey = std::tuple<int, double, std::vector<FrameKey>>;  ///< rotations, size, frames

    Draft& draft_;
    std::map<SpriteKey, SpriteId> known_;
};

/// Adds the thing, which is inside the sector, to the draft's map.
void add_thing(Draft& draft, const ThingRecord& record, SectorId sector, SpriteShelf& sprites);

/// Sorts the solid things by sector.
void list_solid_things(Map& map);

/// Finds the solid things near each sector (near_things.cpp); they are listed, and portals lead somewhere.
void list_near_things(Map& map);

/// Sorts the things that do something when touched by sector; their triggers and keys are known.
void list_touchables(Map& map);

/// The sectors of the map by name, as their numbers.
NameIndex sector_names(const Draft& draft);

// The sectors that triggers are about: by their names, and by the tags that several of them may share.

/// Makes the lists in Map::targets, each only once: ten thousand triggers about one tag share one.
class TargetLists {
public:
    explicit TargetLists(Draft& draft);

    /// The first sector of that name or tag, or none. Cost: log of the number of names.
    SectorId first_of(std::string_view name) const;

    /// The sectors that the trigger names, in the order of its names and then of the file, each once; of a group its
    /// leader; without the names that no sector has. Empty, with a finding, where the lists together get too long.
    /// Cost: log of the number of names for each; and for a list that is new, its sectors.
    TargetRange list_of(const TriggerRecord& record);

    /// The list of this sector alone.
    TargetRange list_of(SectorId sector);

    /// "; did you mean 'X'?" or nothing.
    std::string suggestion(std::string_view name) const { return index_.suggestion(0, name); }

private:
    std::span<const SectorId> sectors_of(std::string_view name) const;
    bool has_room_for(const TriggerRecord& record, std::span<const std::span<const SectorId>> parts);
    TargetRange new_list(std::span<const std::span<const SectorId>> parts);

    Draft& draft_;
    std::vector<std::string_view> names_;  ///< sorted
    std::vector<SectorId> named_;  ///< who has the name of that index; in the order of the file where several have
    std::map<std::vector<const SectorId*>, TargetRange> known_;  ///< by where the sectors of each name begin in named_
    std::map<SectorId, TargetRange> alone_;
    std::size_t listed_ = 0;                ///< sectors in all lists, counted before those that are there twice go
    std::vector<std::uint32_t> last_list_;  ///< the last list a sector was put in, counted from 1; by SectorId
    std::uint32_t list_count_ = 0;
    NameIndex index_;
};

}  // namespace enfilade
