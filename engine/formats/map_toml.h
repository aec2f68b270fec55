// Map files as text: reading both dialects of maps/FORMAT.md, and writing what the reader reads.
#pragma once
#include <string>
#include <string_view>

#include "base/files.h"
#include "base/finding.h"
#include "formats/map_file.h"

namespace enfilade {

/// What the reader made of a text. Where findings has errors the file is refused and `map` holds what could be read,
/// so that further checks can add their findings to the same list.
struct MapReading {
    MapFile map;
    Findings findings;  ///< sorted by place
    std::vector<SourceFile>
        sources;  ///< files that were read into it, by whose places tell_files() (base/finding.h) goes
};

/// Reads a map in either dialect. Every number of the records is finite and in its range, every loop has as many
/// walls as vertices, and a required key that is missing leaves its default: findings say so, none of it need be
/// checked again. Names, geometry and everything that two records must agree on are not looked at.
///
/// The dialect is told by the top-level key `format`. Never throws; any bytes are safe. Texts over kMaxMapBytes or
/// kMaxMapValues, or nested over 64 deep, are refused before memory is taken for them.
/// What stands for something longer (openings, rectangles, prefabs) is written out: nobody else ever sees it.
///
/// prefabs : reads a file by its name, which leads to a place below the map's folder; where empty, a map cannot have
///           prefabs
/// Cost: about 50 ns a byte, and at most a second for what is written out.
MapReading read_map(std::string_view text, const FileReader& prefabs = {});

/// Whether a text is meant to be a map: one that has sectors, as no script has.
bool is_map(std::string_view text);

/// Largest map text that is read [bytes].
inline constexpr std::size_t kMaxMapBytes = kMaxFileBytes;

/// Most values in one map, counted as formats/toml.h says: a sector with four walls has about 150, so that a world of
/// 10^6 sectors may be read; the largest level of FreeDoom II has 540 000. A plain text takes 60 bytes for each while
/// it is read, 7 gigabytes for such a world. For other notations formats/toml_tree.h has lower limits.
inline constexpr std::size_t kMaxMapValues = 160'000'000;

/// The map as text in the enfilade dialect, in which a tutorial file's skies and light are other ones (maps/FORMAT.md):
/// the same records give the same bytes, and read_map gives the same records back (places aside). Numbers are written
/// with the fewest digits that read back exactly.
std::string write_map(const MapFile& map);

}  // namespace enfilade
