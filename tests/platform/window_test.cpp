// The window, on SDL's dummy driver: it behaves like a display that nobody looks at.
#include "platform/window.h"

#include <SDL.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace enfilade {
namespace {

constexpr std::uint32_t kRed = 0xFF0000FF, kBlue = 0xFFFF0000;  // 0xAABBGGRR

class WindowOnDummyDriver : public testing::Test {
protected:
    WindowOnDummyDriver() {
        setenv("SDL_VIDEODRIVER", "dummy", 1);
        auto opened = open_window({"test", 320, 200, false});
        EXPECT_TRUE(opened.ok()) << opened.error().text();
        window_ = std::move(opened).value();
        poll();  // what opening itself caused
    }

    std::vector<InputEvent> poll() {
        std::vector<InputEvent> events;
        window_->poll(events);
        return events;
    }

    static Frame two_halves(int width, int height) {
        Frame frame;
        frame.resize(width, height);
        for (int i = 0; i < width * height; ++i) frame.pixels[i] = i % width < width / 2 ? kRed : kBlue;
        return frame;
    }

    /// The colour in the window as 0xRRGGBB.
    static std::uint32_t shown(int x, int y) {
        SDL_Surface* surface = SDL_GetWindowSurface(SDL_GetWindowFromID(1));
        const auto* row = static_cast<const std::uint8_t*>(surface->pixels) + y * surface->pitch;
        std::uint8_t r = 0, g = 0, b = 0;
        SDL_GetRGB(reinterpret_cast<const std::uint32_t*>(row)[x], surface->format, &r, &g, &b);
        return std::uint32_t(r << 16 | g << 8 | b);
    }

    static void push_key(SDL_Scancode code) {
        SDL_Event event{};
        event.type = SDL_KEYDOWN;
        event.key.keysym.scancode = code;
        SDL_PushEvent(&event);
    }

    std::unique_ptr<Window> window_;
};

TEST_F(WindowOnDummyDriver, HasTheSizeThatWasAskedFor) { EXPECT_EQ(window_->size(), (PixelSize{320, 200})); }

TEST_F(WindowOnDummyDriver, ShowsAFrameOfItsSizePixelByPixel) {
    ASSERT_TRUE(window_->present(two_halves(320, 200)).ok());
    EXPECT_EQ(shown(159, 100), 0xFF0000u);
    EXPECT_EQ(shown(160, 100), 0x0000FFu);
}

TEST_F(WindowOnDummyDriver, ScalesASmallerFrameWithSharpPixels) {
    ASSERT_TRUE(window_->present(two_halves(16, 10)).ok());
    EXPECT_EQ(shown(159, 199), 0xFF0000u);
    EXPECT_EQ(shown(160, 0), 0x0000FFu);
}

TEST_F(WindowOnDummyDriver, KeepsTheFramesProportionsBetweenBlackBars) {
    ASSERT_TRUE(window_->present(two_halves(100, 100)).ok());
    EXPECT_EQ(shown(59, 100), 0x000000u);
    EXPECT_EQ(shown(60, 100), 0xFF0000u);
    EXPECT_EQ(shown(259, 100), 0x0000FFu);
    EXPECT_EQ(shown(260, 100), 0x000000u);
}

TEST_F(WindowOnDummyDriver, ReportsKeysInOrder) {
    push_key(SDL_SCANCODE_W);
    push_key(SDL_SCANCODE_E);
    const auto events = poll();
    ASSERT_EQ(events.size(), 2u);
    EXPECT_EQ(std::get<KeyChange>(events[0]).key, KeyCode::w);
    EXPECT_EQ(std::get<KeyChange>(events[1]).key, KeyCode::e);
}

TEST_F(WindowOnDummyDriver, GivesTheMouseBackWhenItLosesTheFocus) {
    window_->grab_mouse(true);
    ASSERT_TRUE(window_->mouse_grabbed());
    SDL_Event event{};
    event.type = SDL_WINDOWEVENT;
    event.window.windowID = 1;
    event.window.event = SDL_WINDOWEVENT_FOCUS_LOST;
    SDL_PushEvent(&event);
    poll();
    EXPECT_FALSE(window_->mouse_grabbed());
}

TEST_F(WindowOnDummyDriver, SeesButtonsOfAGamepadThatIsPluggedIn) {
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");  // a dummy window never has the focus
    const int device = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX,
                                                 SDL_CONTROLLER_BUTTON_MAX, 0);
    ASSERT_GE(device, 0);
    poll();
    SDL_Joystick* stick = SDL_JoystickOpen(device);
    SDL_JoystickSetVirtualButton(stick, SDL_CONTROLLER_BUTTON_A, 1);
    const auto events = poll();
    EXPECT_TRUE(std::ranges::any_of(events, [](const InputEvent& event) {
        const auto* change = std::get_if<GamepadButtonChange>(&event);
        return change && change->button == GamepadButton::a && change->down;
    }));
    SDL_JoystickClose(stick);
}

TEST(WindowWithoutDisplay, SaysSoInsteadOfDrawingWhereNobodyLooks) {
    unsetenv("SDL_VIDEODRIVER");
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    const auto opened = open_window({"test", 320, 200, false});
    ASSERT_FALSE(opened.ok());
    EXPECT_NE(opened.error().text().find("display"), std::string::npos) << opened.error().text();
}

}  // namespace
}  // namespace enfilade
