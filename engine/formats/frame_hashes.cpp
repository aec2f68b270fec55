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

}  // namespace

Result<std::vector<FrameHash>> read_frame_hashes(std::string_view text) {
    std::vector<FrameHash> hashes;
    for (LineReader lines(text); const auto line = lines.next();) {
        if (line->text.empty() || line->text.starts_with('#')) continue;
        const Result<FrameHash> entry = read_line(*line);
        if (!entry) return entry.error();
        if (!hashes.empty() && entry.value().frame <= hashes.back().frame)
            return bad_line(*line, 0,
                            "frames must grow, found " + std::to_string(entry.value().frame) + " after " +
                                std::to_string(hashes.back().frame));
        hashes.push_back(entry.value());
    }
    return hashes;
}

std::string write_frame_hashes(const std::vector<FrameHash>& hashes) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text = "# Frames and their hashes, written by 'enfilade fly SCRIPT --record'.\n";
    for (const FrameHash& entry : hashes) {
        text += std::to_string(entry.frame) + ' ';
        for (int shift = 60; shift >= 0; shift -= 4) text += kDigits[(entry.hash >> shift) & 15];
        text += '\n';
    }
    return text;
}

}  // namespace enfilade
