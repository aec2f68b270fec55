// Every line of FreeDoom that moves floors or ceilings, fired in the converted map and held against Doom's own rules:
// who moves, how far, how fast, and how long it waits.
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "map/load.h"
#include "wadconv/convert.h"
#include "wadconv/freedoom/doom_rules.h"
#include "wadconv/freedoom/firing_range.h"
#include "wadconv/freedoom/wads.h"
#include "world/input.h"

namespace enfilade::test {
namespace {

using wadconv::DoomMap;
using wadconv::Linedef;

constexpr double kUnits = wadconv::kUnitsPerMetre, kTics = 35;

std::string text_of(const std::vector<MotionLeg>& legs, bool loops) {
    std::string text;
    char number[80];
    for (const MotionLeg& leg : legs) {
        std::snprintf(number, sizeof number, " %.6g at %.6g for %.6g", leg.height, leg.speed, leg.wait);
        text += number;
    }
    return text + (loops ? " over and over" : "");
}

/// A track in Doom's measures. Waits are whole ticks here: the tics next to them. The last wait of what comes to rest
/// means nothing.
Motion motion_of(const Change& change, std::uint32_t sector) {
    const Track& track = change.track;
    Motion motion{sector, change.channel == Channel::ceiling, {}, track.loops};
    for (std::uint8_t i = 0; i < track.count; ++i) {
        const Stop& stop = track.stops[i];
        const bool waits = track.loops || i + 1 < track.count;
        motion.legs.push_back({stop.value * kUnits, stop.per_tick * kUnits * kTickRate / kTics,
                               waits ? std::round(stop.wait * kTics / kTickRate) : 0});
    }
    return motion;
}

using Mover = std::pair<std::uint32_t, bool>;  ///< Doom's sector, and whether its ceiling

std::map<Mover, std::string> expected_of(const std::vector<Motion>& motions) {
    std::map<Mover, std::string> expected;
    for (const Motion& motion : motions)
        expected.emplace(Mover{motion.sector, motion.is_ceiling}, text_of(motion.legs, motion.loops));
    return expected;
}

/// What each part does; where parts of one sector do different things, both are said.
std::map<Mover, std::string> found_of(const Map& map, const History& history) {
    std::map<Mover, std::set<std::string>> all;
    std::map<std::uint32_t, std::size_t> parts, moved;
    for (const Sector& part : map.sectors) ++parts[doom_sector_of(part)];
    for (const Change& change : history.changes()) {
        if (change.channel == Channel::light) continue;
        const std::uint32_t sector = doom_sector_of(map[change.sector]);
        const Motion motion = motion_of(change, sector);
        each_of_group(map, change.sector, [&](SectorId) { ++moved[sector]; });
        all[{sector, motion.is_ceiling}].insert(text_of(motion.legs, motion.loops));
    }
    std::map<Mover, std::string> found;
    for (const auto& [mover, texts] : all) {
        for (const std::string& text : texts) found[mover] += text;
        if (moved[mover.first] != parts[mover.first]) found[mover] += " (not all parts)";
    }
    return found;
}

/// Counts for one special.
struct Row {
    std::size_t lines = 0, targets = 0, differences = 0;

    void operator+=(const Row& more) {
        lines += more.lines;
        targets += more.targets;
        differences += more.differences;
    }
};

std::string said(const std::map<Mover, std::string>& all, const Mover& mover) {
    const auto found = all.find(mover);
    return found == all.end() ? " nothing" : found->second;
}

/// Targets that move in one of the two, and those that do not move alike.
Row compared(const std::map<Mover, std::string>& expected, const std::map<Mover, std::string>& found,
             const std::string& where) {
    std::set<Mover> movers;
    for (const auto* all : {&expected, &found})
        for (const auto& [mover, text] : *all) movers.insert(mover);
    Row row{1, movers.size(), 0};
    for (const Mover& mover : movers) {
        const std::string doom = said(expected, mover), ours = said(found, mover);
        row.differences += doom != ours;
        EXPECT_EQ(ours, doom) << where << ": " << (mover.second ? "ceiling" : "floor") << " of sector " << mover.first;
    }
    return row;
}

class FreeDoomLines : public ::testing::TestWithParam<FreeDoomWad> {
protected:
    void compare(const DoomMap& doom, const Map& map, const TextureHeight& height_of) {
        const FiringRange range(doom, map);
        for (std::size_t i = 0; i < doom.lines.size(); ++i) {
            const Linedef& line = doom.lines[i];
            const std::map<Mover, std::string> found = found_of(map, range.fire(line).history);
            const std::optional<DoomSpecial> special = special_of(line.special);
            const std::string where =
                doom.name + " line " + std::to_string(i) + ", special " + std::to_string(line.special);
            EXPECT_TRUE(special || found.empty()) << where << " moves something, and no rule says what";
            if (!special) continue;
            const std::vector<Motion> motions = motions_of(doom, line, *special, height_of);
            rows_[line.special] += compared(expected_of(motions), found, where);
        }
    }

    std::map<int, Row> rows_;
};

// hard case W13
TEST_P(FreeDoomLines, MoveWhatDoomMovesAndAsFar) {
    if (is_missing(GetParam())) GTEST_SKIP() << kMissing;
    const ReadWad wad(GetParam());
    const TextureHeight height_of = [&](const std::string& texture) {
        const wadconv::PictureFile* file = wad.pictures.wall(texture);
        return file ? static_cast<double>(file->height) : 0;
    };
    for (const DoomMap& doom : wad.maps) {
        const wadconv::Conversion conversion = wadconv::convert_map(doom, wad.pictures, wad.sounds, {});
        Findings findings;
        const std::optional<Map> map = build_map(conversion.file.value(), wad.pictures.sizes(), findings);
        ASSERT_TRUE(map) << doom.name;
        compare(doom, *map, height_of);
    }
    for (const auto& [special, row] : rows_)
        std::printf("special %3d: %4zu lines, %4zu targets, %zu different\n", special, row.lines, row.targets,
                    row.differences);
}

INSTANTIATE_TEST_SUITE_P(Wads, FreeDoomLines, freedoom_wads(), name_of);

}  // namespace
}  // namespace enfilade::test
