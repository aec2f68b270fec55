// Pictures and films: frames as files.
#pragma once
#include <memory>
#include <string>

#include "base/files.h"
#include "base/result.h"
#include "formats/png.h"
#include "render/frame.h"

namespace enfilade {

// Finished frames as picture files.

/// 24-bit surface ids as colours: red is the high byte.
Image ids_image(const FrameFacts& facts, int width, int height);

/// Whether a path names one PNG file or a stream (base/files.h); anything else is a folder of pictures.
bool names_picture(const std::string& path);

/// ".png" of "a/B.PNG".
std::string ending_of(const std::string& path);

/// "argument: expected …; found 'path'".
Error not_a(const std::string& argument, const std::string& expected, const std::string& path);

/// not_a where a path ends like a picture or film of a kind that is not written here (".jpg", ".webm"): whoever names
/// it does not mean a folder.
Result<void> refuse_other_kinds(const std::string& argument, const std::string& expected, const std::string& path);

/// "FOLDER/000012.png".
std::string numbered_picture(const std::string& folder, std::size_t number);

/// Makes the folder, and those above it, where they are missing.
Result<void> make_folder(const std::string& path);

/// As write_file does (base/files.h).
Result<void> write_picture(const std::string& path, const Image& image);
/// numbered_picture(), written as one of many.
Result<void> write_numbered_picture(const std::string& folder, std::size_t number, const Image& image);

// Films: frames one after the other into a .y4m or .mp4 file.

/// What a film is like [px], [frames/s].
struct FilmFormat {
    int width = 0, height = 0, rate = 30;
};

/// A film that is being written, beside its final place. One that is not finished leaves nothing behind.
class Film {
public:
    virtual ~Film() = default;
    virtual Result<void> add(const Frame& frame) = 0;
    /// No frame comes any more: the film takes its place.
    virtual Result<void> finish() = 0;
};

/// What stands before the first frame of a film in YUV4MPEG2, the plainest there is, which every player and ffmpeg
/// reads: size, rate, square pixels, full chroma (4:4:4).
std::string y4m_header(const FilmFormat& format);

/// One frame of it: its mark, then the planes Y, Cb and Cr, width * height bytes each, ITU-R BT.601 in the studio range
/// (16..235, 16..240), rounded to nearest. Whole-number arithmetic: the same bytes on every machine.
Bytes y4m_frame(const Frame& frame);

/// Whether the path ends like a film that can be written, or names a stream (base/files.h).
bool names_film(const std::string& path);

/// .mp4 is written by the program ffmpeg, and it is an error where that is not installed; all else is .y4m, written
/// here.
Result<std::unique_ptr<Film>> start_film(const std::string& path, const FilmFormat& format);

}  // namespace enfilade
