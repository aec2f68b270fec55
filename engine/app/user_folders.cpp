#include "app/user_folders.h"

#include <pwd.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

namespace enfilade {
namespace {

namespace fs = std::filesystem;

struct FolderNames {
    const char *variable, *below_home;
};

FolderNames names_of(UserFolder kind) {
    switch (kind) {
        case UserFolder::config: return {"XDG_CONFIG_HOME", ".config"};
        case UserFolder::data: return {"XDG_DATA_HOME", ".local/share"};
        case UserFolder::cache: return {"XDG_CACHE_HOME", ".cache"};
    }
    return {};
}

/// A relative path is to be taken for none, says the specification.
fs::path absolute_path_in(const char* variable) {
    const char* const value = std::getenv(variable);
    return value && *value == '/' ? value : "";
}

}  // namespace

std::string home_folder() {
    if (const char* home = std::getenv("HOME"); home && *home) return home;
    const passwd* const user = getpwuid(getuid());
    return user && user->pw_dir ? user->pw_dir : "";
}

std::string user_folder(UserFolder kind) {
    const FolderNames names = names_of(kind);
    fs::path folder = absolute_path_in(names.variable);
    if (folder.empty()) {
        const fs::path home = home_folder();
        if (home.empty()) return "";
        folder = home / names.below_home;
    }
    return (folder / "enfilade").string();
}

std::string in_user_folder(UserFolder kind, const std::string& name) {
    const std::string folder = user_folder(kind);
    return folder.empty() ? "" : (fs::path(folder) / name).string();
}

}  // namespace enfilade
