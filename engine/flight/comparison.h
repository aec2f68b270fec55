// Two frames that should be the same: where they differ, and a page that shows it.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "formats/frame_hashes.h"
#include "render/frame.h"

namespace enfilade {

/// Two frames of the same size, pixel by pixel.
struct Difference {
    std::size_t pixels = 0;  ///< that differ
    int largest = 0;         ///< difference in one of red, green and blue, 0..255
    Frame picture;  ///< the expected picture, grey and dim; differing pixels from red (a little) to white (a lot)
};

/// expected and actual have the same size.
Difference difference_of(const Frame& expected, const Frame& actual);

/// A frame whose hash is not the recorded one.
struct Mismatch {
    int frame = 0;
    std::uint64_t expected = 0, actual = 0;  ///< hashes
};

/// Frames of [first, last] whose hash differs from the recorded one. actual[i] is of frame first + i. Frames that were
/// never recorded are not in the list.
std::vector<Mismatch> mismatches(const std::vector<FrameHash>& recorded, int first,
                                 const std::vector<std::uint64_t>& actual);

/// One row of the page. Picture paths are relative to the page; empty: there is none.
struct MismatchRow {
    Mismatch mismatch;
    std::string expected_picture, actual_picture, difference_picture;
    std::string expected_origin;  ///< where the expected picture is from, or why there is none
    int reduction = 1;            ///< of the two pictures that were compared
    std::size_t pixels = 0;       ///< that differ between these two
    std::size_t of_pixels = 0;    ///< that each of them has
    int largest = 0;
};

/// What a page says beside its rows.
struct ReportText {
    std::string title;
    std::string advice;     ///< sentences: what to do about it
    std::size_t total = 0;  ///< all frames that differ; only some have rows
};

/// A page of its own, without scripts or anything from elsewhere.
std::string mismatch_page(const ReportText& text, const std::vector<MismatchRow>& rows);

}  // namespace enfilade
