#include "app/play/status.h"

#include <fmt/format.h>

#include "world/input.h"

namespace enfilade {
namespace {

constexpr Color kInk = 0xFFFFFFFF, kAlarm = 0xFF4040FF;
constexpr int kLowHealth = 25;  ///< from here on the health is shown in red [points]

void draw_centred(Overlay& overlay, std::string_view text, Color color) {
    overlay.rimmed_text((overlay.width() - overlay.text_width(text)) / 2, overlay.height() / 3, text, color);
}

std::string keys_text(const Map& map, const World& world) {
    std::string text;
    for (std::size_t i = 0; i < map.keys.size(); ++i)
        if (world.keys >> i & 1) text += (text.empty() ? "Keys: " : ", ") + map.keys[i];
    return text;
}

}  // namespace

std::string news_text(const Map& map, const News& news) {
    switch (news.kind) {
        case NewsKind::needs_key: return fmt::format("You need the {} key.", map.keys[news.number]);
        case NewsKind::got_key: return fmt::format("You have the {} key.", map.keys[news.number]);
        case NewsKind::healed: return "You feel better.";
        case NewsKind::secret: return "You found a secret place.";
        case NewsKind::hurt:
        case NewsKind::died: return "";
    }
    return "";
}

void draw_status(Overlay& overlay, const Map& map, const World& world) {
    const int margin = overlay.line_height() / 2;
    int y = overlay.height() - margin;
    const auto line = [&](const std::string& text, Color color) {
        y -= overlay.line_height();
        overlay.rimmed_text(margin, y, text, color);
    };
    if (world.health < kFullHealth)
        line(fmt::format("Health {}", world.health), world.health <= kLowHealth ? kAlarm : kInk);
    if (world.keys != 0) line(keys_text(map, world), kInk);
}

void draw_flight(Overlay& overlay, const std::string& text) {
    overlay.rimmed_text((overlay.width() - overlay.text_width(text)) / 2, overlay.height() / 6, text, kInk);
}

void draw_death(Overlay& overlay) { draw_centred(overlay, "You died. Press E to start again.", kAlarm); }

void draw_rewind(Overlay& overlay, std::size_t ticks_back) {
    draw_centred(overlay, fmt::format("<< {:.1f} s", static_cast<double>(ticks_back) / kTickRate), kInk);
}

}  // namespace enfilade
