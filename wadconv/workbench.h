// What the steps of one map's conversion hand on to each other. Private to the converter.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "formats/map_file.h"
#include "wadconv/map_lumps.h"
#include "wadconv/neighbours.h"
#include "wadconv/parts.h"
#include "wadconv/pictures.h"
#include "wadconv/report.h"
#include "wadconv/sounds.h"
#include "wadconv/triggers.h"

namespace enfilade::wadconv {

/// A sector's heights as converted [map units].
struct DoomHeights {
    std::int32_t floor = 0;
    std::int32_t ceiling = 0;  ///< >= floor
};

/// The map on its way. file.sectors[i] is parts.parts[i].
struct Workbench {
    const DoomMap& doom;
    const Pictures& pictures;
    const Sounds& sounds;
    const Parts& parts;
    const Neighbours& neighbours;
    const TriggerMaker& triggers;
    std::vector<DoomHeights> heights;  ///< by Doom sector
    Report& report;
    MapFile& file;

    const Sidedef& side_of(const Edge& edge) const { return doom.sides[edge.side]; }
    const DoomHeights& heights_of(const Part& part) const { return heights[part.sector]; }
};

/// [m] from map units.
constexpr double metres(double units) { return units / kUnitsPerMetre; }
constexpr Vec2 metres(Point p) { return {p.x / kUnitsPerMetre, p.y / kUnitsPerMetre}; }

inline Point point_of(const DoomThing& thing) { return {thing.x, -std::int32_t{thing.y}}; }

bool is_sky(std::string_view flat);

/// heights.cpp: ceilings below floors raised, doors opened if asked.
std::vector<DoomHeights> settle_heights(const DoomMap& doom, const Parts& parts, bool open_doors, Report& report);

/// convert_sectors.cpp: names, floors, ceilings and light of file.sectors.
void convert_sectors(Workbench& bench);

/// convert_walls.cpp: the loops of file.sectors.
void convert_walls(Workbench& bench);

/// The texture of a side with its offset [texels], or nothing for "-", Doom's "no texture" and unknown names.
std::optional<TextureSpec> texture_spec(Workbench& bench, const std::string& name, const Sidedef& side,
                                        std::uint32_t line);

/// By line: the lowest of its edges that bounds a part, which is the right side's if that does; or kNone.
std::vector<std::uint32_t> first_walls(const DoomMap& doom, const Parts& parts);

/// What is left of a line: the special with its tag, unless it became words, and the flags beyond those in `said`;
/// nothing where nothing is. Counts specials that are left.
std::optional<DoomRecord> left_over(Workbench& bench, const Linedef& line, bool has_words, std::uint16_t said);

/// convert_panels.cpp: lines that bound no part but show a picture or mean something.
void convert_panels(Workbench& bench);

/// The number of the sector that each thing to teleport to stands in, by thing; kNone for other things, for those
/// outside, and for all but the first of a sector.
std::vector<std::uint32_t> exits_of(const DoomMap& doom, const Parts& parts);

/// Adds the animations and switches that the map's pictures take part in.
void convert_picture_changes(Workbench& bench);

/// Adds the sounds of what moves, is switched and is picked up, as far as the archives have them.
void convert_sounds(Workbench& bench);

/// convert_things.cpp: things and the player's start.
void convert_things(Workbench& bench);

}  // namespace enfilade::wadconv
