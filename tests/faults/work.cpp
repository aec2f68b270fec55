#include "faults/work.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "app/cli/program.h"
#include "app/commands.h"
#include "app/play/game.h"
#include "base/attempt.h"
#include "base/files.h"
#include "wadconv/convert.h"
#include "wadconv/wad_builder.h"

namespace enfilade::test {
namespace {

namespace fs = std::filesystem;

/// Half a second at ten frames a second: six frames. The looks before and after give other pictures.
constexpr const char* kScript = R"(map = "map.toml"
size = [32, 20]
rate = 10
[[legs]]
seconds = 0.5
to = [6, 3]
)";

std::string text_of(const std::string& path) {
    const auto bytes = read_file(path);
    return bytes.ok() ? std::string(as_text(bytes.value())) : "";
}

void put(const std::string& path, const std::string& text) {
    if (text.empty()) {
        fs::remove(path);
        return;
    }
    fs::create_directories(fs::path(path).parent_path());
    std::ofstream(path, std::ios::binary) << text;  // not flushed to disk: there are thousands
}

std::string picture(int number) { return "frames/00000" + std::to_string(number) + ".png"; }

}  // namespace

Workshop::Workshop() {
    put(path("map.toml"), std::string(kTwoRooms) + "\n[[things]]\nx = 6\ny = 1\nframes = [{ texture = \"t\" }]\n");
    put(path("walk.toml"), kScript);
    add_command("check", {"check", "map.toml"}, {});
    add_command("frame", {"render", "map.toml", "--size", "32x20", "--threads", "2", "--out", "x.png"}, {"x.png"});
    add_command("record", {"fly", "walk.toml", "--record", "--threads", "2"}, {"walk.hashes", "walk.sheet.png"});
    std::vector<std::string> pictures;
    for (int number = 0; number < 6; ++number) pictures.push_back(picture(number));
    add_command("pictures", {"fly", "walk.toml", "--out", "frames", "--threads", "2"}, pictures);
    add_command("film", {"fly", "walk.toml", "--out", "walk.y4m", "--threads", "2"}, {"walk.y4m"});
    add_save();
    add_conversion();
    learn_files();
}

void Workshop::add_command(std::string name, std::vector<std::string> arguments, std::vector<std::string> files) {
    arguments.insert(arguments.begin(), "enfilade");
    const auto run = [arguments] {
        std::vector<const char*> words;
        for (const std::string& argument : arguments) words.push_back(argument.c_str());
        return run_command_line(static_cast<int>(words.size()), words.data());
    };
    works_.push_back({std::move(name), run, std::move(files)});
}

/// A game is loaded, played a little further and saved again.
void Workshop::add_save() {
    const auto run = [] {
        auto game = Game::start("map.toml", {});
        if (!game.ok()) return std::fprintf(stderr, "enfilade: %s\n", game.error().text().c_str()), 1;
        TickInput input;
        input.forward = 127;
        for (int tick = 0; tick < 30; ++tick) game.value()->tick(input);
        const Result<void> result = game.value()->save("a.save");
        if (!result.ok()) std::fprintf(stderr, "enfilade: %s\n", result.error().text().c_str());
        return result.ok() ? 0 : 1;
    };
    works_.push_back({"save", run, {"a.save"}});
}

void Workshop::add_conversion() {
    wadconv::test::WadBuilder wad = wadconv::test::picture_wad();
    wad.add_map("MAP01", wadconv::test::small_level().map);
    const Bytes bytes = wad.finish("IWAD");
    ENFILADE_CHECK(write_file(path("doom.wad"), std::span<const std::byte>(bytes)).ok());
    const auto run = [] {
        wadconv::RunOptions options;
        options.wads = {"doom.wad"};
        options.out = "levels";
        options.jobs = 2;
        const auto result = convert_wads(options, [](std::size_t, std::size_t, std::size_t) {});
        if (!result.ok()) return std::fprintf(stderr, "enfilade: %s\n", result.error().text().c_str()), 1;
        for (const std::string& problem : result.value().problems)
            std::fprintf(stderr, "enfilade: %s\n", problem.c_str());
        return result.value().is_complete() ? 0 : 1;
    };
    works_.push_back({"convert", run, {}});
}

/// Does everything once, so that it is known how each file should become; before, each file holds something else.
void Workshop::learn_files() {
    for (Work& work : works_) {
        const Outcome outcome = outcome_of(start(work, [] {}));
        ENFILADE_CHECK(outcome.status == 0);
        if (work.name == "convert")
            for (const auto& entry : fs::recursive_directory_iterator(path("levels")))
                if (entry.is_regular_file()) work.files.push_back(fs::relative(entry.path(), path()).string());
        for (const std::string& file : work.files)
            versions_.push_back({file, "what was in " + file + " before\n", text_of(path(file))});
    }
}

const Workshop::Versions& Workshop::versions_of(const std::string& file) const {
    const auto found = std::ranges::find(versions_, file, &Versions::file);
    ENFILADE_CHECK(found != versions_.end());
    return *found;
}

void Workshop::put_old_files(const Work& work) const {
    for (const std::string& file : work.files) put(path(file), versions_of(file).before);
}

int Workshop::start(const Work& work, const std::function<void()>& prepare) const {
    std::fflush(nullptr);
    const int process = fork();
    if (process != 0) return process;
    const auto send = [&](const char* name, int to) {
        dup2(::open(path(name).c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), to);
    };
    if (chdir(path().c_str()) != 0) _exit(99);
    send("out.txt", STDOUT_FILENO);
    send("err.txt", STDERR_FILENO);
    prepare();
    const int status = run_program("enfilade", work.run);
    std::fflush(nullptr);
    _exit(status);
}

Outcome Workshop::outcome_of(int process) const {
    int status = 0;
    waitpid(process, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text_of(path("out.txt")),
            text_of(path("err.txt"))};
}

Outcome Workshop::run(const Work& work, const std::function<void()>& prepare) const {
    put_old_files(work);
    return outcome_of(start(work, prepare));
}

Outcome Workshop::run_and_kill(const Work& work, const std::function<void()>& wait) const {
    put_old_files(work);
    const int process = start(work, [] {});
    wait();
    kill(process, SIGKILL);
    return outcome_of(process);
}

std::vector<std::string> Workshop::broken_files(const Work& work, bool must_be_new) const {
    std::vector<std::string> broken;
    for (const std::string& file : work.files) {
        const Versions& versions = versions_of(file);
        const std::string text = text_of(path(file));
        if (text != versions.after && (must_be_new || text != versions.before)) broken.push_back(file);
    }
    return broken;
}

std::vector<std::string> Workshop::left_behind() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(path()))
        if (entry.path().filename().string().starts_with(".")) names.push_back(entry.path().string());
    return names;
}

void Workshop::clean_up() const {
    for (const std::string& name : left_behind()) fs::remove(name);
}

std::size_t trials(std::size_t usual, std::size_t thorough) { return std::getenv("ENFILADE_LONG") ? thorough : usual; }

}  // namespace enfilade::test
