#include "wadconv/workbench.h"

#include <algorithm>
#include <array>

namespace enfilade::wadconv {
namespace {

using enum How;
using enum Times;
using enum DoorKey;

// Speeds [map units / tic].
constexpr double kDoor = 2, kFastDoor = 8, kFloor = 1, kFastFloor = 4, kPlat = 4, kFastPlat = 8, kSlowPlat = 1,
                 kRaisingPlat = 0.5, kSlowStairs = 0.25, kDonut = 0.5, kCeiling = 1, kFastCeiling = 2,
                 kSlowCrush = kCeiling / 8;

// Waits [tics].
constexpr double kDoorWait = 150, kPlatWait = 105, kHalfMinute = 1050;

constexpr LineAction door(int special, How how, Times times, TriggerAction action, DoorKey key = none,
                          double speed = kDoor) {
    const double wait = action == TriggerAction::close_then_open ? kHalfMinute
                        : action == TriggerAction::door          ? kDoorWait
                                                                 : 0;
    return {.special = special, .how = how, .times = times, .action = action, .speed = speed, .wait = wait, .key = key};
}

constexpr LineAction fast_door(int special, How how, Times times, TriggerAction action, DoorKey key = none) {
    return door(special, how, times, action, key, kFastDoor);
}

constexpr LineAction lift(int special, How how, Times times, double speed = kPlat,
                          TriggerAction action = TriggerAction::lift) {
    return {.special = special, .how = how, .times = times, .action = action, .speed = speed, .wait = kPlatWait};
}

constexpr LineAction floor_to(int special, How how, Times times, HeightLevel to, double by = 0, double speed = kFloor,
                              FloorChange change = FloorChange::none) {
    return {.special = special,
            .how = how,
            .times = times,
            .action = TriggerAction::floor,
            .speed = speed,
            .to = to,
            .by = by,
            .change = change};
}

constexpr LineAction floor_by(int special, How how, Times times, double by, double speed = kFloor,
                              FloorChange change = FloorChange::none) {
    return floor_to(special, how, times, HeightLevel::here, by, speed, change);
}

constexpr LineAction crushing_floor(int special, How how, Times times) {
    LineAction line_action = floor_to(special, how, times, HeightLevel::lowest_ceiling_or_own, -8);
    line_action.crushes = true;
    return line_action;
}

constexpr LineAction floor_by_texture(int special, How how, Times times) {
    LineAction line_action = floor_by(special, how, times, 0);
    line_action.special_case = SpecialCase::shortest_lower;
    return line_action;
}

constexpr LineAction ceiling_to(int special, How how, Times times, HeightLevel to, double by = 0,
                                bool crushes = false) {
    return {.special = special,
            .how = how,
            .times = times,
            .action = TriggerAction::ceiling,
            .speed = kCeiling,
            .to = to,
            .by = by,
            .crushes = crushes,
            .crush_speed = crushes ? kSlowCrush : 0};
}

constexpr LineAction crusher(int special, How how, Times times, double speed = kCeiling) {
    return {.special = special,
            .how = how,
            .times = times,
            .action = TriggerAction::crush,
            .speed = speed,
            .crushes = true,
            .crush_speed = speed == kCeiling ? kSlowCrush : 0};
}

constexpr LineAction stairs(int special, How how, double step, double speed, Times times = once) {
    return {
        .special = special, .how = how, .times = times, .action = TriggerAction::stairs, .speed = speed, .by = step};
}

constexpr LineAction donut(int special, How how, Times times = once) {
    return {.special = special,
            .how = how,
            .times = times,
            .action = TriggerAction::floor,
            .speed = kDonut,
            .special_case = SpecialCase::donut};
}

constexpr LineAction plain(int special, How how, Times times, TriggerAction action,
                           SpecialCase special_case = SpecialCase::none) {
    return {.special = special, .how = how, .times = times, .action = action, .special_case = special_case};
}

constexpr LineAction light(int special, How how, Times times, int level, LightLevel light_of = LightLevel::given) {
    return {.special = special,
            .how = how,
            .times = times,
            .action = TriggerAction::light,
            .light = level,
            .light_of = light_of};
}

constexpr std::array kLineActions = {
    door(1, push, again, TriggerAction::door),
    door(2, cross, once, TriggerAction::open),
    door(3, cross, once, TriggerAction::close),
    door(4, cross, once, TriggerAction::door),
    floor_to(5, cross, once, HeightLevel::lowest_ceiling_or_own),
    crusher(6, cross, once, kFastCeiling),
    stairs(7, use, 8, kSlowStairs),
    stairs(8, cross, 8, kSlowStairs),
    donut(9, use),
    lift(10, cross, once),
    plain(11, use, once, TriggerAction::leave_map),
    light(12, cross, once, -1, LightLevel::brightest),
    light(13, cross, once, 255),
    floor_by(14, use, once, 32, kRaisingPlat, FloorChange::picture),
    floor_by(15, use, once, 24, kRaisingPlat, FloorChange::picture),
    door(16, cross, once, TriggerAction::close_then_open),
    light(17, cross, once, -1),
    floor_to(18, use, once, HeightLevel::next_floor_up),
    floor_to(19, cross, once, HeightLevel::highest_floor),
    floor_to(20, use, once, HeightLevel::next_floor_up, 0, kRaisingPlat, FloorChange::harmless),
    lift(21, use, once),
    floor_to(22, cross, once, HeightLevel::next_floor_up, 0, kRaisingPlat, FloorChange::harmless),
    floor_to(23, use, once, HeightLevel::lowest_floor),
    floor_to(24, shoot, once, HeightLevel::lowest_ceiling_or_own),
    crusher(25, cross, once),
    door(26, push, again, TriggerAction::door, blue),
    door(27, push, again, TriggerAction::door, yellow),
    door(28, push, again, TriggerAction::door, red),
    door(29, use, once, TriggerAction::door),
    floor_by_texture(30, cross, once),
    door(31, push, once, TriggerAction::open),
    door(32, push, once, TriggerAction::open, blue),
    door(33, push, once, TriggerAction::open, red),
    door(34, push, once, TriggerAction::open, yellow),
    light(35, cross, once, 35),
    floor_to(36, cross, once, HeightLevel::highest_floor, 8, kFastFloor),
    floor_to(37, cross, once, HeightLevel::lowest_floor, 0, kFloor, FloorChange::as_beside),
    floor_to(38, cross, once, HeightLevel::lowest_floor),
    plain(39, cross, once, TriggerAction::teleport),
    ceiling_to(40, cross, once, HeightLevel::highest_ceiling),
    ceiling_to(41, use, once, HeightLevel::floor),
    door(42, use, again, TriggerAction::close),
    ceiling_to(43, use, again, HeightLevel::floor),
    ceiling_to(44, cross, once, HeightLevel::floor, 8, true),
    floor_to(45, use, again, HeightLevel::highest_floor),
    door(46, shoot, again, TriggerAction::open),
    floor_to(47, shoot, once, HeightLevel::next_floor_up, 0, kRaisingPlat, FloorChange::harmless),
    crusher(49, use, once),
    door(50, use, once, TriggerAction::close),
    plain(51, use, once, TriggerAction::leave_map, SpecialCase::secret_exit),
    plain(52, cross, once, TriggerAction::leave_map),
    lift(53, cross, once, kSlowPlat, TriggerAction::shuttle),
    plain(54, cross, once, TriggerAction::stop),
    crushing_floor(55, use, once),
    crushing_floor(56, cross, once),
    plain(57, cross, once, TriggerAction::stop),
    floor_by(58, cross, once, 24),
    floor_by(59, cross, once, 24, kFloor, FloorChange::as_in_front),
    floor_to(60, use, again, HeightLevel::lowest_floor),
    door(61, use, again, TriggerAction::open),
    lift(62, use, again),
    door(63, use, again, TriggerAction::door),
    floor_to(64, use, again, HeightLevel::lowest_ceiling_or_own),
    crushing_floor(65, use, again),
    floor_by(66, use, again, 24, kRaisingPlat, FloorChange::picture),
    floor_by(67, use, again, 32, kRaisingPlat, FloorChange::picture),
    floor_to(68, use, again, HeightLevel::next_floor_up, 0, kRaisingPlat, FloorChange::harmless),
    floor_to(69, use, again, HeightLevel::next_floor_up),
    floor_to(70, use, again, HeightLevel::highest_floor, 8, kFastFloor),
    floor_to(71, use, once, HeightLevel::highest_floor, 8, kFastFloor),
    ceiling_to(72, cross, again, HeightLevel::floor, 8, true),
    crusher(73, cross, again),
    plain(74, cross, again, TriggerAction::stop),
    door(75, cross, again, TriggerAction::close),
    door(76, cross, again, TriggerAction::close_then_open),
    crusher(77, cross, again, kFastCeiling),
    light(79, cross, again, 35),
    light(80, cross, again, -1, LightLevel::brightest),
    light(81, cross, again, 255),
    floor_to(82, cross, again, HeightLevel::lowest_floor),
    floor_to(83, cross, again, HeightLevel::highest_floor),
    floor_to(84, cross, again, HeightLevel::lowest_floor, 0, kFloor, FloorChange::as_beside),
    door(86, cross, again, TriggerAction::open),
    lift(87, cross, again, kSlowPlat, TriggerAction::shuttle),
    lift(88, cross, again),
    plain(89, cross, again, TriggerAction::stop),
    door(90, cross, again, TriggerAction::door),
    floor_to(91, cross, again, HeightLevel::lowest_ceiling_or_own),
    floor_by(92, cross, again, 24),
    floor_by(93, cross, again, 24, kFloor, FloorChange::as_in_front),
    crushing_floor(94, cross, again),
    floor_to(95, cross, again, HeightLevel::next_floor_up, 0, kRaisingPlat, FloorChange::harmless),
    floor_by_texture(96, cross, again),
    plain(97, cross, again, TriggerAction::teleport),
    floor_to(98, cross, again, HeightLevel::highest_floor, 8, kFastFloor),
    fast_door(99, use, again, TriggerAction::open, blue),
    stairs(100, cross, 16, kFastFloor),
    floor_to(101, use, once, HeightLevel::lowest_ceiling_or_own),
    floor_to(102, use, once, HeightLevel::highest_floor),
    door(103, use, once, TriggerAction::open),
    light(104, cross, once, -1, LightLevel::darkest),
    fast_door(105, cross, again, TriggerAction::door),
    fast_door(106, cross, again, TriggerAction::open),
    fast_door(107, cross, again, TriggerAction::close),
    fast_door(108, cross, once, TriggerAction::door),
    fast_door(109, cross, once, TriggerAction::open),
    fast_door(110, cross, once, TriggerAction::close),
    fast_door(111, use, once, TriggerAction::door),
    fast_door(112, use, once, TriggerAction::open),
    fast_door(113, use, once, TriggerAction::close),
    fast_door(114, use, again, TriggerAction::door),
    fast_door(115, use, again, TriggerAction::open),
    fast_door(116, use, again, TriggerAction::close),
    fast_door(117, push, again, TriggerAction::door),
    fast_door(118, push, once, TriggerAction::open),
    floor_to(119, cross, once, HeightLevel::next_floor_up),
    lift(120, cross, again, kFastPlat),
    lift(121, cross, once, kFastPlat),
    lift(122, use, once, kFastPlat),
    lift(123, use, again, kFastPlat),
    plain(124, cross, once, TriggerAction::leave_map, SpecialCase::secret_exit),
    stairs(127, use, 16, kFastFloor),
    floor_to(128, cross, again, HeightLevel::next_floor_up),
    floor_to(129, cross, again, HeightLevel::next_floor_up, 0, kFastFloor),
    floor_to(130, cross, once, HeightLevel::next_floor_up, 0, kFastFloor),
    floor_to(131, use, once, HeightLevel::next_floor_up, 0, kFastFloor),
    floor_to(132, use, again, HeightLevel::next_floor_up, 0, kFastFloor),
    fast_door(133, use, once, TriggerAction::open, blue),
    fast_door(134, use, again, TriggerAction::open, red),
    fast_door(135, use, once, TriggerAction::open, red),
    fast_door(136, use, again, TriggerAction::open, yellow),
    fast_door(137, use, once, TriggerAction::open, yellow),
    light(138, use, again, 255),
    light(139, use, again, 35),
    floor_by(140, use, once, 512),
    crusher(141, cross, once),
    floor_by(160, use, once, 24, kFloor, FloorChange::as_in_front),
    lift(181, use, again, kSlowPlat, TriggerAction::shuttle),
};

static_assert(std::ranges::is_sorted(kLineActions, {}, &LineAction::special));

// Boom's generalized types are numbers whose bits say what they do (the Boom reference, part I, sections 13 and 14).
constexpr int kGeneralLifts = 0x3400, kGeneralLiftsEnd = 0x3800, kGeneralDoors = 0x3C00, kGeneralDoorsEnd = 0x4000;

constexpr int bits(int number, int low, int count) { return (number >> low) & ((1 << count) - 1); }

/// Bits 0 to 2 say how a generalized line is set off: crossed, used, shot or pushed, each once or again and again.
LineAction set_off(int special) {
    constexpr std::array kHow = {cross, use, shoot, push};
    LineAction line_action;
    line_action.special = special;
    line_action.times = special & 1 ? again : once;
    line_action.how = kHow[static_cast<std::size_t>(bits(special, 1, 2))];
    return line_action;
}

/// Only those that go to the lowest floor around and wait.
std::optional<LineAction> general_lift(int special) {
    if (bits(special, 8, 2) != 0) return {};
    constexpr std::array kWaits = {35., 105., 175., 350.}, kSpeeds = {2., 4., 8., 16.};
    LineAction line_action = set_off(special);
    line_action.action = TriggerAction::lift;
    line_action.speed = kSpeeds[static_cast<std::size_t>(bits(special, 3, 2))];
    line_action.wait = kWaits[static_cast<std::size_t>(bits(special, 6, 2))];
    return line_action;
}

std::optional<LineAction> general_door(int special) {
    constexpr std::array kActions = {TriggerAction::door, TriggerAction::open, TriggerAction::close_then_open,
                                     TriggerAction::close};
    constexpr std::array kWaits = {35., 150., 300., 1050.}, kSpeeds = {2., 4., 8., 16.};
    LineAction line_action = set_off(special);
    line_action.action = kActions[static_cast<std::size_t>(bits(special, 5, 2))];
    line_action.speed = kSpeeds[static_cast<std::size_t>(bits(special, 3, 2))];
    line_action.wait = kWaits[static_cast<std::size_t>(bits(special, 8, 2))];
    return line_action;
}

}  // namespace

std::span<const LineAction> line_actions() { return kLineActions; }

std::optional<LineAction> line_action_of(int special) {
    if (special >= kGeneralLifts && special < kGeneralLiftsEnd) return general_lift(special);
    if (special >= kGeneralDoors && special < kGeneralDoorsEnd) return general_door(special);
    const auto found = std::ranges::lower_bound(kLineActions, special, {}, &LineAction::special);
    if (found == kLineActions.end() || found->special != special) return {};
    return *found;
}

int scroll_of(int special) { return special == 48 ? -1 : special == 85 ? 1 : 0; }

}  // namespace enfilade::wadconv
