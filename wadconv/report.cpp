#include "wadconv/report.h"

#include <algorithm>
#include <array>

#include "base/result.h"
#include "formats/text_parts.h"

namespace enfilade::wadconv {
namespace {

constexpr std::array kFacts = {
    KindFacts{Kind::zero_length_line, Fate::dropped, "lines without length", "line", "They bound nothing: left out."},
    KindFacts{Kind::bad_vertex, Fate::guessed, "lines with a vertex that is not there", "line", "Left out."},
    KindFacts{Kind::bad_side, Fate::guessed, "side numbers that lead nowhere", "line", "They count as no side."},
    KindFacts{Kind::bad_sector, Fate::guessed, "sides with a sector that is not there", "line",
              "They count as no side."},
    KindFacts{Kind::left_side_only, Fate::repaired, "lines with a left side only", "line",
              "A solid wall of the sector on the left."},
    KindFacts{Kind::no_side, Fate::dropped, "lines without any side", "line", "They bound nothing: left out."},
    KindFacts{Kind::two_sides_unmarked, Fate::converted, "lines with two sides but not marked two-sided", "line",
              "A solid wall on either side, as in Doom."},
    KindFacts{Kind::one_side_marked_two, Fate::repaired, "lines marked two-sided with one side", "line",
              "A solid wall."},
    KindFacts{Kind::doubled_line, Fate::repaired, "sides of lines drawn twice", "line",
              "Facing sides of one sector cancel; of sides that look the same way the first stays."},
    KindFacts{Kind::self_portal, Fate::converted, "lines with one sector on both sides that part it", "line",
              "The parts become sectors of their own with a portal between them."},
    KindFacts{Kind::self_panel, Fate::converted, "lines with one sector on both sides that stand in it", "line",
              "Their picture becomes a panel."},
    KindFacts{Kind::self_unseen, Fate::converted, "the same without a picture", "line",
              "A panel without texture, which blocks and does what the line does."},
    KindFacts{Kind::deep_water, Fate::repaired, "lines of a ring with one sector on both sides, inside another", "line",
              "The outside belongs to the sector around the ring (\"deep water\")."},
    KindFacts{Kind::clashing_line, Fate::guessed, "lines of one room that cross or lie on each other", "line",
              "Their room is left out."},
    KindFacts{Kind::closed_doorway, Fate::guessed, "doorways into rooms left out", "line", "A solid wall."},
    KindFacts{Kind::shared_side, Fate::converted, "sides used by several lines", "side", "Each line gets its own."},
    KindFacts{Kind::missing_upper, Fate::converted, "steps down from the ceiling without texture", "line",
              "Open: the neighbour's ceiling goes on."},
    KindFacts{Kind::missing_lower, Fate::converted, "steps up from the floor without texture", "line",
              "Open: the neighbour's floor goes on."},
    KindFacts{Kind::missing_middle, Fate::guessed, "solid walls without texture", "line", "A placeholder is drawn."},
    KindFacts{Kind::sky_step, Fate::converted, "steps between two skies", "line", "Open: the sky is seen."},
    KindFacts{Kind::unknown_texture, Fate::guessed, "texture names that TEXTURE1 and TEXTURE2 lack", "line",
              "They count as no texture."},
    KindFacts{Kind::null_texture, Fate::converted, "uses of the first texture of TEXTURE1", "line",
              "Doom draws nothing for it, and so do we."},
    KindFacts{Kind::unknown_flat, Fate::guessed, "flats that are not there", "sector", "A placeholder is drawn."},
    KindFacts{Kind::split_sector, Fate::converted, "sectors of several parts", "sector",
              "Each part becomes a sector with the same light, heights, special and tag."},
    KindFacts{Kind::unused_sector, Fate::dropped, "sectors without lines", "sector", "They are nowhere: left out."},
    KindFacts{Kind::closed_gap, Fate::guessed, "sectors that lack one line", "sector",
              "Closed by a solid wall without texture."},
    KindFacts{Kind::lost_room, Fate::guessed, "rooms bounded by lines that cross", "sector",
              "Left out, with all that stands in them."},
    KindFacts{Kind::closed_door, Fate::converted, "sectors with the ceiling on the floor", "sector",
              "Kept: closed doors and the like."},
    KindFacts{Kind::opened_door, Fate::converted, "doors opened as asked", "sector",
              "The ceiling goes 4 units below the lowest around."},
    KindFacts{Kind::ceiling_below_floor, Fate::guessed, "sectors with the ceiling below the floor", "sector",
              "The ceiling is raised to the floor."},
    KindFacts{Kind::light_out_of_range, Fate::repaired, "lights outside 0 to 255", "sector", "Brought into range."},
    KindFacts{Kind::closed_trigger, Fate::dropped, "lines to be crossed or pushed that nobody can pass", "line",
              "They do nothing."},
    KindFacts{Kind::aimless_trigger, Fate::dropped, "lines that act on a tag that no sector has", "line",
              "They do nothing."},
    KindFacts{Kind::shot_trigger, Fate::repaired, "lines to be shot at", "line", "They are used instead."},
    KindFacts{Kind::unknown_thing, Fate::dropped, "things of unknown type", "thing", "Left out."},
    KindFacts{Kind::thing_outside, Fate::dropped, "things outside all sectors", "thing", "Left out."},
    KindFacts{Kind::missing_sprite, Fate::guessed, "things whose sprite the WAD lacks", "thing",
              "Kept without a picture."},
    KindFacts{Kind::no_start, Fate::guessed, "maps without a start for player 1", "thing",
              "The first deathmatch or co-operative start; without one nobody can start."},
    KindFacts{Kind::trailing_bytes, Fate::dropped, "bytes behind the last whole record", "byte", "Not read."},
};

std::string_view word_for(Fate fate) {
    switch (fate) {
        case Fate::converted: return "converted";
        case Fate::repaired: return "repaired";
        case Fate::guessed: return "guessed";
        case Fate::dropped: return "dropped";
    }
    return "";
}

constexpr std::array kFates = {Fate::converted, Fate::repaired, Fate::guessed, Fate::dropped};

/// Line width of lists of numbers [characters].
constexpr std::size_t kWrap = 110;

/// "      lines 3, 17, 18 …", wrapped.
std::string numbers_text(std::string_view what, std::vector<std::uint32_t> numbers) {
    std::ranges::sort(numbers);
    numbers.erase(std::ranges::unique(numbers).begin(), numbers.end());
    std::string text, line = "      " + std::string(what) + (numbers.size() == 1 ? "" : "s");
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::string word = " " + std::to_string(numbers[i]) + (i + 1 < numbers.size() ? "," : "");
        if (line.size() + word.size() > kWrap) {
            text += line + "\n";
            line = "       ";
        }
        line += word;
    }
    return text + line + "\n";
}

/// "    name: 12. Rule." for every kind of that fate that was found.
std::string kinds_text(const std::map<Kind, std::vector<std::uint32_t>>& found, Fate fate, bool with_numbers) {
    std::string text;
    for (const auto& [kind, numbers] : found) {
        const KindFacts& facts = facts_of(kind);
        if (facts.fate != fate) continue;
        text += "    " + std::string(facts.name) + ": " + std::to_string(numbers.size()) + ". " +
                std::string(facts.rule) + "\n";
        if (with_numbers) text += numbers_text(facts.numbers, numbers);
    }
    return text.empty() ? text : "  " + std::string(word_for(fate)) + "\n" + text;
}

std::string counts_text(std::string_view what, const std::map<int, std::size_t>& counts) {
    if (counts.empty()) return "";
    std::string text = "  " + std::string(what) + " (number x times):";
    for (const auto& [number, times] : counts) text += " " + std::to_string(number) + "x" + std::to_string(times);
    return text + "\n";
}

std::string sides_text(const SideCount& sides) {
    return "  " + counted(sides.referred, "side") + " = " + counted(sides.walls, "wall") + " + " +
           std::to_string(sides.panels) + " on panels + " + std::to_string(sides.doubled) + " drawn twice + " +
           std::to_string(sides.dropped) + " dropped\n";
}

std::string sums_text(const Report& r) {
    return "  " + counted(r.lines, "line") + ", " + counted(r.sectors, "sector") + ", " + counted(r.things, "thing") +
           " -> " + counted(r.parts, "sector") + ", " + counted(r.walls, "wall") + " (" + counted(r.portals, "portal") +
           "), " + counted(r.panels, "panel") + ", " + counted(r.placed_things, "thing") + "\n";
}

std::string body_text(const Report& report, bool with_numbers) {
    std::string text = sums_text(report) + sides_text(report.sides);
    for (Fate fate : kFates) text += kinds_text(report.found, fate, with_numbers);
    return text + counts_text("line specials", report.line_specials) +
           counts_text("sector specials", report.sector_specials) +
           counts_text("line specials left over", report.lines_left) +
           counts_text("sector specials left over", report.sectors_left);
}

template <class Key, class Value, class Add>
void merge(std::map<Key, Value>& into, const std::map<Key, Value>& from, const Add& add) {
    for (const auto& [key, value] : from) add(into[key], value);
}

void add(Report& total, const Report& r) {
    const auto append = [](auto& into, const auto& from) { into.insert(into.end(), from.begin(), from.end()); };
    const auto sum = [](std::size_t& into, std::size_t from) { into += from; };
    merge(total.found, r.found, append);
    merge(total.line_specials, r.line_specials, sum);
    merge(total.sector_specials, r.sector_specials, sum);
    merge(total.thing_types, r.thing_types, sum);
    merge(total.lines_left, r.lines_left, sum);
    merge(total.sectors_left, r.sectors_left, sum);
    for (auto field :
         {&SideCount::referred, &SideCount::walls, &SideCount::panels, &SideCount::doubled, &SideCount::dropped})
        total.sides.*field += r.sides.*field;
    for (auto field : {&Report::lines, &Report::sectors, &Report::things, &Report::parts, &Report::walls,
                       &Report::portals, &Report::panels, &Report::placed_things})
        total.*field += r.*field;
}

}  // namespace

const KindFacts& facts_of(Kind kind) {
    const auto found = std::ranges::find(kFacts, kind, &KindFacts::kind);
    ENFILADE_CHECK(found != kFacts.end());
    return *found;
}

std::size_t Report::count(Fate fate) const {
    std::size_t count = 0;
    for (const auto& [kind, numbers] : found)
        if (facts_of(kind).fate == fate) count += numbers.size();
    return count;
}

std::string to_text(const Report& report) {
    if (!report.refused.empty()) return report.map + ": refused: " + report.refused + "\n";
    return report.map + "\n" + body_text(report, true);
}

std::string totals_text(const std::vector<Report>& reports) {
    Report total;
    std::size_t refused = 0;
    for (const Report& report : reports) {
        if (report.refused.empty())
            add(total, report);
        else
            ++refused;
    }
    return "Total: " + counted(reports.size() - refused, "map") + " converted, " + std::to_string(refused) +
           " refused\n" + body_text(total, false);
}

}  // namespace enfilade::wadconv
