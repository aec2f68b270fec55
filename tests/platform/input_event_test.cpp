// Names of keys, and the events of SDL in our words.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "platform/input_event.h"
#include "platform/sdl_events.h"

namespace enfilade {
namespace {

SDL_Event key_event(SDL_EventType type, SDL_Scancode code, bool repeat = false) {
    SDL_Event event{};
    event.type = type;
    event.key.keysym.scancode = code;
    event.key.repeat = repeat;
    return event;
}

SDL_Event axis_event(SDL_GameControllerAxis axis, std::int16_t value) {
    SDL_Event event{};
    event.type = SDL_CONTROLLERAXISMOTION;
    event.caxis.axis = static_cast<std::uint8_t>(axis);
    event.caxis.value = value;
    return event;
}

template <class T>
T translated(const SDL_Event& event, const Placement& placement = {}) {
    const auto ours = translate(event, placement);
    EXPECT_TRUE(ours && std::holds_alternative<T>(*ours));
    return ours && std::holds_alternative<T>(*ours) ? std::get<T>(*ours) : T{};
}

TEST(SdlEvents, NamesKeysByTheirPlaceOnTheKeyboard) {
    const auto change = translated<KeyChange>(key_event(SDL_KEYDOWN, SDL_SCANCODE_W));
    EXPECT_EQ(change.key, KeyCode::w);
    EXPECT_TRUE(change.down);
}

TEST(SdlEvents, TellsBothAltKeysAndTheFunctionKeysApart) {
    const std::pair<SDL_Scancode, KeyCode> keys[] = {
        {SDL_SCANCODE_LALT, KeyCode::left_alt}, {SDL_SCANCODE_RALT, KeyCode::right_alt},
        {SDL_SCANCODE_F4, KeyCode::f4},         {SDL_SCANCODE_F6, KeyCode::f6},
        {SDL_SCANCODE_F7, KeyCode::f7},         {SDL_SCANCODE_F8, KeyCode::f8}};
    for (const auto& [code, key] : keys) EXPECT_EQ(translated<KeyChange>(key_event(SDL_KEYDOWN, code)).key, key);
}

TEST(SdlEvents, TellsAReleaseFromAPress) {
    EXPECT_FALSE(translated<KeyChange>(key_event(SDL_KEYUP, SDL_SCANCODE_TAB)).down);
}

TEST(SdlEvents, MarksKeysThatRepeat) {
    EXPECT_TRUE(translated<KeyChange>(key_event(SDL_KEYDOWN, SDL_SCANCODE_E, true)).repeat);
}

TEST(SdlEvents, CallsOtherKeysUnknown) {
    EXPECT_EQ(translated<KeyChange>(key_event(SDL_KEYDOWN, SDL_SCANCODE_KP_7)).key, KeyCode::unknown);
}

TEST(SdlEvents, GivesTheMouseInPixelsOfThePicture) {
    SDL_Event event{};
    event.type = SDL_MOUSEMOTION;
    event.motion.x = 110;
    event.motion.y = 50;
    event.motion.xrel = -7;
    const auto motion = translated<MouseMotion>(event, {10, 20, 2});
    EXPECT_EQ(motion.x, 50);
    EXPECT_EQ(motion.y, 15);
    EXPECT_EQ(motion.dx, -7);
}

TEST(SdlEvents, GivesBothEndsOfAStickAsOne) {
    EXPECT_EQ(translated<GamepadAxisMotion>(axis_event(SDL_CONTROLLER_AXIS_LEFTX, 32767)).value, 1);
    EXPECT_EQ(translated<GamepadAxisMotion>(axis_event(SDL_CONTROLLER_AXIS_LEFTX, -32768)).value, -1);
}

TEST(SdlEvents, TurnsNaturalScrollingBack) {
    SDL_Event event{};
    event.type = SDL_MOUSEWHEEL;
    event.wheel.preciseY = 1;
    event.wheel.direction = SDL_MOUSEWHEEL_FLIPPED;
    EXPECT_EQ(translated<MouseWheel>(event).steps, -1);
}

TEST(SdlEvents, ReportsTheLossOfFocus) {
    SDL_Event event{};
    event.type = SDL_WINDOWEVENT;
    event.window.event = SDL_WINDOWEVENT_FOCUS_LOST;
    EXPECT_FALSE(translated<FocusChange>(event).focused);
}

TEST(SdlEvents, LeavesOutWhatMeansNothingToUs) {
    SDL_Event event{};
    event.type = SDL_CLIPBOARDUPDATE;
    EXPECT_FALSE(translate(event, {}));
}

// Names of keys.

TEST(KeyNames, LeadBackToTheirKeys) {
    std::set<std::string_view> names;
    for (int i = 1; i < kKeyCount; ++i) {
        const auto key = static_cast<KeyCode>(i);
        EXPECT_FALSE(name_of(key).empty()) << i;
        EXPECT_EQ(key_named(name_of(key)), key);
        names.insert(name_of(key));
    }
    EXPECT_EQ(names.size(), std::size_t(kKeyCount - 1));
}

TEST(KeyNames, AreTheSameInSmallLetters) { EXPECT_EQ(key_named("left shift"), KeyCode::left_shift); }

TEST(KeyNames, AreUnknownWhereThereIsNoSuchKey) {
    EXPECT_EQ(key_named("Any"), KeyCode::unknown);
    EXPECT_EQ(key_named(""), KeyCode::unknown);
}

}  // namespace
}  // namespace enfilade
