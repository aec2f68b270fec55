// The catalogue of a pile's pictures: what there is, how large it is, what its file is called; and writing them.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "map/textures.h"
#include "wadconv/picture.h"
#include "wadconv/texture_lumps.h"
#include "wadconv/wad.h"

namespace enfilade::wadconv {

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
/// drawn, in the order of the pictures; an error where one cannot be written. `progress` is called after each picture,
/// from any thread.
Result<std::vector<Error>> write_pictures(const Pictures& pictures, const std::string& folder, std::size_t workers,
                                          const std::function<void()>& progress);

}  // namespace enfilade::wadconv
