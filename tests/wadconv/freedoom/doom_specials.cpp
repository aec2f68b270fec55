#include "wadconv/freedoom/doom_specials.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace enfilade::test {
namespace {

/// speed: [map units / tic]; amount: of a rise or a stair [map units].
struct Numbers {
    std::vector<int> numbers;
    Rule rule;
    double speed;
    double amount = 0;
};

// clang-format off
const std::vector<Numbers> kSpecials = {
    {{1, 26, 27, 28, 4, 29, 63, 90}, Rule::door, 2},
    {{117, 105, 108, 111, 114}, Rule::door, 8},
    {{31, 32, 33, 34, 2, 46, 61, 86, 103}, Rule::open, 2},
    {{118, 106, 109, 112, 115, 99, 133, 134, 135, 136, 137}, Rule::open, 8},
    {{3, 42, 50, 75}, Rule::close, 2},
    {{107, 110, 113, 116}, Rule::close, 8},
    {{16, 76}, Rule::close_then_open, 2},
    {{10, 21, 62, 88}, Rule::lift, 4},
    {{120, 121, 122, 123}, Rule::lift, 8},
    {{53, 87}, Rule::perpetual, 1},
    {{15, 66}, Rule::raise_by, 0.5, 24},
    {{14, 67}, Rule::raise_by, 0.5, 32},
    {{58, 59, 92, 93}, Rule::raise_by, 1, 24},
    {{140}, Rule::raise_by, 1, 512},
    {{20, 22, 47, 68, 95}, Rule::raise_to_next, 0.5},
    {{18, 69, 119, 128}, Rule::raise_to_next, 1},
    {{129, 130, 131, 132}, Rule::raise_to_next, 4},
    {{19, 45, 83, 102}, Rule::to_highest, 1},
    {{36, 70, 71, 98}, Rule::to_highest_and_up, 4},
    {{23, 37, 38, 60, 82, 84}, Rule::to_lowest, 1},
    {{5, 24, 64, 91, 101}, Rule::to_ceiling, 1},
    {{55, 56, 65, 94}, Rule::to_8_below_ceiling, 1},
    {{30, 96}, Rule::by_texture, 1},
    {{9}, Rule::donut, 0.5},
    {{7, 8}, Rule::stairs, 0.25, 8},
    {{100, 127}, Rule::stairs, 4, 16},
    {{41, 43}, Rule::ceiling_to_floor, 1},
    {{40}, Rule::ceiling_to_highest, 1},
    {{44, 72}, Rule::ceiling_to_8_above_floor, 1},
    {{25, 49, 73, 141}, Rule::crusher, 1},
    {{6, 77}, Rule::crusher, 2},
};
// clang-format on

/// Doors one pushes act on what is behind the line, all others on the sectors with the line's tag.
constexpr std::array kPushed = {1, 26, 27, 28, 31, 32, 33, 34, 117, 118};

/// Those that are set off by who walks across the line; all others by hand or by a shot.
constexpr std::array kCrossed = {2,  3,  4,  5,  6,   8,   10,  16,  19,  22,  25,  30,  36,  37,  38,  40,  44,  53,
                                 56, 58, 59, 72, 73,  75,  76,  77,  82,  83,  84,  86,  87,  88,  90,  91,  92,  93,
                                 94, 95, 96, 98, 100, 105, 106, 107, 108, 109, 110, 119, 120, 121, 128, 129, 130, 141};

/// Those that keep their special (p_spec.c, "RETRIGGERS" and what is shot; p_switch.c, "BUTTONS"; p_doors.c, pushed).
constexpr std::array kAgain = {1,   26,  27,  28,  117, 46,  42,  43,  45,  60,  61,  62,  63,  64, 65,  66,
                               67,  68,  69,  70,  99,  72,  73,  74,  75,  76,  77,  79,  80,  81, 82,  83,
                               84,  86,  87,  88,  89,  90,  91,  92,  93,  94,  95,  96,  97,  98, 105, 106,
                               107, 114, 115, 116, 120, 123, 126, 128, 129, 132, 134, 136, 138, 139};
constexpr std::array kExits = {11, 51, 52, 124};
constexpr int kLastOfDoom = 141, kFirstInBits = 0x2F80;

constexpr double kDoorWait = 150, kPlatWait = 105, kHalfMinute = 30 * 35;  // [tics]

bool is_one_of(std::span<const int> numbers, int number) { return std::ranges::find(numbers, number) != numbers.end(); }

double wait_of(Rule rule) {
    const bool is_plat = rule == Rule::lift || rule == Rule::perpetual;
    return is_plat ? kPlatWait : rule == Rule::close_then_open ? kHalfMinute : kDoorWait;
}

/// Boom's generalized doors and lifts say all in bits (Boom's reference, sections 13 and 14).
std::optional<DoomSpecial> read_bits(int number) {
    const auto bits = [number](int low, int count) {
        return static_cast<std::size_t>(number >> low & ((1 << count) - 1));
    };
    constexpr std::array kSpeeds = {2., 4., 8., 16.}, kDoorWaits = {35., 150., 300., 1050.},
                         kLiftWaits = {35., 105., 175., 350.};
    constexpr std::array kDoors = {Rule::door, Rule::open, Rule::close_then_open, Rule::close};
    const bool is_pushed = bits(1, 2) == 3, is_crossed = bits(1, 2) == 0;
    if (number >= 0x3C00 && number < 0x4000)
        return DoomSpecial{kDoors[bits(5, 2)], kSpeeds[bits(3, 2)], 0, kDoorWaits[bits(8, 2)], is_pushed, is_crossed};
    if (number >= 0x3400 && number < 0x3800 && bits(8, 2) == 0)
        return DoomSpecial{Rule::lift, kSpeeds[bits(3, 2)], 0, kLiftWaits[bits(6, 2)], is_pushed, is_crossed};
    return {};
}

}  // namespace

std::optional<DoomSpecial> special_of(int number) {
    for (const Numbers& special : kSpecials)
        if (is_one_of(special.numbers, number))
            return DoomSpecial{special.rule,
                               special.speed,
                               special.amount,
                               wait_of(special.rule),
                               is_one_of(kPushed, number),
                               is_one_of(kCrossed, number)};
    return read_bits(number);
}

std::optional<bool> repeats(int number) {
    if (number >= kFirstInBits) return (number & 1) != 0;
    if (number > kLastOfDoom || is_one_of(kExits, number)) return {};
    return is_one_of(kAgain, number);
}

bool turns_round(int number) { return is_one_of(std::array{1, 26, 27, 28, 117}, number); }

std::optional<DoomLight> light_of(int number) {
    switch (number) {
        case 12:
        case 80: return DoomLight{LightRule::brightest, 0};
        case 13:
        case 81:
        case 138: return DoomLight{LightRule::to_level, 255};
        case 35:
        case 79:
        case 139: return DoomLight{LightRule::to_level, 35};
        case 17: return DoomLight{LightRule::strobe, 0};
        case 104: return DoomLight{LightRule::darkest, 0};
        default: return {};
    }
}

bool is_teleport(int number) { return number == 39 || number == 97; }

}  // namespace enfilade::test
