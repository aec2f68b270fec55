#include "app/options.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "math/grid.h"
#include "render/view.h"

namespace enfilade {
namespace {

/// The whole text as a number, or none.
template <class Number>
std::optional<Number> number_in(std::string_view text) {
    Number number{};
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return {};
    return number;
}

std::optional<double> finite_in(std::string_view text) {
    const auto number = number_in<double>(text);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const auto at = text.find(separator);
        parts.push_back(text.substr(0, at));
        if (at == std::string_view::npos) return parts;
        text.remove_prefix(at + 1);
    }
}

bool is_side(const std::optional<int>& pixels) { return pixels && *pixels >= 1 && *pixels <= kMaxPictureSide; }

}  // namespace

Result<PictureSize> parse_size(const std::string& text) {
    const auto parts = split(text, 'x');
    if (parts.size() == 2) {
        const auto width = number_in<int>(parts[0]), height = number_in<int>(parts[1]);
        if (is_side(width) && is_side(height)) return PictureSize{*width, *height};
    }
    return Error{"--size", fmt::format("expected WIDTHxHEIGHT in pixels, each from 1 to {}, for example 1280x800; "
                                       "found '{}'",
                                       kMaxPictureSide, text)};
}

Result<Viewpoint> parse_viewpoint(const std::string& text) {
    const auto parts = split(text, ',');
    std::vector<double> numbers;
    for (const auto part : parts)
        if (const auto number = finite_in(part)) numbers.push_back(*number);
    if (parts.size() != 5 || numbers.size() != 5)
        return Error{"--view", fmt::format("expected five numbers X,Y,Z,YAW,PITCH (metres and degrees), for example "
                                           "3.5,2,1.7,90,0; found '{}'",
                                           text)};
    Viewpoint viewpoint{numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], {}};
    if (Status wrong = check_viewpoint(viewpoint)) return Error{"--view", wrong->what};
    return viewpoint;
}

Status check_viewpoint(const Viewpoint& viewpoint) {
    const auto off_map = [](double metres) { return !(std::abs(metres) <= kWorldLimit); };
    if (off_map(viewpoint.x) || off_map(viewpoint.y) || off_map(viewpoint.z))
        return Error{"", fmt::format("expected x, y and z within {} metres of the origin; found {}, {}, {}",
                                     kWorldLimit, viewpoint.x, viewpoint.y, viewpoint.z)};
    if (!(std::abs(viewpoint.yaw_degrees) <= 1e9))  // far beyond any use, well inside what Angle takes
        return Error{"", fmt::format("expected a yaw in degrees; found {}", viewpoint.yaw_degrees)};
    if (!(std::abs(viewpoint.pitch_degrees) <= kMaxPitchDegrees))
        return Error{"", fmt::format("expected a pitch from -{0} to {0} degrees; found {1}", kMaxPitchDegrees,
                                     viewpoint.pitch_degrees)};
    return {};
}

Result<FrameRange> parse_frames(const std::string& text) {
    const auto dots = text.find("..");
    const auto first = number_in<int>(std::string_view(text).substr(0, dots));
    const auto last = dots == std::string::npos ? first : number_in<int>(std::string_view(text).substr(dots + 2));
    if (first && last && *first >= 0 && *first <= *last) return FrameRange{*first, *last};
    return Error{"--frames", fmt::format("expected FIRST..LAST, counted from 0, for example 0..59; found '{}'", text)};
}

Result<double> parse_number(const std::string& argument, const std::string& text) {
    if (const auto number = finite_in(text)) return *number;
    return Error{argument, fmt::format("expected a number; found '{}'", text)};
}

}  // namespace enfilade
