// WADs, maps and pictures made in code, byte by byte, for tests that need them.
//
//   Level level;
//   const int hall = level.sector(0, 128);
//   level.box(0, 0, 256, 256, hall);
//   WadBuilder wad;
//   wad.add_map("MAP01", level.map);
//   const Bytes bytes = wad.finish("PWAD");
//
// Coordinates are Doom's: y up, boxes have their sector inside.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "wadconv/wad.h"

namespace enfilade::wadconv::test {

inline Bytes bytes_of(const ByteWriter& writer) { return {writer.bytes().begin(), writer.bytes().end()}; }

/// The first eight characters, filled up with zeros.
void put_name(ByteWriter& out, std::string_view name);

/// Lumps one after another, then the directory.
class WadBuilder {
public:
    void add(std::string name, Bytes bytes = {}) { lumps_.push_back({std::move(name), std::move(bytes)}); }
    /// The map's name and its five lumps.
    void add_map(const std::string& name, const DoomMap& map);
    Bytes finish(std::string_view magic = "IWAD") const;
    /// The same with the directory right behind the header, so that a cut file keeps it.
    Bytes finish_directory_first() const;
    /// Where each lump starts in finish()'s bytes, and where the directory does.
    std::vector<std::size_t> boundaries() const;

private:
    void put_directory(ByteWriter& out, std::size_t first_lump_at) const;

    struct Entry {
        std::string name;
        Bytes bytes;
    };
    std::vector<Entry> lumps_;
};

/// A pile of archives that are known to be sound.
WadPile pile_of(std::vector<Bytes> archives);

/// A map under construction.
struct Level {
    DoomMap map;

    int sector(int floor = 0, int ceiling = 128, std::string floor_flat = "FLOOR0_1",
               std::string ceiling_flat = "CEIL1_1");
    /// A side of the sector with "WALL" in the middle.
    int side(int sector_number);
    /// A line a -> b, its right side facing `right`. With a left sector it is two-sided and has no middle texture.
    int line(Vertex a, Vertex b, int right, int left = -1);
    /// Four lines clockwise: left, top, right, bottom.
    void box(int x0, int y0, int x1, int y1, int inside, int outside = -1);
    /// Lines from point to point and back to the first.
    void ring(const std::vector<Vertex>& points, int right, int left = -1);
    void thing(int x, int y, int type, int angle = 0, int flags = 7);

private:
    std::uint16_t vertex(Vertex v);
};

/// Two rooms with a doorway, a hole, a fence, a lone line and a player: something of everything.
Level small_level();

/// A patch of rows written with '.' for a hole and 'a' + n for palette number n.
Bytes patch(const std::vector<std::string>& rows, int left = 0, int top = 0);

struct PatchPlace {
    int x, y, patch;
};
struct TextureText {
    std::string name;
    int width, height;
    std::vector<PatchPlace> patches;
};
Bytes pnames(const std::vector<std::string>& names);
Bytes texture_lump(const std::vector<TextureText>& textures);

/// PLAYPAL with colour (n, n, n) at n; COLORMAP with 34 maps that darken evenly.
Bytes grey_palette();
Bytes even_colormap();

/// A lump of samples, 0 to 255.
Bytes sound(int rate, const std::vector<int>& samples);

/// An IWAD with pictures for the names that Level uses, a switch, sky and two sprites, and with all sounds that are
/// converted.
WadBuilder picture_wad();

}  // namespace enfilade::wadconv::test
