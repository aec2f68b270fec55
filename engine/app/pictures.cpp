#include "app/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/programs.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

constexpr std::array<std::string_view, 14> kOtherKinds{".jpg", ".jpeg", ".bmp", ".gif",  ".tga", ".tif", ".tiff",
                                                       ".ppm", ".webp", ".avi", ".webm", ".mkv", ".mov", ".mpg"};

Error write_error(const std::string& path) {
    return {path, fmt::format("cannot write the film: {}", std::strerror(errno))};
}

constexpr std::string_view kFrameMark = "FRAME\n";

struct Yuv {
    std::uint8_t y, u, v;
};

/// BT.601 with coefficients in 65536ths: 219/255 and 224/255 of 0.299 R + 0.587 G + 0.114 B and its differences. Each
/// row of the differences sums to 0, so that grey stays grey; the halves round.
Yuv to_yuv(std::uint32_t color) {
    const std::int32_t r = color & 255, g = color >> 8 & 255, b = color >> 16 & 255;
    const std::int32_t y = 16829 * r + 33039 * g + 6416 * b + (16 << 16) + 32768;
    const std::int32_t u = -9714 * r - 19071 * g + 28785 * b + (128 << 16) + 32768;
    const std::int32_t v = 28785 * r - 24104 * g - 4681 * b + (128 << 16) + 32768;
    return {static_cast<std::uint8_t>(y >> 16), static_cast<std::uint8_t>(u >> 16), static_cast<std::uint8_t>(v >> 16)};
}

class Y4mFilm final : public Film {
public:
    Y4mFilm(OutputFile file, const FilmFormat& format) : file_(std::move(file)), header_(y4m_header(format)) {}

    Result<void> add(const Frame& frame) override {
        const std::string header = std::exchange(header_, {});
        if (const Result<void> done = file_.write(std::as_bytes(std::span(header))); !done.ok()) return done.error();
        return file_.write(y4m_frame(frame));
    }

    Result<void> finish() override { return file_.commit(); }

private:
    OutputFile file_;
    std::string header_;  ///< until it is written
};

/// ffmpeg writes into our file, which it is handed open: under a name it could only be given a name to foresee.
class Mp4Film final : public Film {
public:
    Mp4Film(std::string path, OutputFile file, std::FILE* ffmpeg)
        : path_(std::move(path)), file_(std::move(file)), ffmpeg_(ffmpeg) {}
    Mp4Film(const Mp4Film&) = delete;
    Mp4Film& operator=(const Mp4Film&) = delete;
    ~Mp4Film() override {
        if (ffmpeg_) pclose(ffmpeg_);
    }

    Result<void> add(const Frame& frame) override {
        const std::size_t bytes = frame.pixels.size() * 4;
        if (std::fwrite(frame.pixels.data(), 1, bytes, ffmpeg_) != bytes) return write_error(path_);
        return {};
    }

    Result<void> finish() override {
        if (pclose(std::exchange(ffmpeg_, nullptr)) != 0)
            return Error{path_, "the film could not be finished: ffmpeg failed"};
        return file_.commit();
    }

private:
    std::string path_;
    OutputFile file_;
    std::FILE* ffmpeg_;
};

/// H.264 with 4:2:0 chroma is what every player shows; it needs even sides. 16 is "looks like the original".
std::string ffmpeg_command(const std::string& target, const FilmFormat& format) {
    return fmt::format(
        "ffmpeg -v error -nostats -y -f rawvideo -pix_fmt rgba -s {}x{} -r {} -i - "
        "-vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2' -c:v libx264 -crf 16 -pix_fmt yuv420p -movflags +faststart -f mp4 {}",
        format.width, format.height, format.rate, target);
}

Result<std::unique_ptr<Film>> start_mp4(const std::string& path, const FilmFormat& format) {
    if (!find_program("ffmpeg"))
        return Error{path,
                     "an .mp4 film needs the program ffmpeg, which is not installed; install it, or write a .y4m "
                     "film or a folder of pictures"};
    auto file = OutputFile::open(path);
    if (!file.ok()) return file.error();
    std::signal(SIGPIPE, SIG_IGN);  // an ffmpeg that ends early is an error of ours, not our end
    file.value().share_with_children(true);
    std::FILE* ffmpeg = popen(ffmpeg_command(file.value().name_for_children(), format).c_str(), "w");
    file.value().share_with_children(false);
    if (!ffmpeg) return write_error(path);
    return std::unique_ptr<Film>(std::make_unique<Mp4Film>(path, std::move(file).value(), ffmpeg));
}

}  // namespace

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
    return {argument, fmt::format("expected {}; found {}", expected, in_quotes(path))};
}

Result<void> refuse_other_kinds(const std::string& argument, const std::string& expected, const std::string& path) {
    if (std::ranges::find(kOtherKinds, ending_of(path)) == std::end(kOtherKinds)) return {};
    return not_a(argument, expected, path);
}

std::string numbered_picture(const std::string& folder, std::size_t number) {
    return (std::filesystem::path(folder) / fmt::format("{:06}.png", number)).string();
}

Result<void> make_folder(const std::string& path) {
    std::error_code failed;
    std::filesystem::create_directories(path, failed);
    if (std::filesystem::is_directory(path)) return {};
    return Error{path, failed ? "cannot make the folder: " + failed.message() : "expected a folder, found a file"};
}

Result<void> write_picture(const std::string& path, const Image& image) { return write_file(path, write_png(image)); }

Result<void> write_numbered_picture(const std::string& folder, std::size_t number, const Image& image) {
    return write_one_of_many(numbered_picture(folder, number), write_png(image));
}

std::string y4m_header(const FilmFormat& format) {
    return fmt::format("YUV4MPEG2 W{} H{} F{}:1 Ip A1:1 C444\n", format.width, format.height, format.rate);
}

Bytes y4m_frame(const Frame& frame) {
    const std::size_t count = frame.pixels.size();
    Bytes bytes(kFrameMark.size() + 3 * count);
    for (std::size_t i = 0; i < kFrameMark.size(); ++i) bytes[i] = static_cast<std::byte>(kFrameMark[i]);
    std::byte* y = bytes.data() + kFrameMark.size();
    std::byte *u = y + count, *v = u + count;
    for (std::size_t i = 0; i < count; ++i) {
        const Yuv yuv = to_yuv(frame.pixels[i]);
        y[i] = std::byte{yuv.y};
        u[i] = std::byte{yuv.u};
        v[i] = std::byte{yuv.v};
    }
    return bytes;
}

bool names_film(const std::string& path) {
    return ending_of(path) == ".y4m" || ending_of(path) == ".mp4" || names_stream(path);
}

Result<std::unique_ptr<Film>> start_film(const std::string& path, const FilmFormat& format) {
    if (ending_of(path) == ".mp4") return start_mp4(path, format);
    auto file = OutputFile::open(path);
    if (!file.ok()) return file.error();
    return std::unique_ptr<Film>(std::make_unique<Y4mFilm>(std::move(file).value(), format));
}

}  // namespace enfilade
