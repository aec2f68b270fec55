// Films: frames one after the other into a .y4m or .mp4 file.
#pragma once
#include <memory>
#include <string>

#include "base/result.h"
#include "render/frame.h"

namespace enfilade {

/// What a film is like [px], [frames/s].
struct FilmFormat {
    int width = 0, height = 0, rate = 30;
};

/// A film that is being written, beside its final place. One that is not finished leaves nothing behind.
class Film {
public:
    virtual ~Film() = default;
    virtual Status add(const Frame& frame) = 0;
    /// No frame comes any more: the film takes its place.
    virtual Status finish() = 0;
};

/// Whether the path ends like a film that can be written, or names a stream (base/output_file.h).
bool names_film(const std::string& path);

/// .mp4 is written by the program ffmpeg, and it is an error where that is not installed; all else is .y4m, written
/// here.
Result<std::unique_ptr<Film>> start_film(const std::string& path, const FilmFormat& format);

}  // namespace enfilade
