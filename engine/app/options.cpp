#include "app/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "app/messages.h"
#include "app/open_map.h"
#include "base/files.h"
#include "base/text.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

/// The whole text as a whole number, or none.
std::optional<int> whole_number_in(std::string_view text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return {};
    return number;
}

bool is_side(const std::optional<int>& pixels) { return pixels && *pixels >= 1 && *pixels <= kMaxPictureSide; }

/// An error where a picture would be drawn too large to take means of samples x samples of its pixels.
Result<void> check_samples(int samples, PictureSize size) {
    const int most = kMaxPictureSide / std::max(size.width, size.height);
    if (samples <= most) return {};
    return Error{"--samples", fmt::format("expected at most {} for a picture of {}x{}, which is drawn that many times "
                                          "as wide and as high, at most {}; found {}",
                                          most, size.width, size.height, kMaxPictureSide, samples)};
}

}  // namespace

Result<PictureSize> parse_size(const std::string& text) {
    if (const auto x = text.find('x'); x != std::string::npos) {
        const auto width = whole_number_in(std::string_view(text).substr(0, x));
        const auto height = whole_number_in(std::string_view(text).substr(x + 1));
        if (is_side(width) && is_side(height)) return PictureSize{*width, *height};
    }
    return Error{"--size", fmt::format("expected WIDTHxHEIGHT in pixels, each from 1 to {}, for example 1280x800; "
                                       "found {}",
                                       kMaxPictureSide, in_quotes(text))};
}

Result<Dials> dials_from(const DialRequest& request, Dials from, RendererKind renderer, PictureSize size) {
    if (!request.accuracy.empty())
        if (const Result<void> valid = set_accuracy(from, request.accuracy); !valid.ok())
            return Error{"--accuracy", valid.error().what};
    for (const std::string& dial : request.dials)
        if (const Result<void> valid = set_dial(from, dial); !valid.ok()) return Error{"--dial", valid.error().what};
    if (request.samples) from.samples = *request.samples;
    if (const Result<void> valid = check_dials(renderer, from); !valid.ok()) return Error{"--dial", valid.error().what};
    if (const Result<void> valid = check_samples(from.samples, size); !valid.ok()) return valid.error();
    return from;
}

Result<PixelPlace> parse_pixel(const std::string& text, PictureSize size) {
    if (const auto comma = text.find(','); comma != std::string::npos) {
        const auto x = whole_number_in(std::string_view(text).substr(0, comma));
        const auto y = whole_number_in(std::string_view(text).substr(comma + 1));
        if (x && y && *x >= 0 && *x < size.width && *y >= 0 && *y < size.height) return PixelPlace{*x, *y};
    }
    return Error{"--at",
                 fmt::format("expected X,Y in pixels of the picture, X from 0 to {} and Y from 0 to {}; found {}",
                             size.width - 1, size.height - 1, in_quotes(text))};
}

Result<FrameRange> parse_frames(const std::string& text) {
    const auto dots = text.find("..");
    const auto first = whole_number_in(std::string_view(text).substr(0, dots));
    const auto last = dots == std::string::npos ? first : whole_number_in(std::string_view(text).substr(dots + 2));
    if (first && last && *first >= 0 && *first <= *last) return FrameRange{*first, *last};
    return Error{"--frames",
                 fmt::format("expected FIRST..LAST, counted from 0, for example 0..59; found {}", in_quotes(text))};
}

Result<FramePart> parse_part(const std::string& text) {
    const auto slash = text.find('/');
    const auto number = whole_number_in(std::string_view(text).substr(0, slash));
    const auto count = slash == std::string::npos ? number : whole_number_in(std::string_view(text).substr(slash + 1));
    if (slash != std::string::npos && number && count && *number >= 1 && *number <= *count)
        return FramePart{*number, *count};
    return Error{"--part",
                 fmt::format("expected K/N, the K-th of N parts, for example 1/8; found {}", in_quotes(text))};
}

Result<FrameRange> frames_of(const FramePart& part, int frames) {
    const auto begin_of = [&](std::int64_t number) { return int(frames * (number - 1) / part.count); };
    const FrameRange range{begin_of(part.number), begin_of(std::int64_t{part.number} + 1) - 1};
    if (range.first <= range.last) return range;
    return Error{"--part", fmt::format("the flight has {}, fewer than {} parts", counted(std::size_t(frames), "frame"),
                                       part.count)};
}

std::string unknown_command(const std::string& word, std::span<const std::string_view> commands) {
    if (is_file(word)) return "expected a command, " + about_file(word);
    return "expected a command, found " + in_quotes(word) + suggestion(word, commands);
}

std::optional<std::vector<ViewRow>> open_views(const std::string& path) {
    const auto bytes = read_file(path);
    if (!bytes.ok()) {
        fail(bytes.error());
        return {};
    }
    ViewsReading reading = read_views(as_text(bytes.value()));
    if (print_findings(path, reading.findings, Talk::usual)) return {};
    if (reading.views.empty()) {
        fail({path, "expected at least one view below the names of the columns; the list has none"});
        return {};
    }
    return std::move(reading.views);
}

Result<void> refuse_true_pitch(RendererKind renderer, bool wanted) {
    if (!wanted || renderer != RendererKind::column) return {};
    return Error{"--true-pitch",
                 "the column renderer draws upright columns and can only shift the horizon; add --renderer stencil or "
                 "--renderer reference"};
}

}  // namespace enfilade
