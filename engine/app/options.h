// Arguments that several commands share, from text to values. Each parser takes an argument as it was typed and says
// what was expected where it is something else.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"

namespace enfilade {

/// The size of a picture [px], each in 1..kMaxPictureSide.
struct PictureSize {
    int width = 1280;
    int height = 800;
    bool operator==(const PictureSize&) const = default;
};

/// "WIDTHxHEIGHT".
Result<PictureSize> parse_size(const std::string& text);

/// An error where a picture would be drawn too large to take means of samples x samples of its pixels.
Status check_samples(int samples, PictureSize size);

/// A pixel of a picture, counted from the upper left corner [px].
struct PixelPlace {
    int x = 0;
    int y = 0;
    bool operator==(const PixelPlace&) const = default;
};

/// "X,Y", inside a picture of that size.
Result<PixelPlace> parse_pixel(const std::string& text, PictureSize size);

/// A range of frames, both ends included.
struct FrameRange {
    int first = 0;
    int last = 0;
    bool operator==(const FrameRange&) const = default;
};

/// "A..B" or "A", A <= B.
Result<FrameRange> parse_frames(const std::string& text);

// What is said about words of a command line that nobody knows.

/// "expected a command, found 'chekc'; did you mean 'check'?", or which command takes the file of that name.
std::string unknown_command(const std::string& word, std::span<const std::string_view> commands);

/// "there is no option '--siez' here; did you mean '--size'?" word : starts with '-'
std::string unknown_option(const std::string& word, std::span<const std::string_view> options);

}  // namespace enfilade
