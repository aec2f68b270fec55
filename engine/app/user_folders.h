// Where a user's things lie (XDG Base Directory Specification, 0.8).
#pragma once
#include <cstdint>
#include <string>

namespace enfilade {

enum class UserFolder : std::uint8_t { config, data, cache };

/// $HOME, or where that is not set, as in a service, what the system's list of users says. Empty where neither says
/// anything.
std::string home_folder();

/// The folder that is named by XDG_CONFIG_HOME, XDG_DATA_HOME or XDG_CACHE_HOME where that is an absolute path, else
/// ~/.config, ~/.local/share or ~/.cache; in it, enfilade's. Empty where there is no home: nothing is to be read or
/// written then, least of all in the working folder.
std::string user_folder(UserFolder kind);

/// A file or folder of that name in it; empty where there is none.
std::string in_user_folder(UserFolder kind, const std::string& name);

}  // namespace enfilade
