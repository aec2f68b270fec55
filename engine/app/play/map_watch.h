// Notices when a map or one of its pictures is saved, so that an author sees the change at once.
#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "base/files.h"

namespace enfilade {

/// Remembers every file that was read through it, and those that were looked for in vain.
class MapWatch {
public:
    /// A reader for load_map. What was remembered before is forgotten. Must not outlive the watch.
    FileReader start_reading();

    /// True where a file has changed, appeared or gone since it was read. Cost: one look at each file.
    bool changed() const;

private:
    /// When the file was last written, or the smallest time where there is none.
    static std::filesystem::file_time_type written(const std::string& path);

    std::map<std::string, std::filesystem::file_time_type> files_;
};

}  // namespace enfilade
