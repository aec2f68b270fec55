#include "wadconv/pictures.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "base/files.h"
#include "wadconv/workbench.h"

namespace enfilade::wadconv {
namespace {

Error too_short(std::string_view lump, std::size_t bytes) {
    return {std::string(lump), "the lump ends too early, after " + std::to_string(bytes) + " bytes"};
}

Result<std::vector<std::string>> read_patch_names(const WadPile& pile) {
    std::vector<std::string> names;
    const Lump* lump = pile.find("PNAMES");
    if (!lump) return names;
    ByteReader reader(lump->bytes);
    const std::uint32_t count = reader.u32();
    if (reader.failed() || reader.remaining() / 8 < count) return too_short("PNAMES", lump->bytes.size());
    for (std::uint32_t i = 0; i < count; ++i) names.push_back(lump_name(reader.take(8)));
    return names;
}

/// Reads one texture's record, which starts where the reader is.
Result<TextureDef> read_def(ByteReader reader, const Lump& lump, const std::vector<std::string>& patch_names) {
    TextureDef def;
    def.name = lump_name(reader.take(8));
    reader.u32();  // "masked", never used
    def.width = reader.u16();
    def.height = reader.u16();
    reader.u32();  // a pointer of id's tools
    const std::uint16_t count = reader.u16();
    if (reader.failed() || reader.remaining() / 10 < count) return too_short(lump.name, lump.bytes.size());
    if (def.width < 1 || def.height < 1 || def.width > kMaxPictureSide || def.height > kMaxPictureSide)
        return Error{lump.name, "expected texture " + def.name + " of 1 to " + std::to_string(kMaxPictureSide) +
                                    " texels a side, found " + std::to_string(def.width) + " x " +
                                    std::to_string(def.height)};
    for (std::uint16_t i = 0; i < count; ++i) {
        PatchUse use;
        use.x = reader.i16();
        use.y = reader.i16();
        const std::uint16_t number = reader.u16();
        reader.u32();  // two fields that were never used
        if (number >= patch_names.size())
            return Error{lump.name, "texture " + def.name + " uses patch number " + std::to_string(number) +
                                        ", but PNAMES has " + std::to_string(patch_names.size())};
        use.patch = patch_names[number];
        def.patches.push_back(std::move(use));
    }
    return def;
}

/// Most patches in all textures of a lump; FreeDoom has 3500. Records may overlap in a hostile lump, which would let a
/// few bytes stand for billions of patches.
constexpr std::size_t kMaxPatchUses = 1'000'000;

Result<void> read_lump(const Lump& lump, const std::vector<std::string>& patch_names, std::vector<TextureDef>& defs) {
    ByteReader reader(lump.bytes);
    const std::uint32_t count = reader.u32();
    if (reader.failed() || reader.remaining() / 4 < count) return too_short(lump.name, lump.bytes.size());
    std::size_t uses = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t offset = reader.u32();
        if (offset >= lump.bytes.size()) return too_short(lump.name, lump.bytes.size());
        Result<TextureDef> def = read_def(ByteReader(lump.bytes.subspan(offset)), lump, patch_names);
        if (!def) return def.error();
        uses += def.value().patches.size() + 1;
        if (uses > kMaxPatchUses) return Error{lump.name, "the textures use over a million patches"};
        defs.push_back(std::move(def).value());
    }
    return {};
}

/// A patch in its place within a texture.
class Composer {
public:
    Composer(const TextureDef& def, const WadPile& pile) : def_(def), pile_(pile), covers_(def.width) {}

    Result<Picture> compose() {
        for (const PatchUse& use : def_.patches) {
            const Result<PatchHeader> header = header_of(use);
            if (!header) return header.error();
            for_columns(use, header.value().width, [&](std::uint32_t x, std::uint32_t) { ++covers_[x]; });
        }
        Picture picture(def_.width, def_.height);
        for (const PatchUse& use : def_.patches) {
            const Result<Picture> patch = read_patch(pile_.find(use.patch)->bytes);
            if (!patch) return about(use, patch.error());
            for_columns(use, patch.value().width, [&](std::uint32_t x, std::uint32_t from) {
                draw_column(patch.value(), from, use.y, picture, x);
            });
        }
        return picture;
    }

private:
    Error about(const PatchUse& use, const Error& error) {
        return {"texture " + def_.name + ", patch " + use.patch, error.what};
    }

    Result<PatchHeader> header_of(const PatchUse& use) {
        const Lump* lump = pile_.find(use.patch);
        if (!lump) return about(use, {"", "there is no such lump"});
        const Result<PatchHeader> header = read_patch_header(lump->bytes);
        if (!header) return about(use, header.error());
        return header;
    }

    /// Calls visit(texture column, patch column) for the patch's columns within the texture.
    template <class Visit>
    void for_columns(const PatchUse& use, std::uint32_t patch_width, const Visit& visit) {
        const std::int32_t begin = std::max(0, use.x);
        const std::int32_t end = std::min(std::int32_t(def_.width), use.x + std::int32_t(patch_width));
        for (std::int32_t x = begin; x < end; ++x) visit(std::uint32_t(x), std::uint32_t(x - use.x));
    }

    void draw_column(const Picture& patch, std::uint32_t from, std::int32_t y, Picture& picture, std::uint32_t x) {
        if (covers_[x] == 1) y = std::max(y, 0);
        for (std::uint32_t begin = 0, end = 0; begin < patch.height; begin = end) {
            while (end < patch.height && patch.at(from, end) != kHole) ++end;
            draw_run(patch, from, begin, end, y, picture, x);
            if (begin == end) ++end;
        }
    }

    /// Draws rows [begin, end) of a patch's column. A run that begins above the texture loses its END.
    static void draw_run(const Picture& patch, std::uint32_t from, std::uint32_t begin, std::uint32_t end,
                         std::int32_t y, Picture& picture, std::uint32_t x) {
        const std::int32_t top = y + std::int32_t(begin);
        const std::int32_t rows = std::int32_t(end - begin) + std::min(top, 0);
        for (std::int32_t i = 0; i < rows; ++i) {
            const std::int32_t row = std::max(top, 0) + i;
            if (row >= std::int32_t(picture.height)) return;
            picture.at(x, std::uint32_t(row)) = patch.at(from, begin + std::uint32_t(i));
        }
    }

    const TextureDef& def_;
    const WadPile& pile_;
    std::vector<std::uint32_t> covers_;  // by how many patches each column is covered
};

/// From one picture to another in the order of the WAD.
struct PictureRange {
    bool is_flat;
    std::string first, last;
    double tics;
};

/// How long Doom shows each picture [tics].
constexpr double kUsualTics = 8;

/// More pictures than this in one animation are a mistake.
constexpr std::ptrdiff_t kMostFrames = 256;

struct BuiltIn {
    bool is_flat;
    std::string_view first, last;
};

constexpr std::array kBuiltIn = {
    BuiltIn{true, "NUKAGE1", "NUKAGE3"},    BuiltIn{true, "FWATER1", "FWATER4"},
    BuiltIn{true, "SWATER1", "SWATER4"},    BuiltIn{true, "LAVA1", "LAVA4"},
    BuiltIn{true, "BLOOD1", "BLOOD3"},      BuiltIn{true, "RROCK05", "RROCK08"},
    BuiltIn{true, "SLIME01", "SLIME04"},    BuiltIn{true, "SLIME05", "SLIME08"},
    BuiltIn{true, "SLIME09", "SLIME12"},    BuiltIn{false, "BLODGR1", "BLODGR4"},
    BuiltIn{false, "SLADRIP1", "SLADRIP3"}, BuiltIn{false, "BLODRIP1", "BLODRIP4"},
    BuiltIn{false, "FIREWALA", "FIREWALL"}, BuiltIn{false, "GSTFONT1", "GSTFONT3"},
    BuiltIn{false, "FIRELAV3", "FIRELAVA"}, BuiltIn{false, "FIREMAG1", "FIREMAG3"},
    BuiltIn{false, "FIREBLU1", "FIREBLU2"}, BuiltIn{false, "ROCKRED1", "ROCKRED3"},
    BuiltIn{false, "BFALL1", "BFALL4"},     BuiltIn{false, "SFALL1", "SFALL4"},
    BuiltIn{false, "WFALL1", "WFALL4"},     BuiltIn{false, "DBRAIN1", "DBRAIN4"},
};

constexpr std::size_t kEndedNameBytes = 9, kAnimatedBytes = 23, kSwitchesBytes = 20;

/// Entries until one that ends the list or is cut off: kind, last and first name, tics.
std::vector<PictureRange> read_animated(std::span<const std::byte> lump) {
    std::vector<PictureRange> ranges;
    for (; lump.size() >= kAnimatedBytes && lump[0] != std::byte{0xFF}; lump = lump.subspan(kAnimatedBytes)) {
        PictureRange range;
        range.is_flat = (std::to_integer<int>(lump[0]) & 1) == 0;
        range.last = lump_name(lump.subspan(1, kEndedNameBytes));
        range.first = lump_name(lump.subspan(1 + kEndedNameBytes, kEndedNameBytes));
        ByteReader reader(lump.subspan(1 + 2 * kEndedNameBytes));
        range.tics = std::clamp(reader.i32(), 1, 65535);
        ranges.push_back(std::move(range));
    }
    return ranges;
}

std::vector<PictureRange> ranges_of(const WadPile& pile) {
    if (const Lump* lump = pile.find("ANIMATED")) return read_animated(lump->bytes);
    std::vector<PictureRange> ranges;
    for (const BuiltIn& b : kBuiltIn)
        ranges.push_back({b.is_flat, std::string(b.first), std::string(b.last), kUsualTics});
    return ranges;
}

/// Pairs of faces until one of episode 0 or one that is cut off.
std::vector<std::pair<std::string, std::string>> read_switches(std::span<const std::byte> lump) {
    std::vector<std::pair<std::string, std::string>> pairs;
    for (; lump.size() >= kSwitchesBytes; lump = lump.subspan(kSwitchesBytes)) {
        ByteReader episode(lump.subspan(2 * kEndedNameBytes));
        if (episode.u16() == 0) break;
        pairs.emplace_back(lump_name(lump.first(kEndedNameBytes)),
                           lump_name(lump.subspan(kEndedNameBytes, kEndedNameBytes)));
    }
    return pairs;
}

std::vector<std::pair<std::string, std::string>> faces_of(const WadPile& pile, const PictureOrder& order) {
    if (const Lump* lump = pile.find("SWITCHES")) return read_switches(lump->bytes);
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const NamedPicture& wall : order.walls)
        if (wall.lump.starts_with("SW1")) pairs.emplace_back(wall.lump, "SW2" + wall.lump.substr(3));
    return pairs;
}

}  // namespace

Result<std::vector<TextureDef>> read_texture_defs(const WadPile& pile) {
    const Result<std::vector<std::string>> patch_names = read_patch_names(pile);
    if (!patch_names) return patch_names.error();
    std::vector<TextureDef> defs;
    for (const char* name : {"TEXTURE1", "TEXTURE2"})
        if (const Lump* lump = pile.find(name))
            if (const Result<void> done = read_lump(*lump, patch_names.value(), defs); !done.ok()) return done.error();
    std::set<std::string> seen;
    std::vector<TextureDef> first;
    for (TextureDef& def : defs)
        if (seen.insert(def.name).second) first.push_back(def);
    return first;
}

Result<Picture> compose(const TextureDef& def, const WadPile& pile) { return Composer(def, pile).compose(); }

std::uint64_t composing_cost(const TextureDef& def, const WadPile& pile) {
    std::uint64_t cost = std::uint64_t{def.width} * def.height;
    for (const PatchUse& use : def.patches)
        if (const Lump* lump = pile.find(use.patch))
            if (const auto header = read_patch_header(lump->bytes))
                cost += std::uint64_t{header.value().width} * header.value().height;
    return cost;
}

std::vector<AnimationRecord> list_animations(const WadPile& pile, const PictureOrder& order) {
    std::vector<AnimationRecord> animations;
    std::set<std::string> taken;
    for (const PictureRange& range : ranges_of(pile)) {
        const std::vector<NamedPicture>& all = range.is_flat ? order.flats : order.walls;
        const auto first = std::ranges::find(all, range.first, &NamedPicture::lump);
        const auto last = std::find_if(first, all.end(), [&](const NamedPicture& p) { return p.lump == range.last; });
        if (last == all.end() || last == first || last - first >= kMostFrames) continue;
        if (std::any_of(first, last + 1, [&](const NamedPicture& p) { return taken.contains(p.picture); })) continue;
        AnimationRecord& animation = animations.emplace_back();
        animation.seconds = range.tics / kTicsPerSecond;
        for (auto frame = first; frame != last + 1; ++frame) animation.frames.push_back(frame->picture);
        taken.insert(animation.frames.begin(), animation.frames.end());
    }
    return animations;
}

std::vector<SwitchRecord> list_switches(const WadPile& pile, const PictureOrder& order) {
    std::vector<SwitchRecord> switches;
    for (const auto& [off, on] : faces_of(pile, order)) {
        const auto first = std::ranges::find(order.walls, off, &NamedPicture::lump);
        const auto second = std::ranges::find(order.walls, on, &NamedPicture::lump);
        if (first != order.walls.end() && second != order.walls.end())
            switches.push_back({first->picture, second->picture, {}});
    }
    return switches;
}

}  // namespace enfilade::wadconv
