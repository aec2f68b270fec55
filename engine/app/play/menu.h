// The menu of the title screen and behind Escape: pages of rows, driven by keyboard, mouse or gamepad, drawn over the
// picture.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/draw/overlay.h"
#include "app/play/settings.h"
#include "platform/input_event.h"

namespace enfilade {

enum class MenuPage : std::uint8_t { title, pause, views, options, controls, help };

/// What choosing a row asks for.
enum class MenuAction : std::uint8_t {
    none,
    resume,
    restart,
    save,
    load,
    control,   ///< MenuChoice::control, as if its key were pressed
    go_on,     ///< with the game that was played last
    maps,      ///< to the list of maps
    to_title,  ///< out of the game
    settings_changed,
    quit
};

struct MenuChoice {
    MenuAction action = MenuAction::none;
    Control control = Control::forward;
    bool operator==(const MenuChoice&) const = default;
};

/// What rows say that is no setting.
struct MenuFacts {
    std::string last_map;  ///< the name of the map that one may go on in; empty: none
};

/// One row of a page. What it does, at most one of: a choice, a page, a setting, a binding; none of them: it is to
/// read.
struct MenuRow {
    std::string label;
    std::string value{};  ///< in a column of its own; may be empty
    std::string hint{};   ///< shown below the page while the row is chosen
    MenuChoice choice{};
    std::optional<MenuPage> page{};
    const Setting* setting = nullptr;
    std::optional<Control> binding{};
};

std::vector<MenuRow> rows_of(MenuPage page, const Settings& settings, const MenuFacts& facts);

/// What all keys do, as pairs: the keys, and what they do.
std::vector<std::pair<std::string, std::string>> key_lines(const Bindings& bindings);

class Menu {
public:
    bool is_open() const { return !path_.empty(); }
    /// Opens a page with its first row chosen; leaving it closes the menu.
    void open(MenuPage page) { path_ = {{page, 0}}, is_waiting_ = is_pointing_ = false; }
    void close() { path_.clear(); }
    void set_facts(MenuFacts facts) { facts_ = std::move(facts); }

    /// Takes one event; changes settings where it turns or binds one. Ignores everything while closed. Leaving the
    /// first page asks to resume.
    MenuChoice handle(const InputEvent& event, Settings& settings);

    /// Remembers where the rows are, so that the mouse can point at them. Draws nothing while closed.
    void draw(Overlay& overlay, const Settings& settings);

private:
    struct OpenPage {
        MenuPage page;
        int chosen;
    };
    struct RowBox {
        Rect area;
        int row;
    };

    MenuChoice handle_key(KeyCode key, Settings& settings);
    MenuChoice handle_button(GamepadButton button, Settings& settings);
    MenuChoice handle_click(const MouseButtonChange& click, Settings& settings);
    void push_stick(const GamepadAxisMotion& stick, const Settings& settings);
    MenuChoice bind_key(const InputEvent& event, Settings& settings);
    MenuChoice choose(Settings& settings);
    MenuChoice adjust(int steps, Settings& settings);
    MenuChoice unbind(Settings& settings);
    MenuChoice leave();
    void move(int steps, const Settings& settings);
    /// The row under a point, or -1.
    int row_at(double x, double y) const;
    MenuRow chosen_row(const Settings& settings) const;
    void point_at(const MouseMotion& motion);
    void draw_title(Overlay& overlay) const;
    void draw_rows(Overlay& overlay, const std::vector<MenuRow>& rows, const Rect& area);
    void draw_row(Overlay& overlay, const MenuRow& row, const Rect& area, bool is_chosen) const;

    std::vector<OpenPage> path_;  ///< of pages, the open one last; empty: closed
    MenuFacts facts_;
    bool is_waiting_ = false;  ///< for the key that shall be bound
    bool is_stick_pushed_ = false;
    bool is_pointing_ = false;   ///< the pointer has moved since the menu was opened
    std::vector<RowBox> boxes_;  ///< of the rows that were drawn last
};

}  // namespace enfilade
