// Files on their way to disk: whole or not at all, whoever else writes, and nothing but files is replaced.

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <thread>

#include "base/files.h"
#include "support/temp_dir.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;
using test::content;
using test::TempDir;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::size_t entries(const TempDir& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
}

Result<void> write_text(OutputFile& file, std::string_view text) { return file.write(std::as_bytes(std::span(text))); }

/// The only file in the folder whose name begins with a dot: a temporary one.
std::string hidden_in(const TempDir& folder) {
    for (const auto& entry : fs::directory_iterator(folder.path()))
        if (entry.path().filename().string().starts_with(".")) return entry.path().string();
    return "";
}

mode_t mode_of(const std::string& path) {
    struct stat found{};
    stat(path.c_str(), &found);
    return found.st_mode & 07777;
}

/// While it lives, no file can grow beyond `bytes`: writing more fails as on a full disk.
class DiskLimit {
public:
    explicit DiskLimit(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &old_limit_);
        const rlimit limit{bytes, old_limit_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    DiskLimit(const DiskLimit&) = delete;
    DiskLimit& operator=(const DiskLimit&) = delete;
    ~DiskLimit() {
        ::setrlimit(RLIMIT_FSIZE, &old_limit_);
        std::signal(SIGXFSZ, old_handler_);
    }

private:
    rlimit old_limit_{};
    void (*old_handler_)(int);
};

TEST(OutputFile, ReplacesTheOldFileAndLeavesNothingBeside) {
    const TempDir folder;
    ASSERT_TRUE(write_file(folder.path("f"), "a longer old text").ok());
    ASSERT_TRUE(write_file(folder.path("f"), "new").ok());
    EXPECT_EQ(content(folder.path("f")), "new");
    EXPECT_EQ(entries(folder), 1u);
}

TEST(OutputFile, ThatIsNotCommittedLeavesTheOldFileAndNothingBeside) {
    const TempDir folder;
    ASSERT_TRUE(write_file(folder.path("f"), "old").ok());
    {
        auto file = OutputFile::open(folder.path("f"));
        ASSERT_TRUE(file.ok());
        ASSERT_TRUE(write_text(file.value(), "new").ok());
        EXPECT_EQ(content(folder.path("f")), "old");
        EXPECT_EQ(entries(folder), 2u);
    }
    EXPECT_EQ(content(folder.path("f")), "old");
    EXPECT_EQ(entries(folder), 1u);
}

TEST(OutputFile, OnAFullDiskLeavesTheOldFileAndNothingBeside) {
    const TempDir folder;
    ASSERT_TRUE(write_file(folder.path("f"), "old").ok());
    {
        const DiskLimit limit(1000);
        const Result<void> result = write_file(folder.path("f"), std::string(2000, 'x'));
        ASSERT_FALSE(result.ok());
        EXPECT_THAT(result.error().text(), StartsWith(folder.path("f") + ": cannot write the file: "));
    }
    EXPECT_EQ(content(folder.path("f")), "old");
    EXPECT_EQ(entries(folder), 1u);
}

TEST(OutputFile, OverAFolderFailsAndLeavesNothingBeside) {
    const TempDir folder;
    fs::create_directory(folder.path("f"));
    const Result<void> result = write_file(folder.path("f"), "new");
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().what, "expected a file, found a folder");
    EXPECT_EQ(entries(folder), 1u);
}

TEST(OutputFile, InAFolderThatIsNotThereSaysSo) {
    const TempDir folder;
    const Result<void> result = write_file(folder.path("none/f"), "new");
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().text(), folder.path("none/f") + ": cannot create the file: No such file or directory");
}

TEST(OutputFile, HasATemporaryNameThatNobodyForesees) {
    const TempDir folder;
    std::vector<std::string> names;
    for (int i = 0; i < 3; ++i) {
        auto file = OutputFile::open(folder.path("f"));
        names.push_back(hidden_in(folder));
    }
    EXPECT_NE(names[0], "");
    EXPECT_NE(names[0], names[1]);
    EXPECT_NE(names[1], names[2]);
    EXPECT_NE(names[0], names[2]);
}

TEST(OutputFile, CanHaveAsLongANameAsTheFileSystemTakes) {
    const TempDir folder;
    const std::string name(255, 'n');
    ASSERT_TRUE(write_file(folder.path(name), "text").ok());
    EXPECT_EQ(content(folder.path(name)), "text");
}

TEST(OutputFile, KeepsThePermissionsOfTheFileItReplaces) {
    const TempDir folder;
    ASSERT_TRUE(write_file(folder.path("f"), "old").ok());
    for (const mode_t mode : {0600, 0640, 0755}) {
        ASSERT_EQ(::chmod(folder.path("f").c_str(), mode), 0);
        ASSERT_TRUE(write_file(folder.path("f"), "new").ok());
        EXPECT_EQ(mode_of(folder.path("f")), mode);
    }
}

TEST(OutputFile, GivesANewFileThePermissionsThatTheUserWants) {
    const TempDir folder;
    const mode_t before = ::umask(027);
    const Result<void> result = write_file(folder.path("f"), "new");
    ::umask(before);
    ASSERT_TRUE(result.ok());
    EXPECT_EQ(mode_of(folder.path("f")), mode_t{0640});
}

TEST(OutputFile, ReplacesWhatALinkLeadsToAndKeepsTheLink) {
    const TempDir folder;
    fs::create_directory(folder.path("far"));
    fs::create_symlink("far/file", folder.path("near"));
    fs::create_symlink("near", folder.path("nearer"));
    for (const char* text : {"first", "second"}) {  // the file is missing, then there
        ASSERT_TRUE(write_file(folder.path("nearer"), text).ok());
        EXPECT_TRUE(fs::is_symlink(folder.path("nearer")));
        EXPECT_TRUE(fs::is_symlink(folder.path("near")));
        EXPECT_EQ(content(folder.path("far/file")), text);
    }
}

TEST(OutputFile, RefusesLinksThatLeadToEachOther) {
    const TempDir folder;
    fs::create_symlink("b", folder.path("a"));
    fs::create_symlink("a", folder.path("b"));
    const Result<void> result = write_file(folder.path("a"), "text");
    ASSERT_FALSE(result.ok());
    EXPECT_THAT(result.error().what, HasSubstr("links lead to each other"));
}

TEST(OutputFile, WritesIntoAPipeAndLeavesItThere) {
    const TempDir folder;
    ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
    const int reader = ::open(folder.path("pipe").c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_TRUE(write_file(folder.path("pipe"), "text").ok());
    char read[8] = {};
    EXPECT_EQ(::read(reader, read, sizeof read), 4);
    EXPECT_STREQ(read, "text");
    ::close(reader);
    EXPECT_TRUE(fs::is_fifo(folder.path("pipe")));
    EXPECT_EQ(entries(folder), 1u);
}

TEST(OutputFile, WritesToADeviceAndLeavesItThere) {
    const TempDir folder;  // as root this would replace a device that is named directly
    fs::create_symlink("/dev/null", folder.path("null"));
    ASSERT_TRUE(write_file(folder.path("null"), "text").ok());
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    EXPECT_TRUE(fs::is_symlink(folder.path("null")));
    fs::create_symlink("/dev/full", folder.path("full"));
    const Result<void> result = write_file(folder.path("full"), "text");
    ASSERT_FALSE(result.ok());
    EXPECT_THAT(result.error().what, HasSubstr("cannot write the file: No space left"));
}

TEST(StandardStreams, ThatAreClosedStayClosedForWordsAndTakenForFiles) {
    for (const int closed : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        const pid_t child = fork();
        if (child == 0) {
            ::close(closed);
            guard_standard_streams();
            const int file = ::open("/dev/null", O_RDWR);
            char byte = 0;
            const bool is_refused = (closed == STDIN_FILENO ? ::read(closed, &byte, 1) : ::write(closed, "x", 1)) < 0;
            _exit(file > STDERR_FILENO && is_refused && errno == EBADF ? 0 : 1);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        EXPECT_EQ(status, 0) << closed;
    }
}

/// Runs `work` in a process whose standard output is the file at `path`, opened as a shell does for `>`.
template <class Work>
int with_output_to(const std::string& path, Work work) {
    const pid_t child = fork();
    if (child == 0) {
        const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
        ::dup2(file, STDOUT_FILENO);
        _exit(work());
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

TEST(OutputFile, WritesToStandardOutputByAllItsNames) {
    const TempDir folder;
    for (const std::string& name : {std::string("-"), std::string("/dev/stdout"), folder.path("f")}) {
        const auto say = [&] {
            (void)!::write(STDOUT_FILENO, "before ", 7);
            const bool written = write_file(name, "text").ok();
            (void)!::write(STDOUT_FILENO, " after", 6);
            return written ? 0 : 1;
        };
        EXPECT_EQ(with_output_to(folder.path("f"), say), 0) << name;
        EXPECT_EQ(content(folder.path("f")), "before text after") << name;
    }
}

TEST(OutputFile, KnowsStreamsByTheirNames) {
    const TempDir folder;
    ASSERT_TRUE(write_file(folder.path("f"), "text").ok());
    for (const char* stream : {"-", "/dev/null"}) EXPECT_TRUE(names_stream(stream)) << stream;
    for (const std::string& other : {folder.path("f"), folder.path(), folder.path("none"), std::string("--")})
        EXPECT_FALSE(names_stream(other)) << other;
}

TEST(OutputFile, CanBeReadWhereItIsPutInPlaceWhileItGrows) {
    const TempDir folder;
    auto file = OutputFile::open(folder.path("f"));
    ASSERT_TRUE(file.ok());
    ASSERT_TRUE(write_text(file.value(), "one two").ok());
    ASSERT_TRUE(file.value().put_in_place().ok());
    EXPECT_EQ(content(folder.path("f")), "one two");
    ASSERT_TRUE(file.value().cut_to(4).ok());
    ASSERT_TRUE(write_text(file.value(), "three").ok());
    EXPECT_EQ(content(folder.path("f")), "one three");
    ASSERT_TRUE(file.value().commit().ok());
    EXPECT_EQ(entries(folder), 1u);
}

TEST(OutputFile, GoesWithASignalThatEndsTheProgram) {
    for (const int signal : {SIGHUP, SIGINT, SIGTERM}) {
        const TempDir folder;
        ASSERT_TRUE(write_file(folder.path("f"), "old").ok());
        const pid_t child = fork();
        if (child == 0) {
            std::signal(signal, SIG_DFL);  // a shell lets what it starts in the background ignore SIGINT
            remove_temporary_files_on({SIGHUP, SIGINT, SIGTERM});
            auto file = OutputFile::open(folder.path("f"));
            (void)write_text(file.value(), "half");
            std::raise(signal);
            _exit(0);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << signal;
        EXPECT_EQ(content(folder.path("f")), "old");
        EXPECT_EQ(entries(folder), 1u);
    }
}

TEST(OutputFile, LeavesIgnoredSignalsIgnored) {
    const pid_t child = fork();
    if (child == 0) {
        std::signal(SIGHUP, SIG_IGN);
        remove_temporary_files_on({SIGHUP});
        std::raise(SIGHUP);
        _exit(7);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, 7);
}

TEST(OutputFile, WrittenByManyAtOnceIsAlwaysOneOfThem) {
    const TempDir folder;
    constexpr int kWriters = 4, kRounds = 200;
    const auto text_of = [](int writer) { return std::string(1000 + 500 * std::size_t(writer), char('a' + writer)); };
    std::vector<std::jthread> writers;
    for (int writer = 0; writer < kWriters; ++writer)
        writers.emplace_back([&, writer] {
            for (int round = 0; round < kRounds; ++round)
                EXPECT_TRUE(write_file(folder.path("f"), text_of(writer)).ok());
        });
    for (int look = 0; look < kRounds; ++look) {
        const auto bytes = read_file(folder.path("f"));
        if (!bytes.ok()) continue;  // not there yet
        const std::string_view text = as_text(bytes.value());
        ASSERT_TRUE(!text.empty() && text == text_of(text.front() - 'a')) << text.size();
    }
    writers.clear();
    EXPECT_EQ(entries(folder), 1u);
}

}  // namespace
}  // namespace enfilade
