#include "app/play/map_watch.h"

#include <algorithm>

namespace enfilade {

FileReader MapWatch::start_reading() {
    files_.clear();
    return [this](const std::string& path) {
        files_[path] = written(path);  // before reading: a file saved while it is read is read again
        return read_file(path);
    };
}

bool MapWatch::changed() const {
    return std::ranges::any_of(files_, [](const auto& file) { return written(file.first) != file.second; });
}

std::filesystem::file_time_type MapWatch::written(const std::string& path) {
    std::error_code failed;
    const auto time = std::filesystem::last_write_time(path, failed);
    return failed ? std::filesystem::file_time_type::min() : time;
}

}  // namespace enfilade
