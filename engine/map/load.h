// From a map file to a Map: resolve names, round to the grid, check every rule, and load the pictures.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "base/finding.h"
#include "formats/map_toml.h"
#include "map/map.h"
#include "map/textures.h"

namespace enfilade {

// Meaning: names become ids, coordinates go onto the grid, portals find the wall they lead out of, and every rule of
// a sound map is checked with exact predicates. All findings are reported, not the first.

/// The map, or none where a finding (also one that was there before) is an error. Findings are appended, unsorted.
/// Warnings are noted only for a file the reader found no error in: what seems missing may be what could not be read.
/// At most 1000 errors and 1000 warnings are noted, and one more each that says so.
///
/// file: as read_map leaves it (formats/map_toml.h): numbers finite and in range, as many walls as vertices.
/// `textures` must hold every name the file uses (map/textures.h): their sizes turn texels into tiles.
/// Cost: O(n log n) in the number of walls.
std::optional<Map> build_map(const MapFile& file, const TextureSet& textures, Findings& findings);

/// A file beside a map that the map names, and where.
struct NamedFile {
    std::string name;  ///< as written, seen from the map's folder
    TextPlace place;
};

/// A map that was read: there is one exactly where findings has no error.
struct LoadedMap {
    std::optional<Map> map;
    TextureSet textures;
    Findings findings;                 ///< errors and warnings, sorted by place
    std::vector<NamedFile> sounds;     ///< by SoundId
    std::vector<NamedFile> next_maps;  ///< that its exits lead to, as written
    std::vector<SourceFile> sources;   ///< its prefabs: whose places of sounds and next maps are which file's
};

/// The skill, 1..kMostSkill, of a game where nobody chooses one: Doom's "Hurt me plenty".
inline constexpr int kUsualSkill = 3;

/// Where a map that takes long to read is kept, compiled, for the next time (app/open_map.h).
struct MapStore {
    std::uint64_t edition = 0;               ///< of the program: what another one kept is not taken
    std::function<Result<Bytes>()> find;     ///< what was kept, unchecked; an error where that is nothing
    std::function<void(const Bytes&)> keep;  ///< empty: nothing is kept. May fail in silence
};

/// Smaller map texts are not kept: they are read in less than a second [bytes].
inline constexpr std::size_t kLeastKeptBytes = std::size_t{8} << 20;

/// Reads, builds and checks the map at `path` and loads its pictures: from `more_texture_folders` first, then from the
/// folders the map names, which are seen from the map's own folder. A file that cannot be read at all is one finding
/// without a place. A map without a name is called like its file.
///
/// skill : 1..kMostSkill: the map holds only the things that stand there when one plays alone; none: all things
/// list : where given, a picture that is missing is reported with the one that is called nearly so
/// store : where given, a text of at least kLeastKeptBytes is compiled and kept there, and read from there as long as
///         it, the skill, the program and the sizes of its pictures are the same; the map is the same, bit for bit. A
///         map with prefabs is not kept
LoadedMap load_map(const std::string& path, const std::vector<std::string>& more_texture_folders,
                   const FileReader& read, std::optional<int> skill = {}, const FolderLister& list = {},
                   const MapStore* store = nullptr);

/// Where in its file each part of a map is written; each list is indexed by the parts' ids.
struct MapPlaces {
    std::vector<TextPlace> sectors, floors, ceilings, walls, panels, things;
    std::vector<SourceFile> sources;  ///< its prefabs: source_of() (base/finding.h) says whose a place is
};

/// Of the Map that load_map() makes of this text for this skill: not kept with the map, because hardly anybody asks.
/// path, read : of the map's file, for its prefabs
/// Cost: that of read_map().
MapPlaces places_in(std::string_view text, std::optional<int> skill = {}, const std::string& path = {},
                    const FileReader& read = {});

/// read_map() (formats/map_toml.h) of the map at `path`, whose prefabs lie below its folder; the paths of its sources
/// are seen from where `path` is.
MapReading read_map_at(const std::string& path, std::string_view text, const FileReader& read);

// A map as it is once its file was read, built and checked, as bytes: reading them back takes a twentieth of the time.

/// Width and height of a picture [px].
struct TextureSize {
    std::uint32_t width = 0, height = 0;

    bool operator==(const TextureSize&) const = default;
};

/// All that load_map() knows of a map but its pictures.
struct CompiledMap {
    Map map;
    std::vector<std::string> textures;  ///< folders, as the file names them
    PictureNeeds needs;
    std::vector<TextureSize> sizes;  ///< of the pictures it was built with, as in `needs`: their tiles come from them
    Findings findings;               ///< of the reader and the builder: warnings
    std::vector<NamedFile> sounds;
    std::vector<NamedFile> next_maps;
};

/// source: a number for all it was made from; read_compiled() asks for it again.
/// Cost: about 450 bytes for a room of four walls.
Bytes compile(const CompiledMap& compiled, std::uint64_t source);

/// Whether the bytes begin as those of compile() for this source do. Nothing else of them is looked at.
bool is_compiled_from(std::span<const std::byte> bytes, std::uint64_t source);

/// None where the bytes are not those of compile() for the same source: written by another version, of another text,
/// cut off, or damaged. Any bytes are safe: every length, id and number is checked, so that what is there can be drawn
/// and walked through; that walls do not cross and the like is what the checksum vouches for, not looked at again.
/// Cost: about 0.5 s and 0.7 GB for 10^6 sectors.
std::optional<CompiledMap> read_compiled(std::span<const std::byte> bytes, std::uint64_t source);

/// Every id and range of the map leads to something that is there, every number is in its range (map/map_limits.h), its
/// walls are closed rings, portals lie on their exits, its groups are rings too. pictures: how many the map names.
/// For maps that were not built but read from bytes, whose shapes are settled. Cost: as that of copying the map.
bool is_consistent(const Map& map, std::size_t pictures);

}  // namespace enfilade
