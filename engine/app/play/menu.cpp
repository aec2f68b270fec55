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

MenuAction Menu::handle_key(Key key, PlaySettings& settings) {
    switch (key) {
        case Key::escape: return MenuAction::resume;
        case Key::up:
        case Key::w: move(-1); return MenuAction::none;
        case Key::down:
        case Key::s: move(1); return MenuAction::none;
        case Key::left:
        case Key::a: return adjust(-1, settings);
        case Key::right:
        case Key::d: return adjust(1, settings);
        case Key::enter:
        case Key::space:
        case Key::e: return choose(settings);
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
    switch (static_cast<Entry>(chosen_)) {
        case Entry::resume: return MenuAction::resume;
        case Entry::restart: return MenuAction::restart;
        case Entry::quit: return MenuAction::quit;
        default: return adjust(1, settings);
    }
}

MenuAction Menu::adjust(int steps, PlaySettings& settings) {
    switch (static_cast<Entry>(chosen_)) {
        case Entry::fov: widen_view(settings, steps); return MenuAction::settings_changed;
        case Entry::mouse_speed:
            settings.mouse_speed = slide(settings.mouse_speed, steps, kMouseStep, kSlowestMouse, kFastestMouse);
            return MenuAction::settings_changed;
        case Entry::fullscreen: settings.fullscreen = !settings.fullscreen; return MenuAction::settings_changed;
        case Entry::true_pitch: settings.true_pitch = !settings.true_pitch; return MenuAction::settings_changed;
        case Entry::volume:
            settings.volume = slide(settings.volume, steps, kVolumeStep, 0, 1);
            return MenuAction::settings_changed;
        case Entry::pause: settings.pauses_unfocused = !settings.pauses_unfocused; return MenuAction::settings_changed;
        default: return MenuAction::none;
    }
}

void Menu::move(int steps) { chosen_ = (chosen_ + steps + kEntries) % kEntries; }

int Menu::entry_at(double x, double y) const {
    const auto under = std::ranges::find_if(boxes_, [&](const Box& box) { return box.contains(x, y); });
    return under == boxes_.end() ? -1 : int(under - boxes_.begin());
}

std::string Menu::label(Entry entry, const PlaySettings& settings) {
    switch (entry) {
        case Entry::resume: return "Resume";
        case Entry::restart: return "Restart map";
        case Entry::fov: return fmt::format("Field of view   < {:3.0f} >", settings.fov_degrees);
        case Entry::mouse_speed: return fmt::format("Mouse speed     < {:.1f} >", settings.mouse_speed);
        case Entry::fullscreen: return fmt::format("Full screen     < {:>3} >", settings.fullscreen ? "on" : "off");
        case Entry::true_pitch: return fmt::format("True pitch (F2) < {:>3} >", settings.true_pitch ? "on" : "off");
        case Entry::volume: return fmt::format("Volume          < {:3.0f} >", 100 * settings.volume);
        case Entry::pause: return fmt::format("Pause when away < {:>3} >", settings.pauses_unfocused ? "on" : "off");
        case Entry::quit: return "Quit";
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
        const std::string text = label(static_cast<Entry>(i), settings);
        const int width = std::max(overlay.text_width(text), overlay.width() / 3);
        boxes_[std::size_t(i)] = {(overlay.width() - width) / 2, top + i * pitch, width, pitch};
        draw_centered(overlay, top + i * pitch + pitch / 6, text, i == chosen_ ? kChosenInk : kInk);
    }
}

}  // namespace enfilade
