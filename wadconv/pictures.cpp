#include "wadconv/pictures.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

#include "base/files.h"
#include "base/parallel.h"

namespace enfilade::wadconv {
namespace {

/// Texels that composing all textures of a pile may touch. FreeDoom's take 40 million.
constexpr std::uint64_t kMaxComposingCost = std::uint64_t{1} << 29;

/// Most flats that are offered; FreeDoom has 238. Names in a directory cost an attacker nothing.
constexpr std::size_t kMaxFlats = 8192;

constexpr std::size_t kFlatBytes = std::size_t{kFlatSide} * kFlatSide;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool is_plain(char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '[' || c == ']';
}

Result<Picture> read_flat(const Lump& lump) {
    if (lump.bytes.size() < kFlatBytes)
        return Error{"flat " + lump.name,
                     "has " + std::to_string(lump.bytes.size()) + " bytes; 64 x 64 texels take 4096"};
    Picture picture(kFlatSide, kFlatSide);
    for (std::size_t i = 0; i < kFlatBytes; ++i) picture.texels[i] = std::to_integer<std::int16_t>(lump.bytes[i]);
    return picture;
}

/// What is wrong with one picture, and why it could not be written.
struct PictureFaults {
    Result<void> drawn, written;
};

PictureFaults write_picture(const PictureFile& file, const Palette& palette, const std::string& folder) {
    const Result<Picture> picture = file.draw();
    if (!picture) return {picture.error(), {}};
    return {{}, write_one_of_many(folder + "/" + file.name + ".png", to_png(picture.value(), palette))};
}

constexpr std::array<std::string_view, 3> kFolders{"", kFlatFolder, kSpriteFolder};

Result<void> make_folders(const std::string& folder) {
    for (std::string_view part : kFolders) {
        const std::string path = folder + "/" + std::string(part);
        std::error_code failed;
        std::filesystem::create_directories(path, failed);
        if (failed) return Error{path, "cannot make the folder: " + failed.message()};
    }
    return {};
}

}  // namespace

std::string picture_name(std::string_view lump) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string name;
    for (char raw : lump) {
        const char c = lower(raw);
        if (is_plain(c))
            name += c;
        else if (c == '\\')
            name += '^';
        else
            (name += '%') += {kDigits[static_cast<unsigned char>(c) >> 4], kDigits[static_cast<unsigned char>(c) & 15]};
    }
    return name;
}

Result<Pictures> Pictures::list(const WadPile& pile, const std::vector<std::string>& sprite_frames) {
    Pictures pictures;
    const Lump* playpal = pile.find("PLAYPAL");
    if (!playpal) return Error{"", "there is no PLAYPAL lump, so the pictures have no colours; give the IWAD too"};
    const Result<Palette> palette = read_palette(playpal->bytes);
    if (!palette) return palette.error();
    pictures.palette_ = palette.value();
    if (const Lump* colormap = pile.find("COLORMAP")) pictures.list_color_table(*colormap);
    const Result<std::vector<TextureDef>> defs = read_texture_defs(pile);
    if (!defs) return defs.error();
    if (!defs.value().empty()) pictures.null_texture_ = defs.value().front().name;
    pictures.list_walls(pile, defs.value());
    pictures.list_flats(pile);
    const SpriteFrames frames = sort_sprites(pile);
    for (const std::string& frame : sprite_frames) pictures.list_sprite(frames, frame);
    pictures.sort_files();
    pictures.list_changes(pile, defs.value());
    return pictures;
}

void Pictures::list_color_table(const Lump& colormap) {
    const auto levels = measure_colormap(colormap.bytes, palette_);
    const auto table = color_table_picture(colormap.bytes);
    if (!levels || !table) return;
    light_levels_ = levels.value();
    files_.push_back({std::string(kColorTable), table.value().width, table.value().height,
                      [picture = table.value()]() -> Result<Picture> { return picture; }});
}

void Pictures::list_walls(const WadPile& pile, const std::vector<TextureDef>& defs) {
    std::uint64_t cost = 0;
    for (const TextureDef& def : defs) {
        cost += composing_cost(def, pile);
        if (cost > kMaxComposingCost) {
            problems_.push_back({"texture " + def.name, "the textures before it are too large to compose any more"});
            return;
        }
        files_.push_back({picture_name(def.name), def.width, def.height, [def, &pile] { return compose(def, pile); }});
    }
}

void Pictures::list_flats(const WadPile& pile) {
    if (pile.flats().size() > kMaxFlats)
        return problems_.push_back({"flats", "there are " + std::to_string(pile.flats().size()) + "; at most " +
                                                 std::to_string(kMaxFlats) + " are converted"});
    for (const auto& [name, lump] : pile.flats())
        if (name != kSkyFlat)
            files_.push_back({std::string(kFlatFolder) + picture_name(name), kFlatSide, kFlatSide,
                              [flat = lump] { return read_flat(*flat); }});
}

void Pictures::list_sprite(const SpriteFrames& frames, const std::string& frame) {
    const auto found = frames.find(frame);
    if (found == frames.end() || sprites_.contains(frame)) return;
    const Result<SpriteCanvas> measured = measure_frame(found->second);
    if (!measured) return problems_.push_back(measured.error());
    const SpriteCanvas canvas = measured.value();
    SpriteRecord record{std::string(kSpriteFolder) + picture_name(frame), canvas};
    for (std::size_t view = canvas.has_rotations ? 1 : 0; view <= (canvas.has_rotations ? 8u : 0u); ++view)
        files_.push_back({record.name + (view == 0 ? "" : std::to_string(view)), canvas.width, canvas.height,
                          [f = found->second, canvas, view] { return draw_view(f, canvas, view); }});
    sprites_.emplace(frame, std::move(record));
}

void Pictures::list_changes(const WadPile& pile, const std::vector<TextureDef>& defs) {
    PictureOrder order;
    for (const TextureDef& def : defs)
        if (const PictureFile* file = wall(def.name)) order.walls.push_back({def.name, file->name});
    for (const auto& [name, lump] : pile.flats())
        if (const PictureFile* file = flat(name)) order.flats.push_back({std::string(name), file->name});
    animations_ = list_animations(pile, order);
    switches_ = list_switches(pile, order);
}

void Pictures::sort_files() { std::ranges::stable_sort(files_, {}, &PictureFile::name); }

const PictureFile* Pictures::find(std::string_view name) const {
    const auto found =
        std::ranges::lower_bound(files_, name, {}, [](const PictureFile& f) { return std::string_view(f.name); });
    return found == files_.end() || found->name != name ? nullptr : &*found;
}

const SpriteRecord* Pictures::sprite(std::string_view frame) const {
    const auto found = sprites_.find(frame);
    return found == sprites_.end() ? nullptr : &found->second;
}

TextureSet Pictures::sizes() const {
    TextureSet set;
    set.placeholder = make_placeholder();
    for (const PictureFile& file : files_) {
        Texture texture;
        texture.name = file.name;
        texture.width = file.width;
        texture.height = file.height;
        set.textures.push_back(std::move(texture));
    }
    return set;
}

Result<std::vector<Error>> write_pictures(const Pictures& pictures, const std::string& folder, std::size_t workers,
                                          const std::function<void(std::size_t worker)>& step) {
    if (const Result<void> done = make_folders(folder); !done.ok()) return done.error();
    const std::vector<PictureFile>& files = pictures.files();
    std::vector<PictureFaults> faults(files.size());
    parallel_for(files.size(), workers, [&](std::size_t i, std::size_t worker) {
        faults[i] = write_picture(files[i], pictures.palette(), folder);
        step(worker);
    });
    std::vector<Error> problems;
    for (const PictureFaults& fault : faults) {
        if (!fault.written.ok()) return fault.written.error();
        if (!fault.drawn.ok()) problems.push_back(fault.drawn.error());
    }
    for (std::string_view part : kFolders)
        if (const Result<void> done = flush_folder(folder + "/" + std::string(part)); !done.ok()) return done.error();
    return problems;
}

}  // namespace enfilade::wadconv
