#include "app/play/title.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/open_map.h"
#include "app/options.h"
#include "app/play/conversions.h"
#include "app/play/saved_game.h"
#include "app/programs.h"
#include "base/attempt.h"
#include "base/file_name.h"
#include "base/parallel.h"
#include "platform/clock.h"
#include "render/choice/renderer.h"
#include "world/snapshot.h"

namespace enfilade {
namespace {

constexpr Color kChosenFrame = 0xFF3078C0, kEmpty = 0xFF202830;

std::string about(const ListedMap& map) {
    switch (map.origin) {
        case MapOrigin::shipped: return "Comes with Enfilade.";
        case MapOrigin::own: return "Yours: " + map.path;
        case MapOrigin::converted: return "Converted: " + map.path;
        case MapOrigin::wad: return "A game for Doom, " + map.path + ": Enter converts its levels.";
    }
    return {};
}

/// A map is about as wide as a name of so many letters.
constexpr int kNameLetters = 16;

/// The whole picture into the area, each of its pixels taken from the nearest.
void fill_area(Overlay& overlay, const Frame& picture, const Rect& area) {
    for (int y = 0; y < area.height; ++y)
        for (int x = 0; x < area.width; ++x) {
            const std::size_t row = std::size_t(y * picture.height / area.height);
            const std::size_t column = std::size_t(x * picture.width / area.width);
            overlay.dot(area.left + x, area.top + y,
                        picture.pixels[row * std::size_t(picture.width) + column] | 0xFF000000u);
        }
}

/// The name, cut to the width.
std::string fitting(const Overlay& overlay, const std::string& name, int width) {
    const auto most = static_cast<std::size_t>(std::max(4, width / overlay.text_width("M")));
    return name.size() <= most ? name : name.substr(0, most - 3) + "...";
}

}  // namespace

void MapPage::set_maps(std::vector<ListedMap> maps) {
    maps_ = std::move(maps);
    chosen_ = std::clamp(chosen_, 0, std::max(0, static_cast<int>(maps_.size()) - 1));
}

void MapPage::choose(const std::string& path) {
    const auto found = std::ranges::find(maps_, path, &ListedMap::path);
    if (found != maps_.end()) chosen_ = static_cast<int>(found - maps_.begin());
}

MapPageAction MapPage::handle(const InputEvent& event) {
    if (!is_open_) return MapPageAction::none;
    if (const auto* key = std::get_if<KeyChange>(&event)) return key->down ? press(key->key) : MapPageAction::none;
    if (const auto* button = std::get_if<GamepadButtonChange>(&event))
        return button->down ? press(button->button) : MapPageAction::none;
    if (const auto* motion = std::get_if<MouseMotion>(&event); motion && (motion->dx != 0 || motion->dy != 0))
        if (const int map = map_at(motion->x, motion->y); map >= 0) chosen_ = map;
    if (const auto* wheel = std::get_if<MouseWheel>(&event)) move(wheel->steps > 0 ? -columns_ : columns_);
    if (const auto* click = std::get_if<MouseButtonChange>(&event); click && click->down) {
        const int map = map_at(click->x, click->y);
        if (click->button == MouseButton::right) return MapPageAction::leave;
        if (map >= 0) return chosen_ = map, choose();
    }
    return MapPageAction::none;
}

MapPageAction MapPage::press(KeyCode key) {
    switch (key) {
        case KeyCode::escape:
        case KeyCode::backspace: return MapPageAction::leave;
        case KeyCode::left:
        case KeyCode::a: return move(-1), MapPageAction::none;
        case KeyCode::right:
        case KeyCode::d: return move(1), MapPageAction::none;
        case KeyCode::up:
        case KeyCode::w: return move(-columns_), MapPageAction::none;
        case KeyCode::down:
        case KeyCode::s: return move(columns_), MapPageAction::none;
        case KeyCode::page_up: return move(-3 * columns_), MapPageAction::none;
        case KeyCode::page_down: return move(3 * columns_), MapPageAction::none;
        case KeyCode::enter:
        case KeyCode::space:
        case KeyCode::e: return choose();
        default: return MapPageAction::none;
    }
}

MapPageAction MapPage::press(GamepadButton button) {
    switch (button) {
        case GamepadButton::b: return MapPageAction::leave;
        case GamepadButton::left: return move(-1), MapPageAction::none;
        case GamepadButton::right: return move(1), MapPageAction::none;
        case GamepadButton::up: return move(-columns_), MapPageAction::none;
        case GamepadButton::down: return move(columns_), MapPageAction::none;
        case GamepadButton::a:
        case GamepadButton::start: return choose();
        default: return MapPageAction::none;
    }
}

void MapPage::move(int steps) {
    chosen_ = std::clamp(chosen_ + steps, 0, std::max(0, static_cast<int>(maps_.size()) - 1));
}

int MapPage::map_at(double x, double y) const {
    const auto under = std::ranges::find_if(boxes_, [&](const MapBox& box) { return box.area.contains(x, y); });
    return under == boxes_.end() ? -1 : under->map;
}

void MapPage::draw(Overlay& overlay, MapPictures& pictures, const std::string& note) {
    if (!is_open_) return;
    overlay.fill({0, 0, overlay.width(), overlay.height()}, kPageShade);
    const int line = overlay.line_height(), gap = line / 2;
    columns_ = std::max(1, (overlay.width() - 2 * gap) / (overlay.text_width("M") * kNameLetters + gap));
    const int width = (overlay.width() - 2 * gap) / columns_ - gap;
    const int height = width * kPictureHeight / kPictureWidth + 2 * line;
    const int rows = std::max(1, (overlay.height() - 6 * line) / (height + gap));
    const int last_row = (static_cast<int>(maps_.size()) - 1) / columns_;
    const int first_row = std::clamp(chosen_ / columns_ - rows / 2, 0, std::max(0, last_row + 1 - rows));
    boxes_.clear();
    for (int i = first_row * columns_; i < std::min<int>(int(maps_.size()), (first_row + rows) * columns_); ++i) {
        const Rect box{gap + i % columns_ * (width + gap) + gap / 2,
                       3 * line + (i / columns_ - first_row) * (height + gap), width, height};
        boxes_.push_back({box, i});
        draw_map(overlay, maps_[std::size_t(i)], box, i == chosen_, pictures);
    }
    std::string title = "MAPS";
    if (boxes_.size() < maps_.size())
        title += fmt::format("  {} to {} of {}", boxes_.front().map + 1, boxes_.back().map + 1, maps_.size());
    overlay.rimmed_text((overlay.width() - overlay.text_width(title)) / 2, line, title, kTitleInk);
    const std::string hint = !note.empty() ? note : maps_.empty() ? "No maps were found." : about(chosen());
    const std::string shown = fitting(overlay, hint, overlay.width() - line);
    overlay.rimmed_text((overlay.width() - overlay.text_width(shown)) / 2, overlay.height() - 2 * line, shown,
                        kHintInk);
}

void MapPage::draw_map(Overlay& overlay, const ListedMap& map, const Rect& area, bool is_chosen,
                       MapPictures& pictures) {
    const int line = overlay.line_height(), rim = std::max(2, line / 6);
    if (is_chosen) overlay.fill({area.left - rim, area.top - rim, area.width + 2 * rim, area.height}, kChosenFrame);
    const Rect picture{area.left, area.top, area.width, area.height - 2 * line};
    overlay.fill(picture, kEmpty);
    const std::optional<Frame> drawn = map.origin == MapOrigin::wad ? Frame() : pictures.find(map.path);
    if (drawn && drawn->width > 0) fill_area(overlay, *drawn, picture);
    const std::string word = map.origin == MapOrigin::wad ? "WAD" : !drawn ? "..." : "";
    overlay.rimmed_text(picture.left + (picture.width - overlay.text_width(word)) / 2,
                        picture.top + (picture.height - line) / 2, word, kHintInk);
    const std::string name = fitting(overlay, map.name, area.width);
    overlay.rimmed_text(area.left + (area.width - overlay.text_width(name)) / 2,
                        picture.top + picture.height + line / 4, name, is_chosen ? kChosenInk : kInk);
}

namespace {

constexpr double kHz = 60;
constexpr double kNoteSeconds = 12;

double seconds_now() { return static_cast<double>(now_ns()) / kSecond; }

MenuFacts facts_now() { return {file_stem_of(last_map())}; }

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
    conversion_ = std::async(std::launch::async, [wad = map.path] {
        const auto folder = convert_wads({wad});
        return folder.ok() ? level_in(folder.value()) : folder;
    });
}

void TitleScreen::change_settings(const Settings& changed) {
    store_.change(changed);
    if (window_.fullscreen() != changed.fullscreen) window_.set_fullscreen(changed.fullscreen);
}

bool TitleScreen::has_news() {
    if (conversion_.valid() && conversion_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        const Result<std::string> first = conversion_.get();
        note_ = first.ok() ? "" : first.error().text();
        maps_.set_maps(find_maps());
        if (first.ok()) maps_.choose(first.value());
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
