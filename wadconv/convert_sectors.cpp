// Floors, ceilings, light and skies.
#include <algorithm>
#include <array>

#include "wadconv/light_effects.h"
#include "wadconv/thing_table.h"
#include "wadconv/workbench.h"

namespace enfilade::wadconv {
namespace {

/// Light levels of Doom reach from 0 to 255; its 16 steps are level / 16, so that 256 parts make light * 16 exact.
constexpr double kLightLevels = 256;

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

}  // namespace

bool is_sky(std::string_view flat) { return flat == kSkyFlat; }

void convert_sectors(Workbench& bench) {
    for (const Part& part : bench.parts.parts) bench.file.sectors.push_back(sector_record(bench, part));
    for (std::size_t s = 0; s < bench.doom.sectors.size(); ++s) {
        const DoomSector& sector = bench.doom.sectors[s];
        if (sector.light < 0 || sector.light > 255) bench.report.note(Kind::light_out_of_range, s);
        if (sector.special != 0) ++bench.report.sector_specials[sector.special];
    }
}

}  // namespace enfilade::wadconv
