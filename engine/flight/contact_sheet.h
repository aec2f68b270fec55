// Small pictures of a flight, side by side in one image: what a recording keeps for the human eye beside its hashes.
#pragma once
#include <optional>
#include <vector>

#include "render/frame.h"

namespace enfilade {

/// Most pictures on a sheet, and the longest side of each [px]: 12 * 80 * 80 pixels of three bytes are 225 KiB, and
/// twenty shipped flythroughs of 80 x 50 take 2 MB.
inline constexpr int kMostOnSheet = 12, kSmallSide = 80;

/// How many pixels of a picture of this size [px, >= 1] make one of its small picture, each way: the least that leaves
/// at most kSmallSide.
int reduction_of(int width, int height);

/// The picture with the mean colour of each reduction x reduction pixels as one; fewer at the right and lower edges.
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

}  // namespace enfilade
