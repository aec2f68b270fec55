// Arguments that several commands share, from text to values. Each parser takes an argument as it was typed and says
// what was expected where it is something else.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "formats/views_csv.h"
#include "map/map.h"
#include "render/choice/renderer.h"
#include "render/view.h"
#include "world/snapshot.h"

namespace enfilade {

/// The size of a picture [px], each in 1..kMaxPictureSide.
struct PictureSize {
    int width = 1280;
    int height = 800;
    bool operator==(const PictureSize&) const = default;
};

/// "WIDTHxHEIGHT".
Result<PictureSize> parse_size(const std::string& text);

/// What the dials are set to, by an accuracy and single dials, as typed.
struct DialRequest {
    std::string accuracy;            ///< empty where not given
    std::vector<std::string> dials;  ///< "NAME=VALUE"
    std::optional<int> samples;

    bool is_given() const { return !accuracy.empty() || !dials.empty() || samples; }
};

/// The dials `from` and what is asked for on top of them. An error where the renderer has no such dials, they do not go
/// together, or pictures of this size would be drawn too large to take means of their samples.
Result<Dials> dials_from(const DialRequest& request, Dials from, RendererKind renderer, PictureSize size);

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

/// One of several parts of a flight's frames, as even as can be.
struct FramePart {
    int number = 1;  ///< counted from 1
    int count = 1;
};

/// "K/N", 1 <= K <= N.
Result<FramePart> parse_part(const std::string& text);

/// The frames of a part of a flight of so many; an error where that has none.
Result<FrameRange> frames_of(const FramePart& part, int frames);

/// "expected a command, found 'chekc'; did you mean 'check'?", or which command takes the file of that name.
std::string unknown_command(const std::string& word, std::span<const std::string_view> commands);

/// The views of a list; none where it is refused, its findings then are on stderr.
std::optional<std::vector<ViewRow>> open_views(const std::string& path);

/// An error where true pitch is wanted of the column renderer, whose columns stay upright.
Result<void> refuse_true_pitch(RendererKind renderer, bool wanted);

}  // namespace enfilade
