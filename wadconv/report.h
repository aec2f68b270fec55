// What became of a map: every oddity by kind, with the numbers of the lines, sides, sectors or things that had it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace enfilade::wadconv {

/// How sure a conversion is: `guessed` is what --strict refuses.
enum class Fate : std::uint8_t { converted, repaired, guessed, dropped };

/// Everything the converter has a written rule for. The rules are in report.cpp, one sentence each.
enum class Kind : std::uint8_t {
    // Lines
    zero_length_line,
    bad_vertex,
    bad_side,
    bad_sector,
    left_side_only,
    no_side,
    two_sides_unmarked,
    one_side_marked_two,
    doubled_line,
    self_portal,
    self_panel,
    self_unseen,
    deep_water,
    clashing_line,
    closed_doorway,
    shared_side,
    // Textures
    missing_upper,
    missing_lower,
    missing_middle,
    sky_step,
    unknown_texture,
    null_texture,
    unknown_flat,
    // Sectors
    split_sector,
    unused_sector,
    closed_gap,
    lost_room,
    closed_door,
    opened_door,
    ceiling_below_floor,
    light_out_of_range,
    // What lines do
    closed_trigger,
    aimless_trigger,
    shot_trigger,
    // Things and the rest
    unknown_thing,
    thing_outside,
    missing_sprite,
    no_start,
    trailing_bytes,
};

/// What a kind is called, what becomes of it, and what its numbers count.
struct KindFacts {
    Kind kind;
    Fate fate;
    std::string_view name;
    std::string_view numbers;  ///< "line", "side", "sector", "thing" or "byte"
    std::string_view rule;     ///< one sentence
};

const KindFacts& facts_of(Kind kind);

/// What became of the sides that the lines refer to. Every one is counted exactly once.
struct SideCount {
    std::size_t referred = 0;  ///< sides that lines refer to, existing or not
    std::size_t walls = 0;     ///< became a wall of a sector
    std::size_t panels = 0;    ///< became a panel inside a sector, textured or not
    std::size_t doubled = 0;   ///< cancelled or hidden by another line with the same ends
    std::size_t dropped = 0;   ///< of lines without length or with numbers that lead nowhere

    bool is_complete() const { return referred == walls + panels + doubled + dropped; }
};

/// The findings about one map.
struct Report {
    std::string map;
    std::string refused;                               ///< why there is no converted map; empty: there is one
    std::map<Kind, std::vector<std::uint32_t>> found;  ///< numbers as they came, not sorted
    std::map<int, std::size_t> line_specials, sector_specials, thing_types;  ///< how many of each number, 0 left out
    std::map<int, std::size_t> lines_left, sectors_left;  ///< of the specials: those that became no words of the map
    SideCount sides;
    std::size_t lines = 0, sectors = 0, things = 0;             ///< in the WAD
    std::size_t parts = 0, walls = 0, portals = 0, panels = 0;  ///< in the map
    std::size_t placed_things = 0;

    void note(Kind kind, std::size_t number) { found[kind].push_back(static_cast<std::uint32_t>(number)); }
    std::size_t count(Fate fate) const;
};

/// All of it, for a person: a few lines for a map without oddities, numbers in rising order.
std::string to_text(const Report& report);

/// The sums of several maps' reports, kinds without numbers' lists.
std::string totals_text(const std::vector<Report>& reports);

}  // namespace enfilade::wadconv
