// A real window, on a display that nobody looks at, in front of which a test sits: it presses keys when so many
// pictures have been shown, and keeps the pictures.
#pragma once
#include <SDL.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "platform/window.h"

namespace enfilade::test {

class DrivenWindow : public Window {
public:
    DrivenWindow() {
        setenv("SDL_VIDEODRIVER", "dummy", 1);
        auto opened = open_window({"test", 320, 200, false});
        EXPECT_TRUE(opened.ok()) << opened.error().text();
        window_ = std::move(opened).value();
    }

    /// When so many pictures were shown, this is done. Returns the number, to be counted on from.
    int after(int pictures, std::function<void()> call) {
        calls_[pictures].push_back(std::move(call));
        return pictures;
    }
    void press_after(int pictures, SDL_Scancode code) {
        after(pictures, [this, code] { key(code, true), key(code, false); });
    }
    void key(SDL_Scancode code, bool down) const {
        SDL_Event event{};
        event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
        event.key.keysym.scancode = code;
        SDL_PushEvent(&event);
    }
    void wheel(int steps) const {
        SDL_Event event{};
        event.type = SDL_MOUSEWHEEL;
        event.wheel.y = steps;
        event.wheel.preciseY = float(steps);
        SDL_PushEvent(&event);
    }
    void lose_focus() const {
        SDL_Event event{};
        event.type = SDL_WINDOWEVENT;
        event.window.event = SDL_WINDOWEVENT_FOCUS_LOST;
        SDL_PushEvent(&event);
    }
    void quit_after(int pictures) {
        after(pictures, [] {
            SDL_Event event{};
            event.type = SDL_QUIT;
            SDL_PushEvent(&event);
        });
    }

    /// The picture that was shown as the n-th, counted from 1.
    const Frame& picture(int number) const { return pictures_.at(std::size_t(number - 1)); }

    /// What was not shown anew is still there: it counts as one more picture.
    void poll(std::vector<InputEvent>& events) override {
        if (!is_fresh_ && !pictures_.empty()) pictures_.push_back(Frame(pictures_.back()));
        is_fresh_ = false;
        for (const auto& call : calls_[int(pictures_.size())]) call();
        window_->poll(events);
    }
    Result<void> present(const Frame& frame) override {
        pictures_.push_back(frame);
        ++shown_;
        is_fresh_ = true;
        return window_->present(frame);
    }
    /// How many pictures were shown anew.
    int shown() const { return shown_; }
    PixelSize size() const override { return window_->size(); }
    void grab_mouse(bool grab) override { window_->grab_mouse(grab); }
    bool mouse_grabbed() const override { return window_->mouse_grabbed(); }
    void set_title(const std::string& title) override { window_->set_title(title); }
    void set_fullscreen(bool fullscreen) override { window_->set_fullscreen(fullscreen); }
    bool fullscreen() const override { return window_->fullscreen(); }
    double refresh_hz() const override { return 1000; }

private:
    std::unique_ptr<Window> window_;
    std::map<int, std::vector<std::function<void()>>> calls_;
    std::vector<Frame> pictures_;
    int shown_ = 0;
    bool is_fresh_ = false;
};

}  // namespace enfilade::test
