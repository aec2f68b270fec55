// Walls and portals with their textures, hung as Doom hangs them (id Software, r_segs.c, 1993, rules only).
#include <algorithm>
#include <set>

#include "wadconv/workbench.h"

namespace enfilade::wadconv {
namespace {

/// One edge with what lies on its two sides.
struct EdgeSides {
    const Edge& edge;
    const Sidedef& side;
    const DoomSector& front;
    const DoomSector& back;
    DoomHeights here, beyond;

    bool has_two_skies() const { return is_sky(front.ceiling_flat) && is_sky(back.ceiling_flat); }
};

EdgeSides opening_of(const Workbench& bench, const Edge& edge) {
    const Edge& other = bench.parts.edges[edge.opposite];
    return {edge,
            bench.side_of(edge),
            bench.doom.sectors[edge.sector],
            bench.doom.sectors[other.sector],
            bench.heights[edge.sector],
            bench.heights[other.sector]};
}

/// Steps that nothing is drawn on say so, or the check would take it for an oversight.
void open_bare_steps(Workbench& bench, const EdgeSides& o, WallRecord& wall) {
    const TextureSpec nothing{"-", {}, {}, {}};
    if (o.beyond.ceiling < o.here.ceiling && !wall.upper) {
        bench.report.note(o.has_two_skies() ? Kind::sky_step : Kind::missing_upper, o.edge.line);
        wall.upper = nothing;
    }
    if (o.beyond.floor > o.here.floor && !wall.lower) {
        bench.report.note(Kind::missing_lower, o.edge.line);
        wall.lower = nothing;
    }
}

void hang_textures(Workbench& bench, const EdgeSides& o, WallRecord& wall) {
    const std::uint16_t flags = bench.doom.lines[o.edge.line].flags;
    if (!o.has_two_skies()) wall.upper = texture_spec(bench, o.side.upper, o.side, o.edge.line);
    wall.lower = texture_spec(bench, o.side.lower, o.side, o.edge.line);
    wall.middle = texture_spec(bench, o.side.middle, o.side, o.edge.line);
    // Where nothing hangs the pegs stay as they are by default, so that maps stay small.
    if (wall.upper && flags & kUpperUnpegged) wall.upper_peg = Peg::ceiling;
    if (wall.lower && flags & kLowerUnpegged) wall.lower_peg = Peg::ceiling;
    if (wall.middle && flags & kLowerUnpegged) wall.middle_peg = Peg::opening_bottom;
    // Between two skies Doom hangs an unpegged step from the ceiling beyond; a map unit is a texel.
    if (wall.lower && wall.lower_peg == Peg::ceiling && o.has_two_skies())
        wall.lower->offset_tx.y += o.here.ceiling - o.beyond.ceiling;
}

void convert_portal(Workbench& bench, const Edge& edge, WallRecord& wall) {
    const EdgeSides opening = opening_of(bench, edge);
    wall.next = part_name(bench.parts.parts[bench.parts.part_of_edge[edge.opposite]]);
    hang_textures(bench, opening, wall);
    open_bare_steps(bench, opening, wall);
    wall.blocks = (bench.doom.lines[edge.line].flags & kBlocking) != 0;
    ++bench.report.portals;
    if (opening.edge.sector == bench.parts.edges[edge.opposite].sector && !edge.is_left)
        bench.report.note(Kind::self_portal, edge.line);
}

/// A picture without holes that is seen on the edge: a step's of a doorway, else the wall's; null: there is none.
const PictureFile* picture_on(const Workbench& bench, const Edge& edge) {
    if (edge.line == kNone) return nullptr;
    const Sidedef& side = bench.side_of(edge);
    const auto picture = [&](const std::string& name) {
        return bench.pictures.is_null_texture(name) ? nullptr : bench.pictures.wall(name);
    };
    if (!edge.is_open && !edge.was_open) return picture(side.middle);
    const PictureFile* lower = picture(side.lower);
    return lower ? lower : picture(side.upper);
}

/// What a doorway is closed with: its own steps' picture, else the first in the room, else the first in the level.
std::optional<TextureSpec> picture_for_doorway(const Workbench& bench, const Edge& edge) {
    const PictureFile* found = picture_on(bench, edge);
    const std::uint32_t part = bench.parts.part_of_edge[bench.parts.edges[edge.opposite].opposite];
    for (const Loop& loop : bench.parts.parts[part].loops)
        for (const std::uint32_t e : loop.edges)
            if (!found) found = picture_on(bench, bench.parts.edges[e]);
    for (const Edge& other : bench.parts.edges)
        if (!found) found = picture_on(bench, other);
    if (!found) return {};
    return TextureSpec{found->name, {}, {}, {}};
}

void convert_solid(Workbench& bench, const Edge& edge, WallRecord& wall) {
    const Sidedef& side = bench.side_of(edge);
    wall.texture = texture_spec(bench, side.middle, side, edge.line);
    if (!wall.texture && edge.was_open) wall.texture = picture_for_doorway(bench, edge);
    wall.texture_peg = bench.doom.lines[edge.line].flags & kLowerUnpegged ? Peg::floor : Peg::ceiling;
    if (wall.texture) return;
    wall.texture = TextureSpec{"-", {}, {}, {}};
    // Closed sectors behind the edge of the sky have such walls by the dozen, and nobody ever sees them.
    if (bench.heights[edge.sector].floor < bench.heights[edge.sector].ceiling)
        bench.report.note(Kind::missing_middle, edge.line);
}

/// Flags that the wall says in words of its own: whether it is solid or blocks, and what its pictures hang from.
constexpr std::uint16_t kFlagsInWords = kBlocking | kTwoSided | kUpperUnpegged | kLowerUnpegged;

/// What the line does, on the wall in front of it.
void give_effects(Workbench& bench, const Edge& edge, WallRecord& wall) {
    const Linedef& line = bench.doom.lines[edge.line];
    if (line.special != 0 && !edge.is_left) wall.triggers = bench.triggers.triggers_of(edge.line, edge.is_open);
    if (!edge.is_left) wall.scroll.x = metres(scroll_of(line.special) * kTicsPerSecond);
    wall.doom = left_over(bench, line, !wall.triggers.empty() || wall.scroll.x != 0, kFlagsInWords);
}

/// `keeper`: by line, the edge that keeps the line's record.
WallRecord convert_wall(Workbench& bench, std::uint32_t index, const std::vector<std::uint32_t>& keeper) {
    const Edge& edge = bench.parts.edges[index];
    WallRecord wall;
    ++bench.report.walls;
    if (edge.line == kNone) return wall;
    ++bench.report.sides.walls;
    if (edge.is_open)
        convert_portal(bench, edge, wall);
    else
        convert_solid(bench, edge, wall);
    if (keeper[edge.line] == index) give_effects(bench, edge, wall);
    return wall;
}

// Animations and switches that the converted map takes part in.

using Names = std::set<std::string, std::less<>>;

void add(const std::optional<TextureSpec>& spec, Names& names) {
    if (spec) names.insert(spec->name);
}

void add(const std::vector<TriggerRecord>& triggers, Names& names) {
    for (const TriggerRecord& trigger : triggers)
        if (!trigger.texture.empty()) names.insert(trigger.texture);
}

void add(const WallRecord& wall, Names& names) {
    for (const auto* spec : {&wall.texture, &wall.upper, &wall.lower, &wall.middle}) add(*spec, names);
    add(wall.triggers, names);
}

template <class Use>
void for_each_wall(const MapFile& file, const Use& use) {
    for (const SectorRecord& sector : file.sectors)
        for (const LoopRecord& loop : sector.loops)
            for (const WallRecord& wall : loop.walls) use(wall);
}

/// All pictures on walls, flats and panels, at some time.
Names pictures_of(const MapFile& file) {
    Names names;
    for_each_wall(file, [&](const WallRecord& wall) { add(wall, names); });
    for (const SectorRecord& sector : file.sectors) {
        add(sector.floor.texture, names);
        add(sector.ceiling.texture, names);
        for (const PanelRecord& panel : sector.panels) names.insert(panel.texture.name);
    }
    return names;
}

/// Those on walls that do something.
Names pictures_of_triggers(const MapFile& file) {
    Names names;
    for_each_wall(file, [&](const WallRecord& wall) {
        if (!wall.triggers.empty()) add(wall, names);
    });
    for (const SectorRecord& sector : file.sectors)
        for (const PanelRecord& panel : sector.panels) add(panel.triggers, names);
    return names;
}

}  // namespace

std::optional<TextureSpec> texture_spec(Workbench& bench, const std::string& name, const Sidedef& side,
                                        std::uint32_t line) {
    if (name == "-" || name.empty()) return {};
    if (bench.pictures.is_null_texture(name)) {
        bench.report.note(Kind::null_texture, line);
        return {};
    }
    const PictureFile* file = bench.pictures.wall(name);
    if (!file) {
        bench.report.note(Kind::unknown_texture, line);
        return {};
    }
    // Doom's offsets move into the picture, ours are subtracted; + 0.0 keeps a zero from turning negative.
    return TextureSpec{file->name, {}, {0.0 - side.x_offset, 0.0 - side.y_offset}, {}};
}

std::vector<std::uint32_t> first_walls(const DoomMap& doom, const Parts& parts) {
    std::vector<std::uint32_t> first(doom.lines.size(), kNone);
    for (std::uint32_t e = 0; e < parts.edges.size(); ++e)
        if (const std::uint32_t line = parts.edges[e].line;
            line != kNone && parts.part_of_edge[e] != kNone && first[line] == kNone)
            first[line] = e;
    return first;
}

std::optional<DoomRecord> left_over(Workbench& bench, const Linedef& line, bool has_words, std::uint16_t said) {
    DoomRecord record{has_words ? 0 : line.special, has_words ? 0 : line.tag, line.flags & ~said};
    if (record.special != 0) ++bench.report.lines_left[record.special];
    return record == DoomRecord{} ? std::nullopt : std::optional(record);
}

void convert_walls(Workbench& bench) {
    const std::vector<std::uint32_t> first = first_walls(bench.doom, bench.parts);
    for (std::size_t p = 0; p < bench.parts.parts.size(); ++p)
        for (const Loop& loop : bench.parts.parts[p].loops) {
            LoopRecord& record = bench.file.sectors[p].loops.emplace_back();
            record.name = &loop == &bench.parts.parts[p].loops[0] ? "border" : "hole";
            for (std::uint32_t e : loop.edges) {
                record.vertices.push_back(metres(bench.parts.edges[e].a));
                record.walls.push_back(convert_wall(bench, e, first));
            }
        }
}

void convert_picture_changes(Workbench& bench) {
    const Names seen = pictures_of(bench.file), on_triggers = pictures_of_triggers(bench.file);
    const auto is_seen = [&](const std::string& picture) { return seen.contains(picture); };
    for (const AnimationRecord& animation : bench.pictures.animations())
        if (std::ranges::any_of(animation.frames, is_seen)) bench.file.animations.push_back(animation);
    for (const SwitchRecord& pair : bench.pictures.switches())
        if (on_triggers.contains(pair.off) || on_triggers.contains(pair.on)) bench.file.switches.push_back(pair);
}

}  // namespace enfilade::wadconv
