#include "app/play/automap.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace enfilade {
namespace {

constexpr Color kWall = 0xFFE0E0E0, kStep = 0xFF50A0C0, kOpening = 0xFF606060, kLink = 0xFFFF80C0, kMirror = 0xFFFFE080,
                kPlayer = 0xFF40FF40, kDim = 0xB0000000;

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

Color color_of(const Map& map, const Wall& wall) {
    if (wall.kind == WallKind::solid || wall.kind == WallKind::way_back) return kWall;
    if (wall.kind == WallKind::mirror) return kMirror;
    if (wall.link != Wall::kNoLink) return kLink;
    return has_step(map, wall) ? kStep : kOpening;
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

void draw_room(Overlay& overlay, const Map& map, const LaidOut& room, const Chart& chart, bool bright) {
    const Sector& sector = map[room.sector];
    for (std::uint32_t w = sector.first_wall; w < sector.first_wall + sector.wall_count; ++w) {
        const Wall& wall = map.walls[w];
        const Color color = color_of(map, wall);
        overlay.line(chart(room.to_player.apply(wall.a)), chart(room.to_player.apply(wall.b)),
                     bright ? color : dim(color));
    }
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

void Automap::draw(Overlay& overlay, const Map& map, const Place& player, Vec2 forward) const {
    if (!open_) return;
    overlay.fill({0, 0, overlay.width(), overlay.height()}, kDim);
    const double half_height_m = kReach / std::pow(kZoomFactor, zoom_steps_);
    const Vec2 middle{overlay.width() * 0.5, overlay.height() * 0.5};
    const Chart chart{player.point, forward, middle, middle.y / half_height_m};
    const double corner_m = std::sqrt(dot(middle, middle)) / chart.px_per_m;
    const auto rooms = lay_out(map, player, corner_m);
    for (const Known known : {Known::seen, Known::visited})  // bright lines over dim ones
        for (const LaidOut& room : rooms)
            if (known_[room.sector.index] == known) draw_room(overlay, map, room, chart, known == Known::visited);
    draw_player(overlay, middle);
}

}  // namespace enfilade
