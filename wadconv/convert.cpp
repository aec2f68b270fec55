// A map of Doom as a map of ours, step by step; and the step that is about things, and where the player starts.
#include "wadconv/convert.h"

#include <algorithm>
#include <array>

#include "wadconv/workbench.h"

namespace enfilade::wadconv {
namespace {

/// Vertical stretch of Doom's picture: 320 x 200 pixels shown on a screen of 4 : 3.
constexpr double kStretch = 1.2;

MapFile empty_map(const std::string& name) {
    MapFile file;
    file.format = 1;
    file.name = name;
    file.size = kUnitsPerMetre;
    file.render.stretch = kStretch;
    file.render.light = LightModel::classic;
    file.render.sky = SkyRows::straight;
    file.render.things = ThingEdges::whole;
    file.render.rays = RayPoint::corner;
    return file;
}

/// Points to be found times edges to be looked at; the largest map of FreeDoom needs 30 million. What asks for far more
/// is no map but an attempt to keep us busy.
constexpr std::uint64_t kMaxSearches = std::uint64_t{1} << 31;

bool is_too_large(const DoomMap& doom, const Parts& parts) {
    return (doom.things.size() + parts.lone.size()) * std::uint64_t{parts.edges.size()} > kMaxSearches;
}

/// "3, 5 and 12".
std::string listed(std::vector<std::uint32_t> numbers) {
    std::ranges::sort(numbers);
    numbers.erase(std::ranges::unique(numbers).begin(), numbers.end());
    std::string text = std::to_string(numbers.front());
    for (std::size_t i = 1; i < numbers.size(); ++i)
        text += (i + 1 < numbers.size() ? ", " : " and ") + std::to_string(numbers[i]);
    return text;
}

/// Why a map that has lost rooms cannot be played; empty: it can.
std::string unplayable(const DoomMap& doom, const Parts& parts, const Report& report) {
    if (parts.lost.empty()) return {};
    const std::string lost =
        "the rooms of sector " + listed(parts.lost) +
        " were left out, because lines cross there: " + listed(report.found.at(Kind::clashing_line));
    if (parts.parts.empty()) return "no room is left: " + lost;
    const auto start = std::ranges::find(doom.things.rbegin(), doom.things.rend(), kFirstStart, &DoomThing::type);
    if (start == doom.things.rend() || part_at(parts, to_fine(point_of(*start))) != kNone) return {};
    return "player 1 starts at (" + std::to_string(start->x) + ", " + std::to_string(start->y) +
           "), in no room that is left: " + lost;
}

void count_contents(const DoomMap& doom, Report& report) {
    report.map = doom.name;
    report.lines = doom.lines.size();
    report.sectors = doom.sectors.size();
    report.things = doom.things.size();
    for (const Linedef& line : doom.lines)
        if (line.special != 0) ++report.line_specials[line.special];
    for (std::size_t i = 0; i < doom.trailing_bytes; ++i) report.note(Kind::trailing_bytes, i);
}

}  // namespace

Conversion convert_map(const DoomMap& doom, const Pictures& pictures, const Sounds& sounds,
                       const ConvertOptions& options) {
    Conversion conversion;
    Report& report = conversion.report;
    count_contents(doom, report);
    const Result<Parts> parts = make_parts(collect_edges(doom, report), doom.sectors.size(), report);
    if (!parts) {
        report.refused = parts.error().what;
        return conversion;
    }
    if (is_too_large(doom, parts.value())) {
        report.refused = std::to_string(doom.things.size()) + " things and " +
                         std::to_string(parts.value().edges.size()) + " sides are too many together";
        return conversion;
    }
    report.refused = unplayable(doom, parts.value(), report);
    if (!report.refused.empty()) return conversion;
    MapFile file = empty_map(doom.name);
    if (const PictureFile* table = pictures.color_table()) file.render.color_table = table->name;
    const Neighbours neighbours(doom);
    Exits exits(doom.sectors.size());
    for (const std::uint32_t sector : exits_of(doom, parts.value()))
        if (sector != kNone) exits[sector] = true;
    const TriggerMaker triggers(doom, parts.value(), pictures, neighbours, exits, report);
    Workbench bench{doom,
                    pictures,
                    sounds,
                    parts.value(),
                    neighbours,
                    triggers,
                    settle_heights(doom, parts.value(), options.open_doors, report),
                    report,
                    file};
    convert_sectors(bench);
    convert_walls(bench);
    convert_panels(bench);
    convert_things(bench);
    convert_picture_changes(bench);
    convert_sounds(bench);
    report.parts = file.sectors.size();
    conversion.file = std::move(file);
    return conversion;
}

// Things, and where the player starts.

namespace {

/// Height of the player's eye above the floor [map units].
constexpr double kEyeHeight = 41;

/// Doom turns things by eighths only; yaw turns right where Doom's angle turns left.
double yaw_of(const DoomThing& thing) { return (8 - thing.angle / 45 % 8) % 8 * 45.0; }

std::uint32_t part_of(const Workbench& bench, const DoomThing& thing) {
    return part_at(bench.parts, to_fine(point_of(thing)));
}

/// The idle animation: eight rotations only where all frames have them.
void give_frames(Workbench& bench, const ThingType& type, std::size_t index, ThingRecord& record) {
    std::vector<const SpriteRecord*> sprites;
    bool is_bright = !type.frames.empty(), has_rotations = true;
    for (std::string_view rest = type.frames; !rest.empty();) {
        const IdleFrame frame = take_frame(rest);
        const SpriteRecord* sprite = bench.pictures.sprite(std::string(type.sprite) + frame.letter);
        if (!sprite) return bench.report.note(Kind::missing_sprite, index);
        is_bright = is_bright && frame.is_bright;
        has_rotations = has_rotations && sprite->canvas.has_rotations;
        sprites.push_back(sprite);
        record.frames.push_back({sprite->name,
                                 frame.tics / kTicsPerSecond,
                                 Vec2{double(sprite->canvas.origin_x), double(sprite->canvas.origin_y)},
                                 {},
                                 {}});
    }
    record.rotations = has_rotations && !sprites.empty() ? 8 : 1;
    if (record.rotations == 1)
        for (std::size_t i = 0; i < sprites.size(); ++i)
            if (sprites[i]->canvas.has_rotations) record.frames[i].texture += '1';
    if (is_bright) record.light = 1;
}

/// Whether a thing is there to be met. Starts and exits are places, and no skill takes them away.
bool is_place(const ThingType& type) { return type.sprite.empty(); }

std::uint8_t skills_of(std::uint16_t flags) {
    constexpr std::uint8_t kOfEasy = 0b00011, kOfMedium = 0b00100, kOfHard = 0b11000;
    return static_cast<std::uint8_t>((flags & kEasy ? kOfEasy : 0) | (flags & kMedium ? kOfMedium : 0) |
                                     (flags & kHard ? kOfHard : 0));
}

/// What one picks up: keys of either kind, and what heals.
void give_pickup(int type, ThingRecord& record) {
    switch (type) {
        case 5:
        case 40: record.gives_key = "blue"; break;
        case 6:
        case 39: record.gives_key = "yellow"; break;
        case 13:
        case 38: record.gives_key = "red"; break;
        case 2011: record.gives_health = 10; break;
        case 2012: record.gives_health = 25; break;
        case 2013: record.gives_health = 100; break;
        case 83: record.gives_health = 200; break;
        case 2014: record.gives_health = 1; break;
        default: break;
    }
}

void convert_thing(Workbench& bench, std::size_t index, std::uint32_t exit_of) {
    const DoomThing& thing = bench.doom.things[index];
    const ThingType* type = find_thing_type(thing.type);
    if (!type) return bench.report.note(Kind::unknown_thing, index);
    const std::uint32_t part = part_of(bench, thing);
    if (part == kNone) return bench.report.note(Kind::thing_outside, index);
    ThingRecord record;
    record.kind = type->kind;
    record.sector = bench.file.sectors[part].name;
    record.position = metres(point_of(thing));
    record.yaw_degrees = yaw_of(thing);
    record.radius = metres(type->radius);
    record.height = metres(type->height);
    record.solid = type->is_solid;
    if (record.solid) record.holds_up = can_be_shot(thing.type) ? HoldsUp::all_but_crushers : HoldsUp::nothing;
    record.hanging = type->hangs;
    record.size = kUnitsPerMetre;
    record.doom = DoomRecord{thing.type, 0, thing.flags};
    if (!is_place(*type)) {
        record.skills = skills_of(thing.flags);
        record.multiplayer = (thing.flags & kMultiplayer) != 0;
    }
    if (exit_of != kNone) record.name = exit_name(exit_of);
    give_pickup(thing.type, record);
    give_frames(bench, *type, index, record);
    bench.file.things.push_back(std::move(record));
    ++bench.report.placed_things;
}

bool start_here(Workbench& bench, const DoomThing& thing) {
    const std::uint32_t part = part_of(bench, thing);
    if (part == kNone) return false;
    PlayerRecord player;
    player.sector = bench.file.sectors[part].name;
    player.position = metres(point_of(thing));
    player.eye_z = metres(bench.heights_of(bench.parts.parts[part]).floor + kEyeHeight);
    player.yaw_degrees = yaw_of(thing);
    bench.file.player = std::move(player);
    return true;
}

/// Player 1's last start, as in Doom; else the first of the other players', else of a deathmatch.
void place_player(Workbench& bench) {
    const auto& things = bench.doom.things;
    for (auto thing = things.rbegin(); thing != things.rend(); ++thing)
        if (thing->type == kFirstStart && start_here(bench, *thing)) return;
    bench.report.note(Kind::no_start, kFirstStart);
    for (const auto& [first, last] :
         {std::pair(kFirstStart, kLastStart), std::pair(kDeathmatchStart, kDeathmatchStart)})
        for (const DoomThing& thing : things)
            if (thing.type >= first && thing.type <= last && start_here(bench, thing)) return;
}

}  // namespace

std::vector<std::uint32_t> exits_of(const DoomMap& doom, const Parts& parts) {
    std::vector<std::uint32_t> exits(doom.things.size(), kNone);
    std::vector<bool> has_one(doom.sectors.size());
    for (std::size_t i = 0; i < doom.things.size(); ++i) {
        if (doom.things[i].type != kTeleportExit) continue;
        const std::uint32_t part = part_at(parts, to_fine(point_of(doom.things[i])));
        if (part == kNone || has_one[parts.parts[part].sector]) continue;
        exits[i] = parts.parts[part].sector;
        has_one[exits[i]] = true;
    }
    return exits;
}

void convert_things(Workbench& bench) {
    for (const DoomThing& thing : bench.doom.things) ++bench.report.thing_types[thing.type];
    const std::vector<std::uint32_t> exits = exits_of(bench.doom, bench.parts);
    for (std::size_t i = 0; i < bench.doom.things.size(); ++i) convert_thing(bench, i, exits[i]);
    place_player(bench);
}

}  // namespace enfilade::wadconv
