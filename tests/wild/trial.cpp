#include "wild/trial.h"

#include "app/play/game.h"
#include "base/attempt.h"
#include "hard_cases/comparison.h"
#include "map/load.h"
#include "space/hearing.h"
#include "space/triangle_faults.h"
#include "world/body.h"
#include "world/player_fault.h"
#include "world/step.h"
#include "world/voices.h"

namespace enfilade::test {
namespace {

std::string triangles_fault(const Map& map) {
    for (std::size_t i = 0; i < map.sectors.size(); ++i) {
        const std::string fault = triangle_fault(map, SectorId(i), triangulate(map, SectorId(i)));
        if (!fault.empty()) return "triangles of sector '" + map.sectors[i].name + "': " + fault;
    }
    return "";
}

/// All that sounds, from where the player starts and from a hard place.
std::string hearing_fault(const Map& map, const Place& listener) {
    const History nothing_yet;
    Hearing hearing(map);
    const std::vector<double> lengths(map.sounds.size(), 1.0);
    for (const Voice& voice : voices_at({map, nothing_yet, 60}, hearing, {listener, {}}, lengths))
        if (!(voice.level > 0 && voice.level <= 1 && voice.side >= -1 && voice.side <= 1))
            return "a voice out of range";
    hearing.forget();
    hearing.listen(listener, 64);
    const auto own = hearing.from(listener);
    constexpr double kOffACorner = 0x1p-15;  // who stands exactly in one listens a bit beside it [m]
    if (!own || own->length_m > kOffACorner) return "what sounds where one stands is heard from elsewhere";
    return "";
}

/// Cheap, and what is wrong with a body is wrong in few places.
constexpr int kBodies = 20;

/// A body may be put anywhere: it gets so narrow that it touches no wall.
std::string body_fault(const Map& map, Random& random) {
    const HardPose pose = hard_pose(map, {1, 1}, random);
    const Place place{pose.view.sector, pose.view.eye};
    const Instant at_rest(map);
    const Body body = squeezed(at_rest, {place, heights_of(at_rest, place.sector).floor_z});
    for (const ReachedWall& wall : around(at_rest, body).walls)
        if (!is_one_way_exit(map, wall)) return "a body put into a narrow place is in a wall";
    return "";
}

void draw_automap(const Map& map, const Place& place) {
    Automap automap(map);
    automap.toggle();
    for (std::size_t i = 0; i < map.sectors.size(); ++i) automap.visit(SectorId(i));
    Frame frame;
    frame.resize(64, 48);
    static const Font font;
    Overlay overlay(frame, font);
    automap.draw(overlay, map, place, {1, 0});
}

}  // namespace

std::vector<TickInput> random_inputs(int ticks, Random& random) {
    std::vector<TickInput> inputs;
    TickInput keys;
    for (int tick = 0; tick < ticks; ++tick) {
        if (tick % 15 == 0) {
            keys.forward = static_cast<std::int8_t>(random.below(4) == 0 ? -127 : 127);
            keys.strafe = static_cast<std::int8_t>(127 * (static_cast<int>(random.below(3)) - 1));
            keys.yaw_steps = static_cast<std::int32_t>(random.bits()) / 128;
        }
        keys.buttons = static_cast<std::uint8_t>(random.below(8));
        inputs.push_back(keys);
    }
    return inputs;
}

std::string what_is_wrong(const std::function<std::string()>& work) {
    std::string fault;
    const Result<void> result = attempt([&] { fault = work(); });
    return result.ok() ? fault : result.error().text();
}

std::string picture_fault(const TrialMap& on, const HardPose& pose) {
    return what_is_wrong([&] {
        const Comparison result = compare({on.map.name, on.map, on.textures}, at_rest(on.map), pose.view, pose.size);
        return result.is_faultless() ? std::string() : describe(result);
    });
}

namespace {

std::string fault_of_walk(const TrialMap& on, const World& start, std::vector<TickInput>& inputs) {
    Timeline timeline(start);
    PlayerWatch watch;
    for (std::size_t tick = 0; tick < inputs.size(); ++tick) {
        timeline.play(on.map, inputs[tick]);
        const std::string fault = watch.fault_of(on.map, timeline.world());
        if (fault.empty()) continue;
        inputs.resize(tick + 1);
        return fault + " after tick " + std::to_string(tick);
    }
    World again = timeline.after(on.map, inputs.size() / 2);
    for (std::size_t tick = inputs.size() / 2; tick < inputs.size(); ++tick) step(on.map, again, inputs[tick]);
    return hash(again) == hash(timeline.world()) ? "" : "half of the walk again leads elsewhere";
}

std::string fault_of_ground(const TrialMap& on, std::uint64_t seed) {
    Random random(seed);
    const HardPose pose = hard_pose(on.map, {1, 1}, random);
    const Place place{pose.view.sector, pose.view.eye};
    if (!is_consistent(on.map, on.textures.textures.size())) return "a map that was built would not be read from bytes";
    std::string fault = triangles_fault(on.map);
    if (fault.empty()) fault = hearing_fault(on.map, place);
    for (int i = 0; i < kBodies && fault.empty(); ++i) fault = body_fault(on.map, random);
    if (fault.empty()) draw_automap(on.map, place);
    return fault;
}

}  // namespace

MotionDials random_motion(Random& random) {
    const std::uint64_t lot = random.below(4);
    const TickRate rate = lot == 0 ? TickRate::hz35 : lot == 1 ? TickRate::hz140 : kUsualTickRate;
    return {rate, random.below(8) == 0 ? CrossingMethod::naive : CrossingMethod::exact};
}

std::string walk_fault(const TrialMap& on, const MotionDials& motion, std::vector<TickInput>& inputs) {
    const std::optional<World> start = start_of(on.map, motion);
    return start ? what_is_wrong([&] { return fault_of_walk(on, *start, inputs); }) : "";
}

std::string ground_fault(const TrialMap& on, std::uint64_t seed) {
    return what_is_wrong([&] { return fault_of_ground(on, seed); });
}

std::optional<Fault> first_fault(const TrialMap& on, const TrialPlan& plan) {
    if (std::string what = ground_fault(on, plan.seed); !what.empty()) return Fault{std::move(what), {}, {}};
    Random random(plan.seed);
    for (int i = 0; i < plan.poses; ++i) {
        const HardPose pose = hard_pose(on.map, plan.largest, random);
        if (std::string what = picture_fault(on, pose); !what.empty()) return Fault{std::move(what), pose, {}};
    }
    std::vector<TickInput> inputs = random_inputs(plan.ticks, random);
    const MotionDials motion = random_motion(random);
    if (std::string what = walk_fault(on, motion, inputs); !what.empty())
        return Fault{std::move(what), {}, std::move(inputs), motion};
    return {};
}

}  // namespace enfilade::test
