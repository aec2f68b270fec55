#include "app/play/screenshot.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/pictures.h"

namespace enfilade {
namespace {

constexpr int kMostScreenshots = 9999;

}  // namespace

Result<std::string> save_screenshot(const Frame& frame, const std::string& folder) {
    for (int number = 1; number <= kMostScreenshots; ++number) {
        const std::string name = fmt::format("enfilade-{:04}.png", number);
        const auto path = std::filesystem::path(folder) / name;
        std::error_code unknown;
        if (std::filesystem::exists(path, unknown)) continue;
        if (Status failed = write_picture(path.string(), image_of(frame))) return *failed;
        return name;
    }
    return Error{folder, fmt::format("there are {} screenshots already; move some away", kMostScreenshots)};
}

}  // namespace enfilade
