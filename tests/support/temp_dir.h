// A fresh folder for one test, gone when the test ends.
#pragma once
#include <stdlib.h>

#include <filesystem>
#include <string>
#include <system_error>

#include "base/files.h"
#include "base/result.h"

namespace enfilade::test {

/// Makes an empty folder below the system's folder for temporary files, and removes it with all it holds.
class TempDir {
public:
    TempDir() {
        std::string pattern = (std::filesystem::temp_directory_path() / "enfilade-XXXXXX").string();
        ENFILADE_CHECK(::mkdtemp(pattern.data()) != nullptr);
        path_ = pattern;
    }
    TempDir(const TempDir&) = delete;
    TempDir& operator=(const TempDir&) = delete;
    ~TempDir() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    /// The path of `name` inside the folder; of the folder itself without a name.
    std::string path(const std::string& name = "") const { return (path_ / name).string(); }

private:
    std::filesystem::path path_;
};

/// The file's text, or why there is none.
inline std::string content(const std::string& path) {
    const auto bytes = read_file(path);
    return bytes.ok() ? std::string(as_text(bytes.value())) : bytes.error().text();
}

}  // namespace enfilade::test
