#include "app/play/end_screen.h"

#include <fmt/format.h>

#include <set>
#include <vector>

namespace enfilade {
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
