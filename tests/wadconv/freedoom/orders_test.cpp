// Every line of FreeDoom held against Doom's own rules once more: whether it works again, what it does to what already
// moves, what light it makes, and where it sends who crosses it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <set>

#include "map/build.h"
#include "space/locate.h"
#include "wadconv/convert.h"
#include "wadconv/freedoom/doom_rules.h"
#include "wadconv/freedoom/firing_range.h"
#include "wadconv/freedoom/wads.h"

namespace enfilade::test {
namespace {

using wadconv::DoomMap;
using wadconv::DoomThing;
using wadconv::Linedef;

/// One level of the archive, as it was and as it became.
struct Level {
    const DoomMap& doom;
    const Map& map;
    const TextureHeight& height_of;
    FiringRange range;

    std::string name_of(const Linedef& line) const {
        return doom.name + " line " + std::to_string(&line - doom.lines.data()) + ", special " +
               std::to_string(line.special);
    }
    std::vector<Motion> motions_of(const Linedef& line) const {
        const auto special = special_of(line.special);
        return special ? test::motions_of(doom, line, *special, height_of) : std::vector<Motion>{};
    }
};

/// How many were compared, by special.
using Counts = std::map<int, std::size_t>;

void print(const char* what, const Counts& counts) {
    std::size_t sum = 0;
    std::printf("%s:", what);
    for (const auto& [special, count] : counts) {
        std::printf(" %dx%zu", special, count);
        sum += count;
    }
    std::printf("; %zu in all\n", sum);
}

class FreeDoomOrders : public ::testing::TestWithParam<FreeDoomWad> {
protected:
    void each_level(const std::function<void(const Level&)>& visit) {
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
            visit({doom, *map, height_of, FiringRange(doom, *map)});
        }
    }
};

TEST_P(FreeDoomOrders, WorkAsOftenAsInDoom) {
    if (is_missing(GetParam())) GTEST_SKIP() << kMissing;
    Counts compared;
    each_level([&](const Level& level) {
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

using Mover = std::pair<std::uint32_t, bool>;  ///< Doom's sector, and whether its ceiling

/// What is still on its way a tick after it was set off. Anything that moves for two tics or more is.
std::set<Mover> busy_after(const Level& level, const std::vector<Motion>& motions) {
    std::set<Mover> busy;
    for (const Motion& motion : motions) {
        const auto& sector = level.doom.sectors[motion.sector];
        const double start = motion.is_ceiling ? std::max(sector.ceiling, sector.floor) : sector.floor;
        double tics = 0, z = start;
        for (const Leg& leg : motion.legs) {
            tics += std::abs(leg.height - z) / leg.speed + (&leg == &motion.legs.back() ? 0 : leg.wait);
            z = leg.height;
        }
        if (tics > 2 || motion.loops) busy.insert({motion.sector, motion.is_ceiling});
    }
    return busy;
}

/// What the second firing ordered.
std::set<Mover> ordered_by(const Level& level, const Fired& fired) {
    std::set<Mover> movers;
    for (std::size_t i = fired.first_change; i < fired.history.changes().size(); ++i) {
        const Change& change = fired.history.changes()[i];
        if (change.channel != Channel::light)
            movers.insert({doom_sector_of(level.map[change.sector]), change.channel == Channel::ceiling});
    }
    return movers;
}

/// Lines that may meet: by the sectors they move, one of each special and tag.
std::map<std::uint32_t, std::vector<const Linedef*>> movers_of(const Level& level) {
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
    Counts compared, not_turned;
    each_level([&](const Level& level) {
        for (const auto& [sector, lines] : movers_of(level))
            for (const Linedef* first : lines) {
                const History before = level.range.fire(*first).history;
                const std::set<Mover> busy = busy_after(level, level.motions_of(*first));
                for (const Linedef* second : lines) {
                    const std::set<Mover> ordered = ordered_by(level, level.range.fire(*second, before, 1));
                    if (turns_round(second->special)) {
                        // Doom turns such a door round whatever moves it; ours only where that is a door's own course,
                        // and not where a line opens or closes it for good.
                        const Mover door{sector, true};
                        if (busy.contains(door) && !ordered.contains(door)) ++not_turned[first->special];
                        continue;
                    }
                    ++compared[second->special];
                    for (const Mover& mover : busy)
                        EXPECT_FALSE(ordered.contains(mover))
                            << level.name_of(*second) << ", a tick after " << level.name_of(*first) << ": "
                            << (mover.second ? "ceiling" : "floor") << " of sector " << mover.first;
                }
            }
    });
    print("fired at what moves", compared);
    print("pushed doors that do not turn round, while this moves them", not_turned);
}

TEST_P(FreeDoomOrders, TurnDoorsRoundThatArePushedAgain) {
    if (is_missing(GetParam())) GTEST_SKIP() << kMissing;
    Counts compared;
    each_level([&](const Level& level) {
        for (const Linedef& line : level.doom.lines) {
            if (!turns_round(line.special) || busy_after(level, level.motions_of(line)).empty()) continue;
            const std::uint32_t door = level.motions_of(line).front().sector;
            const History opening = level.range.fire(line).history;
            const Fired closing = level.range.fire(line, opening, 1);
            ASSERT_EQ(ordered_by(level, closing), (std::set<Mover>{{door, true}})) << level.name_of(line);
            const Course& course = closing.history.changes().back().course;
            ++compared[line.special];
            EXPECT_EQ(course.count, 1) << level.name_of(line);
            EXPECT_EQ(course.stops[0].value * wadconv::kUnitsPerMetre, level.doom.sectors[door].floor)
                << level.name_of(line);
        }
    });
    print("doors pushed again", compared);
}

/// Doom's levels of light, sector by sector, as one after the other is changed.
class Lights {
public:
    explicit Lights(const DoomMap& doom) : doom_(doom) {
        for (const wadconv::DoomSector& sector : doom.sectors) now_.push_back(sector.light);
    }

    /// By sector what the line gives to those with its tag; a flash: the darkest around.
    std::map<std::uint32_t, int> give(const Linedef& line, const DoomLight& light) {
        std::map<std::uint32_t, int> given;
        for (std::uint32_t s = 0; s < now_.size() && line.tag != 0; ++s)
            if (doom_.sectors[s].tag == line.tag) given[s] = now_[s] = level(s, light);
        return given;
    }

private:
    int level(std::uint32_t sector, const DoomLight& light) const {
        if (light.rule == LightRule::to_level) return static_cast<int>(light.amount);
        int brightest = 0, darkest = now_[sector];
        for (const Linedef& line : doom_.lines) {
            if (!(line.flags & wadconv::kTwoSided) || line.left >= doom_.sides.size()) continue;
            const std::uint16_t front = doom_.sides[line.right].sector, back = doom_.sides[line.left].sector;
            if (front == back || (front != sector && back != sector)) continue;
            const int beside = now_[front == sector ? back : front];
            brightest = std::max(brightest, beside);
            darkest = std::min(darkest, beside);
        }
        return light.rule == LightRule::brightest ? brightest : darkest;
    }

    const DoomMap& doom_;
    std::vector<int> now_;
};

/// What the changes of light give: the level, or where it flashes its darker one.
std::map<std::uint32_t, int> lights_of(const Level& level, const History& history) {
    constexpr double kLevels = 256;
    std::map<std::uint32_t, int> given;
    for (const Change& change : history.changes()) {
        if (change.channel != Channel::light) continue;
        const auto& effect = level.map[change.cause].effect;
        const double light = effect ? effect->dark : change.course.stops[0].value;
        given[doom_sector_of(level.map[change.sector])] = static_cast<int>(std::lround(light * kLevels));
    }
    return given;
}

bool can_be_passed(const DoomMap& doom, const Linedef& line) {
    return line.left < doom.sides.size() && (line.flags & wadconv::kTwoSided) != 0;
}

TEST_P(FreeDoomOrders, MakeDoomsLight) {
    if (is_missing(GetParam())) GTEST_SKIP() << kMissing;
    Counts compared;
    each_level([&](const Level& level) {
        for (const Linedef& line : level.doom.lines) {
            const std::optional<DoomLight> light = light_of(line.special);
            const std::map<std::uint32_t, int> found = lights_of(level, level.range.fire(line).history);
            if (!light || !can_be_passed(level.doom, line)) continue;
            ++compared[line.special];
            EXPECT_EQ(found, Lights(level.doom).give(line, *light)) << level.name_of(line);
        }
    });
    print("lights", compared);
}

Vec2 place_of(const DoomThing& thing) {
    return {thing.x / wadconv::kUnitsPerMetre, 0 - thing.y / wadconv::kUnitsPerMetre};
}

/// The first thing to teleport to in the first sector with the line's tag that has one (EV_Teleport).
const DoomThing* exit_of(const Level& level, const Linedef& line) {
    constexpr int kTeleportMan = 14;
    for (std::uint32_t s = 0; s < level.doom.sectors.size() && line.tag != 0; ++s) {
        if (level.doom.sectors[s].tag != line.tag) continue;
        for (const DoomThing& thing : level.doom.things) {
            if (thing.type != kTeleportMan) continue;
            const SectorId part = locate(level.map, place_of(thing));
            if (part && doom_sector_of(level.map[part]) == s) return &thing;
        }
    }
    return nullptr;
}

TEST_P(FreeDoomOrders, TeleportToWhereDoomDoes) {
    if (is_missing(GetParam())) GTEST_SKIP() << kMissing;
    Counts compared;
    each_level([&](const Level& level) {
        for (const Linedef& line : level.doom.lines) {
            if (!is_teleport(line.special) || !can_be_passed(level.doom, line)) continue;
            const DoomThing* exit = exit_of(level, line);
            const TriggerRange triggers = level.range.triggers_of(line);
            ++compared[line.special];
            ASSERT_EQ(triggers.count, exit ? 1u : 0u) << level.name_of(line);
            if (!exit) continue;
            const Trigger& trigger = level.map.triggers[triggers.first];
            ASSERT_EQ(trigger.deed, Deed::teleport) << level.name_of(line);
            EXPECT_TRUE(trigger.one_way) << level.name_of(line) << " works from its front only";
            EXPECT_EQ(level.map[trigger.destination].position, place_of(*exit)) << level.name_of(line);
            EXPECT_EQ(level.map[trigger.destination].yaw, Angle::from_degrees(-exit->angle / 45 * 45.0))
                << level.name_of(line);
        }
    });
    print("teleports", compared);
}

INSTANTIATE_TEST_SUITE_P(Wads, FreeDoomOrders, freedoom_wads(), name_of);

}  // namespace
}  // namespace enfilade::test
