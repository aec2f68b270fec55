#include "app/play/readout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "app/draw/overlay.h"
#include "world/input.h"

namespace enfilade {
namespace {

constexpr Color kNoticeInk = 0xFFFFFFFF, kAlarm = 0xFF4040FF, kKeysPanel = 0xD0202020;
constexpr Color kBlood = 0x0000B0;
constexpr double kStrongestFlash = 150;  ///< of 255
constexpr int kLowHealth = 25;           ///< from here on the health is shown in red [points]

/// In the middle of a dark panel, readable on any wall.
void draw_panel(Overlay& overlay, std::string_view text, Color color) {
    const int line = overlay.line_height(), width = overlay.text_width(text), left = (overlay.width() - width) / 2;
    const int top = overlay.height() / 3;
    overlay.fill({left - line, top - line / 2, width + 2 * line, 2 * line}, kKeysPanel);
    overlay.rimmed_text(left, top, text, color);
}

std::string carried_keys(const Map& map, const World& world) {
    std::string text;
    for (std::size_t i = 0; i < map.keys.size(); ++i)
        if (world.keys >> i & 1) text += (text.empty() ? "Keys: " : ", ") + map.keys[i];
    return text;
}

}  // namespace

std::string message_text(const Map& map, const PlayerMessage& message) {
    switch (message.kind) {
        case PlayerMessageKind::needs_key: return fmt::format("You need the {} key.", map.keys[message.number]);
        case PlayerMessageKind::got_key: return fmt::format("You have the {} key.", map.keys[message.number]);
        case PlayerMessageKind::healed: return "You feel better.";
        case PlayerMessageKind::secret: return "You found a secret place.";
        case PlayerMessageKind::hurt:
        case PlayerMessageKind::died: return "";
    }
    return "";
}

void draw_status(Overlay& overlay, const Map& map, const World& world, int bottom) {
    const int margin = overlay.line_height() / 2;
    int y = bottom;
    const auto line = [&](const std::string& text, Color color) {
        y -= overlay.line_height();
        overlay.rimmed_text(margin, y, text, color);
    };
    if (world.health < kFullHealth)
        line(fmt::format("Health {}", world.health), world.health <= kLowHealth ? kAlarm : kNoticeInk);
    if (world.keys != 0) line(carried_keys(map, world), kNoticeInk);
}

void draw_flight(Overlay& overlay, const std::string& text, int top) {
    overlay.rimmed_text((overlay.width() - overlay.text_width(text)) / 2, std::max(top, overlay.height() / 6), text,
                        kNoticeInk);
}

void draw_hurt(Overlay& overlay, double strength) {
    const auto alpha = static_cast<Color>(std::lround(std::clamp(strength, 0.0, 1.0) * kStrongestFlash));
    if (alpha > 0) overlay.fill({0, 0, overlay.width(), overlay.height()}, alpha << 24 | kBlood);
}

void draw_death(Overlay& overlay, const Bindings& bindings) {
    const auto keys = [&](Control control) { return keys_text(keys_for(bindings, control)); };
    draw_panel(
        overlay,
        fmt::format("You died. {}: start again. {}, held: back in time.", keys(Control::use), keys(Control::rewind)),
        kNoticeInk);
}

void draw_rewind(Overlay& overlay, double seconds_back) {
    draw_panel(overlay, fmt::format("<< {:.1f} s", seconds_back), kNoticeInk);
}

namespace {

/// Outlines by how many portals are looked through; deeper ones begin again.
constexpr std::array<Color, 6> kByDepth{0xFFFFFFFF, 0xFF40FFFF, 0xFF40FF40, 0xFFFFB040, 0xFF4060FF, 0xFFFF60FF};

/// One edge of a viewport: its row in every column, joined where it jumps.
void draw_edge(Overlay& overlay, int begin, const std::vector<int>& rows, int offset, Color color) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const int x = begin + int(i), y = rows[i] + offset;
        const int from = i == 0 ? y : rows[i - 1] + offset;
        for (int row = std::min(from, y); row <= std::max(from, y); ++row) overlay.dot(x, row, color);
    }
}

void draw_outline(Overlay& overlay, const ViewportShape& shape) {
    if (shape.top.empty() || shape.bottom.empty()) return;
    const Color color = kByDepth[std::size_t(shape.depth) % kByDepth.size()];
    draw_edge(overlay, shape.begin, shape.top, 0, color);
    draw_edge(overlay, shape.begin, shape.bottom, -1, color);
    for (int y = shape.top.front(); y < shape.bottom.front(); ++y) overlay.dot(shape.begin, y, color);
    for (int y = shape.top.back(); y < shape.bottom.back(); ++y) overlay.dot(shape.end - 1, y, color);
}

}  // namespace

void FrameTimes::add(std::int64_t draw_ns, std::int64_t shown_ns) {
    draw_ns_[count_ % kKept] = draw_ns;
    shown_ns_[count_ % kKept] = shown_ns;
    ++count_;
}

FrameTimes::Summary FrameTimes::summary() const {
    const std::size_t kept = std::min(count_, kKept);
    if (kept < 2) return {};
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < kept; ++i) sum += draw_ns_[i];
    const std::int64_t worst = *std::max_element(draw_ns_.begin(), draw_ns_.begin() + std::ptrdiff_t(kept));
    const std::int64_t newest = shown_ns_[(count_ - 1) % kKept], oldest = shown_ns_[(count_ - kept) % kKept];
    const double span_s = std::max(double(newest - oldest) * 1e-9, 1e-9);
    return {double(sum) * 1e-6 / double(kept), double(worst) * 1e-6, double(kept - 1) / span_s};
}

int draw_readout(Overlay& overlay, const FrameTimes& times, const ReadoutFacts& facts,
                 const std::vector<ViewportShape>& viewports) {
    for (const ViewportShape& shape : viewports) draw_outline(overlay, shape);
    const auto summary = times.summary();
    const std::string lines[] = {
        fmt::format("{:5.2f} ms a picture, worst {:5.2f}; {:.0f} a second", summary.mean_draw_ms, summary.worst_draw_ms,
                    summary.per_second),
        fmt::format("{} {}x{}, {} viewports", facts.renderer, overlay.width(), overlay.height(), viewports.size()),
        fmt::format("{}  x {:.2f}  y {:.2f}  z {:.2f}", facts.sector, facts.x, facts.y, facts.eye_z),
        fmt::format("yaw {:.1f}  pitch {:.1f}", facts.yaw_degrees, facts.pitch_degrees),
    };
    const int left = overlay.line_height() / 2;
    const int top = overlay.height() - left - int(std::size(lines)) * overlay.line_height();
    for (std::size_t i = 0; i < std::size(lines); ++i)
        overlay.rimmed_text(left, top + int(i) * overlay.line_height(), lines[i], kNoticeInk);
    return top;
}

int scale_for_lines(std::size_t lines, int height_px) {
    const int with_rim = static_cast<int>(lines) + 2;
    return std::clamp(height_px / (with_rim * Font::kHeight * 5 / 4), 1, comfortable_scale(height_px));
}

void draw_keys(Overlay& overlay, const std::vector<std::pair<std::string, std::string>>& lines) {
    int keys_width = 0, width = 0;
    for (const auto& [keys, what] : lines) keys_width = std::max(keys_width, overlay.text_width(keys + "  "));
    for (const auto& [keys, what] : lines) width = std::max(width, keys_width + overlay.text_width(what));
    const int pitch = overlay.line_height(), height = pitch * static_cast<int>(lines.size() + 1);
    const Rect panel{(overlay.width() - width - pitch) / 2, (overlay.height() - height) / 2, width + pitch, height};
    overlay.fill(panel, kKeysPanel);
    int y = panel.top + pitch / 2;
    for (const auto& [keys, what] : lines) {
        overlay.rimmed_text(panel.left + pitch / 2, y, keys, kNoticeInk);
        overlay.rimmed_text(panel.left + pitch / 2 + keys_width, y, what, kNoticeInk);
        y += pitch;
    }
}

int draw_pointed(Overlay& overlay, int x, int y, const std::string& text, int bottom) {
    constexpr int kGap = 3, kArm = 8;  // of the cross, whose middle stays free [px]
    const auto arm = [&](int dx, int dy) {
        for (int i = kGap; i < kArm; ++i) overlay.dot(x + i * dx, y + i * dy, kNoticeInk);
    };
    arm(1, 0), arm(-1, 0), arm(0, 1), arm(0, -1);
    const int margin = overlay.line_height() / 2;
    const std::vector<std::string> lines =
        wrapped(text, std::size_t(std::max(8, (overlay.width() - 2 * margin) / overlay.text_width(" "))));
    const int top = bottom - int(lines.size()) * overlay.line_height();
    for (std::size_t i = 0; i < lines.size(); ++i)
        overlay.rimmed_text((overlay.width() - overlay.text_width(lines[i])) / 2, top + int(i) * overlay.line_height(),
                            lines[i], kNoticeInk);
    return top;
}

namespace {

constexpr Color kReadoutShade = 0xD0101060;

}  // namespace

void Notices::say(std::string text, double now_s, double seconds) {
    notices_.push_back({std::move(text), now_s + seconds, {}});
    is_new_ = true;
}

void Notices::update(std::string_view about, std::string text, double now_s, double seconds) {
    std::erase_if(notices_, [&](const Notice& notice) { return notice.about == about; });
    notices_.push_back({std::move(text), now_s + seconds, std::string(about)});
    is_new_ = true;
}

bool Notices::have_changed(double now_s) const {
    return is_new_ || std::ranges::any_of(notices_, [&](const Notice& notice) { return notice.until_s <= now_s; });
}

int Notices::draw(Overlay& overlay, double now_s, bool with_panel) {
    is_new_ = false;
    std::erase_if(notices_, [&](const Notice& notice) { return notice.until_s <= now_s; });
    const int margin = overlay.line_height() / 2;
    const auto most = std::size_t(std::max(8, (overlay.width() - 4 * margin) / (Font::kWidth * overlay.scale())));
    int y = margin;
    for (const Notice& notice : notices_)
        for (const std::string& piece : wrapped(notice.text, most)) {
            overlay.rimmed_text(margin, y, piece, kNoticeInk);
            y += overlay.line_height();
        }
    if (pinned_.empty() || !with_panel) return y;
    std::vector<std::string> lines;
    for (const std::string& line : pinned_)
        for (std::string& piece : wrapped(line, most)) lines.push_back(std::move(piece));
    const Rect panel{margin, y, overlay.width() - 2 * margin, int(lines.size()) * overlay.line_height() + margin};
    overlay.fill(panel, kReadoutShade);
    for (std::size_t i = 0; i < lines.size(); ++i)
        overlay.text(2 * margin, y + margin / 2 + int(i) * overlay.line_height(), lines[i], kNoticeInk);
    return y + panel.height;
}

namespace {

std::string time_text(double seconds) {
    const auto whole = static_cast<long>(seconds);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string next_text(const MapEnd& end) {
    if (end.next.empty()) return "The way ends here; it begins again.";
    if (end.next_path.empty()) return fmt::format("The next map, {}, is not here; this one begins again.", end.next);
    return "Next: " + end.next;
}

}  // namespace

std::size_t count_of_secrets(const Map& map) {
    std::set<SectorId> leaders;
    for (const Sector& sector : map.sectors)
        if (sector.secret) leaders.insert(sector.leader);
    return leaders.size();
}

void draw_end(Overlay& overlay, const MapEnd& end) {
    overlay.fill({0, 0, overlay.width(), overlay.height()}, kPageShade);
    std::vector<std::pair<std::string, Color>> lines{
        {"You left " + end.left, kTitleInk}, {"", kValueInk}, {"Time     " + time_text(end.seconds), kValueInk}};
    if (end.secrets > 0) lines.emplace_back(fmt::format("Secrets  {} of {}", end.found, end.secrets), kValueInk);
    lines.insert(lines.end(),
                 {{"", kValueInk}, {next_text(end), kValueInk}, {"", kValueInk}, {"Any key goes on", kHintInk}});
    const int pitch = overlay.line_height() * 3 / 2;
    int y = (overlay.height() - pitch * static_cast<int>(lines.size())) / 2;
    for (const auto& [text, color] : lines) {
        overlay.rimmed_text((overlay.width() - overlay.text_width(text)) / 2, y, text, color);
        y += pitch;
    }
}

}  // namespace enfilade
