// Runs the `enfilade` program as a person or a script would.
#pragma once
#include <sys/wait.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "base/files.h"
#include "support/temp_dir.h"

namespace enfilade::test {

/// What a program said and how it ended.
struct Ended {
    int exit_code = -1;  ///< 128 + signal where it was killed
    std::string out, err;
};

/// A folder for a test, and the program, run inside it.
class Program {
public:
    /// environment: "NAME=value" words put before the program.
    Ended run(const std::vector<std::string>& arguments, const std::string& environment = "") const {
        return run_other(ENFILADE_PROGRAM, arguments, environment);
    }

    /// The same with another program.
    Ended run_other(const std::string& program, const std::vector<std::string>& arguments,
                    const std::string& environment = "") const {
        const std::string own = " XDG_CONFIG_HOME='" + home_.path("config") + "' XDG_DATA_HOME='" + home_.path("data") +
                                "' XDG_CACHE_HOME='" + home_.path("cache") + "' ";
        std::string command = "cd '" + dir_.path() + "' && " + own + environment + " '" + program + "'";
        for (const std::string& argument : arguments) command += " '" + argument + "'";
        const int status = std::system((command + " >out.txt 2>err.txt </dev/null").c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text("out.txt"), text("err.txt")};
    }

    std::string path(const std::string& name) const { return dir_.path(name); }
    bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }
    /// How many files there are whose names begin with a dot: temporary ones.
    std::size_t hidden_files() const {
        std::size_t count = 0;
        for (const auto& entry : std::filesystem::directory_iterator(dir_.path()))
            count += entry.path().filename().string().starts_with(".") ? 1 : 0;
        return count;
    }
    std::string text(const std::string& name) const {
        const auto bytes = read_file(path(name));
        return bytes.ok() ? std::string(as_text(bytes.value())) : "";
    }
    void write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
        (void)write_file(path(name), std::string_view(text));
    }

    /// Where the program keeps what belongs to its user: "config/enfilade/settings.toml".
    std::string home(const std::string& name) const { return home_.path(name); }

private:
    test::TempDir dir_, home_;
};

/// A sound map of two rooms with a door; without pictures, so with warnings. The player looks through the door.
inline const char* const kTwoRooms = R"(format = 1
name = "Two rooms"

[player]
sector = "hall"
x = 2
y = 3
z = 1.5
yaw = 0

[[sectors]]
name = "hall"
floor = { z = 0, texture = "floor" }
ceiling = { z = 3, texture = "floor" }
[[sectors.loops]]
name = "border"
v = [0, 0,  8, 0,  8, 2,  8, 4,  8, 6,  0, 6]
walls = [{ texture = "wall" }, { texture = "wall" }, { next = "niche" }, { texture = "wall" }, { texture = "wall" }, { texture = "wall" }]

[[sectors]]
name = "niche"
floor = { z = 0, texture = "floor" }
ceiling = { z = 3, texture = "floor" }
[[sectors.loops]]
name = "border"
v = [8, 2,  10, 2,  10, 4,  8, 4]
walls = [{ texture = "wall" }, { texture = "wall" }, { texture = "wall" }, { next = "hall" }]
)";

}  // namespace enfilade::test
