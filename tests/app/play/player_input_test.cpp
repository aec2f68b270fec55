// From keys, mouse and gamepad to what is asked of the player.
#include "app/play/player_input.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

constexpr double kStepsPerDegree = 4294967296.0 / 360;

class PlayerInputFromEvents : public ::testing::Test {
protected:
    void press(KeyCode key) { input_.handle(KeyChange{key, true, false}, true); }
    void release(KeyCode key) { input_.handle(KeyChange{key, false, false}, true); }
    void press(GamepadButton button) { input_.handle(GamepadButtonChange{button, true}, true); }
    void push(GamepadAxis axis, double value) { input_.handle(GamepadAxisMotion{axis, value}, true); }
    void move_mouse(double dx, double dy, bool looks = true) {
        input_.obey(settings_);
        input_.handle(MouseMotion{dx, dy, 0, 0}, looks);
    }
    TickInput tick() { return input_.take_tick(0, kTickSeconds); }

    PlayerInput input_;
    Settings settings_;
};

TEST_F(PlayerInputFromEvents, AsksForNothingByItself) { EXPECT_EQ(tick(), TickInput{}); }

TEST_F(PlayerInputFromEvents, WalksWhileAKeyIsHeld) {
    press(KeyCode::w);
    EXPECT_EQ(tick().forward, 127);
    EXPECT_EQ(tick().forward, 127);
    release(KeyCode::w);
    EXPECT_EQ(tick().forward, 0);
}

TEST_F(PlayerInputFromEvents, WalksInAllFourDirections) {
    press(KeyCode::s);
    press(KeyCode::d);
    EXPECT_EQ(tick().forward, -127);
    EXPECT_EQ(tick().strafe, 127);
}

TEST_F(PlayerInputFromEvents, StandsStillBetweenOppositeKeys) {
    press(KeyCode::a);
    press(KeyCode::d);
    EXPECT_EQ(tick().strafe, 0);
}

TEST_F(PlayerInputFromEvents, DoesNotWalkTwiceAsFastWithTwoKeysForTheSame) {
    press(KeyCode::w);
    press(KeyCode::up);
    EXPECT_EQ(tick().forward, 127);
    release(KeyCode::up);
    EXPECT_EQ(tick().forward, 127);
}

TEST_F(PlayerInputFromEvents, UsesOnceForATapThatIsOverBeforeTheTick) {
    press(KeyCode::e);
    release(KeyCode::e);
    EXPECT_EQ(tick().buttons, kButtonUse);
    EXPECT_EQ(tick().buttons, 0);
}

TEST_F(PlayerInputFromEvents, StandsUpWhileControlAndTheWheelZoom) {
    press(KeyCode::left_control);
    EXPECT_EQ(tick().buttons, kButtonCrouch);
    input_.handle(MouseWheel{1}, true);
    EXPECT_EQ(tick().buttons, 0);
    press(KeyCode::c);
    EXPECT_EQ(tick().buttons, kButtonCrouch);
    release(KeyCode::c);
    release(KeyCode::left_control);
    press(KeyCode::left_control);
    EXPECT_EQ(tick().buttons, kButtonCrouch);
}

TEST_F(PlayerInputFromEvents, RunsCrouchesAndUses) {
    press(KeyCode::left_shift);
    EXPECT_EQ(tick().buttons, kButtonRun);
    press(KeyCode::c);
    press(KeyCode::e);
    EXPECT_EQ(tick().buttons, kButtonRun | kButtonCrouch | kButtonUse);
}

TEST_F(PlayerInputFromEvents, TurnsWithTheMouseOnce) {
    move_mouse(16, 0);
    move_mouse(16, 0);
    EXPECT_NEAR(tick().yaw_steps, 32 * 180.0 / 1600 * kStepsPerDegree, 1);  // rounded to whole steps
    EXPECT_EQ(tick().yaw_steps, 0);
}

TEST_F(PlayerInputFromEvents, LooksUpWhereTheMouseMovesAway) {
    move_mouse(0, -8);
    EXPECT_GT(tick().pitch_steps, 0);
}

TEST_F(PlayerInputFromEvents, TurnsFasterWithAFasterMouse) {
    move_mouse(16, 0);
    const auto slow = tick().yaw_steps;
    settings_.mouse_speed = 2;
    move_mouse(16, 0);
    EXPECT_NEAR(tick().yaw_steps, 2.0 * slow, 1);
}

TEST_F(PlayerInputFromEvents, IgnoresAMouseThatIsNotGrabbed) {
    move_mouse(50, 50, false);
    EXPECT_EQ(tick(), TickInput{});
}

TEST_F(PlayerInputFromEvents, ShowsTheMousesTurnAtOnceAndNothingTwice) {
    move_mouse(16, 0);
    const auto all = input_.ahead(1).yaw;
    EXPECT_GT(all, 0);
    EXPECT_EQ(input_.take_tick(0, kTickSeconds).yaw_steps, all);
    EXPECT_EQ(input_.ahead(0).yaw, all);  // the picture is still at the tick before
    EXPECT_EQ(input_.ahead(1).yaw, 0);    // the picture has caught up
}

TEST_F(PlayerInputFromEvents, TurnsWithArrowsAndFasterWhileRunning) {
    press(KeyCode::right);
    const auto walking = tick().yaw_steps;
    EXPECT_GT(walking, 0);
    press(KeyCode::right_shift);
    EXPECT_GT(tick().yaw_steps, walking);
}

TEST_F(PlayerInputFromEvents, LooksAheadWithHome) {
    press(KeyCode::home);
    EXPECT_EQ(input_.take_tick(12345, kTickSeconds).pitch_steps, -12345);
    EXPECT_EQ(input_.take_tick(0, kTickSeconds).pitch_steps, 0);
}

TEST_F(PlayerInputFromEvents, SurvivesAMouseThatJumps) {
    move_mouse(1e12, -1e12);
    EXPECT_EQ(tick().yaw_steps, INT32_MAX);
}

TEST_F(PlayerInputFromEvents, WalksWithTheLeftStick) {
    push(GamepadAxis::left_y, -1);
    push(GamepadAxis::left_x, 0.6);
    EXPECT_EQ(tick().forward, 127);
    EXPECT_EQ(tick().strafe, 65);
}

TEST_F(PlayerInputFromEvents, TakesAWornStickForLetGo) {
    push(GamepadAxis::left_x, 0.15);
    push(GamepadAxis::right_x, -0.15);
    EXPECT_EQ(tick(), TickInput{});
}

TEST_F(PlayerInputFromEvents, LooksWithTheRightStick) {
    push(GamepadAxis::right_x, 1);
    push(GamepadAxis::right_y, -1);
    const TickInput input = tick();
    EXPECT_GT(input.yaw_steps, 0);
    EXPECT_GT(input.pitch_steps, 0);
}

TEST_F(PlayerInputFromEvents, LetsGoOfAGamepadThatIsPulledOut) {
    push(GamepadAxis::left_y, -1);
    press(GamepadButton::b);
    input_.handle(GamepadLost{}, true);
    EXPECT_EQ(tick(), TickInput{});
}

TEST_F(PlayerInputFromEvents, LetsGoOfEverythingWithoutTheFocus) {
    press(KeyCode::w);
    move_mouse(10, 10);
    input_.handle(FocusChange{false}, true);
    EXPECT_EQ(tick(), TickInput{});
}

TEST_F(PlayerInputFromEvents, WalksSlowlyWhileAltIsHeld) {
    press(KeyCode::w);
    press(KeyCode::d);
    press(KeyCode::left_alt);
    EXPECT_EQ(tick().forward, 44);
    EXPECT_EQ(tick().strafe, 44);
    EXPECT_EQ(tick().buttons, 0) << "a tape knows of no slow walk";
    release(KeyCode::left_alt);
    EXPECT_EQ(tick().forward, 127);
    press(KeyCode::right_alt);
    EXPECT_EQ(tick().forward, 44);
}

}  // namespace
}  // namespace enfilade
