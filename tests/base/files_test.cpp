// Whole files in: what is refused. How they are written is in output_file_test.cpp.
#include "base/files.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <filesystem>
#include <thread>

#include "support/temp_dir.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;
using test::content;
using test::TempDir;
using ::testing::HasSubstr;

TEST(WriteFile, WritesWhatReadFileReads) {
    const TempDir folder;
    const std::string text("a\0b\r\n\xFF", 6);
    for (const std::string& written : {text, std::string()}) {
        ASSERT_TRUE(write_file(folder.path("f"), written).ok());
        EXPECT_EQ(content(folder.path("f")), written);
    }
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
    ASSERT_TRUE(write_file(folder.path("f"), "").ok());
    fs::resize_file(folder.path("f"), std::uintmax_t{1} << 40);
    EXPECT_THAT(content(folder.path("f")), HasSubstr("the file has 1099511627776 bytes; at most 536870912 are read"));
}

TEST(ReadFile, FollowsALinkToAFile) {
    const TempDir folder;
    ASSERT_TRUE(write_file(folder.path("f"), "text").ok());
    fs::create_symlink(folder.path("f"), folder.path("link"));
    EXPECT_EQ(content(folder.path("link")), "text");
}

TEST(ReadBeginning, ReadsNoMoreThanIsAskedFor) {
    const TempDir folder;
    const auto beginning = [&](const std::string& name, std::size_t most) {
        const auto bytes = read_beginning(name, most);
        return bytes.ok() ? std::string(as_text(bytes.value())) : bytes.error().text();
    };
    ASSERT_TRUE(write_file(folder.path("f"), "text").ok());
    EXPECT_EQ(beginning(folder.path("f"), 2), "te");
    EXPECT_EQ(beginning(folder.path("f"), 4), "text");
    EXPECT_EQ(beginning(folder.path("f"), 5), "text");
    EXPECT_EQ(beginning(folder.path("f"), 0), "");
    fs::resize_file(folder.path("f"), std::uintmax_t{1} << 40);
    EXPECT_EQ(beginning(folder.path("f"), 6), std::string("text\0\0", 6));
    EXPECT_EQ(beginning("/proc/self/comm", 4).size(), 4u);  // has no size of its own
}

TEST(ReadBeginning, RefusesWhatReadFileRefuses) {
    const TempDir folder;
    ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
    for (const std::string& path : {folder.path("pipe"), folder.path("none"), folder.path(), std::string("/dev/zero")})
        EXPECT_EQ(read_beginning(path, 1).error().text(), content(path));
}

TEST(ReadFile, ReadsOneFileWhereAnotherTakesItsPlaceAllTheTime) {
    const TempDir folder;
    const std::string small(1000, 's'), large(5000, 'l');
    ASSERT_TRUE(write_file(folder.path("small"), small).ok());
    ASSERT_TRUE(write_file(folder.path("large"), large).ok());
    fs::create_hard_link(folder.path("small"), folder.path("f"));
    std::jthread swapping([&](const std::stop_token& stop) {
        while (!stop.stop_requested())
            for (const char* next : {"large", "small"}) {
                fs::create_hard_link(folder.path(next), folder.path("next"));
                fs::rename(folder.path("next"), folder.path("f"));
            }
    });
    for (int look = 0; look < 20'000; ++look) {
        const std::string found = content(folder.path("f"));
        ASSERT_TRUE(found == small || found == large) << found.size() << " bytes: " << found.substr(0, 80);
    }
}

}  // namespace
}  // namespace enfilade
