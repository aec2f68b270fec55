#include "app/play/play_loop.h"

#include <algorithm>

#include "base/attempt.h"
#include "platform/clock.h"

namespace enfilade {
namespace {

constexpr std::int64_t kTick = kSecond / kTickRate;   ///< [ns]
constexpr std::int64_t kMostToCatchUp = kSecond / 4;  ///< after a longer pause the world just goes on [ns]
constexpr double kWelcomeSeconds = 6;

/// While R is held time runs backwards this fast [ticks a tick].
constexpr std::size_t kRewindSpeed = 2;

/// A display that is waited for sets the pace; the limit only keeps those from racing that do not wait after all.
constexpr double kSpareForDisplay = 1.25;

}  // namespace

PlayLoop::PlayLoop(Game& game, Window& window, SettingsStore& store, const PlayOptions& options,
                   std::unique_ptr<Renderer> renderer)
    : game_(game),
      window_(window),
      store_(store),
      options_(options),
      renderer_(std::move(renderer)),
      outside_renderer_(std::make_unique<OutsideRenderer>(game.map(), game.textures())),
      stillness_(game.map()),
      drawn_by_(store.now().renderer) {}

Result<void> PlayLoop::run() {
    Result<void> ended;
    if (const Result<void> unbroken = attempt([&] { ended = play(); }); !unbroken.ok()) ended = unbroken;
    if (!ended.ok()) return save_what_was_played(ended.error());
    return {};
}

void PlayLoop::begin() {
    started_ns_ = passed_until_ns_ = ticked_until_ns_ = looked_ns_ = acted_ns_ = now_ns();
    hurt_ns_ = died_ns_ = started_ns_ - kSecond;
    last_health_ = game_.world().health;
    input_.obey(settings());
    if (!renderer_) use_or_replace(settings().renderer);
    window_.grab_mouse(true);
    notices_.say("F1: keys   Esc: menu   Tab: map", 0, kWelcomeSeconds);
    for (const std::string& note : store_.notes()) notices_.say(note, 0, 2 * kWelcomeSeconds);
    tell_warnings();
    begin_sounds();
}

Result<void> PlayLoop::play() {
    if (!options_.tape.empty())
        if (const Result<void> done = game_.record(options_.tape); !done.ok()) return done.error();
    begin();
    std::vector<InputEvent> events;
    while (!quit_ && !to_title_) {
        set_pace(now_ns());
        sleep_until_ns(pacing_.begin());
        const std::int64_t now = began_ns_ = now_ns();
        events.clear();
        window_.poll(events);
        if (!events.empty()) is_changed_ = true, acted_ns_ = now;
        for (const InputEvent& event : events) handle(event);
        look_for_changes(now);
        pass_time(now);
        hear();
        if (const Result<void> done = show(now); !done.ok()) return done.error();
        pacing_.go_on(now_ns());
    }
    if (const Result<void> done = store_.save(); !done.ok()) tell(done.error().text());
    game_.end_recording();
    if (const auto fault = game_.take_recording_fault()) return *fault;
    return {};
}

void PlayLoop::set_pace(std::int64_t now) {
    double hz = settings().frame_limit > 0 ? settings().frame_limit : window_.refresh_hz();
    if (window_.waits_for_display() && hz >= window_.refresh_hz()) hz = window_.refresh_hz() * kSpareForDisplay;
    if (is_paused() && now - acted_ns_ > kUntilIdle) hz = std::min(hz, kIdleHz);
    if (window_.is_hidden()) hz = std::min(hz, kHiddenHz);
    pacing_.set_period(static_cast<std::int64_t>(kSecond / hz));
}

double PlayLoop::now_s() const { return static_cast<double>(now_ns() - started_ns_) / kSecond; }

double PlayLoop::part_of_tick(std::int64_t now) const { return static_cast<double>(now - ticked_until_ns_) / kTick; }

void PlayLoop::tell(const std::string& text) { notices_.say(text, now_s()); }

void PlayLoop::pass_time(std::int64_t now) {
    if (is_paused()) ticked_until_ns_ += now - passed_until_ns_;
    passed_until_ns_ = now;
    ticked_until_ns_ = std::max(ticked_until_ns_, now - kMostToCatchUp);
    if (!rewinding_) rewound_ticks_ = 0;
    for (; now - ticked_until_ns_ >= kTick && !end_; ticked_until_ns_ += kTick) {
        const TickInput input =
            input_.take_tick(free_camera_ ? free_camera_->eye().pitch_steps : game_.player().pitch_steps);
        if (rewinding_) {
            const std::uint64_t before = game_.world().tick;
            game_.rewind(kRewindSpeed);
            rewound_ticks_ += before - game_.world().tick;
        } else {
            if (free_camera_) free_camera_->move(game_.map(), input);
            game_.tick(free_camera_ ? TickInput() : input);
        }
    }
    follow_events();
    follow_health(now);
}

}  // namespace enfilade
