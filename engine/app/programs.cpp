#include "app/programs.h"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace enfilade {
namespace {

namespace fs = std::filesystem;

std::string command_of(const std::vector<std::string>& words) {
    std::string command = "exec";
    for (const std::string& word : words) command += " " + shell_word(word);
    return command + " </dev/null 2>&1";
}

}  // namespace

std::string shell_word(const std::string& word) {
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

Result<ChildEnd> run_child(const std::vector<std::string>& words) {
    std::FILE* const child = popen(command_of(words).c_str(), "r");
    if (!child) return Error{words[0], std::string("cannot start it: ") + std::strerror(errno)};
    ChildEnd end;
    std::array<char, 4096> part;
    for (std::size_t size; end.said.size() <= kMostSaid && (size = std::fread(part.data(), 1, part.size(), child)) > 0;)
        end.said.append(part.data(), size);
    const int status = pclose(child);  // closes the pipe first: who goes on writing ends
    if (end.said.size() > kMostSaid) return Error{words[0], "it says more than 256 MiB; expected a measurement"};
    end.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return end;
}

std::optional<std::string> find_program(std::string_view name) {
    std::string_view folders = std::getenv("PATH") ? std::getenv("PATH") : "";
    while (!folders.empty()) {
        const auto end = folders.find(':');
        const fs::path program = fs::path(folders.substr(0, end)) / name;
        if (access(program.c_str(), X_OK) == 0) return program.string();
        folders.remove_prefix(end == std::string_view::npos ? folders.size() : end + 1);
    }
    return {};
}

std::string this_program() {
    std::error_code unknown;
    return fs::read_symlink("/proc/self/exe", unknown).string();
}

std::string shipped_map(const std::string& name) {
    const char* const wish = std::getenv("ENFILADE_SHARE");
    const fs::path share =
        wish && *wish ? fs::path(wish) : fs::path(this_program()).parent_path() / "../share/enfilade";
    return (share / "maps" / name).lexically_normal().string();
}

}  // namespace enfilade
