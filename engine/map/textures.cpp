#include "map/textures.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "base/hash.h"
#include "base/parallel.h"
#include "formats/png.h"
#include "formats/text_parts.h"
#include "map/draft.h"

namespace enfilade {
namespace {

/// Of the pictures' files.
constexpr std::string_view kEnding = ".png";

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

/// Every name the file uses, in lower case, with the place of its first use in the text and as it was written there.
struct FirstUse {
    TextPlace place;
    std::string written;
};
using Names = std::map<std::string, FirstUse>;

void note(Names& names, const TextureSpec& spec) {
    if (spec.name.empty() || spec.name == "-") return;
    const auto [it, is_new] = names.try_emplace(lower_case(spec.name), FirstUse{spec.place, spec.name});
    if (!is_new && spec.place < it->second.place) it->second = {spec.place, spec.name};
}

void note(Names& names, const std::optional<TextureSpec>& spec) {
    if (spec) note(names, *spec);
}

/// The pictures of one frame: one, or one for each of eight directions.
void note(Names& names, const ThingRecord& thing, const SpriteFrameRecord& frame) {
    for (int view = 0; view < thing.rotations; ++view)
        note(names, TextureSpec{sprite_picture_name(thing, frame, view), {}, {}, key_place(frame, "texture")});
}

void note(Names& names, const FlatRecord& flat) {
    note(names, flat.texture);
    for (const FlatLayerRecord& layer : flat.layers) note(names, layer.texture);
}

void note(Names& names, const std::vector<TriggerRecord>& triggers) {
    for (const TriggerRecord& trigger : triggers)
        note(names, TextureSpec{trigger.texture, {}, {}, key_place(trigger, "texture")});
}

void note_changes(Names& names, const MapFile& file) {
    for (const AnimationRecord& animation : file.animations)
        for (const std::string& frame : animation.frames)
            note(names, TextureSpec{frame, {}, {}, key_place(animation, "frames")});
    for (const SwitchRecord& faces : file.switches) {
        note(names, TextureSpec{faces.off, {}, {}, key_place(faces, "off")});
        note(names, TextureSpec{faces.on, {}, {}, key_place(faces, "on")});
    }
}

Names names_used(const MapFile& file) {
    Names names;
    if (!file.render.color_table.empty())
        note(names, TextureSpec{file.render.color_table, {}, {}, key_place(file.render, "color_table")});
    note_changes(names, file);
    for (const SectorRecord& sector : file.sectors) {
        note(names, sector.floor);
        note(names, sector.ceiling);
        note(names, sector.triggers);
        for (const LoopRecord& loop : sector.loops)
            for (const WallRecord& wall : loop.walls) {
                for (const auto* spec : {&wall.texture, &wall.upper, &wall.lower, &wall.middle}) note(names, *spec);
                note(names, wall.triggers);
            }
        for (const PanelRecord& panel : sector.panels) {
            note(names, panel.texture);
            note(names, panel.triggers);
        }
    }
    for (const ThingRecord& thing : file.things) note(names, thing.triggers);
    for (const ThingRecord& thing : file.things)
        for (const SpriteFrameRecord& frame : thing.frames) note(names, thing, frame);
    return names;
}

Texture by_columns(const Image& image) {
    Texture texture;
    texture.width = image.width;
    texture.height = image.height;
    texture.pixels.resize(image.pixels.size());
    for (std::size_t y = 0; y < image.height; ++y)
        for (std::size_t x = 0; x < image.width; ++x)
            texture.pixels[x * image.height + y] = image.pixels[y * image.width + x];
    texture.has_holes = std::any_of(image.pixels.begin(), image.pixels.end(), [](auto p) { return p >> 24 != 255; });
    return texture;
}

/// The first folder's FOLDER/NAME.png, the name tried as written and in lower case.
Result<Bytes> read_from_folders(const std::string& written, const std::vector<std::string>& folders,
                                const FileReader& read, std::string& path) {
    for (const std::string& folder : folders)
        for (const std::string& name : {written, lower_case(written)}) {
            path = folder + "/" + name + std::string(kEnding);
            if (Result<Bytes> bytes = read(path)) return bytes;
        }
    return Error{"", "not found"};
}

}  // namespace

std::string sprite_picture_name(const ThingRecord& thing, const SpriteFrameRecord& frame, int view) {
    if (frame.texture == "-" || thing.rotations == 1) return frame.texture;
    return frame.texture + std::to_string(view + 1);
}

TextureId TextureSet::find(std::string_view name) const {
    const std::string wanted = lower_case(name);
    const auto it = std::lower_bound(textures.begin(), textures.end(), wanted,
                                     [](const Texture& t, const std::string& n) { return t.name < n; });
    if (it == textures.end() || it->name != wanted) return {};
    return TextureId(static_cast<std::size_t>(it - textures.begin()));
}

Texture make_placeholder() {
    constexpr std::uint32_t kSide = 64, kCell = 16;
    Texture texture;
    texture.width = texture.height = kSide;
    texture.pixels.resize(std::size_t{kSide} * kSide);
    for (std::uint32_t x = 0; x < kSide; ++x)
        for (std::uint32_t y = 0; y < kSide; ++y)
            texture.pixels[std::size_t{x} * kSide + y] = (x / kCell + y / kCell) % 2 ? 0xFFFF00FFu : 0xFF000000u;
    return texture;
}

PictureNeeds pictures_needed(const MapFile& file) {
    PictureNeeds needs;
    for (const auto& [name, use] : names_used(file)) needs.pictures.push_back({name, use.written, use.place});
    needs.color_table = lower_case(file.render.color_table);
    needs.color_table_place = key_place(file.render, "color_table");
    return needs;
}

TextureLoader::TextureLoader(const PictureNeeds& needs, const std::vector<std::string>& folders, const FileReader& read,
                             const FolderLister& list) {
    for (const auto& [name, written, place] : needs.pictures) {
        PictureSource& picture = pictures_.emplace_back();
        picture.name = name;
        picture.written = written;
        picture.place = place;
        if (Result<Bytes> bytes = read_from_folders(written, folders, read, picture.path))
            picture.bytes = std::move(bytes).value();
        if (picture.bytes) make_room_for(picture);
    }
    const auto is_missing = [](const PictureSource& picture) { return !picture.bytes; };
    table_place_ = needs.color_table_place;
    if (!needs.color_table.empty()) read_color_table(needs.color_table);
    if (list && std::any_of(pictures_.begin(), pictures_.end(), is_missing)) suggest_names(folders, list);
}

void TextureLoader::make_room_for(PictureSource& picture) {
    const auto size = png_size(*picture.bytes);
    const std::uint64_t unpacked = size ? std::uint64_t{size->width} * size->height * sizeof(std::uint32_t) : 0;
    bytes_needed_ += picture.bytes->size() + unpacked;
    picture.is_over = bytes_needed_ > kMostTextureBytes;
    if (picture.is_over) picture.bytes = Bytes();
}

/// Before all others, which are to be looked up in it.
void TextureLoader::read_color_table(const std::string& name) {
    const auto picture = std::ranges::find(pictures_, name, &PictureSource::name);
    if (picture == pictures_.end()) return;
    picture->is_color_table = true;
    if (!picture->bytes) return;
    const Result<Image> image = read_png(*picture->bytes);
    if (!image) return;  // said of the picture
    Result<ColorTable> table = ColorTable::read(by_columns(image.value()));
    if (table)
        color_table_ = std::move(table).value();
    else
        table_fault_ = table.error().what;
}

void TextureLoader::suggest_names(const std::vector<std::string>& folders, const FolderLister& list) {
    std::vector<std::string> known;
    for (const std::string& folder : folders)
        for (const std::string& name : list(folder))
            if (name.ends_with(kEnding)) known.push_back(lower_case(name.substr(0, name.size() - kEnding.size())));
    std::vector<ScopedName> names;
    for (const std::string& name : known) names.push_back({0, name, 0});
    const NameIndex index(std::move(names));
    for (PictureSource& picture : pictures_)
        if (!picture.bytes) picture.near = index.suggestion(0, picture.name);
}

TextureSet TextureLoader::sizes() const {
    TextureSet set;
    set.placeholder = make_placeholder();
    for (const PictureSource& picture : pictures_) {
        Texture& texture = set.textures.emplace_back();
        const auto size = picture.bytes ? png_size(*picture.bytes) : std::nullopt;
        texture.name = picture.name;
        texture.width = size ? size->width : set.placeholder.width;
        texture.height = size ? size->height : set.placeholder.height;
    }
    return set;
}

void TextureLoader::unpack(std::size_t i) {
    PictureSource& picture = pictures_[i];
    picture.texture = make_placeholder();
    if (picture.bytes && !picture.is_over) {
        const Result<Image> image = read_png(*picture.bytes);
        if (image)
            picture.texture = by_columns(image.value());
        else
            picture.fault = image.error().what;
        picture.bytes = Bytes();
    }
    picture.texture.missing = !picture.bytes;
    if (!color_table_.is_empty()) picture.texture.numbers = color_table_.numbers_in(picture.texture);
    picture.texture.name = picture.name;
}

/// Whether the same words of the map name this missing picture and the one before, which is missing, too: those of a
/// thing's eight sides are.
bool TextureLoader::is_missing_with_last(std::size_t i) const {
    if (i == 0 || i >= pictures_.size()) return false;
    const PictureSource &last = pictures_[i - 1], &picture = pictures_[i];
    return picture.texture.missing && last.texture.missing && picture.place == last.place && picture.place.line > 0;
}

void TextureLoader::report_missing(std::size_t first, Findings& findings) const {
    if (is_missing_with_last(first)) return;
    const PictureSource& picture = pictures_[first];
    std::size_t more = 0;
    while (is_missing_with_last(first + more + 1)) ++more;
    std::string names = (picture.is_color_table ? "color table " : "texture ") + in_quotes(picture.written);
    if (more > 0) names += " and " + std::to_string(more) + " more, for other sides of the thing,";
    findings.push_back(
        {picture.place, Severity::warning, "missing-texture",
         names + (more > 0 ? " are" : " is") +
             " in none of the texture folders (textures/ beside the map, the map's own 'textures', --textures); " +
             (picture.is_color_table ? "all colors are darkened in proportion" : "a placeholder is drawn") +
             picture.near});
}

void TextureLoader::report(std::size_t i, Findings& findings) const {
    const PictureSource& picture = pictures_[i];
    if (picture.texture.missing) report_missing(i, findings);
    if (!picture.fault.empty())
        findings.push_back({picture.place, Severity::error, "bad-texture", picture.path + ": " + picture.fault});
}

void TextureLoader::report_color_table(Findings& findings) const {
    if (table_fault_.empty()) return;
    findings.push_back(
        {table_place_, Severity::error, "bad-color-table", "the color table is no such table: " + table_fault_});
}

void TextureLoader::report_shortage(Findings& findings) const {
    const auto over = std::ranges::find(pictures_, true, &PictureSource::is_over);
    if (over == pictures_.end()) return;
    const auto megabytes = [](std::uint64_t bytes) { return std::to_string(bytes >> 20) + " MiB"; };
    findings.push_back({over->place, Severity::error, "too-many-pictures",
                        "expected pictures that take at most " + megabytes(kMostTextureBytes) +
                            " of memory together, found " + megabytes(bytes_needed_) + ", and " +
                            in_quotes(over->written) + " (" + in_quotes(over->path) +
                            ") is the first that is over; make pictures smaller, or use fewer"});
}

TextureSet TextureLoader::take(Findings& findings) {
    TextureSet set;
    report_shortage(findings);
    report_color_table(findings);
    set.color_table = std::move(color_table_);
    set.placeholder = make_placeholder();
    for (std::size_t i = 0; i < pictures_.size(); ++i) report(i, findings);
    for (PictureSource& picture : pictures_) set.textures.push_back(std::move(picture.texture));
    pictures_.clear();
    return set;
}

TextureSet load_textures(const MapFile& file, const std::vector<std::string>& folders, const FileReader& read,
                         Findings& findings) {
    TextureLoader loader(pictures_needed(file), folders, read);
    parallel_for(loader.count(), hardware_threads(), [&](std::size_t i, std::size_t) { loader.unpack(i); });
    return loader.take(findings);
}

}  // namespace enfilade
