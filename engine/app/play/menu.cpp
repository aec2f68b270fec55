#include "app/play/menu.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace enfilade {
namespace {

constexpr Color kShadow = 0xB0000000, kInk = 0xFFC8C8C8, kChosenInk = 0xFF60D8FF, kTitleInk = 0xFFFFFFFF;

void draw_centered(Overlay& overlay, int y, const std::string& text, Color color) {
    overlay.rimmed_text((overlay.width() - overlay.text_width(text)) / 2, y, text, color);
}

}  // namespace

void Menu::open() {
    open_ = true;
    chosen_ = 0;
}

MenuAction Menu::handle(const InputEvent& event, PlaySettings& settings) {
    if (!open_) return MenuAction::none;
    if (const auto* key = std::get_if<KeyChange>(&event))
        return key->down ? handle_key(key->key, settings) : MenuAction::none;
    if (const auto* button = std::get_if<GamepadButtonChange>(&event))
        return button->down ? handle_button(button->button, settings) : MenuAction::none;
    if (const auto* click = std::get_if<MouseButtonChange>(&event)) return handle_click(*click, settings);
    if (const auto* motion = std::get_if<MouseMotion>(&event))
        if (const int entry = entry_at(motion->x, motion->y); entry >= 0) chosen_ = entry;
    if (const auto* wheel = std::get_if<MouseWheel>(&event)) return adjust(wheel->steps > 0 ? 1 : -1, settings);
    return MenuAction::none;
}

MenuAction Menu::handle_key(KeyCode key, PlaySettings& settings) {
    switch (key) {
        case KeyCode::escape: return MenuAction::resume;
        case KeyCode::up:
        case KeyCode::w: move(-1); return MenuAction::none;
        case KeyCode::down:
        case KeyCode::s: move(1); return MenuAction::none;
        case KeyCode::left:
        case KeyCode::a: return adjust(-1, settings);
        case KeyCode::right:
        case KeyCode::d: return adjust(1, settings);
        case KeyCode::enter:
        case KeyCode::space:
        case KeyCode::e: return choose(settings);
        default: return MenuAction::none;
    }
}

MenuAction Menu::handle_button(GamepadButton button, PlaySettings& settings) {
    switch (button) {
        case GamepadButton::start:
        case GamepadButton::b: return MenuAction::resume;
        case GamepadButton::up: move(-1); return MenuAction::none;
        case GamepadButton::down: move(1); return MenuAction::none;
        case GamepadButton::left: return adjust(-1, settings);
        case GamepadButton::right: return adjust(1, settings);
        case GamepadButton::a: return choose(settings);
        default: return MenuAction::none;
    }
}

MenuAction Menu::handle_click(const MouseButtonChange& click, PlaySettings& settings) {
    const int entry = entry_at(click.x, click.y);
    if (!click.down || entry < 0) return MenuAction::none;
    chosen_ = entry;
    if (click.button == MouseButton::right) return adjust(-1, settings);
    return click.button == MouseButton::left ? choose(settings) : MenuAction::none;
}

MenuAction Menu::choose(PlaySettings& settings) {
    switch (static_cast<MenuEntry>(chosen_)) {
        case MenuEntry::resume: return MenuAction::resume;
        case MenuEntry::restart: return MenuAction::restart;
        case MenuEntry::quit: return MenuAction::quit;
        default: return adjust(1, settings);
    }
}

MenuAction Menu::adjust(int steps, PlaySettings& settings) {
    switch (static_cast<MenuEntry>(chosen_)) {
        case MenuEntry::fov: widen_view(settings, steps); return MenuAction::settings_changed;
        case MenuEntry::mouse_speed:
            settings.mouse_speed = slide(settings.mouse_speed, steps, kMouseStep, kSlowestMouse, kFastestMouse);
            return MenuAction::settings_changed;
        case MenuEntry::fullscreen: settings.fullscreen = !settings.fullscreen; return MenuAction::settings_changed;
        case MenuEntry::true_pitch: settings.true_pitch = !settings.true_pitch; return MenuAction::settings_changed;
        case MenuEntry::volume:
            settings.volume = slide(settings.volume, steps, kVolumeStep, 0, 1);
            return MenuAction::settings_changed;
        case MenuEntry::pause:
            settings.pauses_unfocused = !settings.pauses_unfocused;
            return MenuAction::settings_changed;
        default: return MenuAction::none;
    }
}

void Menu::move(int steps) { chosen_ = (chosen_ + steps + kEntries) % kEntries; }

int Menu::entry_at(double x, double y) const {
    const auto under = std::ranges::find_if(boxes_, [&](const Rect& box) { return box.contains(x, y); });
    return under == boxes_.end() ? -1 : int(under - boxes_.begin());
}

std::string Menu::label(MenuEntry entry, const PlaySettings& settings) {
    switch (entry) {
        case MenuEntry::resume: return "Resume";
        case MenuEntry::restart: return "Restart map";
        case MenuEntry::fov: return fmt::format("Field of view   < {:3.0f} >", settings.fov_degrees);
        case MenuEntry::mouse_speed: return fmt::format("Mouse speed     < {:.1f} >", settings.mouse_speed);
        case MenuEntry::fullscreen: return fmt::format("Full screen     < {:>3} >", settings.fullscreen ? "on" : "off");
        case MenuEntry::true_pitch: return fmt::format("True pitch (F2) < {:>3} >", settings.true_pitch ? "on" : "off");
        case MenuEntry::volume: return fmt::format("Volume          < {:3.0f} >", 100 * settings.volume);
        case MenuEntry::pause:
            return fmt::format("Pause when away < {:>3} >", settings.pauses_unfocused ? "on" : "off");
        case MenuEntry::quit: return "Quit";
    }
    return {};
}

int Menu::scale_for(int height_px) {
    constexpr int kLines = kEntries + 4;  // the title, the space below it, and a rim
    return std::clamp(height_px / (kLines * Font::kHeight * 3 / 2), 1, comfortable_scale(height_px) + 1);
}

void Menu::draw(Overlay& overlay, const PlaySettings& settings) {
    if (!open_) return;
    overlay.fill({0, 0, overlay.width(), overlay.height()}, kShadow);
    const int pitch = overlay.line_height() * 3 / 2, top = (overlay.height() - pitch * kEntries) / 2;
    draw_centered(overlay, top - 2 * pitch, "ENFILADE", kTitleInk);
    for (int i = 0; i < kEntries; ++i) {
        const std::string text = label(static_cast<MenuEntry>(i), settings);
        const int width = std::max(overlay.text_width(text), overlay.width() / 3);
        boxes_[std::size_t(i)] = {(overlay.width() - width) / 2, top + i * pitch, width, pitch};
        draw_centered(overlay, top + i * pitch + pitch / 6, text, i == chosen_ ? kChosenInk : kInk);
    }
}

}  // namespace enfilade
