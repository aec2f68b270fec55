#include "wadconv/animations.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "base/bytes.h"
#include "wadconv/thing_table.h"

namespace enfilade::wadconv {
namespace {

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

constexpr std::size_t kNameBytes = 9, kAnimatedBytes = 23, kSwitchesBytes = 20;

/// Entries until one that ends the list or is cut off: kind, last and first name, tics.
std::vector<PictureRange> read_animated(std::span<const std::byte> lump) {
    std::vector<PictureRange> ranges;
    for (; lump.size() >= kAnimatedBytes && lump[0] != std::byte{0xFF}; lump = lump.subspan(kAnimatedBytes)) {
        PictureRange range;
        range.is_flat = (std::to_integer<int>(lump[0]) & 1) == 0;
        range.last = lump_name(lump.subspan(1, kNameBytes));
        range.first = lump_name(lump.subspan(1 + kNameBytes, kNameBytes));
        ByteReader reader(lump.subspan(1 + 2 * kNameBytes));
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
        ByteReader episode(lump.subspan(2 * kNameBytes));
        if (episode.u16() == 0) break;
        pairs.emplace_back(lump_name(lump.first(kNameBytes)), lump_name(lump.subspan(kNameBytes, kNameBytes)));
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
