// What has happened, asked for by what is seen of it: as a look at everything that ever happened would find, without
// one.
#include "world/history.h"

#include <gtest/gtest.h>

#include <set>

#include "base/hash.h"
#include "support/map_builder.h"
#include "world/input.h"
#include "world/snapshot.h"

namespace enfilade {
namespace {

using namespace test;

/// A room whose triggers do nothing that matters here.
Map room_with_triggers(Random& random) {
    Map map = built(map_of({box_room("room", 0, 0, 8, 8, 0, 4)}));
    map.triggers.resize(6);
    for (Trigger& trigger : map.triggers) {
        trigger.once = random.below(2) == 0;
        trigger.heals = random.below(3) == 0;
        if (random.below(3) == 0) trigger.texture = TextureId(random.below(5));
    }
    return map;
}

/// As the present moment is found by asking all that ever happened.
struct Asked {
    std::set<std::uint32_t> pressed, taken;

    Asked(const Map& map, const History& history, double tick) {
        for (const Firing& firing : history.firings()) {
            const bool stays = map[firing.trigger].once;
            const bool lasts = tick < static_cast<double>(firing.tick) + kSwitchSeconds * kTickRate;
            if (firing.wall && static_cast<double>(firing.tick) <= tick && (stays || lasts))
                pressed.insert(firing.wall.index);
        }
        for (const Pickup& pickup : history.pickups())
            if (static_cast<double>(pickup.tick) <= tick) taken.insert(pickup.thing.index);
    }
};

template <class Ids>
std::vector<std::uint32_t> numbers_of(const Ids& ids) {
    std::vector<std::uint32_t> numbers;
    for (const auto id : ids) numbers.push_back(id.index);
    return numbers;
}

std::vector<std::uint32_t> in_order(const std::set<std::uint32_t>& numbers) { return {numbers.begin(), numbers.end()}; }

TEST(History, TellsOfAnyMomentWhichSwitchesAreTurnedAndWhichThingsAreTaken) {
    Random random(31);
    for (int trial = 0; trial < 300; ++trial) {
        const Map map = room_with_triggers(random);
        History history;
        std::set<std::uint32_t> fired_once;
        for (std::uint64_t tick = 0; tick < 400; tick += random.below(20)) {
            const TriggerId trigger(random.below(6));
            const bool has_wall = random.below(4) != 0;
            if (!map[trigger].once || fired_once.insert(trigger.index).second)
                history.add(Firing{trigger, has_wall ? WallId(random.below(4)) : WallId(), tick});
            const ThingId thing(random.below(50));
            if (random.below(3) == 0 && !history.is_taken(thing, 1e9)) history.add(Pickup{thing, tick});
        }
        Snapshot snapshot = at_rest(map);
        for (int look = 0; look < 5; ++look) {
            const double tick = random.uniform(0, 500);
            show({map, history, tick}, snapshot);
            const Asked asked(map, history, tick);
            ASSERT_EQ(numbers_of(snapshot.pressed), in_order(asked.pressed)) << trial;
            ASSERT_EQ(numbers_of(snapshot.taken), in_order(asked.taken)) << trial;
        }
    }
}

/// What a floor was given last, by asking all of its changes.
TextureId picture_asked(const Map& map, const History& history, const Change* change, double tick) {
    for (; change; change = change->before == Change::kNone ? nullptr : &history.changes()[change->before]) {
        const bool rises = change->track.count > 0 && change->track.stops[0].value > change->track.from;
        const bool has_come = rises || stop_at(change->track, tick) > 0;
        if (change->cause && map[change->cause].texture && has_come) return map[change->cause].texture;
    }
    return {};
}

TEST(History, TellsOfAnyMomentWhichPictureAFloorWasGiven) {
    Random random(32);
    for (int trial = 0; trial < 500; ++trial) {
        const Map map = room_with_triggers(random);
        History history;
        for (std::uint64_t tick = 0; tick < 400; tick += random.below(40)) {
            const Stop there{random.uniform(-1, 1), 0.01, 0};
            const TriggerId cause = random.below(5) == 0 ? TriggerId() : TriggerId(random.below(6));
            history.add(map, {SectorId(0u), Channel::floor, {tick, random.uniform(-1, 1), {there}, 1, false}, cause});
        }
        for (int look = 0; look < 5; ++look) {
            const double tick = random.uniform(0, 500);
            const Change* floor = history.change_of(SectorId(0u), Channel::floor, tick);
            ASSERT_EQ(changed_floor_picture({map, history, tick}, floor), picture_asked(map, history, floor, tick));
        }
    }
}

/// Switches pressed, lifts moved: a hundred thousand times, and still only what is seen of it is asked.
TEST(History, AsksForWhatIsSeenHoweverMuchHappened) {
    constexpr std::uint64_t kEvents = 100'000;
    Random random(33);
    Map map = room_with_triggers(random);
    map.triggers[0].texture = TextureId(1u);
    map.triggers[1].texture = TextureId();
    map.triggers[1].heals = map.triggers[0].heals = false;
    History history;
    const auto move = [&](std::uint64_t tick, std::uint32_t cause) {
        history.add(map, {SectorId(0u), Channel::floor, {tick, 0, {Stop{1, 0.01, 0}}, 1, false}, TriggerId(cause)});
    };
    move(0, 0);
    for (std::uint64_t tick = 1; tick < kEvents; ++tick) {
        move(tick, 1);
        history.add(Firing{TriggerId(1u), WallId(2u), tick});
    }
    EXPECT_EQ(history.changes().back().before_with_picture, 0u);
    EXPECT_EQ(history.changes().back().before_that_heals, Change::kNone);
    std::size_t presses = 0, firsts = 0;
    history.each_last_press(kEvents, [&](const Firing& firing) {
        ++presses;
        EXPECT_EQ(firing.tick, kEvents - 1);
    });
    history.each_first_firing([&](const Firing& firing) {
        ++firsts;
        EXPECT_EQ(firing.tick, 1u);
    });
    EXPECT_EQ(presses, 1u);
    EXPECT_EQ(firsts, 1u);
}

}  // namespace
}  // namespace enfilade
