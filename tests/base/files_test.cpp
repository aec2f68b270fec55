// Whole files in and out: what is refused, and that a failed write leaves the old file as it was.
#include "base/files.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>

#include "support/temp_dir.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using testing::TempDir;

std::string content(const std::string& path) {
    const auto bytes = read_file(path);
    return bytes.ok() ? std::string(as_text(bytes.value())) : bytes.error().text();
}

std::size_t entries(const TempDir& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
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

TEST(WriteFile, WritesWhatReadFileReads) {
    const TempDir folder;
    const std::string text("a\0b\r\n\xFF", 6);
    ASSERT_FALSE(write_file(folder.path("f"), text));
    EXPECT_EQ(content(folder.path("f")), text);
}

TEST(WriteFile, WritesAnEmptyFile) {
    const TempDir folder;
    ASSERT_FALSE(write_file(folder.path("f"), ""));
    EXPECT_EQ(content(folder.path("f")), "");
}

TEST(WriteFile, ReplacesTheOldFileAndLeavesNothingBeside) {
    const TempDir folder;
    ASSERT_FALSE(write_file(folder.path("f"), "a longer old text"));
    ASSERT_FALSE(write_file(folder.path("f"), "new"));
    EXPECT_EQ(content(folder.path("f")), "new");
    EXPECT_EQ(entries(folder), 1u);
}

TEST(WriteFile, OnAFullDiskLeavesTheOldFileAndNothingBeside) {
    const TempDir folder;
    ASSERT_FALSE(write_file(folder.path("f"), "old"));
    for (std::size_t size : {2'000u, 100'000u}) {  // smaller and larger than the C library's buffer
        const DiskLimit limit(1000);
        const Status failed = write_file(folder.path("f"), std::string(size, 'x'));
        ASSERT_TRUE(failed);
        EXPECT_THAT(failed->text(), StartsWith(folder.path("f") + ": cannot write the file: "));
    }
    EXPECT_EQ(content(folder.path("f")), "old");
    EXPECT_EQ(entries(folder), 1u);
}

TEST(WriteFile, OverAFolderFailsAndLeavesNothingBeside) {
    const TempDir folder;
    fs::create_directory(folder.path("f"));
    const Status failed = write_file(folder.path("f"), "new");
    ASSERT_TRUE(failed);
    EXPECT_THAT(failed->what, HasSubstr("put the finished file in its place"));
    EXPECT_EQ(entries(folder), 1u);
}

TEST(WriteFile, IntoAFolderThatIsNotThereSaysSo) {
    const TempDir folder;
    const Status failed = write_file(folder.path("none/f"), "new");
    ASSERT_TRUE(failed);
    EXPECT_EQ(failed->text(), folder.path("none/f") + ": cannot create the file: No such file or directory");
}

TEST(ReadFile, NamesTheFileThatIsNotThere) {
    const TempDir folder;
    EXPECT_EQ(content(folder.path("none")), folder.path("none") + ": no such file");
}

TEST(ReadFile, RefusesAFolder) {
    const TempDir folder;
    EXPECT_EQ(content(folder.path()), folder.path() + ": expected a file, found a folder");
}

TEST(ReadFile, RefusesADevice) {
    EXPECT_EQ(content("/dev/zero"), "/dev/zero: expected a file, found a device or a pipe");
}

TEST(ReadFile, RefusesAPipeWithoutWaitingForIt) {
    const TempDir folder;
    ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
    EXPECT_THAT(content(folder.path("pipe")), HasSubstr("found a device or a pipe"));
}

TEST(ReadFile, RefusesATooLargeFileBeforeTakingMemory) {
    const TempDir folder;
    ASSERT_FALSE(write_file(folder.path("f"), ""));
    fs::resize_file(folder.path("f"), std::uintmax_t{1} << 40);
    EXPECT_THAT(content(folder.path("f")), HasSubstr("the file has 1099511627776 bytes; at most 536870912 are read"));
}

TEST(ReadFile, FollowsALinkToAFile) {
    const TempDir folder;
    ASSERT_FALSE(write_file(folder.path("f"), "text"));
    fs::create_symlink(folder.path("f"), folder.path("link"));
    EXPECT_EQ(content(folder.path("link")), "text");
}

}  // namespace
}  // namespace enfilade
