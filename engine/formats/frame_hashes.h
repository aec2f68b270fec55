// The hashes a flythrough's frames had when they were recorded: a text file beside the script.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace enfilade {

/// What one frame looked like.
struct FrameHash {
    std::uint32_t frame = 0;
    std::uint64_t hash = 0;
    bool operator==(const FrameHash&) const = default;
};

/// Reads "FRAME HASH" lines, HASH as 16 hexadecimal digits, frames growing; empty lines and lines that start with '#'
/// are skipped. `where` of an error is "line:column".
Result<std::vector<FrameHash>> read_frame_hashes(std::string_view text);

/// The text that reads back as these, with a comment that says what it is. Frames must grow.
std::string write_frame_hashes(const std::vector<FrameHash>& hashes);

}  // namespace enfilade
