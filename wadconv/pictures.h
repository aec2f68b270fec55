// Doom's pictures: palette, patches, sprites and textures, and a catalogue of all that a pile of WADs has: how large
// each is, what its file is called; and writing them.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "base/result.h"
#include "formats/effect_records.h"
#include "formats/png.h"
#include "map/textures.h"
#include "wadconv/wad.h"

namespace enfilade::wadconv {

// Doom's pictures: the palette's colours and holes.

/// A texel through which one sees what lies behind.
inline constexpr std::int16_t kHole = -1;

/// Palette numbers by row, top row first.
struct Picture {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::int16_t> texels;  ///< width * height, 0..255 or kHole

    Picture() = default;
    Picture(std::uint32_t w, std::uint32_t h) : width(w), height(h), texels(std::size_t{w} * h, kHole) {}

    std::int16_t& at(std::uint32_t x, std::uint32_t y) { return texels[std::size_t{y} * width + x]; }
    std::int16_t at(std::uint32_t x, std::uint32_t y) const { return texels[std::size_t{y} * width + x]; }
};

/// Largest width and height of a picture [texels]. The widest in use are skies of 1024.
inline constexpr std::uint32_t kMaxPictureSide = 4096;

/// The 256 colours 0xAABBGGRR of PLAYPAL's first palette.
using Palette = std::array<std::uint32_t, 256>;

/// Colours from the first 768 bytes of PLAYPAL; fewer are an Error.
Result<Palette> read_palette(std::span<const std::byte> playpal);

/// Brightness that COLORMAP's 32 light levels leave on average, full light first: the mean over the palette's colours
/// of level's sum of channels / full sum. Fewer than 32 maps of 256 bytes are an Error.
Result<std::array<double, 32>> measure_colormap(std::span<const std::byte> colormap, const Palette& palette);

/// COLORMAP as the picture that map/textures.h wants: the palette's colours, and below them its 32 light levels.
/// Fewer than 32 maps of 256 bytes are an Error.
Result<Picture> color_table_picture(std::span<const std::byte> colormap);

/// Mirrored left to right.
Picture mirrored(const Picture& picture);

/// As PNG; equal pictures give equal bytes.
Bytes to_png(const Picture& picture, const Palette& palette);

// Patches: Doom's pictures in columns of posts, from which sprites and wall textures are made.
// Source: Matthew S. Fell, "The Unofficial Doom Specs" (1994), §5.1.

/// The first eight bytes of a patch.
struct PatchHeader {
    std::uint32_t width = 0, height = 0;  ///< 1..kMaxPictureSide [texels]
    /// The texel that sits at a sprite's position, from the picture's top left [texels].
    std::int32_t left = 0, top = 0;
};

/// An Error where the sizes are out of range or the columns' table does not fit the lump.
Result<PatchHeader> read_patch_header(std::span<const std::byte> lump);

/// The whole picture; what no post covers is a hole. A post that begins not below the one before it counts from that
/// one
/// ("tall patches", for pictures of more than 254 rows); texels below the picture are left out.
/// An Error names the column whose posts lead out of the lump or never end. Cost: the texels.
Result<Picture> read_patch(std::span<const std::byte> lump);

// Sprites: which lumps make up each frame, seen from one or from eight directions.
// Source: Matthew S. Fell, "The Unofficial Doom Specs" (1994), §5.2.

/// One frame of a sprite from one direction.
struct SpriteView {
    const Lump* lump = nullptr;  ///< null: there is none
    bool is_mirrored = false;
};

/// One frame of a sprite. views[0] serves all directions; views[1] is the front, and so on turning by eighths.
struct DoomSpriteFrame {
    std::array<SpriteView, 9> views;

    bool has_all_directions() const;  ///< views 1 to 8 are all there
};

/// All frames of all sprites, by "POSSA": the sprite's four letters and the frame's.
using SpriteFrames = std::map<std::string, DoomSpriteFrame>;

/// Sorts the lumps of the sprites' section. "POSSA2A8" is frame A from direction 2, and mirrored from 8. Names that
/// are not of that form are left out; of two lumps for the same view the later name counts.
SpriteFrames sort_sprites(const WadPile& pile);

/// A frame made ready: all its views on canvases of one size, with the thing's position at the same texel of each.
struct SpriteCanvas {
    std::uint32_t width = 0, height = 0;
    std::int32_t origin_x = 0, origin_y = 0;  ///< the texel at the thing's position
    bool has_rotations = false;               ///< eight views, else one
};

/// The smallest canvas for the frame, from the headers alone. A frame that lacks some of its eight directions is shown
/// from the one it has. An Error where a header is broken, or there is no view at all.
Result<SpriteCanvas> measure_frame(const DoomSpriteFrame& frame);

/// The picture of one view, 1..8 with rotations, else 0, on its canvas.
Result<Picture> draw_view(const DoomSpriteFrame& frame, const SpriteCanvas& canvas, std::size_t view);

// TEXTURE1, TEXTURE2 and PNAMES: how wall textures are composed of patches.
// Source: Matthew S. Fell, "The Unofficial Doom Specs" (1994), §8.4.

struct PatchUse {
    std::string patch;          ///< the lump's name
    std::int32_t x = 0, y = 0;  ///< where its top left goes [texels]
};

struct TextureDef {
    std::string name;
    std::uint32_t width = 0, height = 0;  ///< 1..kMaxPictureSide [texels]
    std::vector<PatchUse> patches;        ///< drawn in this order
};

/// All textures of TEXTURE1 and then TEXTURE2, in the file's order; of textures of one name the first counts, as in
/// Doom. The very first is Doom's "no texture". A pile without TEXTURE1 has none.
Result<std::vector<TextureDef>> read_texture_defs(const WadPile& pile);

/// The finished picture. Columns that a single patch covers hang from row 0 at the highest, and where several patches
/// cover a column a patch that begins above row 0 is moved down instead of cut: both as in Doom (id Software,
/// r_data.c, 1993), so that FreeDoom's textures look as they do there. What no patch covers is a hole.
/// An Error names the patch that is missing or broken.
Result<Picture> compose(const TextureDef& def, const WadPile& pile);

/// About how many texels compose() will touch; a missing patch counts nothing.
std::uint64_t composing_cost(const TextureDef& def, const WadPile& pile);

// Pictures that change: which walls and flats follow one another, and which are the two faces of a switch.
// Source: the lists of Matthew S. Fell, "The Unofficial Doom Specs" (1994), §8.4.1 and §4.3.3; lumps ANIMATED and
// SWITCHES as the Boom reference (1998) describes them.

/// A wall texture or flat: its name in the WAD, and its picture's in the map.
struct NamedPicture {
    std::string lump, picture;
};

/// All walls and all flats, each in an order in which animations run from one to another.
struct PictureOrder {
    std::vector<NamedPicture> walls, flats;
};

/// The pile's animations, of those pictures it has: from ANIMATED, else Doom's own. No picture is in two of them.
/// A lump that breaks off, or names what is not there, gives what it can.
std::vector<AnimationRecord> list_animations(const WadPile& pile, const PictureOrder& order);

/// The pile's switches: from SWITCHES, else every wall SW1… that has a SW2….
std::vector<SwitchRecord> list_switches(const WadPile& pile, const PictureOrder& order);

// The catalogue.

/// Flats are squares of this side [texels]; in the plane they lie on a grid of 64 map units.
inline constexpr std::uint32_t kFlatSide = 64;

/// The flat that is sky.
inline constexpr std::string_view kSkyFlat = "F_SKY1";

/// A lump's name as a picture's name in the map and, with ".png", as a file's: lower case, '\' as '^', anything else
/// that a file system or the map format might take amiss as '%' and two digits.
std::string picture_name(std::string_view lump);

/// Folders in which pictures lie, so that a flat and a wall of one name do not meet. Walls lie in none.
inline constexpr std::string_view kFlatFolder = "flats/", kSpriteFolder = "sprites/";

/// What COLORMAP's picture is called: a name too long for a lump's, so that no texture has it.
inline constexpr std::string_view kColorTable = "color_table";

/// One picture file: how to make it, once somebody asks.
struct PictureFile {
    std::string name;  ///< with its folder, without ".png"
    std::uint32_t width = 0, height = 0;
    std::function<Result<Picture>()> draw;
};

/// A sprite's frame as the map refers to it.
struct SpriteRecord {
    std::string name;  ///< picture's name; with rotations the digits 1 to 8 come behind it
    SpriteCanvas canvas;
};

/// Everything a converter needs to know about a pile's pictures. Nothing but headers has been read yet. Looks into the
/// pile, which must outlive it.
class Pictures {
public:
    /// `sprite_frames`: the frames to offer, as "POSSA"; those that the pile lacks are left out.
    /// An Error where PLAYPAL, or a lump that lists textures, is missing or broken.
    static Result<Pictures> list(const WadPile& pile, const std::vector<std::string>& sprite_frames);

    /// Doom's "no texture" is the first of TEXTURE1.
    bool is_null_texture(std::string_view texture) const { return texture == null_texture_; }
    /// The wall texture's file, or null.
    const PictureFile* wall(std::string_view texture) const { return find(picture_name(texture)); }
    const PictureFile* flat(std::string_view flat) const { return find(std::string(kFlatFolder) + picture_name(flat)); }
    /// What becomes of colours in the dark, or null where COLORMAP is missing or too short.
    const PictureFile* color_table() const { return find(kColorTable); }
    const SpriteRecord* sprite(std::string_view frame) const;

    const std::vector<PictureFile>& files() const { return files_; }  ///< sorted by name
    const Palette& palette() const { return palette_; }
    /// How bright COLORMAP's 32 levels are, full light first; nothing where the lump is missing or too short.
    const std::optional<std::array<double, 32>>& light_levels() const { return light_levels_; }
    const std::vector<AnimationRecord>& animations() const { return animations_; }
    const std::vector<SwitchRecord>& switches() const { return switches_; }
    /// What was wrong with single pictures so far; they are left out.
    const std::vector<Error>& problems() const { return problems_; }

    /// Every picture with its size and without pixels: enough for build_map to check a map.
    TextureSet sizes() const;

private:
    Pictures() = default;
    const PictureFile* find(std::string_view name) const;
    void list_color_table(const Lump& colormap);
    void list_walls(const WadPile& pile, const std::vector<TextureDef>& defs);
    void list_flats(const WadPile& pile);
    void list_sprite(const SpriteFrames& frames, const std::string& frame);
    void list_changes(const WadPile& pile, const std::vector<TextureDef>& defs);
    void sort_files();

    Palette palette_{};
    std::optional<std::array<double, 32>> light_levels_;
    std::string null_texture_;
    std::vector<PictureFile> files_;
    std::map<std::string, SpriteRecord, std::less<>> sprites_;
    std::vector<AnimationRecord> animations_;
    std::vector<SwitchRecord> switches_;
    std::vector<Error> problems_;
};

/// Writes every picture as FOLDER/NAME.png, on `workers` threads. Returns what is wrong with those that cannot be
/// drawn, in the order of the pictures; an error where one cannot be written. `step` is called after each picture,
/// from any thread.
Result<std::vector<Error>> write_pictures(const Pictures& pictures, const std::string& folder, std::size_t workers,
                                          const std::function<void(std::size_t worker)>& step);

}  // namespace enfilade::wadconv
