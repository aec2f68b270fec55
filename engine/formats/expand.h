// What an author writes once becomes what every other part of the engine reads: loops, walls, sectors. Private to
// formats/; read_map does all of it.
//
// Text → records as written → (this) → records as maps have them. Nothing behind the reader knows of the short words,
// and what they become has the places where the author wrote them.
#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/finding.h"
#include "formats/map_file.h"
#include "formats/reading.h"
#include "formats/toml.h"

namespace enfilade {

/// How much the short words of a map make: walls, things and the like. Their text is short, so the limits of texts do
/// not hold them.
class Expansion {
public:
    explicit Expansion(Reading& reading) : reading_(reading) {}

    /// Whether so much more may be made; the first time that it may not, it is noted at `place`.
    bool take(std::size_t count, TextPlace place);

private:
    Reading& reading_;
    std::size_t left_ = kMost;
    bool is_noted_ = false;

    /// A map of so many walls is built in half a second, from 200 MB of records.
    static constexpr std::size_t kMost = std::size_t{1} << 18;
};

/// What a copy of the wall takes, counted in usual walls: it may have long names.
std::size_t weight_of(const WallRecord& wall);

class PrefabFiles;

/// Gives each loop of a sector its corners and walls: `rect` and `polygon` become vertices, `wall` the walls that say
/// nothing of their own, and the sector's own outline its first loop. Every loop has as many walls as vertices then.
void write_out_loops(Reading& reading, Expansion& expansion, SectorRecord& sector);

/// Reads what a document says into a map without short words.
/// read : finds a prefab by its name; where empty, none is found
void read_document(Reading& reading, TomlNode root, PrefabFiles& files, MapFile& map);

/// The map files that others put into themselves: each is read once, however often it is placed.
class PrefabFiles {
public:
    /// first_line : beyond all lines of the map's own text
    PrefabFiles(const FileReader& read, Reading& reading, Expansion& expansion, std::uint32_t first_line)
        : read_(read), reading_(reading), expansion_(expansion), next_line_(first_line) {}

    Expansion& expansion() { return expansion_; }

    /// Puts the maps that `prefabs` name into this one; none are left.
    void place_all(MapFile& map);

    /// All files that were read, in the order of their lines.
    const std::vector<SourceFile>& sources() const { return sources_; }

private:
    struct File {
        MapFile map;
        std::size_t weight = 0;  ///< what a copy takes, counted in usual walls
        bool is_sound = false;
        bool is_merged = false;  ///< its sounds, suns, animations and switches are in the map
    };

    File* find(const PrefabRecord& prefab);
    void read_into(const PrefabRecord& prefab, std::string_view text, File& file);
    void place(const PrefabRecord& prefab, MapFile& map);

    const FileReader& read_;
    Reading& reading_;
    Expansion& expansion_;
    std::uint32_t next_line_;
    std::size_t bytes_ = 0;  ///< of all that were read
    std::vector<SourceFile> sources_;
    std::map<std::string, File> files_;
    std::vector<std::string> open_;  ///< files that are being read, each by the one before it
};

/// Cuts the walls that `openings` lead through and adds the sectors that lie between; none are left.
void cut_openings(Reading& reading, Expansion& expansion, MapFile& map);

// Where an opening is.

/// A wall by its place in the records.
struct WallIndex {
    std::size_t sector = 0, loop = 0, wall = 0;
};

/// The piece of a wall that is opened: from one point of it to another, in its direction, both on the vertex grid.
struct Gap {
    WallIndex wall;
    Vec2 begin, end;
};

/// The two gaps of an opening: near.begin faces far.end, and near.end faces far.begin.
struct TwoGaps {
    Gap near, far;
    bool touch = false;  ///< the walls lie on one line, and nothing is between them
};

/// Finds the walls that openings are in. Looks at only so many walls in all, because a hostile map may have many
/// openings between large rooms.
class GapFinder {
public:
    GapFinder(Reading& reading, const MapFile& map) : reading_(reading), map_(map) {}

    /// The gaps of an opening between sectors with these indices, or none with a finding.
    std::optional<TwoGaps> find(const OpeningRecord& opening, std::size_t near_sector, std::size_t far_sector);
    /// The gap of a link around a point of the sector's walls, at whose place `place` findings are noted.
    /// facing: the sector that it is to be opposite to; none: it leads elsewhere
    std::optional<Gap> around(const OpeningRecord& opening, std::size_t sector, Vec2 middle,
                              std::optional<std::size_t> facing, TextPlace place);

private:
    const WallRecord& record(WallIndex wall) const;
    bool is_too_much(const OpeningRecord& opening, std::size_t walls);
    std::optional<Vec2> fitting_place(std::size_t sector, Vec2 point, double width,
                                      std::optional<std::size_t> facing) const;
    std::optional<WallIndex> wall_at(std::size_t sector, Vec2 point, double width, std::optional<std::size_t> facing,
                                     TextPlace place);
    bool is_taken(WallIndex wall) const;
    bool can_afford(std::size_t walls);
    bool may_open(const Gap& gap, TextPlace place);
    std::optional<TwoGaps> facing(const OpeningRecord& opening, std::size_t near_sector, std::size_t far_sector);
    std::optional<Gap> opposite(const OpeningRecord& opening, const Gap& near, std::size_t far_sector);

    Reading& reading_;
    const MapFile& map_;
    std::size_t looked_at_ = 0;
};

}  // namespace enfilade
