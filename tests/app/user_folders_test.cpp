// Where a user's things lie: never where the program happens to be started.
#include "app/user_folders.h"

#include <gtest/gtest.h>
#include <pwd.h>
#include <unistd.h>

#include <cstdlib>

#include "app/play/saved_game.h"
#include "support/temp_dir.h"

namespace enfilade {
namespace {

class UserFolders : public ::testing::Test {
protected:
    UserFolders() {
        for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"}) unsetenv(name);
        setenv("HOME", "/home/player", 1);
    }
    ~UserFolders() override {
        unsetenv("XDG_DATA_HOME");
        setenv("HOME", before_.c_str(), 1);
    }

    const std::string before_ = std::getenv("HOME") ? std::getenv("HOME") : "/";
};

TEST_F(UserFolders, AreBelowHome) {
    EXPECT_EQ(user_folder(UserFolder::config), "/home/player/.config/enfilade");
    EXPECT_EQ(user_folder(UserFolder::data), "/home/player/.local/share/enfilade");
    EXPECT_EQ(user_folder(UserFolder::cache), "/home/player/.cache/enfilade");
    EXPECT_EQ(in_user_folder(UserFolder::data, "last_map"), "/home/player/.local/share/enfilade/last_map");
}

TEST_F(UserFolders, AreWhereTheEnvironmentSaysByAnAbsolutePath) {
    setenv("XDG_DATA_HOME", "/data", 1);
    EXPECT_EQ(user_folder(UserFolder::data), "/data/enfilade");
    for (const char* relative : {"", ".", "data"}) {
        setenv("XDG_DATA_HOME", relative, 1);
        EXPECT_EQ(user_folder(UserFolder::data), "/home/player/.local/share/enfilade") << relative;
    }
}

TEST_F(UserFolders, AreTheUsersWhereTheEnvironmentNamesNoHome) {
    const std::string home = getpwuid(getuid())->pw_dir;
    for (const bool is_empty : {true, false}) {
        is_empty ? setenv("HOME", "", 1) : unsetenv("HOME");
        EXPECT_EQ(home_folder(), home);
        EXPECT_EQ(user_folder(UserFolder::data), home + "/.local/share/enfilade");
        EXPECT_EQ(saved_game_of("map.toml").substr(0, home.size()), home) << "not the working folder";
    }
}

}  // namespace
}  // namespace enfilade
