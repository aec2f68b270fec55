// A map and a player in it, for tests: hold keys for some ticks and look where that led.
#pragma once
#include <utility>

#include "base/result.h"
#include "space/trace.h"
#include "support/map_builder.h"
#include "world/step.h"

namespace enfilade::test {

/// Keys that are held, at full pace.
inline constexpr TickInput kNoKeys{}, kForward{.forward = 127}, kBack{.forward = -127}, kLeft{.strafe = -127},
    kUse{.buttons = kButtonUse}, kRight{.strafe = 127}, kRunForward{.forward = 127, .buttons = kButtonRun},
    kCrouch{.buttons = kButtonCrouch}, kCrouchForward{.forward = 127, .buttons = kButtonCrouch};

inline constexpr double kEyeOnFloor = 1.55;  ///< of one who stands on a floor at 0 [m]

inline TriggerRecord trigger_on(Activation activation, TriggerAction action, std::vector<std::string> targets = {}) {
    TriggerRecord trigger;
    trigger.on = activation;
    trigger.action = action;
    trigger.targets = std::move(targets);
    return trigger;
}

struct Game {
    explicit Game(const MapFile& file, const MotionDials& motion = {}) : map(built(file)) {
        const auto start = start_of(map, motion);
        ENFILADE_CHECK(start.has_value());
        world = *start;
    }

    void hold(const TickInput& keys, int ticks = 1) {
        for (int i = 0; i < ticks; ++i) step(map, world, keys);
    }

    const Player& player() const { return world.player; }
    Vec2 point() const { return world.player.place.point; }
    const std::string& room() const { return map[world.player.place.sector].name; }
    bool is_contained() const { return contains(map, world.player.place.sector, point()); }

    Map map;
    World world;
};

}  // namespace enfilade::test
