// The hashes a flythrough's frames had when they were recorded: a text file beside the script.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace enfilade {

/// What one frame looked like.
struct FrameHash {
    std::uint32_t frame = 0;  ///< its number, below kMaxFlightFrames
    std::uint64_t hash = 0;
    bool operator==(const FrameHash&) const = default;
};

/// How the frames of a recording were drawn.
struct RecordedPictures {
    std::uint32_t width = 1, height = 1;  ///< of each frame [px], 1..kMaxPictureSide
    std::string renderer;                 ///< a word for a RendererKind
    bool operator==(const RecordedPictures&) const = default;
};

/// What a flythrough looked like.
struct FrameRecording {
    std::optional<RecordedPictures> pictures;  ///< none: the recording does not say
    std::optional<std::uint64_t> sheet;        ///< hash of the sheet of small pictures beside it; none: there is none
    std::vector<FrameHash> frames;
    bool operator==(const FrameRecording&) const = default;
};

/// Reads "FRAME HASH" lines, HASH as 16 hexadecimal digits, frames growing, and before them at most one line "picture
/// WIDTHxHEIGHT RENDERER" and one "sheet HASH"; empty lines and lines that start with '#' are skipped. `where` of an
/// error is "line:column".
Result<FrameRecording> read_frame_hashes(std::string_view text);

/// The text that reads back as this, with a comment that says what it is. Frames must grow.
std::string write_frame_hashes(const FrameRecording& recording);

}  // namespace enfilade
