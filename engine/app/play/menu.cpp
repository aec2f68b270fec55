#include "app/play/menu.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/play/player_input.h"

namespace enfilade {
namespace {

constexpr Color kMenuShade = 0xC0000000, kTitleShade = 0x70000000, kPanel = 0xB0141C28, kChosenBar = 0xC0305890;

std::string title_of(MenuPage page) {
    switch (page) {
        case MenuPage::title: return "ENFILADE";
        case MenuPage::pause: return "PAUSE";
        case MenuPage::views: return "VIEWS";
        case MenuPage::options: return "OPTIONS";
        case MenuPage::controls: return "CONTROLS";
        case MenuPage::help: return "HELP";
    }
    return {};
}

void draw_centered(Overlay& overlay, int y, const std::string& text, Color color) {
    overlay.rimmed_text((overlay.width() - overlay.text_width(text)) / 2, y, text, color);
}

/// Rows are this high [lines].
constexpr double kRowLines = 1.4;

}  // namespace

MenuChoice Menu::handle(const InputEvent& event, Settings& settings) {
    if (!is_open()) return {};
    if (is_waiting_) return bind_key(event, settings);
    if (const auto* key = std::get_if<KeyChange>(&event))
        return key->down ? handle_key(key->key, settings) : MenuChoice();
    if (const auto* button = std::get_if<GamepadButtonChange>(&event))
        return button->down ? handle_button(button->button, settings) : MenuChoice();
    if (const auto* click = std::get_if<MouseButtonChange>(&event)) return handle_click(*click, settings);
    if (const auto* stick = std::get_if<GamepadAxisMotion>(&event)) push_stick(*stick, settings);
    if (const auto* motion = std::get_if<MouseMotion>(&event)) point_at(*motion);
    if (const auto* wheel = std::get_if<MouseWheel>(&event)) move(wheel->steps > 0 ? -1 : 1, settings);
    return {};
}

/// Where the pointer appears when it is let go is nobody's choice: only one that moves on points at anything.
void Menu::point_at(const MouseMotion& motion) {
    const int row = row_at(motion.x, motion.y);
    if (std::exchange(is_pointing_, true) && row >= 0) path_.back().chosen = row;
}

/// A stick that is pushed moves by one row until it is let go.
void Menu::push_stick(const GamepadAxisMotion& stick, const Settings& settings) {
    constexpr double kLetGo = 0.3, kPushed = 0.5;
    if (stick.axis != GamepadAxis::left_y) return;
    const bool is_pushed = std::abs(stick.value) > (is_stick_pushed_ ? kLetGo : kPushed);
    if (is_pushed && !is_stick_pushed_) move(stick.value > 0 ? 1 : -1, settings);
    is_stick_pushed_ = is_pushed;
}

MenuChoice Menu::handle_key(KeyCode key, Settings& settings) {
    switch (key) {
        case KeyCode::escape:
        case KeyCode::backspace: return leave();
        case KeyCode::up:
        case KeyCode::w: return move(-1, settings), MenuChoice();
        case KeyCode::down:
        case KeyCode::s: return move(1, settings), MenuChoice();
        case KeyCode::left:
        case KeyCode::a: return adjust(-1, settings);
        case KeyCode::right:
        case KeyCode::d: return adjust(1, settings);
        case KeyCode::enter:
        case KeyCode::space:
        case KeyCode::e: return choose(settings);
        case KeyCode::remove: return unbind(settings);
        default: return {};
    }
}

MenuChoice Menu::handle_button(GamepadButton button, Settings& settings) {
    switch (button) {
        case GamepadButton::start:
        case GamepadButton::b: return leave();
        case GamepadButton::up: return move(-1, settings), MenuChoice();
        case GamepadButton::down: return move(1, settings), MenuChoice();
        case GamepadButton::left: return adjust(-1, settings);
        case GamepadButton::right: return adjust(1, settings);
        case GamepadButton::a: return choose(settings);
        default: return {};
    }
}

MenuChoice Menu::handle_click(const MouseButtonChange& click, Settings& settings) {
    const int row = row_at(click.x, click.y);
    if (!click.down) return {};
    if (click.button == MouseButton::right && (row < 0 || !chosen_row(settings).setting)) return leave();
    if (row < 0) return {};
    path_.back().chosen = row;
    if (click.button == MouseButton::right) return adjust(-1, settings);
    return click.button == MouseButton::left ? choose(settings) : MenuChoice();
}

MenuChoice Menu::bind_key(const InputEvent& event, Settings& settings) {
    if (const auto* button = std::get_if<GamepadButtonChange>(&event); button && button->down) is_waiting_ = false;
    const auto key = as_key(event);
    if (!key || !key->down || key->key == KeyCode::unknown) return {};
    is_waiting_ = false;
    const MenuRow row = chosen_row(settings);
    if (key->key == KeyCode::escape || !row.binding) return {};
    bind(settings.bindings, *row.binding, key->key);
    return {MenuAction::settings_changed};
}

MenuChoice Menu::unbind(Settings& settings) {
    const MenuRow row = chosen_row(settings);
    if (!row.binding) return {};
    settings.bindings[static_cast<std::size_t>(*row.binding)] = {};
    return {MenuAction::settings_changed};
}

MenuChoice Menu::choose(Settings& settings) {
    const MenuRow row = chosen_row(settings);
    if (row.page) path_.push_back({*row.page, 0});
    if (row.binding) is_waiting_ = true;
    if (row.setting) return adjust(1, settings);
    return row.choice;
}

MenuChoice Menu::adjust(int steps, Settings& settings) {
    const MenuRow row = chosen_row(settings);
    if (!row.setting) return {};
    row.setting->turn(*row.setting, steps, settings);
    return {MenuAction::settings_changed};
}

MenuChoice Menu::leave() {
    if (path_.size() == 1) return {MenuAction::resume};
    path_.pop_back();
    return {};
}

void Menu::move(int steps, const Settings& settings) {
    const int count = static_cast<int>(rows_of(path_.back().page, settings, facts_).size());
    path_.back().chosen = ((path_.back().chosen + steps) % count + count) % count;
}

int Menu::row_at(double x, double y) const {
    const auto under = std::ranges::find_if(boxes_, [&](const RowBox& box) { return box.area.contains(x, y); });
    return under == boxes_.end() ? -1 : under->row;
}

MenuRow Menu::chosen_row(const Settings& settings) const {
    const auto rows = rows_of(path_.back().page, settings, facts_);
    return rows[static_cast<std::size_t>(std::clamp(path_.back().chosen, 0, static_cast<int>(rows.size()) - 1))];
}

void Menu::draw(Overlay& overlay, const Settings& settings) {
    if (!is_open()) return;
    const bool is_title = path_.back().page == MenuPage::title;
    overlay.fill({0, 0, overlay.width(), overlay.height()}, is_title ? kTitleShade : kMenuShade);
    const std::vector<MenuRow> rows = rows_of(path_.back().page, settings, facts_);
    const int line = overlay.line_height();
    draw_title(overlay);
    const bool has_values = std::ranges::any_of(rows, [](const MenuRow& row) { return !row.value.empty(); });
    const int width = std::min(overlay.width() - line, overlay.text_width("M") * (has_values ? 62 : 30));
    const Rect area{(overlay.width() - width) / 2, 3 * line, width, overlay.height() - 7 * line};
    draw_rows(overlay, rows, area);
    const std::string hint =
        is_waiting_ ? "Press the key or mouse button for it; Esc leaves it as it is." : chosen_row(settings).hint;
    int y = overlay.height() - 3 * line - line / 2;
    for (const std::string& piece : wrapped(hint, std::size_t(std::max(8, width / overlay.text_width("M"))))) {
        draw_centered(overlay, y, piece, kHintInk);
        y += line;
    }
}

/// The name of the program three times as large as all else.
void Menu::draw_title(Overlay& overlay) const {
    const std::string title = title_of(path_.back().page);
    if (path_.back().page != MenuPage::title) return draw_centered(overlay, overlay.line_height(), title, kTitleInk);
    Overlay large = overlay.scaled(3);
    draw_centered(large, overlay.height() / 8, title, kTitleInk);
}

/// As many rows as fit, the chosen one among them, in the middle of the area.
void Menu::draw_rows(Overlay& overlay, const std::vector<MenuRow>& rows, const Rect& area) {
    const int pitch = static_cast<int>(overlay.line_height() * kRowLines), count = static_cast<int>(rows.size());
    const int shown = std::clamp(area.height / pitch, 1, count);
    const int first = std::clamp(path_.back().chosen - shown / 2, 0, count - shown);
    const int top = area.top + (area.height - shown * pitch) / 2;
    overlay.fill({area.left, top - pitch / 4, area.width, shown * pitch + pitch / 2}, kPanel);
    boxes_.clear();
    for (int i = first; i < first + shown; ++i) {
        const Rect box{area.left, top + (i - first) * pitch, area.width, pitch};
        boxes_.push_back({box, i});
        draw_row(overlay, rows[static_cast<std::size_t>(i)], box, i == path_.back().chosen);
    }
    const int arrow = area.left + area.width - 2 * overlay.text_width("M");
    if (first > 0) overlay.rimmed_text(arrow, top - pitch, "^", kHintInk);
    if (first + shown < count) overlay.rimmed_text(arrow, top + shown * pitch + pitch / 4, "v", kHintInk);
}

void Menu::draw_row(Overlay& overlay, const MenuRow& row, const Rect& area, bool is_chosen) const {
    const int margin = overlay.text_width("M"), y = area.top + (area.height - overlay.line_height()) / 2;
    if (is_chosen) overlay.fill(area, kChosenBar);
    const Color ink = is_chosen ? kChosenInk : kInk;
    if (row.value.empty() && !row.setting && !row.binding) return draw_centered(overlay, y, row.label, ink);
    overlay.rimmed_text(area.left + margin, y, row.label, ink);
    const bool waits = is_chosen && is_waiting_;
    const std::string value = waits ? "..." : row.setting && is_chosen ? "< " + row.value + " >" : row.value;
    const int indent = row.setting && is_chosen ? 2 * overlay.text_width("<") : 0;
    overlay.rimmed_text(area.left + area.width / 2 - indent, y, value, is_chosen ? kChosenInk : kValueInk);
}

}  // namespace enfilade
