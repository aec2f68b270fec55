// The menu, by keyboard, mouse and gamepad.
#include "app/play/menu.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace enfilade {
namespace {

using ::testing::HasSubstr;

class OpenMenu : public ::testing::Test {
protected:
    OpenMenu() {
        menu_.open(MenuPage::pause);
        frame_.resize(640, 400);
        draw();
    }

    void draw() {
        std::ranges::fill(frame_.pixels, 0xFF000000);
        Overlay overlay(frame_, font_);
        menu_.draw(overlay, settings_);
    }
    MenuAction press(KeyCode key) { return menu_.handle(KeyChange{key, true, false}, settings_).action; }
    MenuAction press(GamepadButton button) { return menu_.handle(GamepadButtonChange{button, true}, settings_).action; }
    MenuAction push(double y) { return menu_.handle(GamepadAxisMotion{GamepadAxis::left_y, y}, settings_).action; }
    MenuAction click(double x, double y, MouseButton button = MouseButton::left) {
        return menu_.handle(MouseButtonChange{button, true, x, y}, settings_).action;
    }
    /// Goes to the row of that label on a page, by keys.
    void go_to(MenuPage page, const std::string& label) {
        menu_.open(page);
        const auto rows = rows_of(page, settings_, {});
        const auto found = std::ranges::find(rows, label, &MenuRow::label);
        ASSERT_NE(found, rows.end()) << label;
        for (auto i = rows.begin(); i != found; ++i) press(KeyCode::down);
    }
    MenuAction choose(MenuPage page, const std::string& label) {
        go_to(page, label);
        return press(KeyCode::enter);
    }

    Menu menu_;
    Settings settings_;
    Frame frame_;
    Font font_;
};

TEST_F(OpenMenu, ResumesWithEscape) { EXPECT_EQ(press(KeyCode::escape), MenuAction::resume); }

TEST_F(OpenMenu, ResumesWithItsFirstRow) { EXPECT_EQ(press(KeyCode::enter), MenuAction::resume); }

TEST_F(OpenMenu, DoesWhatItsRowsSay) {
    EXPECT_EQ(choose(MenuPage::pause, "Save game"), MenuAction::save);
    EXPECT_EQ(choose(MenuPage::pause, "Load game"), MenuAction::load);
    EXPECT_EQ(choose(MenuPage::pause, "Restart map"), MenuAction::restart);
    EXPECT_EQ(choose(MenuPage::pause, "Title screen"), MenuAction::to_title);
    EXPECT_EQ(choose(MenuPage::title, "Maps"), MenuAction::maps);
}

TEST_F(OpenMenu, QuitsWithItsLastRowReachedUpward) {
    press(KeyCode::up);
    EXPECT_EQ(press(KeyCode::enter), MenuAction::quit);
}

TEST_F(OpenMenu, GoesIntoPagesAndBack) {
    choose(MenuPage::pause, "Options");
    press(KeyCode::right);
    EXPECT_EQ(settings_.renderer, RendererKind::stencil) << "the first of the options";
    EXPECT_EQ(press(KeyCode::escape), MenuAction::none);
    EXPECT_EQ(press(KeyCode::escape), MenuAction::resume);
}

TEST_F(OpenMenu, TurnsASettingBothWays) {
    go_to(MenuPage::options, "Field of view");
    EXPECT_EQ(press(KeyCode::right), MenuAction::settings_changed);
    EXPECT_EQ(settings_.fov_degrees, 95);
    press(KeyCode::left), press(KeyCode::left);
    EXPECT_EQ(settings_.fov_degrees, 85);
}

TEST_F(OpenMenu, HasARowForEverySetting) {
    const auto rows = rows_of(MenuPage::options, settings_, {});
    ASSERT_EQ(rows.size(), all_settings().size());
    for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i].setting, &all_settings()[i]);
}

TEST_F(OpenMenu, SaysWhyTruePitchIsNotSeen) {
    settings_.true_pitch = true;
    const auto rows = rows_of(MenuPage::options, settings_, {});
    EXPECT_THAT(std::ranges::find(rows, "True pitch", &MenuRow::label)->value, HasSubstr("by stencil only"));
}

TEST_F(OpenMenu, BindsTheNextKeyThatIsPressed) {
    choose(MenuPage::controls, "Use");
    EXPECT_EQ(press(KeyCode::q), MenuAction::settings_changed);
    EXPECT_EQ(keys_for(settings_.bindings, Control::use), (ControlKeys{KeyCode::q, KeyCode::e}));
}

TEST_F(OpenMenu, BindsAMouseButton) {
    choose(MenuPage::controls, "Use");
    EXPECT_EQ(click(0, 0, MouseButton::right), MenuAction::settings_changed);
    EXPECT_EQ(keys_for(settings_.bindings, Control::use)[0], KeyCode::mouse_right);
}

TEST_F(OpenMenu, LeavesTheKeysAsTheyAreWithEscape) {
    choose(MenuPage::controls, "Use");
    EXPECT_EQ(press(KeyCode::escape), MenuAction::none);
    EXPECT_EQ(settings_.bindings, usual_bindings());
    EXPECT_EQ(press(KeyCode::escape), MenuAction::resume) << "it waits for no key any more";
}

TEST_F(OpenMenu, TakesKeysAwayWithDelete) {
    go_to(MenuPage::controls, "Use");
    EXPECT_EQ(press(KeyCode::remove), MenuAction::settings_changed);
    EXPECT_EQ(keys_text(keys_for(settings_.bindings, Control::use)), "none");
}

TEST_F(OpenMenu, NamesTheViewsThatFunctionKeysOpen) {
    go_to(MenuPage::views, "Fly through walls");
    const MenuChoice choice = menu_.handle(KeyChange{KeyCode::enter, true, false}, settings_);
    EXPECT_EQ(choice, (MenuChoice{MenuAction::control, Control::fly}));
}

TEST_F(OpenMenu, OffersToGoOnOnlyWhereThereIsAGame) {
    EXPECT_EQ(rows_of(MenuPage::title, settings_, {})[0].label, "Maps");
    EXPECT_EQ(rows_of(MenuPage::title, settings_, {"palace"})[0].label, "Continue");
}

TEST_F(OpenMenu, WorksWithTheGamepad) {
    press(GamepadButton::down);
    EXPECT_EQ(press(GamepadButton::a), MenuAction::save);
    EXPECT_EQ(press(GamepadButton::start), MenuAction::resume);
}

TEST_F(OpenMenu, MovesOneRowForAPushOfTheStick) {
    for (const double y : {0.4, 0.7, 1.0, 0.6, 0.4}) push(y);
    EXPECT_EQ(press(GamepadButton::a), MenuAction::save);
    push(0), push(0.9);
    EXPECT_EQ(press(GamepadButton::a), MenuAction::load);
}

TEST_F(OpenMenu, ChoosesTheRowThatIsClicked) {
    // Ten rows of 18 px in the middle of what lies between row 39 and row 348: the second begins 4 rows above it.
    const int middle = 3 * 13 + (400 - 7 * 13) / 2;
    EXPECT_EQ(click(320, middle - 4 * 18 + 5), MenuAction::save);
    EXPECT_EQ(click(5, 5), MenuAction::none);
}

TEST_F(OpenMenu, FollowsAPointerThatMovesAndNotOneThatIsJustThere) {
    const double middle = 3 * 13 + (400 - 7 * 13) / 2.0;
    const auto point = [&](int row) { menu_.handle(MouseMotion{0, 1, 320, middle + (row - 5) * 18 + 5}, settings_); };
    point(1);
    EXPECT_EQ(press(KeyCode::enter), MenuAction::resume);
    point(2);
    EXPECT_EQ(press(KeyCode::enter), MenuAction::load);
}

TEST_F(OpenMenu, ShowsTheChosenRowWhereNotAllFit) {
    frame_.resize(320, 200);
    go_to(MenuPage::controls, "Save a picture");
    draw();
    constexpr Color kInk = 0xFFFFFFFF;
    EXPECT_GT(std::count(frame_.pixels.begin() + 60 * 320, frame_.pixels.begin() + 150 * 320, kInk), 30);
}

TEST_F(OpenMenu, IgnoresKeysThatAreLetGo) {
    EXPECT_EQ(menu_.handle(KeyChange{KeyCode::escape, false, false}, settings_).action, MenuAction::none);
}

TEST(Menu, IgnoresEverythingWhileClosed) {
    Menu menu;
    Settings settings;
    EXPECT_EQ(menu.handle(KeyChange{KeyCode::enter, true, false}, settings).action, MenuAction::none);
}

}  // namespace
}  // namespace enfilade
