#include "app/authoring/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "formats/text_parts.h"
#include "formats/words.h"
#include "math/angle.h"

namespace enfilade {
namespace {

constexpr double kScale = 28;          ///< of the drawing [px/m]
constexpr double kMargin = 1.5;        ///< around each drawing, for the numbers at its squares [m]
constexpr double kRowWidth = 2400;     ///< where drawings go on below [px]
constexpr double kLegendHeight = 170;  ///< [px]
constexpr double kLeastNumbered = 36;  ///< sectors that are narrower have no numbers at their walls [px]
constexpr double kMostSquares = 200;   ///< lines of the paper in one direction; larger drawings have wider squares

std::string triggers_text(const std::vector<TriggerRecord>& triggers) {
    std::string text;
    for (const TriggerRecord& trigger : triggers) {
        text +=
            (text.empty() ? "" : "; ") + std::string(to_word(trigger.on)) + ": " + std::string(to_word(trigger.action));
        for (const std::string& target : trigger.targets) text += " " + target;
        if (!trigger.key.empty()) text += " (key " + trigger.key + ")";
    }
    return text;
}

/// Writes the picture, one drawing after the other.
class PlanDrawing {
public:
    explicit PlanDrawing(const MapFile& map) : map_(map), drawings_(map) {}

    std::string run() {
        for (std::size_t i = 0; i < map_.sectors.size(); ++i)
            if (drawings_.of(i) == i && !drawings_.box(i).is_empty()) drawing(i);
        legend();
        const double height = row_top_ + row_height_ + kLegendHeight;
        return fmt::format(
                   "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 "
                   "{0:.0f} "
                   "{1:.0f}\" font-family=\"sans-serif\" font-size=\"11\" stroke=\"none\">\n<title>{2}</title>\n<rect "
                   "width=\"100%\" "
                   "height=\"100%\" fill=\"#ffffff\"/>\n",
                   std::max(width_, 900.0), height, escaped(map_.name)) +
               text_ + "</svg>\n";
    }

private:
    template <class... Parts>
    void add(fmt::format_string<Parts...> format, Parts&&... parts) {
        text_ += fmt::format(format, std::forward<Parts>(parts)...) + "\n";
    }

    double x(double metres) const { return left_ + (metres - box_.low.x + kMargin) * scale_; }
    double y(double metres) const { return top_ + (metres - box_.low.y + kMargin) * scale_; }

    void drawing(std::size_t root) {
        box_ = drawings_.box(root);
        const Vec2 size = box_.high - box_.low;
        scale_ = std::min(kScale, kRowWidth / (size.x + 2 * kMargin));
        const double width = (size.x + 2 * kMargin) * scale_, height = (size.y + 2 * kMargin) * scale_;
        if (left_ > 0 && left_ + width > kRowWidth) {
            row_top_ += row_height_;
            row_height_ = left_ = 0;
        }
        top_ = row_top_;
        paper(size);
        std::vector<std::size_t> sectors;
        for (std::size_t i = 0; i < map_.sectors.size(); ++i)
            if (drawings_.of(i) == root) sectors.push_back(i);
        for (const std::size_t i : sectors) ground(map_.sectors[i]);
        for (const std::size_t i : sectors) walls(map_.sectors[i]);
        // Of rooms within rooms, the inner one has its name in its middle.
        std::ranges::stable_sort(sectors, {}, [&](std::size_t i) { return box_of(map_.sectors[i]).area(); });
        for (const std::size_t i : sectors) words(map_.sectors[i]);
        inhabitants();
        text_ += labels_.placed();
        left_ += width;
        width_ = std::max(width_, left_);
        row_height_ = std::max(row_height_, height);
    }

    /// Squares of a metre, or of as many as keep them few; every fifth has its number.
    void paper(Vec2 size) {
        const double step = std::ceil(std::max({size.x, size.y, 1.0}) / kMostSquares);
        const auto line = [&](bool upright, double at) {
            const bool is_fifth = std::fmod(std::abs(at), 5 * step) == 0;
            const double from = upright ? y(box_.low.y) : x(box_.low.x), to = upright ? y(box_.high.y) : x(box_.high.x);
            const double here = upright ? x(at) : y(at);
            add("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"{}\"/>", upright ? here : from,
                upright ? from : here, upright ? here : to, upright ? to : here, is_fifth ? "#d0d8e0" : "#eceff3");
            if (is_fifth)
                add("<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"#90a0b0\">{}</text>", upright ? here - 3 : from - 28,
                    upright ? from - 8 : here + 4, number_text(at));
        };
        for (double at = std::ceil(box_.low.x / step) * step; at <= box_.high.x; at += step) line(true, at);
        for (double at = std::ceil(box_.low.y / step) * step; at <= box_.high.y; at += step) line(false, at);
    }

    void ground(const SectorRecord& sector) {
        std::string path;
        for (const LoopRecord& loop : sector.loops) {
            for (std::size_t i = 0; i < loop.vertices.size(); ++i)
                path +=
                    fmt::format("{}{:.1f} {:.1f}", i == 0 ? 'M' : 'L', x(loop.vertices[i].x), y(loop.vertices[i].y));
            path += 'Z';
        }
        const char* const color = sector.ceiling.parallax ? "#dff0df" : sector.triggers.empty() ? "#f4efe2" : "#fbe3c4";
        add("<path d=\"{}\" fill=\"{}\" fill-opacity=\"0.7\" fill-rule=\"evenodd\"><title>{}, line {}</title></path>",
            path, color, escaped(sector.name), sector.place.line);
    }

    void walls(const SectorRecord& sector) {
        const Vec2 size = box_of(sector).high - box_of(sector).low;
        const bool is_wide = std::min(size.x, size.y) * scale_ > kLeastNumbered;
        for (const LoopRecord& loop : sector.loops)
            for (std::size_t i = 0; i < loop.vertices.size(); ++i)
                wall(sector, loop, i, is_wide && &loop == &sector.loops.front());
        for (const PanelRecord& panel : sector.panels)
            add("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#7a5230\" stroke-width=\"2\" "
                "stroke-dasharray=\"2 2\"><title>panel, line {} {}</title></path>",
                x(panel.a.x), y(panel.a.y), x(panel.b.x), y(panel.b.y), panel.place.line,
                escaped(triggers_text(panel.triggers)));
    }

    static const char* look_of(const WallRecord& wall) {
        if (!wall.triggers.empty()) return "stroke=\"#e07000\" stroke-width=\"4\"";
        if (!wall.via.empty()) return "stroke=\"#c000c0\" stroke-width=\"4\"";
        if (wall.mirror) return "stroke=\"#00a0b0\" stroke-width=\"4\"";
        if (!wall.next.empty() && wall.blocks)
            return "stroke=\"#3070d0\" stroke-width=\"1.5\" stroke-dasharray=\"5 3\"";
        if (!wall.next.empty()) return "stroke=\"#3070d0\" stroke-width=\"1.5\"";
        return "stroke=\"#202020\" stroke-width=\"2.5\"";
    }

    void wall(const SectorRecord& sector, const LoopRecord& loop, std::size_t i, bool has_number) {
        const WallRecord& wall = loop.walls[i];
        const Vec2 a = loop.vertices[i], b = loop.vertices[(i + 1) % loop.vertices.size()];
        const std::string behind = wall.next.empty() ? "" : " to " + wall.next;
        const std::string triggers = triggers_text(wall.triggers);
        add("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" {}><title>{}, wall {}{}, line {} {}</title></path>", x(a.x),
            y(a.y), x(b.x), y(b.y), look_of(wall), escaped(sector.name), i, escaped(behind), wall.place.line,
            escaped(triggers));
        const Vec2 along = b - a;
        const double length = std::sqrt(dot(along, along));
        if (length * scale_ < 12) return;
        const Vec2 inside = right_of(along) * (8 / (length * scale_)), middle = (a + b) * 0.5 + inside;
        const Vec2 outside = (a + b) * 0.5 - inside * 1.5;
        if (has_number) label(Importance::number, middle, 3, 8, kGrey, std::to_string(i));
        if (!wall.via.empty()) label(Importance::link, outside, 3, 9, kViolet, "→ " + wall.next);
        label(Importance::trigger, outside, 3, 9, kOrange, triggers);
    }

    /// Names stand where there is room; others, as those of steps, are told to who points at the sector.
    void words(const SectorRecord& sector) {
        const Box box = box_of(sector);
        const Vec2 size = box.high - box.low;
        const std::string triggers = triggers_text(sector.triggers);
        if (box.is_empty() || (std::max(size.x, size.y) * scale_ < 30 && triggers.empty())) return;
        const Vec2 middle = box.middle();
        const bool is_small = std::min(size.x, size.y) * scale_ < 40;
        if (is_small) {
            label(Importance::small_name, middle, 3, 8, kBold, sector.name);
            label(Importance::trigger, middle, 12, 9, kOrange, triggers);
        } else {
            label(Importance::name, middle, 0, 12, kBold, sector.name,
                  number_text(sector.floor.z) + " to " + number_text(sector.ceiling.z) + " m");
            label(Importance::trigger, middle, 25, 9, kOrange, triggers);
        }
    }

    /// below : how far the line of writing is below the point [px]
    void label(Importance importance, Vec2 point, double below, double size, const char* look, std::string text,
               std::string second = {}) {
        labels_.add({importance, {x(point.x), y(point.y) + below}, size, look, std::move(text), std::move(second)});
    }

    bool is_here(Vec2 p) const {
        return p.x >= box_.low.x && p.x <= box_.high.x && p.y >= box_.low.y && p.y <= box_.high.y;
    }

    /// What is drawn, and what is told to who points at it. Not every program knows a title inside of a circle.
    void add_titled(const std::string& shape, const std::string& title) {
        add("<g><title>{}</title>{}</g>", escaped(title), shape);
    }

    void inhabitants() {
        for (const PointLightRecord& light : map_.lights)
            if (is_here(light.position))
                add_titled(
                    fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" fill=\"#ffd040\" stroke=\"#a07000\"/>",
                                x(light.position.x), y(light.position.y)),
                    fmt::format("lamp, line {}, reach {} m", light.place.line, number_text(light.reach)));
        for (const ThingRecord& thing : map_.things)
            if (is_here(thing.position))
                add_titled(
                    fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"#40a040\" fill-opacity=\"{}\" "
                                "stroke=\"#207020\"/>",
                                x(thing.position.x), y(thing.position.y), std::clamp(thing.radius * scale_, 3.0, 12.0),
                                thing.solid ? "0.9" : "0.4"),
                    fmt::format("{} {}, line {} {}", thing.kind, thing.name, thing.place.line,
                                triggers_text(thing.triggers)));
        if (map_.player && is_here(map_.player->position))
            add_titled(player_arrow({x(map_.player->position.x), y(map_.player->position.y)}, map_.player->yaw_degrees),
                       fmt::format("the player, line {}", map_.player->place.line));
    }

    /// at [px]
    static std::string player_arrow(Vec2 at, double yaw_degrees) {
        const Vec2 ahead = direction(Angle::from_degrees(yaw_degrees)), right = right_of(ahead);
        std::string path;
        for (const auto& [along, aside] : {std::pair{10.0, 0.0}, {-6.0, -6.0}, {-3.0, 0.0}, {-6.0, 6.0}}) {
            const Vec2 corner = at + ahead * along + right * aside;
            path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', corner.x, corner.y);
        }
        return "<path d=\"" + path + "Z\" fill=\"#d02020\"/>";
    }

    void legend() {
        const std::pair<const char*, const char*> lines[] = {
            {"stroke=\"#202020\" stroke-width=\"2.5\"", "wall, with its number in the sector's outline"},
            {"stroke=\"#3070d0\" stroke-width=\"1.5\"", "portal"},
            {"stroke=\"#3070d0\" stroke-width=\"1.5\" stroke-dasharray=\"5 3\"", "portal that blocks"},
            {"stroke=\"#c000c0\" stroke-width=\"4\"", "link, to →"},
            {"stroke=\"#e07000\" stroke-width=\"4\"", "wall with triggers (ON: DO TARGET)"},
            {"stroke=\"#00a0b0\" stroke-width=\"4\"", "mirror"},
            {"stroke=\"#7a5230\" stroke-width=\"2\" stroke-dasharray=\"2 2\"", "panel"}};
        double at = row_top_ + row_height_ + 20;
        add("<text x=\"20\" y=\"{:.0f}\" font-size=\"14\" font-weight=\"bold\">{}</text>", at, escaped(map_.name));
        for (const auto& [look, words] : lines) {
            at += 18;
            add("<path d=\"M20 {0:.0f}L60 {0:.0f}\" {1}/><text x=\"70\" y=\"{2:.0f}\">{3}</text>", at, look, at + 4,
                words);
        }
        at = row_top_ + row_height_ + 38;
        add("{}<text x=\"420\" y=\"{:.0f}\">the player's start</text>", player_arrow({400, at}, 0), at + 4);
        add("<circle cx=\"400\" cy=\"{:.0f}\" r=\"6\" fill=\"#40a040\" fill-opacity=\"0.9\" stroke=\"#207020\"/><text "
            "x=\"420\" y=\"{:.0f}\">thing (pale: not solid)</text>",
            at + 18, at + 22);
        add("<circle cx=\"400\" cy=\"{:.0f}\" r=\"5\" fill=\"#ffd040\" stroke=\"#a07000\"/><text x=\"420\" "
            "y=\"{:.0f}\">lamp</text>",
            at + 36, at + 40);
        add("<rect x=\"392\" y=\"{:.0f}\" width=\"16\" height=\"12\" fill=\"#fbe3c4\"/><text x=\"420\" "
            "y=\"{:.0f}\">sector with triggers</text>",
            at + 48, at + 58);
        add("<rect x=\"392\" y=\"{:.0f}\" width=\"16\" height=\"12\" fill=\"#dff0df\"/><text x=\"420\" "
            "y=\"{:.0f}\">sector under a sky</text>",
            at + 66, at + 76);
        add("<text x=\"392\" y=\"{:.0f}\">Whoever points at a part is told its name and its line in the file.</text>",
            at + 100);
    }

    const MapFile& map_;
    Drawings drawings_;
    std::string text_;
    Labels labels_;
    Box box_;
    double scale_ = kScale, left_ = 0, top_ = 0, row_top_ = 0, row_height_ = 0, width_ = 0;
};

}  // namespace

std::string plan_svg(const MapFile& map) { return PlanDrawing(map).run(); }

}  // namespace enfilade
