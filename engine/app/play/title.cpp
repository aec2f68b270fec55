#include "app/play/title.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "app/file_kind.h"
#include "app/open_map.h"
#include "app/options.h"
#include "app/play/saved_game.h"
#include "base/attempt.h"
#include "base/parallel.h"
#include "platform/clock.h"
#include "render/choice/renderer.h"
#include "world/snapshot.h"

namespace enfilade {
namespace {

constexpr double kHz = 60;
constexpr double kNoteSeconds = 12;

double seconds_now() { return static_cast<double>(now_ns()) / kSecond; }

MenuFacts facts_now() { return {std::filesystem::path(last_map()).stem().string()}; }

}  // namespace

TitleScreen::TitleScreen(Window& window, SettingsStore& store, const std::string& note)
    : window_(window), store_(store) {
    for (const std::string& wrong : store.notes()) notices_.say(wrong, seconds_now(), kNoteSeconds);
    if (!note.empty()) notices_.say(note, seconds_now(), kNoteSeconds);
    menu_.set_facts(facts_now());
    menu_.open(MenuPage::title);
    static_cast<void>(window_.show_by_gpu(store.now().vsync && has_gpu()));
    window_.grab_mouse(false);
}

Result<TitleChoice> TitleScreen::run() {
    std::vector<InputEvent> events;
    std::int64_t acted = now_ns();
    while (!is_over_) {
        const bool is_idle = now_ns() - acted > kUntilIdle;
        const double hz = window_.is_hidden() ? kHiddenHz : is_idle ? kIdleHz : kHz;
        pacing_.set_period(static_cast<std::int64_t>(kSecond / hz));
        sleep_until_ns(pacing_.begin());
        events.clear();
        window_.poll(events);
        if (!events.empty()) is_changed_ = true, acted = now_ns();
        for (const InputEvent& event : events) handle(event);
        if (!is_over_ && !window_.is_hidden() && has_news())
            if (const Result<void> done = show(); !done.ok()) return done.error();
        pacing_.go_on(now_ns());
    }
    static_cast<void>(store_.save());
    return choice_;
}

void TitleScreen::handle(const InputEvent& event) {
    if (std::holds_alternative<QuitRequest>(event)) is_over_ = true;
    if (maps_.is_open()) {
        switch (maps_.handle(event)) {
            case MapPageAction::none: return;
            case MapPageAction::leave: return maps_.close();
            case MapPageAction::choose: return choose_map(maps_.chosen());
        }
    }
    Settings changed = store_.now();
    const MenuChoice choice = menu_.handle(event, changed);
    if (choice.action == MenuAction::settings_changed) return change_settings(changed);
    obey(choice);
}

void TitleScreen::obey(const MenuChoice& choice) {
    switch (choice.action) {
        case MenuAction::go_on:
            choice_ = {last_map(), true};
            is_over_ = true;
            return;
        case MenuAction::maps: maps_.set_maps(find_maps()); return maps_.open();
        case MenuAction::quit: is_over_ = true; return;
        default: return;  // Escape on the first page leaves nothing
    }
}

void TitleScreen::choose_map(const ListedMap& map) {
    if (conversion_.valid()) return;
    if (map.origin != MapOrigin::wad) {
        choice_ = {map.path, false};
        is_over_ = true;
        return;
    }
    note_ = "Converting " + map.name + " ...";
    wad_ = map.path;
    conversion_ = std::async(std::launch::async, convert_wad, map.path);
}

void TitleScreen::change_settings(const Settings& changed) {
    store_.change(changed);
    if (window_.fullscreen() != changed.fullscreen) window_.set_fullscreen(changed.fullscreen);
}

bool TitleScreen::has_news() {
    if (conversion_.valid() && conversion_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        const Result<void> converted = conversion_.get();
        note_ = converted.ok() ? "" : converted.error().text();
        maps_.set_maps(find_maps());
        if (converted.ok())
            if (const auto first = first_level_of(wad_); first.ok()) maps_.choose(first.value());
        is_changed_ = true;
    }
    const std::size_t pictures = pictures_.count();
    if (maps_.is_open() && pictures != shown_pictures_) is_changed_ = true;
    shown_pictures_ = pictures;
    return is_changed_ || notices_.have_changed(seconds_now());
}

void TitleScreen::draw_background() {
    const PixelSize size = window_.size();
    if (background_.width == size.width && background_.height == size.height) return;
    background_.resize(size.width, size.height);
    std::ranges::fill(background_.pixels, 0xFF201810);
    static_cast<void>(attempt([&] {
        const std::string path = shipped_map("enfilade.toml");
        const MapStore cache = cache_of(path);
        LoadedMap tour = load_map(path, {}, read_file, kUsualSkill, list_folder, &cache);
        if (!tour.map || !tour.map->player) return;
        const auto view = view_at_start(*tour.map, lens_for(tour.map->render));
        auto renderer = make_renderer({RendererKind::column, {}, hardware_threads(), {}}, *tour.map, tour.textures);
        if (renderer.ok())
            static_cast<void>(renderer.value()->render(background_, nullptr, at_rest(*tour.map), view.value()));
    }));
}

Result<void> TitleScreen::show() {
    is_changed_ = false;
    draw_background();
    frame_ = background_;
    Overlay overlay(frame_, font_, comfortable_scale(frame_.height));
    if (maps_.is_open())
        maps_.draw(overlay, pictures_, note_);
    else
        menu_.draw(overlay, store_.now());
    notices_.draw(overlay, seconds_now());
    return window_.present(frame_);
}

}  // namespace enfilade
