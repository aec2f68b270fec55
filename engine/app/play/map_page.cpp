#include "app/play/map_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

}  // namespace enfilade
