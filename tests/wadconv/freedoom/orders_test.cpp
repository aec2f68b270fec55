// Every line of FreeDoom held against Doom's own rules once more: whether it works again, and what it does to what
// already moves.
#include <algorithm>
#include <cmath>
#include <set>

#include "wadconv/freedoom/levels.h"

namespace enfilade::test {
namespace {

using wadconv::Linedef;

using FreeDoomOrders = FreeDoomLevels;

TEST_P(FreeDoomOrders, WorkAsOftenAsInDoom) {
    if (is_missing(GetParam())) GTEST_SKIP() << kMissing;
    Counts compared;
    each_level([&](const ConvertedLevel& level) {
        for (const Linedef& line : level.doom.lines) {
            const TriggerRange triggers = level.range.triggers_of(line);
            const std::optional<bool> again = repeats(line.special);
            if (triggers.count == 0 || !again) continue;
            ++compared[line.special];
            for (std::uint32_t i = triggers.first; i < triggers.first + triggers.count; ++i)
                EXPECT_EQ(level.map.triggers[i].once, !*again) << level.name_of(line);
        }
    });
    print("repeats", compared);
}

using OrderedMover = std::pair<std::uint32_t, bool>;  ///< Doom's sector, and whether its ceiling

/// What is still on its way a tick after it was set off. Anything that moves for two tics or more is.
std::set<OrderedMover> busy_after(const ConvertedLevel& level, const std::vector<Motion>& motions) {
    std::set<OrderedMover> busy;
    for (const Motion& motion : motions) {
        const auto& sector = level.doom.sectors[motion.sector];
        const double start = motion.is_ceiling ? std::max(sector.ceiling, sector.floor) : sector.floor;
        double tics = 0, z = start;
        for (const MotionLeg& leg : motion.legs) {
            tics += std::abs(leg.height - z) / leg.speed + (&leg == &motion.legs.back() ? 0 : leg.wait);
            z = leg.height;
        }
        if (tics > 2 || motion.loops) busy.insert({motion.sector, motion.is_ceiling});
    }
    return busy;
}

/// What the second firing ordered.
std::set<OrderedMover> ordered_by(const ConvertedLevel& level, const Fired& fired) {
    std::set<OrderedMover> movers;
    for (std::size_t i = fired.first_change; i < fired.history.changes().size(); ++i) {
        const Change& change = fired.history.changes()[i];
        if (change.channel != Channel::light)
            movers.insert({doom_sector_of(level.map[change.sector]), change.channel == Channel::ceiling});
    }
    return movers;
}

/// Lines that may meet: by the sectors they move, one of each special and tag.
std::map<std::uint32_t, std::vector<const Linedef*>> movers_of(const ConvertedLevel& level) {
    std::map<std::uint32_t, std::vector<const Linedef*>> by_sector;
    std::set<std::pair<int, std::uint32_t>> seen;
    for (const Linedef& line : level.doom.lines)
        for (const Motion& motion : level.motions_of(line))
            if (seen.insert({line.special, motion.sector}).second) by_sector[motion.sector].push_back(&line);
    return by_sector;
}

/// Doom's sectors take one order for the floor and one for the ceiling at a time (Boom), but for doors that are pushed.
TEST_P(FreeDoomOrders, LeaveAloneWhatIsOnItsWay) {
    if (is_missing(GetParam())) GTEST_SKIP() << kMissing;
    Counts compared, turned;
    each_level([&](const ConvertedLevel& level) {
        for (const auto& [sector, lines] : movers_of(level))
            for (const Linedef* first : lines) {
                const History before = level.range.fire(*first).history;
                const std::set<OrderedMover> busy = busy_after(level, level.motions_of(*first));
                for (const Linedef* second : lines) {
                    const std::set<OrderedMover> ordered = ordered_by(level, level.range.fire(*second, before, 1));
                    if (turns_round(second->special)) {
                        const OrderedMover door{sector, true};
                        if (!busy.contains(door)) continue;
                        ++turned[first->special];
                        EXPECT_TRUE(ordered.contains(door)) << level.name_of(*second) << ", pushed a tick after "
                                                            << level.name_of(*first) << " has set it off";
                        continue;
                    }
                    ++compared[second->special];
                    for (const OrderedMover& mover : busy)
                        EXPECT_FALSE(ordered.contains(mover))
                            << level.name_of(*second) << ", a tick after " << level.name_of(*first) << ": "
                            << (mover.second ? "ceiling" : "floor") << " of sector " << mover.first;
                }
            }
    });
    print("fired at what moves", compared);
    print("pushed doors that turn round, while this moves them", turned);
}

TEST_P(FreeDoomOrders, TurnDoorsRoundThatArePushedAgain) {
    if (is_missing(GetParam())) GTEST_SKIP() << kMissing;
    Counts compared;
    each_level([&](const ConvertedLevel& level) {
        for (const Linedef& line : level.doom.lines) {
            if (!turns_round(line.special) || busy_after(level, level.motions_of(line)).empty()) continue;
            const std::uint32_t door = level.motions_of(line).front().sector;
            const History opening = level.range.fire(line).history;
            const Fired closing = level.range.fire(line, opening, 1);
            ASSERT_EQ(ordered_by(level, closing), (std::set<OrderedMover>{{door, true}})) << level.name_of(line);
            const Track& track = closing.history.changes().back().track;
            ++compared[line.special];
            EXPECT_EQ(track.count, 1) << level.name_of(line);
            EXPECT_EQ(track.stops[0].value * wadconv::kUnitsPerMetre, level.doom.sectors[door].floor)
                << level.name_of(line);
        }
    });
    print("doors pushed again", compared);
}

INSTANTIATE_TEST_SUITE_P(Wads, FreeDoomOrders, freedoom_wads(), name_of);

}  // namespace
}  // namespace enfilade::test
