// The menu behind Escape: driven by keyboard, mouse or gamepad, drawn over the picture.
#pragma once
#include <array>

#include "app/draw/overlay.h"
#include "app/play/settings.h"
#include "platform/input_event.h"

namespace enfilade {

/// What choosing in the menu asks the game to do.
enum class MenuAction : std::uint8_t { none, resume, restart, settings_changed, quit };

class Menu {
public:
    bool is_open() const { return open_; }
    /// Opens with the first entry chosen.
    void open();
    void close() { open_ = false; }

    /// Takes one event; changes settings where it moves a slider. Ignores everything while closed.
    MenuAction handle(const InputEvent& event, PlaySettings& settings);

    /// The scale at which all of the menu fits into a picture of this height.
    static int scale_for(int height_px);

    /// Remembers where the entries are, so that the mouse can point at them. Draws nothing while closed.
    void draw(Overlay& overlay, const PlaySettings& settings);

private:
    enum class MenuEntry : std::uint8_t {
        resume,
        restart,
        fov,
        mouse_speed,
        fullscreen,
        true_pitch,
        volume,
        pause,
        quit
    };
    static constexpr int kEntries = 9;

    MenuAction handle_key(KeyCode key, PlaySettings& settings);
    MenuAction handle_button(GamepadButton button, PlaySettings& settings);
    MenuAction handle_click(const MouseButtonChange& click, PlaySettings& settings);
    MenuAction choose(PlaySettings& settings);
    MenuAction adjust(int steps, PlaySettings& settings);
    void move(int steps);
    /// The entry under a point, or -1.
    int entry_at(double x, double y) const;
    static std::string label(MenuEntry entry, const PlaySettings& settings);

    bool open_ = false;
    int chosen_ = 0;
    std::array<Rect, kEntries> boxes_{};
};

}  // namespace enfilade
