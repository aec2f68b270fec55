// Finished frames as picture files.
#pragma once
#include <string>

#include "base/result.h"
#include "formats/png.h"
#include "render/frame.h"

namespace enfilade {

Image image_of(const Frame& frame);

/// 24-bit surface ids as colours: red is the high byte.
Image ids_image(const FrameFacts& facts, int width, int height);

/// Whether a path names one PNG file or a stream (base/output_file.h); anything else is a folder of pictures.
bool names_picture(const std::string& path);

/// ".png" of "a/B.PNG".
std::string ending_of(const std::string& path);

/// "argument: expected …; found 'path'".
Error not_a(const std::string& argument, const std::string& expected, const std::string& path);

/// not_a where a path ends like a picture or film of a kind that is not written here (".jpg", ".webm"): whoever names
/// it does not mean a folder.
Status refuse_other_kinds(const std::string& argument, const std::string& expected, const std::string& path);

/// "FOLDER/000012.png".
std::string numbered_picture(const std::string& folder, std::size_t number);

/// Makes the folder, and those above it, where they are missing.
Status make_folder(const std::string& path);

/// As write_file does (base/files.h).
Status write_picture(const std::string& path, const Image& image);
/// numbered_picture(), written as one of many.
Status write_numbered_picture(const std::string& folder, std::size_t number, const Image& image);

}  // namespace enfilade
