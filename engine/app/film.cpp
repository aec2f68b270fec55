#include "app/film.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "app/pictures.h"
#include "flight/y4m.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

std::string beside(const std::string& path) { return path + ".part"; }

Error write_error(const std::string& path) {
    return {path, fmt::format("cannot write the film: {}", std::strerror(errno))};
}

Status move_into_place(const std::string& path) {
    std::error_code failed;
    fs::rename(beside(path), path, failed);
    if (failed) return Error{path, "cannot put the finished film in its place: " + failed.message()};
    return {};
}

/// The part of the work that both kinds share: bytes into a stream, and tidying up.
class StreamFilm : public Film {
public:
    StreamFilm(std::string path, std::FILE* stream, int (*close)(std::FILE*))
        : path_(std::move(path)), stream_(stream), close_(close) {}
    StreamFilm(const StreamFilm&) = delete;
    StreamFilm& operator=(const StreamFilm&) = delete;
    ~StreamFilm() override {
        if (stream_) close_(stream_);
        std::error_code ignored;
        fs::remove(beside(path_), ignored);
    }

    Status finish() override {
        const int failed = close_(std::exchange(stream_, nullptr));
        if (failed != 0) return Error{path_, "the film could not be finished"};
        return move_into_place(path_);
    }

protected:
    Status write(const void* bytes, std::size_t count) {
        if (std::fwrite(bytes, 1, count, stream_) != count) return write_error(path_);
        return {};
    }

private:
    std::string path_;
    std::FILE* stream_;
    int (*close_)(std::FILE*);
};

class Y4mFilm final : public StreamFilm {
public:
    Y4mFilm(std::string path, std::FILE* file, std::string header)
        : StreamFilm(std::move(path), file, std::fclose), header_(std::move(header)) {}

    Status add(const Frame& frame) override {
        if (Status failed = write(header_.data(), header_.size())) return failed;
        header_.clear();
        const Bytes bytes = y4m_frame(frame);
        return write(bytes.data(), bytes.size());
    }

private:
    std::string header_;  ///< until it is written
};

class Mp4Film final : public StreamFilm {
public:
    Mp4Film(std::string path, std::FILE* ffmpeg) : StreamFilm(std::move(path), ffmpeg, pclose) {}

    Status add(const Frame& frame) override { return write(frame.pixels.data(), frame.pixels.size() * 4); }
};

bool is_installed(std::string_view program) {
    std::string_view folders = std::getenv("PATH") ? std::getenv("PATH") : "";
    while (!folders.empty()) {
        const auto end = folders.find(':');
        if (access((fs::path(folders.substr(0, end)) / program).c_str(), X_OK) == 0) return true;
        folders.remove_prefix(end == std::string_view::npos ? folders.size() : end + 1);
    }
    return false;
}

/// The text as one word of the shell.
std::string quoted_for_shell(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

/// H.264 with 4:2:0 chroma is what every player shows; it needs even sides. 16 is "looks like the original".
std::string ffmpeg_command(const std::string& target, const FilmFormat& format) {
    return fmt::format(
        "ffmpeg -v error -nostats -y -f rawvideo -pix_fmt rgba -s {}x{} -r {} -i - "
        "-vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2' -c:v libx264 -crf 16 -pix_fmt yuv420p -movflags +faststart -f mp4 {}",
        format.width, format.height, format.rate, quoted_for_shell(fs::absolute(target).string()));
}

Result<std::unique_ptr<Film>> start_y4m(const std::string& path, const FilmFormat& format) {
    std::FILE* file = std::fopen(beside(path).c_str(), "wb");
    if (!file) return write_error(path);
    return std::unique_ptr<Film>(
        std::make_unique<Y4mFilm>(path, file, y4m_header(format.width, format.height, format.rate)));
}

Result<std::unique_ptr<Film>> start_mp4(const std::string& path, const FilmFormat& format) {
    if (!is_installed("ffmpeg"))
        return Error{path,
                     "an .mp4 film needs the program ffmpeg, which is not installed; install it, or write a .y4m "
                     "film or a folder of pictures"};
    std::signal(SIGPIPE, SIG_IGN);  // an ffmpeg that ends early is an error of ours, not our end
    std::FILE* ffmpeg = popen(ffmpeg_command(beside(path), format).c_str(), "w");
    if (!ffmpeg) return write_error(path);
    return std::unique_ptr<Film>(std::make_unique<Mp4Film>(path, ffmpeg));
}

}  // namespace

bool names_film(const std::string& path) { return ending_of(path) == ".y4m" || ending_of(path) == ".mp4"; }

Result<std::unique_ptr<Film>> start_film(const std::string& path, const FilmFormat& format) {
    return ending_of(path) == ".y4m" ? start_y4m(path, format) : start_mp4(path, format);
}

}  // namespace enfilade
