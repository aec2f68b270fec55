#include "formats/frame_hashes.h"

#include <algorithm>
#include <charconv>

#include "formats/dials.h"
#include "formats/script.h"
#include "formats/text_parts.h"
#include "formats/words.h"

namespace enfilade {
namespace {

constexpr std::size_t kHashDigits = 16;

Error bad_line(const TextLine& line, std::size_t column, std::string what) {
    return {std::to_string(line.number) + ":" + std::to_string(column + 1), std::move(what)};
}

template <class Number>
bool read_whole(std::string_view text, int base, Number& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, base);
    return error == std::errc() && end == text.data() + text.size();
}

Result<std::uint64_t> read_hash(const TextLine& line, std::size_t column) {
    const std::string_view digits = line.text.substr(column);
    std::uint64_t hash = 0;
    if (digits.size() != kHashDigits || !read_whole(digits, 16, hash))
        return bad_line(line, column, "expected 16 hexadecimal digits, found " + in_quotes(digits));
    return hash;
}

Result<FrameHash> read_line(const TextLine& line) {
    const std::size_t blank = line.text.find(' ');
    if (blank == std::string_view::npos)
        return bad_line(line, 0, "expected \"FRAME HASH\", found " + in_quotes(line.text));
    FrameHash entry;
    if (!read_whole(line.text.substr(0, blank), 10, entry.frame) || entry.frame >= kMaxFlightFrames)
        return bad_line(line, 0, "expected a frame's number, found " + in_quotes(line.text.substr(0, blank)));
    const auto hash = read_hash(line, blank + 1);
    if (!hash) return hash.error();
    entry.hash = hash.value();
    return entry;
}

constexpr std::string_view kPictures = "picture ", kSheet = "sheet ";

/// The digits of a picture's width or height.
bool read_side(std::string_view text, std::uint32_t& side) {
    return read_whole(text, 10, side) && side > 0 && side <= kMaxPictureSide;
}

/// "picture WIDTHxHEIGHT RENDERER".
Result<RecordedPictures> read_pictures(const TextLine& line) {
    const std::string_view rest = line.text.substr(kPictures.size());
    const std::string_view size = rest.substr(0, rest.find(' '));
    const std::string_view width = size.substr(0, size.find('x'));
    RecordedPictures pictures;
    if (width == size || size == rest || !read_side(width, pictures.width) ||
        !read_side(size.substr(width.size() + 1), pictures.height))
        return bad_line(line, 0,
                        "expected \"picture WIDTHxHEIGHT RENDERER\", each side from 1 to " +
                            std::to_string(kMaxPictureSide) + " pixels, found " + in_quotes(line.text));
    pictures.renderer = rest.substr(size.size() + 1);
    if (std::ranges::find(kWords<RendererKind>, pictures.renderer) == kWords<RendererKind>.end())
        return bad_line(line, kPictures.size() + size.size() + 1,
                        "expected a renderer, found " + in_quotes(pictures.renderer) +
                            suggestion(pictures.renderer, kWords<RendererKind>));
    return pictures;
}

/// Reads a line about all frames into the recording; false where it is none of these, or the second of its kind.
Result<bool> read_heading(const TextLine& line, FrameRecording& recording) {
    if (!recording.pictures && line.text.starts_with(kPictures)) {
        auto pictures = read_pictures(line);
        if (!pictures) return pictures.error();
        recording.pictures = std::move(pictures).value();
        return true;
    }
    if (!recording.sheet && line.text.starts_with(kSheet)) {
        const auto hash = read_hash(line, kSheet.size());
        if (!hash) return hash.error();
        recording.sheet = hash.value();
        return true;
    }
    return false;
}

void add_hash(std::string& text, std::uint64_t hash) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    for (int shift = 60; shift >= 0; shift -= 4) text += kDigits[(hash >> shift) & 15];
    text += '\n';
}

}  // namespace

Result<FrameRecording> read_frame_hashes(std::string_view text) {
    FrameRecording recording;
    std::vector<FrameHash>& hashes = recording.frames;
    for (LineReader lines(text); const auto line = lines.next();) {
        if (line->text.empty() || line->text.starts_with('#')) continue;
        if (hashes.empty()) {
            const Result<bool> is_heading = read_heading(*line, recording);
            if (!is_heading) return is_heading.error();
            if (is_heading.value()) continue;
        }
        const Result<FrameHash> entry = read_line(*line);
        if (!entry) return entry.error();
        if (!hashes.empty() && entry.value().frame <= hashes.back().frame)
            return bad_line(*line, 0,
                            "frames must grow, found " + std::to_string(entry.value().frame) + " after " +
                                std::to_string(hashes.back().frame));
        hashes.push_back(entry.value());
    }
    return recording;
}

std::string write_frame_hashes(const FrameRecording& recording) {
    std::string text = "# Frames and their hashes, written by 'enfilade fly SCRIPT --record'.\n";
    if (const auto& pictures = recording.pictures)
        text += std::string(kPictures) + std::to_string(pictures->width) + "x" + std::to_string(pictures->height) +
                " " + pictures->renderer + "\n";
    if (recording.sheet) add_hash(text += kSheet, *recording.sheet);
    for (const FrameHash& entry : recording.frames) add_hash(text += std::to_string(entry.frame) + ' ', entry.hash);
    return text;
}

}  // namespace enfilade
