#include "wadconv/convert.h"

#include <algorithm>

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

}  // namespace enfilade::wadconv
