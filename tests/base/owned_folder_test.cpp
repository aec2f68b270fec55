// Folders that are the program's own and go, others that stay; what is put aside; one holder of a lock at a time.
#include "base/owned_folder.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include "base/files.h"
#include "support/temp_dir.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class OwnedFolders : public ::testing::Test {
protected:
    std::string write(const std::string& name, const std::string& text = "mine") const {
        fs::create_directories(fs::path(dir_.path(name)).parent_path());
        EXPECT_TRUE(write_file(dir_.path(name), std::string_view(text)).ok());
        return dir_.path(name);
    }
    /// A folder with the file "level", put in its place.
    void make(const std::string& name, const std::string& level) const {
        auto scratch = ScratchFolder::make(dir_.path());
        ASSERT_TRUE(scratch.ok()) << scratch.error().text();
        ASSERT_TRUE(write_file(scratch.value().path() + "/level", std::string_view(level)).ok());
        const Result<void> done = scratch.value().take_place(dir_.path(name), "mark of " + level);
        ASSERT_TRUE(done.ok()) << done.error().text();
    }
    std::size_t entries() const { return list_folder(dir_.path()).size(); }

    test::TempDir dir_;
};

TEST_F(OwnedFolders, GoWithTheirObjectUnlessTheyTookAPlace) {
    {
        auto scratch = ScratchFolder::make(dir_.path("new"));
        ASSERT_TRUE(scratch.ok());
        fs::create_directories(scratch.value().path() + "/sub/folder");
        EXPECT_EQ(mark_of(scratch.value().path()), "");
    }
    EXPECT_TRUE(fs::is_empty(dir_.path("new")));
    make("place", "one");
    EXPECT_EQ(test::content(dir_.path("place/level")), "one");
    EXPECT_EQ(mark_of(dir_.path("place")), "mark of one");
}

TEST_F(OwnedFolders, TakeThePlaceOfOthers) {
    make("place", "one");
    make("place", "two");
    EXPECT_EQ(test::content(dir_.path("place/level")), "two");
    EXPECT_EQ(entries(), 1u) << "the first is gone";
}

TEST_F(OwnedFolders, TakeThePlaceOfOneThatWasLeftEmpty) {
    fs::create_directory(dir_.path("place"));
    make("place", "one");
    EXPECT_EQ(test::content(dir_.path("place/level")), "one");
}

TEST_F(OwnedFolders, TakeNoPlaceOfWhatIsSomebodyElses) {
    write("place/saved");
    auto scratch = ScratchFolder::make(dir_.path());
    ASSERT_TRUE(scratch.ok());
    for (const char* place : {"place", "place/saved"}) {
        const Result<void> done = scratch.value().take_place(dir_.path(place), "");
        ASSERT_FALSE(done.ok());
        EXPECT_THAT(done.error().what, HasSubstr("not this program's own"));
    }
    EXPECT_EQ(test::content(dir_.path("place/saved")), "mine");
}

TEST_F(OwnedFolders, AreRemovedOnlyWithTheirMark) {
    make("place", "one");
    write("yours/saved");
    fs::create_directory_symlink(dir_.path("place"), dir_.path("link"));
    EXPECT_FALSE(remove_owned_folder(dir_.path("yours")).ok());
    EXPECT_FALSE(remove_owned_folder(dir_.path("link")).ok());
    EXPECT_FALSE(remove_owned_folder(dir_.path("place/level")).ok());
    EXPECT_FALSE(remove_owned_folder(dir_.path("nowhere")).ok());
    EXPECT_EQ(entries(), 3u);
    EXPECT_TRUE(remove_owned_folder(dir_.path("place")).ok());
    EXPECT_EQ(test::content(dir_.path("yours/saved")), "mine");
}

TEST_F(OwnedFolders, DoNotTakeAlongWhatTheirLinksLeadTo) {
    write("yours/saved");
    {
        auto scratch = ScratchFolder::make(dir_.path());
        ASSERT_TRUE(scratch.ok());
        fs::create_directory_symlink(dir_.path("yours"), scratch.value().path() + "/link");
    }
    EXPECT_EQ(test::content(dir_.path("yours/saved")), "mine");
}

TEST_F(OwnedFolders, ThatWereLeftAreFoundByTheirMark) {
    fs::create_directories(dir_.path("scratch-yours"));
    write("scratch-left/" + std::string(kFolderMark), "");
    write("scratch-left/sub/level");
    remove_left_scratch_folders(dir_.path());
    EXPECT_THAT(list_folder(dir_.path()), ::testing::ElementsAre("scratch-yours"));
}

TEST_F(OwnedFolders, StandAsTheyWereWhereTheirSuccessorCannotTakeTheirPlace) {
    make("place", "one");
    auto scratch = ScratchFolder::make(dir_.path());
    ASSERT_TRUE(scratch.ok());
    fs::remove_all(scratch.value().path());
    EXPECT_FALSE(scratch.value().take_place(dir_.path("place"), "").ok());
    EXPECT_EQ(test::content(dir_.path("place/level")), "one");
}

class Superseded : public OwnedFolders {};

TEST_F(Superseded, FilesGoOnceTheirSuccessorIsThere) {
    const std::string old = write("old"), gone = dir_.path("gone"), full = write("full/other");
    fs::create_directory(dir_.path("empty"));
    const std::vector<std::string> files{old, gone, dir_.path("full"), dir_.path("empty")};
    EXPECT_FALSE(remove_superseded(files, dir_.path("new")).ok());
    EXPECT_TRUE(fs::exists(old));
    const Result<void> done = remove_superseded(files, write("new"));
    EXPECT_TRUE(done.ok()) << done.error().text();
    EXPECT_THAT(list_folder(dir_.path()), ::testing::ElementsAre("full", "new"));
    EXPECT_TRUE(fs::exists(full));
}

class SetAside : public OwnedFolders {};

TEST_F(SetAside, OverwritesNothing) {
    const std::string path = write("settings.toml", "first");
    EXPECT_EQ(set_aside(path).value(), path + ".unreadable");
    EXPECT_EQ(test::content(path), "first") << "until the successor is there";
    write("settings.toml", "second");
    EXPECT_EQ(set_aside(path).value(), path + ".unreadable-2");
    EXPECT_EQ(test::content(path + ".unreadable"), "first");
    EXPECT_EQ(test::content(path + ".unreadable-2"), "second");
    EXPECT_FALSE(set_aside(dir_.path("nothing")).ok());
}

TEST_F(SetAside, TakesWhatIsNoFile) {
    write("folder/file");
    EXPECT_EQ(set_aside(dir_.path("folder")).value(), dir_.path("folder.unreadable"));
    EXPECT_EQ(test::content(dir_.path("folder.unreadable/file")), "mine");
    ASSERT_EQ(mkfifo(dir_.path("pipe").c_str(), 0600), 0);
    EXPECT_TRUE(set_aside(dir_.path("pipe")).ok());
    EXPECT_FALSE(fs::exists(dir_.path("pipe"))) << "it would be written to";
}

TEST_F(SetAside, KeepsTheFileThatALinkLeadsTo) {
    write("real/settings.toml");
    fs::create_symlink("real/settings.toml", dir_.path("settings.toml"));
    ASSERT_TRUE(set_aside(dir_.path("settings.toml")).ok());
    write("settings.toml", "new");
    EXPECT_TRUE(fs::is_symlink(dir_.path("settings.toml")));
    EXPECT_EQ(test::content(dir_.path("real/settings.toml.unreadable")), "mine");
}

/// Who holds the lock in another process, or waits for it.
class LockedElsewhere : public OwnedFolders {
protected:
    /// Takes the lock once this process says so; exits with 0 when it was had.
    void start() {
        ASSERT_EQ(pipe(go_) + pipe(waits_), 0);
        child_ = fork();  // before the lock is taken here: a child has all locks of its parent
        if (child_ != 0) {
            close(waits_[1]);  // so that who reads sees the child end
            waits_[1] = -1;
            return;
        }
        char byte = 0;
        const bool is_told = read(go_[0], &byte, 1) == 1;
        const auto lock = FileLock::take(path_, [&] { byte = char(::write(waits_[1], "w", 1)); });
        _exit(is_told && byte == 1 && lock.ok() ? 0 : 1);
    }
    ~LockedElsewhere() override {
        for (const int end : {go_[0], go_[1], waits_[0], waits_[1]}) close(end);
    }

    const std::string path_ = dir_.path("lock");
    int go_[2] = {-1, -1}, waits_[2] = {-1, -1};
    pid_t child_ = -1;
};

TEST_F(LockedElsewhere, WaitsUntilItIsFree) {
    start();
    auto held = FileLock::take(path_);
    ASSERT_TRUE(held.ok());
    EXPECT_EQ(::write(go_[1], "g", 1), 1);
    char byte = 0;
    EXPECT_EQ(read(waits_[0], &byte, 1), 1);
    int status = -1;
    EXPECT_EQ(waitpid(child_, &status, WNOHANG), 0) << "it waits";
    {
        const FileLock released = std::move(held).value();
    }
    EXPECT_EQ(waitpid(child_, &status, 0), child_);
    EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace enfilade
