// The lines of FreeDoom that change light or teleport, held against Doom's own rules.
#include <algorithm>
#include <cmath>

#include "space/trace.h"
#include "wadconv/freedoom/levels.h"

namespace enfilade::test {
namespace {

using wadconv::DoomMap;
using wadconv::DoomThing;
using wadconv::Linedef;

using FreeDoomLightsAndExits = FreeDoomLevels;

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
std::map<std::uint32_t, int> lights_of(const ConvertedLevel& level, const History& history) {
    constexpr double kLevels = 256;
    std::map<std::uint32_t, int> given;
    for (const Change& change : history.changes()) {
        if (change.channel != Channel::light) continue;
        const auto& effect = level.map[change.cause].effect;
        const double light = effect ? effect->dark : change.track.stops[0].value;
        given[doom_sector_of(level.map[change.sector])] = static_cast<int>(std::lround(light * kLevels));
    }
    return given;
}

bool can_be_passed(const DoomMap& doom, const Linedef& line) {
    return line.left < doom.sides.size() && (line.flags & wadconv::kTwoSided) != 0;
}

TEST_P(FreeDoomLightsAndExits, MakeDoomsLight) {
    if (is_missing(GetParam())) GTEST_SKIP() << kMissing;
    Counts compared;
    each_level([&](const ConvertedLevel& level) {
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
const DoomThing* exit_of(const ConvertedLevel& level, const Linedef& line) {
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

TEST_P(FreeDoomLightsAndExits, TeleportToWhereDoomDoes) {
    if (is_missing(GetParam())) GTEST_SKIP() << kMissing;
    Counts compared;
    each_level([&](const ConvertedLevel& level) {
        for (const Linedef& line : level.doom.lines) {
            if (!is_teleport(line.special) || !can_be_passed(level.doom, line)) continue;
            const DoomThing* exit = exit_of(level, line);
            const TriggerRange triggers = level.range.triggers_of(line);
            ++compared[line.special];
            ASSERT_EQ(triggers.count, exit ? 1u : 0u) << level.name_of(line);
            if (!exit) continue;
            const Trigger& trigger = level.map.triggers[triggers.first];
            ASSERT_EQ(trigger.action, TriggerAction::teleport) << level.name_of(line);
            EXPECT_TRUE(trigger.one_way) << level.name_of(line) << " works from its front only";
            EXPECT_EQ(level.map[trigger.destination].position, place_of(*exit)) << level.name_of(line);
            EXPECT_EQ(level.map[trigger.destination].yaw, Angle::from_degrees(-exit->angle / 45 * 45.0))
                << level.name_of(line);
        }
    });
    print("teleports", compared);
}

INSTANTIATE_TEST_SUITE_P(Wads, FreeDoomLightsAndExits, freedoom_wads(), name_of);

}  // namespace
}  // namespace enfilade::test
