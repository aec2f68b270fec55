// Frames as YUV4MPEG2, the plainest film there is: every player and ffmpeg reads it.
#pragma once
#include <string>

#include "base/files.h"
#include "render/frame.h"

namespace enfilade {

/// What stands before the first frame: size, rate [frames/s], square pixels, full chroma (4:4:4).
std::string y4m_header(int width, int height, int rate);

/// One frame: its mark, then the planes Y, Cb and Cr, width * height bytes each, ITU-R BT.601 in the studio range
/// (16..235, 16..240), rounded to nearest. Whole-number arithmetic: the same bytes on every machine.
Bytes y4m_frame(const Frame& frame);

}  // namespace enfilade
