#include "app/play/notices.h"

#include <algorithm>

#include "app/draw/wrapped.h"

namespace enfilade {
namespace {

constexpr Color kInk = 0xFFFFFFFF, kPanel = 0xD0101060;

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
    const Box panel{margin, y, overlay.width() - 2 * margin, int(lines.size()) * overlay.line_height() + margin};
    overlay.fill(panel, kPanel);
    for (std::size_t i = 0; i < lines.size(); ++i)
        overlay.text(2 * margin, y + margin / 2 + int(i) * overlay.line_height(), lines[i], kInk);
}

}  // namespace enfilade
