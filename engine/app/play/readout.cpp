#include "app/play/readout.h"

#include <fmt/format.h>
#include <algorithm>

#include "app/draw/overlay.h"
#include "world/input.h"

namespace enfilade {

namespace {

constexpr Color kInk = 0xFFFFFFFF, kAlarm = 0xFF4040FF, kKeysPanel = 0xD0202020;
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

void draw_readout(Overlay& overlay, const FrameTimes& times, const ReadoutFacts& facts,
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
    int y = overlay.height() - left - int(std::size(lines)) * overlay.line_height();
    for (const std::string& line : lines) {
        overlay.rimmed_text(left, y, line, kInk);
        y += overlay.line_height();
    }
}

namespace {

/// Of kKeys, each a line: the keys, and what they do.
constexpr std::size_t kKeyColumns = 15;
constexpr std::string_view kKeys[][2] = {
    {"W A S D, mouse", "walk, look around"},
    {"Shift, Alt", "run; walk slowly"},
    {"C or Ctrl", "crouch"},
    {"E or Space", "use"},
    {"Tab, + -", "map, its zoom"},
    {"R, held", "go back in time"},
    {"F5, F9", "save; load"},
    {"F2", "column or stencil renderer"},
    {"F3", "times, place, viewports"},
    {"F4, F6, + -", "from outside; side; zoom"},
    {"F7", "what a pixel shows"},
    {"F8", "fly through walls; come back"},
    {"Ctrl and wheel", "field of view"},
    {"F11, F12", "full screen; save a picture"},
    {"Esc", "menu"},
};

}  // namespace

int scale_for_keys(int height_px) {
    constexpr int kLines = static_cast<int>(std::size(kKeys)) + 2;  // and a rim
    return std::clamp(height_px / (kLines * Font::kHeight * 5 / 4), 1, comfortable_scale(height_px));
}

void draw_keys(Overlay& overlay) {
    std::vector<std::string> lines;
    for (const auto& [keys, what] : kKeys) lines.push_back(fmt::format("{:<{}} {}", keys, kKeyColumns, what));
    int width = 0;
    for (const std::string& line : lines) width = std::max(width, overlay.text_width(line));
    const int pitch = overlay.line_height(), height = pitch * static_cast<int>(lines.size() + 1);
    const Rect panel{(overlay.width() - width - pitch) / 2, (overlay.height() - height) / 2, width + pitch, height};
    overlay.fill(panel, kKeysPanel);
    int y = panel.top + pitch / 2;
    for (const std::string& line : lines) {
        overlay.rimmed_text(panel.left + pitch / 2, y, line, kInk);
        y += pitch;
    }
}

void draw_pointed(Overlay& overlay, int x, int y, const std::string& text) {
    constexpr int kGap = 3, kArm = 8;  // of the cross, whose middle stays free [px]
    const auto arm = [&](int dx, int dy) {
        for (int i = kGap; i < kArm; ++i) overlay.dot(x + i * dx, y + i * dy, kInk);
    };
    arm(1, 0), arm(-1, 0), arm(0, 1), arm(0, -1);
    const int margin = overlay.line_height() / 2;
    const std::vector<std::string> lines =
        wrapped(text, std::size_t(std::max(8, (overlay.width() - 2 * margin) / overlay.text_width(" "))));
    int row = overlay.height() - margin - int(lines.size()) * overlay.line_height();
    for (const std::string& line : lines) {
        overlay.rimmed_text((overlay.width() - overlay.text_width(line)) / 2, row, line, kInk);
        row += overlay.line_height();
    }
}

namespace {

constexpr Color kPanel = 0xD0101060;

}  // namespace

void Notices::say(std::string text, double now_s, double seconds) {
    notices_.push_back({std::move(text), now_s + seconds, {}});
}

void Notices::update(std::string_view about, std::string text, double now_s, double seconds) {
    std::erase_if(notices_, [&](const Notice& notice) { return notice.about == about; });
    notices_.push_back({std::move(text), now_s + seconds, std::string(about)});
}

void Notices::draw(Overlay& overlay, double now_s) {
    std::erase_if(notices_, [&](const Notice& notice) { return notice.until_s <= now_s; });
    const int margin = overlay.line_height() / 2;
    const auto most = std::size_t(std::max(8, (overlay.width() - 4 * margin) / (Font::kWidth * overlay.scale())));
    int y = margin;
    for (const Notice& notice : notices_)
        for (const std::string& piece : wrapped(notice.text, most)) {
            overlay.rimmed_text(margin, y, piece, kInk);
            y += overlay.line_height();
        }
    if (pinned_.empty()) return;
    std::vector<std::string> lines;
    for (const std::string& line : pinned_)
        for (std::string& piece : wrapped(line, most)) lines.push_back(std::move(piece));
    const Rect panel{margin, y, overlay.width() - 2 * margin, int(lines.size()) * overlay.line_height() + margin};
    overlay.fill(panel, kPanel);
    for (std::size_t i = 0; i < lines.size(); ++i)
        overlay.text(2 * margin, y + margin / 2 + int(i) * overlay.line_height(), lines[i], kInk);
}

}  // namespace enfilade
