// Floors, ceilings, light and skies.
#include <algorithm>
#include <array>
#include <limits>

#include "wadconv/workbench.h"

namespace enfilade::wadconv {
namespace {

// Times [tics]. Flickering light is dark for 1 to 8 tics, and then bright for 1 or 65: in the mean for these.
constexpr double kFlash = 5, kFastDark = 15, kSlowDark = 35, kMeanCalm = 33, kMeanFlicker = 4.5, kFlame = 4;

/// Flickering light has times of half a tic [1/s].
constexpr double kFlickerClock = 2 * kTicsPerSecond;

/// How much darker a flame may be than the next [of 0..255].
constexpr double kFireStep = 16;

/// What glowing light changes by in a tic [of 0..255].
constexpr double kGlowSpeed = 8;

/// How much brighter than the darkest sector around fire stays [of 0..255].
constexpr int kFireAbove = 16;

LightEffectRecord effect(LightKind kind, int dark, double dark_tics, double bright_tics, bool in_step = false) {
    LightEffectRecord effect;
    effect.kind = kind;
    effect.dark = std::clamp(dark, 0, 255) / kLightLevels;
    effect.dark_s = dark_tics / kTicsPerSecond;
    effect.bright_s = bright_tics / kTicsPerSecond;
    effect.in_step = in_step;
    effect.lasts = true;
    effect.clock_hz = kind == LightKind::flicker ? kFlickerClock : kTicsPerSecond;
    if (kind == LightKind::fire) effect.step = kFireStep / kLightLevels;
    return effect;
}

/// Strobes go quite dark where nothing around is darker.
LightEffectRecord strobe(int light, int darkest, double dark_tics, bool in_step) {
    return effect(LightKind::strobe, darkest == light ? 0 : darkest, dark_tics, kFlash, in_step);
}

// The heights a map starts with: sound ones, and with open doors if asked.

/// Line specials that open the sector behind the line: doors one pushes.
constexpr std::array kPushedDoors = {1, 26, 27, 28, 31, 32, 33, 34, 117, 118};

/// Line specials that open the sectors of the line's tag. Source: "The Unofficial Doom Specs", §4.3.3.
constexpr std::array kRemoteDoors = {2,   4,   29,  46,  61,  63,  86,  90,  99,  103, 105, 106,
                                     108, 109, 111, 112, 114, 115, 133, 134, 135, 136, 137};

/// How far below the lowest ceiling around it an open door stops [map units].
constexpr std::int32_t kDoorLip = 4;

bool is_one_of(std::span<const int> specials, int special) {
    return std::ranges::find(specials, special) != specials.end();
}

/// Which sectors some line opens.
std::vector<bool> find_doors(const DoomMap& doom, const Parts& parts) {
    std::vector<bool> is_door(doom.sectors.size());
    std::vector<bool> tag_opens(65536);
    for (const Linedef& line : doom.lines)
        if (line.tag != 0 && is_one_of(kRemoteDoors, line.special)) tag_opens[line.tag] = true;
    for (std::size_t s = 0; s < doom.sectors.size(); ++s) is_door[s] = tag_opens[doom.sectors[s].tag];
    for (const Edge& edge : parts.edges)
        if (edge.line != kNone && edge.is_left && is_one_of(kPushedDoors, doom.lines[edge.line].special))
            is_door[edge.sector] = true;
    return is_door;
}

bool is_closed(const DoomHeights& h) { return h.floor == h.ceiling; }

/// The lowest ceiling of the open sectors around each sector; the largest number where there is none.
std::vector<std::int32_t> lowest_around(const Parts& parts, const std::vector<DoomHeights>& heights) {
    std::vector<std::int32_t> lowest(heights.size(), std::numeric_limits<std::int32_t>::max());
    for (const Edge& edge : parts.edges) {
        if (!edge.is_open) continue;
        const std::uint32_t around = parts.edges[edge.opposite].sector;
        if (!is_closed(heights[around])) lowest[edge.sector] = std::min(lowest[edge.sector], heights[around].ceiling);
    }
    return lowest;
}

void raise_doors(const DoomMap& doom, const Parts& parts, std::vector<DoomHeights>& heights, Report& report) {
    const std::vector<bool> is_door = find_doors(doom, parts);
    const std::vector<std::int32_t> lowest = lowest_around(parts, heights);
    for (std::size_t s = 0; s < heights.size(); ++s) {
        if (!is_door[s] || !is_closed(heights[s]) || lowest[s] == std::numeric_limits<std::int32_t>::max()) continue;
        if (lowest[s] - kDoorLip <= heights[s].floor) continue;
        heights[s].ceiling = lowest[s] - kDoorLip;
        report.note(Kind::opened_door, s);
    }
}

/// A sky picture's columns go round 1024 to the full turn, and to the left: Doom's skies are mirrored.
constexpr double kSkyColumns = -1024;
/// One row for every pixel of a 320 x 200 picture with a field of view of 90 degrees: this many to the tangent 1.
constexpr double kSkyRowsPerTangent = 160;
/// How fast doors move [map units / tic].
constexpr double kDoorSpeed = 2;

/// The row that lies on the horizon.
constexpr double kSkyHorizonRow = 100;

/// The texture Doom uses as sky: by episode, or in Doom II for maps 1 to 11, 12 to 20 and from 21.
std::string sky_texture(std::string_view map) {
    if (map.starts_with('E')) return std::string("SKY") + map[1];
    const int number = (map[3] - '0') * 10 + (map[4] - '0');
    return number < 12 ? "SKY1" : number < 21 ? "SKY2" : "SKY3";
}

/// The map's sky, or the first of all; null where there is neither.
const PictureFile* sky_file(const Workbench& bench) {
    const PictureFile* file = bench.pictures.wall(sky_texture(bench.doom.name));
    return file ? file : bench.pictures.wall("SKY1");
}

TextureSpec sky_spec(const PictureFile& file) {
    TextureSpec spec;
    spec.name = file.name;
    spec.tile_m = Vec2{kSkyColumns / file.width, file.height / kSkyRowsPerTangent};
    spec.offset_tx = {0, std::max(0.0, file.height - kSkyHorizonRow)};
    return spec;
}

std::optional<TextureSpec> flat_spec(const Workbench& bench, const std::string& flat) {
    const PictureFile* file = is_sky(flat) ? sky_file(bench) : bench.pictures.flat(flat);
    if (!file) return {};
    return is_sky(flat) ? sky_spec(*file) : TextureSpec{file->name, {}, {}, {}};
}

/// A flat, or the sky.
FlatRecord flat_record(Workbench& bench, const std::string& flat, std::int32_t height, std::uint32_t sector) {
    FlatRecord record;
    record.z = metres(height);
    record.parallax = is_sky(flat);
    record.texture = flat_spec(bench, flat);
    if (!record.texture) bench.report.note(Kind::unknown_flat, sector);
    return record;
}

/// Specials of Boom put together from bits: light, damage, secrets.
struct Nature {
    int light = 0;   ///< the special whose light it has
    int damage = 0;  ///< every 32 tics [points of health]
    bool is_secret = false;
};

Nature nature_of(int special) {
    constexpr int kGeneralized = 32;  // from here on numbers are bits
    constexpr std::array kDamages = {0, 5, 10, 20};
    if (special < kGeneralized) return {special, damage_of(special), special == 9};
    return {special & 31, kDamages[static_cast<std::size_t>(special >> 5 & 3)], (special & 128) != 0};
}

/// Doors that move by themselves: one closes after half a minute, the other opens after five.
TriggerRecord door_at_start(TriggerAction action, double after_s) {
    TriggerRecord trigger;
    trigger.on = Activation::start;
    trigger.action = action;
    trigger.after = after_s;
    trigger.speed = metres(kDoorSpeed * kTicsPerSecond);
    return trigger;
}

/// Specials that are all said in words. 11 also ends the level, which nobody here dies to see.
bool is_said(int special) {
    constexpr std::array kSaid = {1, 2, 3, 4, 5, 7, 8, 9, 10, 12, 13, 14, 16, 17};
    return special >= 32 ? (special & ~0xFF) == 0 && (special & 31) < 18
                         : std::ranges::find(kSaid, special) != kSaid.end();
}

/// Light that changes, floors that hurt, secrets, and doors that move by themselves.
void give_nature(Workbench& bench, const Part& part, SectorRecord& record) {
    const DoomSector& doom = bench.doom.sectors[part.sector];
    const Nature nature = nature_of(doom.special);
    record.light_effect = light_effect_of(nature.light, doom.light, bench.neighbours.darkest(part.sector));
    record.damage = damage_a_second(nature.damage);
    record.secret = nature.is_secret;
    if (doom.special == 10) record.triggers.push_back(door_at_start(TriggerAction::close, 30));
    if (doom.special == 14) record.triggers.push_back(door_at_start(TriggerAction::door, 300));
    if (doom.special == 0 || is_said(doom.special)) return;
    record.doom = DoomRecord{doom.special, doom.tag, 0};
    if (part.number == 0) ++bench.report.sectors_left[doom.special];
}

SectorRecord sector_record(Workbench& bench, const Part& part) {
    const DoomSector& doom = bench.doom.sectors[part.sector];
    const DoomHeights& heights = bench.heights_of(part);
    SectorRecord record;
    record.name = part_name(part);
    record.light = std::clamp<int>(doom.light, 0, 255) / kLightLevels;
    record.floor = flat_record(bench, doom.floor_flat, heights.floor, part.sector);
    record.ceiling = flat_record(bench, doom.ceiling_flat, heights.ceiling, part.sector);
    if (doom.tag != 0) record.tags = {tag_name(doom.tag)};
    if (bench.parts.count_of[part.sector] > 1) record.group = "s" + std::to_string(part.sector);
    give_nature(bench, part, record);
    return record;
}

/// By sector: whether a line might move it, or it moves by itself.
std::vector<bool> find_movable(const DoomMap& doom, const Parts& parts) {
    std::vector<bool> is_movable;
    for (const DoomSector& sector : doom.sectors) is_movable.push_back(sector.tag != 0 || sector.special != 0);
    for (const Edge& edge : parts.edges)
        if (edge.line != kNone && doom.lines[edge.line].special != 0) is_movable[edge.sector] = true;
    return is_movable;
}

/// A closed sector under the sky that stays so hides what is behind it: Doom shows the sky down to its floor. Who looks
/// at it from above would see the floor instead.
void extend_sky(const DoomHeights& heights, SectorRecord& record) {
    if (!record.ceiling.parallax || !is_closed(heights)) return;
    record.floor.parallax = true;
    record.floor.texture = record.ceiling.texture;
}

}  // namespace

LightEffectRecord slow_strobe(int dark) { return effect(LightKind::strobe, dark, kSlowDark, kFlash); }

std::optional<LightEffectRecord> light_effect_of(int special, int light, int darkest) {
    if (light <= 0) return {};
    switch (special) {
        case 2:
        case 4: return strobe(light, darkest, kFastDark, false);
        case 3: return strobe(light, darkest, kSlowDark, false);
        case 12: return strobe(light, darkest, kSlowDark, true);
        case 13: return strobe(light, darkest, kFastDark, true);
        default: break;
    }
    if (darkest >= light) return {};
    switch (special) {
        case 1: return effect(LightKind::flicker, darkest, kMeanCalm, kMeanFlicker);
        case 8: return effect(LightKind::glow, darkest, std::max(1.0, (light - darkest) / kGlowSpeed), kFlash);
        case 17: return effect(LightKind::fire, std::min(darkest + kFireAbove, light), kSlowDark, kFlame);
        default: return {};
    }
}

std::vector<DoomHeights> settle_heights(const DoomMap& doom, const Parts& parts, bool open_doors, Report& report) {
    std::vector<DoomHeights> heights;
    for (std::size_t s = 0; s < doom.sectors.size(); ++s) {
        const DoomSector& sector = doom.sectors[s];
        heights.push_back({sector.floor, std::max(sector.floor, sector.ceiling)});
        if (sector.ceiling < sector.floor) report.note(Kind::ceiling_below_floor, s);
        if (sector.ceiling == sector.floor) report.note(Kind::closed_door, s);
    }
    if (open_doors) raise_doors(doom, parts, heights, report);
    return heights;
}

bool is_sky(std::string_view flat) { return flat == kSkyFlat; }

void convert_sectors(Workbench& bench) {
    const std::vector<bool> is_movable = find_movable(bench.doom, bench.parts);
    for (const Part& part : bench.parts.parts) {
        bench.file.sectors.push_back(sector_record(bench, part));
        if (!is_movable[part.sector]) extend_sky(bench.heights_of(part), bench.file.sectors.back());
    }
    for (std::size_t s = 0; s < bench.doom.sectors.size(); ++s) {
        const DoomSector& sector = bench.doom.sectors[s];
        if (sector.light < 0 || sector.light > 255) bench.report.note(Kind::light_out_of_range, s);
        if (sector.special != 0) ++bench.report.sector_specials[sector.special];
    }
}

}  // namespace enfilade::wadconv
