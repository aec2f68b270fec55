// A map as it is once its file was read, built and checked, as bytes: reading them back takes a twentieth of the time.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/finding.h"
#include "map/map.h"
#include "map/textures.h"

namespace enfilade {

/// A file beside a map that the map names, and where.
struct NamedFile {
    std::string name;
    TextPlace place;
};

/// Width and height of a picture [px].
struct TextureSize {
    std::uint32_t width = 0, height = 0;

    bool operator==(const TextureSize&) const = default;
};

/// All that load_map() (map/load.h) knows of a map but its pictures.
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
/// cut off, or damaged. Any bytes are safe: every length and every id is checked, so that what is there can be drawn
/// and walked through; that walls do not cross and the like is what the checksum vouches for, not looked at again.
/// Cost: about 0.5 s and 0.7 GB for 10^6 sectors.
std::optional<CompiledMap> read_compiled(std::span<const std::byte> bytes, std::uint64_t source);

/// Every id and range of the map leads to something that is there, its walls are closed rings on the grid, its groups
/// are rings too. pictures: how many the map names. For maps that were not built but read from bytes.
bool is_consistent(const Map& map, std::size_t pictures);

}  // namespace enfilade
