// How evenly pictures come while one plays: `frame_pacing MAP [SECONDS [HZ]]` walks and turns in the map for so long
// (by default 30 s at 60 Hz), in a window of 1280 x 800 px on the display there is (SDL_VIDEODRIVER=dummy: one that
// nobody sees), with the pace kept by the frame limit. Prints how many pictures were shown within 2 ms of their time,
// which is a period after the picture before, and how late the latest were [ms].
#include <SDL.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "app/play/play_loop.h"
#include "platform/clock.h"

using namespace enfilade;

namespace {

constexpr double kAllowed_ms = 2;
constexpr std::size_t kFirstPictures = 30;  ///< while memory grows and the slowest picture is not known

/// Shows pictures by a real window, and notes when.
class TimedWindow final : public Window {
public:
    TimedWindow(std::unique_ptr<Window> window, double seconds, double hz)
        : window_(std::move(window)), wanted_(kFirstPictures + static_cast<std::size_t>(seconds * hz)) {}

    void poll(std::vector<InputEvent>& events) override {
        walk_on();
        window_->poll(events);
    }
    Result<void> present(const Frame& frame) override {
        shown_ns_.push_back(now_ns());
        return window_->present(frame);
    }
    PixelSize size() const override { return window_->size(); }
    void grab_mouse(bool grab) override { window_->grab_mouse(grab); }
    bool mouse_grabbed() const override { return window_->mouse_grabbed(); }
    void set_title(const std::string& title) override { window_->set_title(title); }
    void set_fullscreen(bool fullscreen) override { window_->set_fullscreen(fullscreen); }
    bool fullscreen() const override { return window_->fullscreen(); }
    double refresh_hz() const override { return window_->refresh_hz(); }

    /// From each picture to the next, without the first ones [ms].
    std::vector<double> intervals_ms() const {
        std::vector<double> intervals;
        for (std::size_t i = kFirstPictures; i < shown_ns_.size(); ++i)
            intervals.push_back(static_cast<double>(shown_ns_[i] - shown_ns_[i - 1]) * 1e-6);
        return intervals;
    }

private:
    /// Keys are held that walk and turn; the way is turned now and then, so that no wall ends it.
    void walk_on() {
        constexpr std::size_t kOneWay = 90;  // pictures
        if (shown_ns_.empty()) push_key(SDL_SCANCODE_W, true);
        const bool left = shown_ns_.size() / kOneWay % 2 == 0;
        push_key(left ? SDL_SCANCODE_LEFT : SDL_SCANCODE_RIGHT, true);
        push_key(left ? SDL_SCANCODE_RIGHT : SDL_SCANCODE_LEFT, false);
        if (shown_ns_.size() < wanted_) return;
        SDL_Event quit{};
        quit.type = SDL_QUIT;
        SDL_PushEvent(&quit);
    }
    static void push_key(SDL_Scancode code, bool is_down) {
        SDL_Event event{};
        event.type = is_down ? SDL_KEYDOWN : SDL_KEYUP;
        event.key.keysym.scancode = code;
        SDL_PushEvent(&event);
    }

    std::unique_ptr<Window> window_;
    std::size_t wanted_;
    std::vector<std::int64_t> shown_ns_;
};

int complain(const std::string& why) {
    std::fprintf(stderr, "frame_pacing: %s\n", why.c_str());
    return 1;
}

void print(const char* map, std::vector<double> late_ms) {
    const auto on_time = std::ranges::count_if(late_ms, [](double late) { return std::fabs(late) <= kAllowed_ms; });
    std::ranges::sort(late_ms);
    const auto part = [&](double share) {
        return late_ms[static_cast<std::size_t>(share * static_cast<double>(late_ms.size() - 1))];
    };
    std::printf("%s: %zu pictures, %.2f %% within %.0f ms; late by %.2f ms (99 %%), %.2f ms (the latest)\n", map,
                late_ms.size(), 100 * static_cast<double>(on_time) / static_cast<double>(late_ms.size()), kAllowed_ms,
                part(0.99), part(1));
}

}  // namespace

int main(int count, char** words) {
    if (count < 2) return complain("expected frame_pacing MAP [SECONDS [HZ]]");
    const double seconds = count > 2 ? std::atof(words[2]) : 30, hz = count > 3 ? std::atof(words[3]) : 60;
    auto opened = open_window({"frame_pacing"});
    if (!opened.ok()) return complain(opened.error().text());
    auto game = Game::start(words[1], {});
    if (!game.ok()) return complain(game.error().text());
    Settings settings;
    settings.vsync = false;
    settings.frame_limit = hz;
    settings.size = PictureSize{1280, 800};
    SettingsStore store;
    store.change_for_now(settings);
    PlayOptions options;
    options.mute = true;
    TimedWindow window(std::move(opened).value(), seconds, hz);
    if (const Result<void> done = PlayLoop(*game.value(), window, store, options).run(); !done.ok())
        return complain(done.error().text());
    std::vector<double> late_ms = window.intervals_ms();
    if (late_ms.empty()) return complain("no picture was shown");
    for (double& interval : late_ms) interval -= 1000 / hz;
    print(words[1], std::move(late_ms));
}
