// The heights a map starts with: sound ones, and with open doors if asked.
#include <algorithm>
#include <array>
#include <limits>

#include "wadconv/workbench.h"

namespace enfilade::wadconv {
namespace {

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

}  // namespace

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

}  // namespace enfilade::wadconv
