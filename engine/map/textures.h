// The pictures of a map, ready for drawing.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "base/finding.h"
#include "base/id.h"
#include "base/result.h"
#include "formats/map_file.h"

namespace enfilade {

// What becomes of the colours of a map's pictures in the dark, where they are not darkened in proportion: a table, as
// Doom's COLORMAP is one. Yellow may turn brown, then green.

struct Texture;

/// Up to 256 colours 0xAABBGGRR, all opaque, each as it is painted and at 32 levels of darkness.
class ColorTable {
public:
    static constexpr std::size_t kMostColors = 256;
    static constexpr std::size_t kLevels = 32;

    /// Reads a picture whose top row has the colours as they are painted, and whose other rows have what becomes of
    /// each at the 32 levels, full light first. Of equal colours in the top row the first counts.
    /// An error without a place says what was expected and found where the picture is no such table.
    static Result<ColorTable> read(const Texture& picture);

    bool is_empty() const { return levels_.empty(); }

    /// The colours at a level, by their numbers, kMostColors of them. level: 0, full light, to kLevels - 1.
    const std::uint32_t* at_level(std::size_t level) const { return &levels_[level * kMostColors]; }

    /// The number of each texel's colour, holes having any; nothing where the table lacks the colour of one of them.
    /// Cost: a search for every texel that differs from the one above it.
    std::vector<std::uint8_t> numbers_in(const Texture& picture) const;

    /// Gives each texel of an opaque picture the nearest of the painted colours, and the picture their numbers.
    /// Cost: a comparison with each colour for every texel.
    void paint_in_its_colors(Texture& picture) const;

    /// Of all levels, level by level; for graphics cards.
    const std::vector<std::uint32_t>& levels() const { return levels_; }

private:
    struct Painted {
        std::uint32_t color;
        std::uint8_t number;
    };
    std::vector<Painted> painted_;  ///< sorted by color
    std::vector<std::uint32_t> levels_;
};

/// A picture of any size. Pixels are 0xAABBGGRR (bytes R, G, B, A), by column: pixel (x, y) is
/// pixels[x * height + y], y down, because walls are drawn by column.
struct Texture {
    std::string name;          ///< lower case
    std::uint32_t width = 1;   ///< >= 1 [px]
    std::uint32_t height = 1;  ///< >= 1 [px]
    std::vector<std::uint32_t> pixels;
    std::vector<std::uint8_t> numbers;  ///< of their colours in the map's color table, by which the picture is then
                                        ///< darkened; empty: there is none, or it lacks one of the colours
    bool has_holes = false;             ///< some pixel is not opaque
    bool missing = false;               ///< a placeholder for a file that was not found

    /// x < width, y < height: not checked.
    std::uint32_t at(std::uint32_t x, std::uint32_t y) const { return pixels[std::size_t{x} * height + y]; }
};

/// Indexed by TextureId; sorted by name.
struct TextureSet {
    std::vector<Texture> textures;
    Texture placeholder;     ///< stands in for "no texture" where something must be drawn
    ColorTable color_table;  ///< empty: all pictures are darkened in proportion

    /// The placeholder for none. Valid as long as the set; ids are of it, which is not checked.
    const Texture& operator[](TextureId id) const { return id ? textures[id.index] : placeholder; }
    /// none where there is no such name; upper and lower case are the same. Cost: log of the number of pictures.
    TextureId find(std::string_view name) const;
};

/// The name of the picture that a frame of a thing's sprite shows from one of eight directions, 0..7; the same for
/// all where the thing has one rotation, "-" where nothing is shown.
std::string sprite_picture_name(const ThingRecord& thing, const SpriteFrameRecord& frame, int view);

/// The picture that nobody can overlook: magenta and black.
Texture make_placeholder();

/// Memory that all pictures of a map may take together, files and pixels [bytes]: nine times what every picture of a
/// whole Doom game takes (the 1548 of FreeDoom II: 58 MiB), or four of the largest that are read.
inline constexpr std::uint64_t kMostTextureBytes = std::uint64_t{512} << 20;

/// A picture that a map names: its name in lower case, as it is written at its first use, and where that is.
struct PictureNeed {
    std::string name, written;
    TextPlace place;
};

/// All pictures that a map names ("-" is none), each once, by name.
struct PictureNeeds {
    std::vector<PictureNeed> pictures;
    std::string color_table;  ///< in lower case; empty: none
    TextPlace color_table_place;
};

/// Cost: O(n log n) in the places where the map names one.
PictureNeeds pictures_needed(const MapFile& file);

/// Loads every picture the file names ("-" is none) as FOLDER/NAME.png, the first folder that has it winning. One file
/// is one picture: formats/text_keys.cpp has one spelling for each.
/// Where all pictures would take more than kMostTextureBytes, an error says so, and those that are over, in the order
/// of their names, are not kept; until all are unpacked, twice as much is taken.
/// What no folder has becomes the placeholder and a warning at its first use; what is not an image is an error.
/// Unpacking takes longer than anything else in starting a map, so it is a step of its own, to be done on several cores
/// beside other work.
class TextureLoader {
public:
    /// Reads the files. `needs` may go afterwards. `list`, where given, finds the names that are nearly those of
    /// pictures that are missing.
    TextureLoader(const PictureNeeds& needs, const std::vector<std::string>& folders, const FileReader& read,
                  const FolderLister& list = {});

    /// Every picture as large as its file says, without pixels: enough to build a map (map/load.h).
    TextureSet sizes() const;

    std::size_t count() const { return pictures_.size(); }
    /// Unpacks the i-th picture, i < count(). Different ones may be unpacked at once.
    void unpack(std::size_t i);

    /// All pictures, once all are unpacked; the loader is empty afterwards.
    TextureSet take(Findings& findings);

private:
    struct PictureSource {
        std::string name, written;   ///< as in PictureNeed
        TextPlace place;             ///< of its first use
        std::string path;            ///< where it was found
        std::optional<Bytes> bytes;  ///< of its file; none: in no folder
        bool is_color_table = false;
        bool is_over = false;  ///< there is no room for it; bytes are empty
        Texture texture;
        std::string fault;  ///< why it is not an image; empty: it is one
        std::string near;   ///< "; did you mean 'X'?" where it is missing and another one is called nearly so
    };
    void suggest_names(const std::vector<std::string>& folders, const FolderLister& list);
    void read_color_table(const std::string& name);
    /// Counts what it takes, and drops its bytes where that is too much.
    void make_room_for(PictureSource& picture);
    bool is_missing_with_last(std::size_t i) const;
    void report_missing(std::size_t first, Findings& findings) const;
    void report(std::size_t i, Findings& findings) const;
    void report_color_table(Findings& findings) const;
    void report_shortage(Findings& findings) const;

    std::uint64_t bytes_needed_ = 0;       ///< by all pictures
    std::vector<PictureSource> pictures_;  ///< sorted by name
    ColorTable color_table_;
    TextPlace table_place_;
    std::string table_fault_;  ///< what is wrong with it
};

/// All of it, on all cores.
TextureSet load_textures(const MapFile& file, const std::vector<std::string>& folders, const FileReader& read,
                         Findings& findings);

}  // namespace enfilade
