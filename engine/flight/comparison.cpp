#include "flight/comparison.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "base/result.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

/// The largest difference in red, green or blue.
int channel_difference(std::uint32_t a, std::uint32_t b) {
    int largest = 0;
    for (int shift = 0; shift < 24; shift += 8)
        largest = std::max(largest, std::abs(int(a >> shift & 255) - int(b >> shift & 255)));
    return largest;
}

std::uint32_t dim_grey(std::uint32_t color) {
    const std::uint32_t grey = ((color & 255) + (color >> 8 & 255) + (color >> 16 & 255)) / 9;
    return 0xFF000000u | grey << 16 | grey << 8 | grey;
}

/// Red for the smallest difference, white for the largest.
std::uint32_t alarm(int difference) {
    const auto rest = static_cast<std::uint32_t>(difference);
    return 0xFF0000FFu | rest << 16 | rest << 8;
}

std::string hex(std::uint64_t hash) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

std::string figure(const std::string& picture, const std::string& caption) {
    const std::string image = picture.empty() ? "" : "<img src=\"" + xml_escaped(picture) + "\"><br>";
    return "<td>" + image + xml_escaped(caption) + "</td>";
}

/// What the difference picture shows; nothing where there is none.
std::string difference_text(const MismatchRow& row) {
    if (row.difference_picture.empty()) return {};
    std::string text = std::to_string(row.pixels) + " of " + std::to_string(row.of_pixels) + " pixels differ, by " +
                       std::to_string(row.largest) + " of 255 at most";
    if (row.reduction > 1) text += "; both pictures " + std::to_string(row.reduction) + " times smaller";
    if (row.pixels == 0) text += ": the frames differ by less than such small pictures can show";
    return text;
}

std::string row_text(const MismatchRow& row) {
    return "<tr><th>frame " + std::to_string(row.mismatch.frame) + "</th>" +
           figure(row.expected_picture, row.expected_origin + ", hash " + hex(row.mismatch.expected)) +
           figure(row.actual_picture, "hash " + hex(row.mismatch.actual)) +
           figure(row.difference_picture, difference_text(row)) + "</tr>\n";
}

constexpr int kColumns = 4;  ///< pictures side by side: twelve of 80 x 50 make a sheet of a picture's usual shape
constexpr std::uint32_t kBlack = 0xFF000000u;

int parts(int whole, int part) { return (whole + part - 1) / part; }

/// The mean, rounded, of the pixels [left, right) x [top, bottom).
std::uint32_t mean_color(const Frame& picture, int left, int top, int right, int bottom) {
    std::uint64_t sums[3] = {};
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x)
            for (int channel = 0; channel < 3; ++channel)
                sums[channel] +=
                    picture.pixels[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)] >> 8 * channel & 255;
    const auto count = std::uint64_t(right - left) * std::uint64_t(bottom - top);
    std::uint32_t color = kBlack;
    for (int channel = 0; channel < 3; ++channel)
        color |= static_cast<std::uint32_t>((sums[channel] + count / 2) / count) << 8 * channel;
    return color;
}

}  // namespace

Difference difference_of(const Frame& expected, const Frame& actual) {
    Difference found;
    found.picture.resize(expected.width, expected.height);
    for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
        const int difference = channel_difference(expected.pixels[i], actual.pixels[i]);
        found.pixels += difference > 0;
        found.largest = std::max(found.largest, difference);
        found.picture.pixels[i] = difference > 0 ? alarm(difference) : dim_grey(expected.pixels[i]);
    }
    return found;
}

std::vector<Mismatch> mismatches(const std::vector<FrameHash>& recorded, int first,
                                 const std::vector<std::uint64_t>& actual) {
    std::vector<Mismatch> found;
    for (const FrameHash& frame : recorded) {
        const std::int64_t i = std::int64_t{frame.frame} - first;
        if (i < 0 || i >= std::int64_t(actual.size()) || actual[std::size_t(i)] == frame.hash) continue;
        found.push_back({static_cast<int>(frame.frame), frame.hash, actual[std::size_t(i)]});
    }
    return found;
}

std::string mismatch_page(const ReportText& text, const std::vector<MismatchRow>& rows) {
    std::string page = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" +
                       xml_escaped(text.title) +
                       "</title>\n<style>body{font-family:sans-serif;background:#222;color:#ddd}"
                       "img{width:28vw;image-rendering:pixelated}td,th{padding:.5em;vertical-align:top}</style>"
                       "</head>\n<body><h1>" +
                       xml_escaped(text.title) + "</h1>\n<p>" + std::to_string(text.total) + " frames differ; " +
                       std::to_string(rows.size()) + " are shown. " + xml_escaped(text.advice) +
                       "</p>\n<table><tr><th></th><th>expected</th><th>actual</th><th>difference</th></tr>\n";
    for (const MismatchRow& row : rows) page += row_text(row);
    return page + "</table></body></html>\n";
}

int reduction_of(int width, int height) { return parts(std::max(width, height), kSmallSide); }

Frame reduced(const Frame& picture, int reduction) {
    Frame small;
    small.resize(parts(picture.width, reduction), parts(picture.height, reduction));
    auto pixel = small.pixels.begin();
    for (int top = 0; top < picture.height; top += reduction)
        for (int left = 0; left < picture.width; left += reduction)
            *pixel++ = mean_color(picture, left, top, std::min(left + reduction, picture.width),
                                  std::min(top + reduction, picture.height));
    return small;
}

std::vector<int> frames_on_sheet(int frames) {
    const int count = std::min(frames, kMostOnSheet);
    std::vector<int> chosen{0};
    for (int i = 1; i < count; ++i) chosen.push_back(static_cast<int>(std::int64_t{i} * (frames - 1) / (count - 1)));
    return chosen;
}

ContactSheet::ContactSheet(int frames, int width, int height)
    : frames_(frames_on_sheet(frames)),
      reduction_(reduction_of(width, height)),
      width_(parts(width, reduction_)),
      height_(parts(height, reduction_)) {
    const int count = static_cast<int>(frames_.size());
    image_.resize(std::min(count, kColumns) * width_, parts(count, kColumns) * height_);
    std::ranges::fill(image_.pixels, kBlack);
}

bool ContactSheet::take(Frame image) {
    if (image.width != image_.width || image.height != image_.height) return false;
    image_ = std::move(image);
    return true;
}

std::optional<std::size_t> ContactSheet::place_of(int frame) const {
    const auto found = std::ranges::lower_bound(frames_, frame);
    if (found == frames_.end() || *found != frame) return {};
    const auto number = static_cast<int>(found - frames_.begin());
    const int row = number / kColumns * height_, column = number % kColumns * width_;
    return std::size_t(row) * std::size_t(image_.width) + std::size_t(column);
}

void ContactSheet::put(int frame, const Frame& picture) {
    if (place_of(frame)) put_small(frame, reduced(picture, reduction_));
}

void ContactSheet::put_small(int frame, const Frame& small) {
    const auto place = place_of(frame);
    if (!place) return;
    ENFILADE_CHECK(small.width == width_ && small.height == height_);
    for (int y = 0; y < height_; ++y)
        std::copy_n(small.pixels.begin() + y * width_, width_,
                    image_.pixels.begin() + std::ptrdiff_t(*place) + y * image_.width);
}

std::optional<Frame> ContactSheet::picture_of(int frame) const {
    const auto place = place_of(frame);
    if (!place) return {};
    Frame small;
    small.resize(width_, height_);
    for (int y = 0; y < height_; ++y)
        std::copy_n(image_.pixels.begin() + std::ptrdiff_t(*place) + y * image_.width, width_,
                    small.pixels.begin() + y * width_);
    return small;
}

namespace {

std::string size_text(std::uint32_t width, std::uint32_t height) {
    return std::to_string(width) + "x" + std::to_string(height);
}

/// Where the recording is of pictures that these can never be equal to.
Result<void> other_pictures(const FrameRecording& recording, const DrawPlan& plan, const std::string& script_path) {
    if (!recording.pictures) return {};
    const RecordedPictures& pictures = *recording.pictures;
    const std::string recorded = size_text(pictures.width, pictures.height),
                      drawn = size_text(std::uint32_t(plan.width), std::uint32_t(plan.height));
    if (recorded != drawn)
        return Error{script_path, "the recording has pictures of " + recorded + " pixels, and these have " + drawn +
                                      "; check with --size " + recorded + ", or record it again with --record"};
    if (pictures.renderer == name_of(plan.renderer)) return {};
    return Error{script_path, "the recording was drawn by the " + pictures.renderer +
                                  " renderer, and these pictures are by " + name_of(plan.renderer) +
                                  "; check with --renderer " + pictures.renderer +
                                  ", or compare the two with --check --against " + pictures.renderer};
}

/// Where the recording does not cover exactly the frames of the flight.
Result<void> other_frames(const std::vector<FrameHash>& recorded, int frames, const std::string& script_path) {
    bool same = recorded.size() == std::size_t(frames);
    for (std::size_t i = 0; same && i < recorded.size(); ++i) same = recorded[i].frame == i;
    if (same) return {};
    return Error{script_path, "the flight has " + counted(std::size_t(frames), "frame") + ", but " +
                                  std::to_string(recorded.size()) +
                                  " others were recorded; record it again with --record if that is meant"};
}

}  // namespace

std::string hashes_path(const std::string& script_path) {
    return std::filesystem::path(script_path).replace_extension(".hashes").string();
}

Result<FrameRecording> read_recording(const std::string& script_path, const FileReader& read) {
    const std::string path = hashes_path(script_path);
    const auto bytes = read(path);
    if (!bytes.ok()) return Error{path, bytes.error().what + "; `enfilade fly --record` makes it"};
    auto recording = read_frame_hashes(as_text(bytes.value()));
    if (!recording.ok()) return Error{path + ":" + recording.error().where, recording.error().what};
    return recording;
}

Result<void> refuse_recording(const FrameRecording& recording, const DrawPlan& plan, int flight_frames,
                              const std::string& script_path) {
    if (const Result<void> valid = other_pictures(recording, plan, script_path); !valid.ok()) return valid.error();
    return other_frames(recording.frames, flight_frames, script_path);
}

Result<std::vector<std::uint64_t>> hash_frames(const FlightScene& scene, const DrawPlan& plan, const FrameTaker& also) {
    std::vector<std::uint64_t> hashes(frames_of(plan));
    const Result<void> drawn =
        draw_frames(scene, plan, [&](int number, const Frame& frame, std::size_t worker) -> Result<void> {
            hashes[std::size_t(number - plan.first)] = hash_of(frame);
            return also ? also(number, frame, worker) : Result<void>{};
        });
    if (!drawn.ok()) return drawn.error();
    return hashes;
}

}  // namespace enfilade
