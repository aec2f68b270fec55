#include "app/play/game.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace enfilade {
namespace {

constexpr Color kPlayer = 0xFF40FF40, kDim = 0xB0000000, kNameInk = 0xFFB0B0B0;

/// Of lines and things.
struct Palette {
    Color wall, step, opening, link, mirror, door, thing, item;
};
constexpr Palette kUsual{0xFFE0E0E0, 0xFF50A0C0, 0xFF606060, 0xFFFF80C0,
                         0xFFFFE080, 0xFF4060FF, 0xFF808080, 0xFF40E0E0};
/// Eight that eyes of all kinds tell apart (Okabe, Ito: "Color Universal Design", 2008).
constexpr Palette kSafe{0xFFFFFFFF, 0xFFE9B456, 0xFF606060, 0xFFA779CC, 0xFF42E4F0, 0xFF009FE6, 0xFF909090, 0xFF739E00};

const Palette& palette_of(AutomapColors colors) { return colors == AutomapColors::safe ? kSafe : kUsual; }

/// Half the height of the picture shows this much at zoom 0 [m].
constexpr double kReach = 24;
constexpr double kZoomFactor = 1.25;
constexpr int kMostZoom = 12;

/// A sector as it lies around the player.
struct LaidOut {
    SectorId sector;
    Rigid to_player;  ///< from the sector's space into the player's
};

/// The nearest distance from the player to the sector's box, seen in the player's space [m]; from its middle and half
/// its diagonal, so never too large.
double distance_to(const Sector& sector, const Rigid& to_player, Vec2 player) {
    const Vec2 half = (sector.max - sector.min) * 0.5;
    const Vec2 way = to_player.apply(sector.min + half) - player;
    return std::sqrt(dot(way, way)) - std::sqrt(dot(half, half));
}

/// Every sector once, by the fewest doorways from the player, as far as `reach` [m].
std::vector<LaidOut> lay_out(const Map& map, const Place& player, double reach) {
    std::vector<LaidOut> rooms{{player.sector, {}}};
    std::vector<bool> found(map.sectors.size(), false);
    found[player.sector.index] = true;
    for (std::size_t next = 0; next < rooms.size(); ++next) {
        const LaidOut room = rooms[next];
        const Sector& sector = map[room.sector];
        for (std::uint32_t w = sector.first_wall; w < sector.first_wall + sector.wall_count; ++w) {
            const Wall& wall = map.walls[w];
            if (wall.kind != WallKind::portal || found[wall.behind.index]) continue;
            const Rigid to_player = then(inverse(map.passage(wall)), room.to_player);
            if (distance_to(map[wall.behind], to_player, player.point) > reach) continue;
            found[wall.behind.index] = true;
            rooms.push_back({wall.behind, to_player});
        }
    }
    return rooms;
}

bool has_step(const Map& map, const Wall& wall) {
    return map[wall.sector].floor.z + map.passage(wall).rise != map[wall.behind].floor.z;
}

/// Everything that drawing a room needs to know.
struct Sheet {
    const Map& map;
    const std::vector<bool>& is_door;
    const Palette& palette;
    std::span<const ThingId> taken;
};

Color color_of(const Sheet& sheet, const Wall& wall) {
    const Palette& palette = sheet.palette;
    if (wall.kind == WallKind::solid || wall.kind == WallKind::way_back) return palette.wall;
    if (wall.kind == WallKind::mirror) return palette.mirror;
    if (sheet.is_door[wall.behind.index] || sheet.is_door[wall.sector.index]) return palette.door;
    if (wall.link != Wall::kNoLink) return palette.link;
    return has_step(sheet.map, wall) ? palette.step : palette.opening;
}

/// From metres around the player to pixels, the player in the middle and looking up.
struct Chart {
    Vec2 player, forward, middle_px;
    double px_per_m;

    Vec2 operator()(Vec2 p) const {
        const Vec2 way = p - player;
        return {middle_px.x + dot(way, right_of(forward)) * px_per_m, middle_px.y - dot(way, forward) * px_per_m};
    }
};

/// The colour at five eighths of its brightness.
Color dim(Color color) { return 0xFF000000u | ((color >> 1 & 0x7F7F7F) + (color >> 3 & 0x1F1F1F)); }

void draw_room(Overlay& overlay, const Sheet& sheet, const LaidOut& room, const Chart& chart, bool bright) {
    const Sector& sector = sheet.map[room.sector];
    for (std::uint32_t w = sector.first_wall; w < sector.first_wall + sector.wall_count; ++w) {
        const Wall& wall = sheet.map.walls[w];
        const Color color = color_of(sheet, wall);
        overlay.line(chart(room.to_player.apply(wall.a)), chart(room.to_player.apply(wall.b)),
                     bright ? color : dim(color));
    }
}

/// "s17": a name that a program gave tells nobody anything.
bool is_name_for_people(std::string_view name) {
    return name.find_first_not_of("0123456789", name.starts_with('s') ? 1 : 0) != std::string_view::npos;
}

/// The room's name in its middle, where there is room for it.
void draw_name(Overlay& overlay, const Sector& sector, const LaidOut& room, const Chart& chart) {
    const int width = overlay.text_width(sector.name);
    const double size_m = std::min(sector.max.x - sector.min.x, sector.max.y - sector.min.y);
    if (size_m * chart.px_per_m < width || !is_name_for_people(sector.name)) return;
    const Vec2 middle = chart(room.to_player.apply((sector.min + sector.max) * 0.5));
    overlay.rimmed_text(int(middle.x) - width / 2, int(middle.y) - overlay.line_height() / 2, sector.name, kNameInk);
}

/// Crosses for what can be picked up, dots for the rest.
void draw_things(Overlay& overlay, const Sheet& sheet, const std::vector<LaidOut>& rooms, const Chart& chart,
                 const std::vector<bool>& is_visited) {
    std::vector<const LaidOut*> room_of(sheet.map.sectors.size());
    for (const LaidOut& room : rooms) room_of[room.sector.index] = &room;
    for (std::uint32_t i = 0; i < sheet.map.things.size(); ++i) {
        const Thing& thing = sheet.map.things[i];
        const LaidOut* const room = room_of[thing.sector.index];
        if (!room || !is_visited[thing.sector.index] || !thing.sprite) continue;
        if (std::ranges::binary_search(sheet.taken, ThingId(i))) continue;
        const Vec2 at = chart(room->to_player.apply(thing.position));
        const double arm = (thing.is_pickup() ? 3.0 : 1.0) * overlay.scale();
        const Color color = thing.is_pickup() ? sheet.palette.item : sheet.palette.thing;
        overlay.line(at + Vec2{-arm, 0}, at + Vec2{arm, 0}, color);
        overlay.line(at + Vec2{0, -arm}, at + Vec2{0, arm}, color);
    }
}

/// What the colours mean, and how the map is moved.
void draw_legend(Overlay& overlay, const Palette& palette, std::string_view keys) {
    const std::pair<std::string_view, Color> lines[] = {{"wall", palette.wall},
                                                        {"step", palette.step},
                                                        {"open", palette.opening},
                                                        {"door", palette.door},
                                                        {"leads elsewhere", palette.link},
                                                        {"mirror", palette.mirror},
                                                        {"thing", palette.thing},
                                                        {"to take", palette.item}};
    const int line = overlay.line_height(), rows = static_cast<int>(std::size(lines));
    const int left = overlay.width() - overlay.text_width("leads elsewhere") - line;
    int y = overlay.height() - line / 2 - rows * line;
    for (const auto& [word, color] : lines) {
        overlay.fill({left - line - line / 4, y + line / 4, line, line / 4}, color);
        overlay.rimmed_text(left, y, word, kNameInk);
        y += line;
    }
    overlay.rimmed_text((overlay.width() - overlay.text_width(keys)) / 2, overlay.height() - line - line / 2, keys,
                        kNameInk);
}

void draw_player(Overlay& overlay, Vec2 middle_px) {
    const double size = 5.0 * overlay.scale();
    const Vec2 tip = middle_px + Vec2{0, -size}, left = middle_px + Vec2{-size * 0.7, size},
               right = middle_px + Vec2{size * 0.7, size};
    overlay.line(left, tip, kPlayer);
    overlay.line(tip, right, kPlayer);
    overlay.line(right, left, kPlayer);
}

}  // namespace

void Automap::see(SectorId sector) {
    Known& known = known_[sector.index];
    known = std::max(known, Known::seen);
}

void Automap::zoom(int steps) { zoom_steps_ = std::clamp(zoom_steps_ + steps, -kMostZoom, kMostZoom); }

void Automap::pan(int right, int up) {
    constexpr double kStep = 0.25;  // of half the height
    panned_m_ = panned_m_ + Vec2{double(right), double(up)} * (kStep * half_height_m());
}

double Automap::half_height_m() const { return kReach / std::pow(kZoomFactor, zoom_steps_); }

Automap::Automap(const Map& map) : known_(map.sectors.size(), Known::unknown), is_door_(map.sectors.size()) {
    for (const Trigger& trigger : map.triggers) {
        const bool is_of_door = trigger.action == TriggerAction::door || trigger.action == TriggerAction::open ||
                                trigger.action == TriggerAction::close ||
                                trigger.action == TriggerAction::close_then_open;
        if (!is_of_door) continue;
        for (const SectorId target : map.targets_of(trigger))
            each_of_group(map, target, [&](SectorId id) { is_door_[id.index] = true; });
    }
}

void Automap::draw(Overlay& overlay, const Map& map, const Place& player, Vec2 forward, const AutomapLook& look) const {
    if (!open_) return;
    overlay.fill({0, 0, overlay.width(), overlay.height()}, kDim);
    const Vec2 half{overlay.width() * 0.5, overlay.height() * 0.5};
    const double px_per_m = half.y / half_height_m();
    const Vec2 middle = half + Vec2{-panned_m_.x, panned_m_.y} * px_per_m;
    const Chart chart{player.point, forward, middle, px_per_m};
    const double corner_m = std::sqrt(dot(half, half)) / px_per_m + std::sqrt(dot(panned_m_, panned_m_));
    const auto rooms = lay_out(map, player, corner_m);
    const Sheet sheet{map, is_door_, palette_of(look.colors), look.taken};
    for (const Known known : {Known::seen, Known::visited})  // bright lines over dim ones
        for (const LaidOut& room : rooms)
            if (known_[room.sector.index] == known) draw_room(overlay, sheet, room, chart, known == Known::visited);
    std::vector<bool> is_visited(known_.size());
    for (std::size_t i = 0; i < known_.size(); ++i) is_visited[i] = known_[i] == Known::visited;
    draw_things(overlay, sheet, rooms, chart, is_visited);
    for (const LaidOut& room : rooms)
        if (is_visited[room.sector.index]) draw_name(overlay, map[room.sector], room, chart);
    draw_player(overlay, middle);
    if (!look.keys.empty()) draw_legend(overlay, sheet.palette, look.keys);
}

}  // namespace enfilade
