#include "app/pictures.h"
#include "formats/quoted.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "base/output_file.h"

namespace enfilade {
namespace {

constexpr std::array<std::string_view, 14> kOtherKinds{".jpg", ".jpeg", ".bmp", ".gif",  ".tga", ".tif", ".tiff",
                                                       ".ppm", ".webp", ".avi", ".webm", ".mkv", ".mov", ".mpg"};

}  // namespace

Image image_of(const Frame& frame) { return {std::uint32_t(frame.width), std::uint32_t(frame.height), frame.pixels}; }

Image ids_image(const FrameFacts& facts, int width, int height) {
    Image image{std::uint32_t(width), std::uint32_t(height), {}};
    image.pixels.resize(facts.ids.size());
    std::ranges::transform(facts.ids, image.pixels.begin(), [](PixelSurface id) {
        return 0xFF000000u | (id & 0xFF) << 16 | (id & 0xFF00) | (id >> 16 & 0xFF);
    });
    return image;
}

std::string ending_of(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return ending;
}

bool names_picture(const std::string& path) { return ending_of(path) == ".png" || names_stream(path); }

Error not_a(const std::string& argument, const std::string& expected, const std::string& path) {
    return {argument, fmt::format("expected {}; found {}", expected, enfilade::quoted(path))};
}

Status refuse_other_kinds(const std::string& argument, const std::string& expected, const std::string& path) {
    if (std::ranges::find(kOtherKinds, ending_of(path)) == std::end(kOtherKinds)) return {};
    return not_a(argument, expected, path);
}

std::string numbered_picture(const std::string& folder, std::size_t number) {
    return (std::filesystem::path(folder) / fmt::format("{:06}.png", number)).string();
}

Status make_folder(const std::string& path) {
    std::error_code failed;
    std::filesystem::create_directories(path, failed);
    if (std::filesystem::is_directory(path)) return {};
    return Error{path, failed ? "cannot make the folder: " + failed.message() : "expected a folder, found a file"};
}

Status write_picture(const std::string& path, const Image& image) { return write_file(path, write_png(image)); }

Status write_numbered_picture(const std::string& folder, std::size_t number, const Image& image) {
    return write_one_of_many(numbered_picture(folder, number), write_png(image));
}

}  // namespace enfilade
