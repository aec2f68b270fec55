#include "formats/frame_hashes.h"

#include <charconv>

#include "formats/lines.h"
#include "formats/quoted.h"

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

Result<FrameHash> read_line(const TextLine& line) {
    const std::size_t blank = line.text.find(' ');
    if (blank == std::string_view::npos)
        return bad_line(line, 0, "expected \"FRAME HASH\", found " + quoted(line.text));
    FrameHash entry;
    if (!read_whole(line.text.substr(0, blank), 10, entry.frame))
        return bad_line(line, 0, "expected a frame's number, found " + quoted(line.text.substr(0, blank)));
    const std::string_view digits = line.text.substr(blank + 1);
    if (digits.size() != kHashDigits || !read_whole(digits, 16, entry.hash))
        return bad_line(line, blank + 1, "expected 16 hexadecimal digits, found " + quoted(digits));
    return entry;
}

constexpr std::string_view kPicture = "picture ";

/// "picture WIDTHxHEIGHT RENDERER".
Status read_picture(const TextLine& line, FrameRecording& recording) {
    const std::string_view rest = line.text.substr(kPicture.size());
    const std::size_t blank = rest.find(' '), x = rest.find('x');
    const bool has_parts = blank != std::string_view::npos && x < blank;
    if (!has_parts || !read_whole(rest.substr(0, x), 10, recording.width) ||
        !read_whole(rest.substr(x + 1, blank - x - 1), 10, recording.height))
        return bad_line(line, 0, "expected \"picture WIDTHxHEIGHT RENDERER\", found " + quoted(line.text));
    recording.renderer = rest.substr(blank + 1);
    return {};
}

}  // namespace

Result<FrameRecording> read_frame_hashes(std::string_view text) {
    FrameRecording recording;
    std::vector<FrameHash>& hashes = recording.frames;
    for (LineReader lines(text); const auto line = lines.next();) {
        if (line->text.empty() || line->text.starts_with('#')) continue;
        if (hashes.empty() && line->text.starts_with(kPicture)) {
            if (Status wrong = read_picture(*line, recording)) return *wrong;
            continue;
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
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text = "# Frames and their hashes, written by 'enfilade fly SCRIPT --record'.\n";
    if (recording.width > 0)
        text += std::string(kPicture) + std::to_string(recording.width) + "x" + std::to_string(recording.height) + " " +
                recording.renderer + "\n";
    for (const FrameHash& entry : recording.frames) {
        text += std::to_string(entry.frame) + ' ';
        for (int shift = 60; shift >= 0; shift -= 4) text += kDigits[(entry.hash >> shift) & 15];
        text += '\n';
    }
    return text;
}

}  // namespace enfilade
