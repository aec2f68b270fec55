// The menu, by keyboard, mouse and gamepad.
#include "app/play/menu.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

class OpenMenu : public ::testing::Test {
protected:
    OpenMenu() {
        menu_.open();
        frame_.resize(640, 400);
        Overlay overlay(frame_, font_);
        menu_.draw(overlay, settings_);
    }

    MenuAction press(KeyCode key) { return menu_.handle(KeyChange{key, true, false}, settings_); }
    MenuAction press(GamepadButton button) { return menu_.handle(GamepadButtonChange{button, true}, settings_); }
    MenuAction click(double x, double y) {
        return menu_.handle(MouseButtonChange{MouseButton::left, true, x, y}, settings_);
    }
    /// Presses a key so many times, then another once.
    MenuAction press(KeyCode key, int times, KeyCode then) {
        for (int i = 0; i < times; ++i) press(key);
        return press(then);
    }

    Menu menu_;
    PlaySettings settings_;
    Frame frame_;
    Font font_;
};

TEST_F(OpenMenu, ResumesWithEscape) { EXPECT_EQ(press(KeyCode::escape), MenuAction::resume); }

TEST_F(OpenMenu, ResumesWithItsFirstEntry) { EXPECT_EQ(press(KeyCode::enter), MenuAction::resume); }

TEST_F(OpenMenu, RestartsWithItsSecondEntry) {
    EXPECT_EQ(press(KeyCode::down, 1, KeyCode::enter), MenuAction::restart);
}

TEST_F(OpenMenu, QuitsWithItsLastEntryReachedUpward) {
    EXPECT_EQ(press(KeyCode::up, 1, KeyCode::enter), MenuAction::quit);
}

TEST_F(OpenMenu, WidensTheViewWithTheRightArrow) {
    EXPECT_EQ(press(KeyCode::down, 2, KeyCode::right), MenuAction::settings_changed);
    EXPECT_EQ(settings_.fov_degrees, 95);
}

TEST_F(OpenMenu, StopsTheViewAtItsEnd) {
    press(KeyCode::down, 2, KeyCode::left);
    for (int i = 0; i < 100; ++i) press(KeyCode::left);
    EXPECT_EQ(settings_.fov_degrees, kSmallestFov);
}

TEST_F(OpenMenu, ChangesTheMouseSpeedInWholeSteps) {
    press(KeyCode::down, 3, KeyCode::right);
    press(KeyCode::left);
    press(KeyCode::left);
    EXPECT_NEAR(settings_.mouse_speed, 0.8, 1e-12);  // four steps of 0.2, which no double holds exactly
}

TEST_F(OpenMenu, TogglesFullScreenWithEnter) {
    press(KeyCode::down, 4, KeyCode::enter);
    EXPECT_TRUE(settings_.fullscreen);
}

TEST_F(OpenMenu, TurnsTheVolumeDownToNothing) {
    EXPECT_EQ(press(KeyCode::down, 6, KeyCode::left), MenuAction::settings_changed);
    EXPECT_NEAR(settings_.volume, 0.9, 1e-12);  // nine steps of 0.1, which no double holds exactly
    for (int i = 0; i < 20; ++i) press(KeyCode::left);
    EXPECT_EQ(settings_.volume, 0);
}

TEST_F(OpenMenu, WorksWithTheGamepad) {
    press(GamepadButton::down);
    EXPECT_EQ(press(GamepadButton::a), MenuAction::restart);
    EXPECT_EQ(press(GamepadButton::start), MenuAction::resume);
}

TEST_F(OpenMenu, ChoosesTheEntryThatIsClicked) {
    // Eight entries of 19 px around the middle of 400 rows: the second begins 3 * 19 px above the middle.
    EXPECT_EQ(click(320, 400 / 2 - 3 * 19 + 5), MenuAction::restart);
    EXPECT_EQ(click(5, 5), MenuAction::none);
}

TEST_F(OpenMenu, IgnoresKeysThatAreLetGo) {
    EXPECT_EQ(menu_.handle(KeyChange{KeyCode::escape, false, false}, settings_), MenuAction::none);
}

TEST(Menu, IgnoresEverythingWhileClosed) {
    Menu menu;
    PlaySettings settings;
    EXPECT_EQ(menu.handle(KeyChange{KeyCode::enter, true, false}, settings), MenuAction::none);
}

TEST_F(OpenMenu, LetsTheGameGoOnWhenTheWindowLosesTheFocus) {
    EXPECT_TRUE(settings_.pauses_unfocused);
    EXPECT_EQ(press(KeyCode::up, 2, KeyCode::right), MenuAction::settings_changed);
    EXPECT_FALSE(settings_.pauses_unfocused);
}

}  // namespace
}  // namespace enfilade
