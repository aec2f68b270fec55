// Arguments that several commands share, from text to values. Each parser takes an argument as it was typed and says
// what was expected where it is something else.
#pragma once
#include <string>
#include <vector>

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

/// Where to look from, as typed: not yet a place in a map.
struct Viewpoint {
    double x = 0, y = 0, z = 0;  ///< of the eye [m]
    double yaw_degrees = 0;      ///< any
    double pitch_degrees = 0;    ///< within +-kMaxPitchDegrees
    std::string sector;          ///< empty: found from x and y
};

/// Steepest look [degrees]: at 90 the horizon of a sheared picture would be infinitely far away.
inline constexpr double kMaxPitchDegrees = 89;

/// "X,Y,Z,YAW,PITCH".
Result<Viewpoint> parse_viewpoint(const std::string& text);

/// An error where a number is not finite, off the map or too steep.
Status check_viewpoint(const Viewpoint& viewpoint);

/// A range of frames, both ends included.
struct FrameRange {
    int first = 0;
    int last = 0;
    bool operator==(const FrameRange&) const = default;
};

/// "A..B" or "A", A <= B.
Result<FrameRange> parse_frames(const std::string& text);

/// A whole text as one finite number, or an error naming the argument.
Result<double> parse_number(const std::string& argument, const std::string& text);

}  // namespace enfilade
