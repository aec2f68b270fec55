// Flythroughs and what was recorded of them: the hashes beside a script, where frames differ, and a page that shows it.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/result.h"
#include "flight/flight.h"
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
    int largest = 0;              ///< as in Difference
};

/// What a page says beside its rows.
struct ReportText {
    std::string title;
    std::string advice;     ///< sentences: what to do about it
    std::size_t total = 0;  ///< all frames that differ; only some have rows
};

/// A page of its own, without scripts or anything from elsewhere.
std::string mismatch_page(const ReportText& text, const std::vector<MismatchRow>& rows);

// Small pictures of a flight, side by side in one image: what a recording keeps for the human eye beside its hashes.

/// Most pictures on a sheet, and the longest side of each [px]: 12 * 80 * 80 pixels of three bytes are 225 KiB, and
/// twenty shipped flythroughs of 80 x 50 take 2 MB.
inline constexpr int kMostOnSheet = 12, kSmallSide = 80;

/// How many pixels of a picture of this size [px, >= 1] make one of its small picture, each way: the least that leaves
/// at most kSmallSide.
int reduction_of(int width, int height);

/// The picture with the mean colour of each reduction x reduction pixels as one; fewer at the right and lower edges.
/// reduction : >= 1; 1 changes nothing but alpha, which is full then
Frame reduced(const Frame& picture, int reduction);

/// Which frames of a flight of so many (>= 1) are on its sheet: all of a short one, else kMostOnSheet evenly from the
/// first to the last. Growing.
std::vector<int> frames_on_sheet(int frames);

/// The sheet of one flight: four pictures a row, in order of frames; what no picture covers is black.
class ContactSheet {
public:
    /// An empty sheet for a flight of so many frames of this size [px], all >= 1.
    ContactSheet(int frames, int width, int height);

    /// Takes a whole image for the sheet; false, and no change, where it has not the sheet's size.
    bool take(Frame image);

    /// Puts the frame's small picture in its place; nothing for a frame that is not on the sheet. Several threads may
    /// put different frames.
    void put(int frame, const Frame& picture);

    /// The same with a small picture, as picture_of() of a sheet of the same flight gives it.
    void put_small(int frame, const Frame& small);

    /// The small picture of a frame; none where it is not on the sheet.
    std::optional<Frame> picture_of(int frame) const;

    const Frame& image() const { return image_; }

private:
    /// The number of the first pixel of a frame's picture; none where it is not on the sheet.
    std::optional<std::size_t> place_of(int frame) const;

    std::vector<int> frames_;
    int reduction_, width_, height_;  ///< width and height of one small picture [px]
    Frame image_;
};

// What a flythrough looked like when it was recorded: the hashes beside its script, and those of its frames now.

/// The hashes beside a script: "tour.hashes" of "tour.toml".
std::string hashes_path(const std::string& script_path);

/// What was recorded of the script. An error where the file of hashes cannot be read or is none.
Result<FrameRecording> read_recording(const std::string& script_path, const FileReader& read);

/// An error where the recording can never be equal to what the plan draws: it is of pictures of another size or
/// renderer, or of another number of frames than the flight has.
Result<void> refuse_recording(const FrameRecording& recording, const DrawPlan& plan, int flight_frames,
                              const std::string& script_path);

/// How many frames a plan draws.
inline std::size_t frames_of(const DrawPlan& plan) { return std::size_t(plan.last - plan.first + 1); }

/// The hash of every frame of the plan, in order; `also` sees every frame, too, as draw_frames() hands them over.
Result<std::vector<std::uint64_t>> hash_frames(const FlightScene& scene, const DrawPlan& plan,
                                               const FrameTaker& also = {});

}  // namespace enfilade
