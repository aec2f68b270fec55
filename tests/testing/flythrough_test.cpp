// A flythrough as a test of others: passes as it was recorded, and names what differs or cannot be read.
#include "testing/flythrough.h"

#include <gmock/gmock.h>

#include "formats/frame_hashes.h"
#include "support/temp_dir.h"

namespace enfilade {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr const char* kRoom = R"(format = 1
[player]
sector = "room"
x = 1
y = 1
[[sectors]]
name = "room"
floor = { texture = "floor" }
ceiling = { z = 3, texture = "floor" }
[[sectors.loops]]
v = [0, 0,  4, 0,  4, 3,  0, 3]
walls = [{ texture = "wall" }, { texture = "wall" }, { texture = "wall" }, { texture = "wall" }]
)";
constexpr const char* kTurn = "map = \"room.toml\"\nsize = [16, 10]\nrate = 4\n[[legs]]\nseconds = 1\nturn = 90\n";

class CheckFlythrough : public ::testing::Test {
protected:
    CheckFlythrough() {
        write("room.toml", kRoom);
        write("turn.toml", kTurn);
        record(std::vector<std::uint64_t>(5, 0));
    }

    void write(const std::string& name, std::string_view text) const { (void)write_file(dir_.path(name), text); }

    void record(const std::vector<std::uint64_t>& hashes) const {
        FrameRecording recording{RecordedPictures{16, 10, "column"}, {}, {}};
        for (const std::uint64_t hash : hashes)
            recording.frames.push_back({std::uint32_t(recording.frames.size()), hash});
        write("turn.hashes", write_frame_hashes(recording));
    }

    Result<std::vector<Mismatch>> check() const { return check_flythrough(dir_.path("turn.toml"), 2); }
    std::string complaint() const {
        const auto checked = check();
        return checked.ok() ? "" : checked.error().text();
    }

    test::TempDir dir_;
};

TEST_F(CheckFlythrough, NamesEveryFrameThatDiffersUntilItIsRecorded) {
    const auto differing = check();
    ASSERT_TRUE(differing.ok()) << differing.error().text();
    ASSERT_THAT(differing.value(), SizeIs(5));
    std::vector<std::uint64_t> hashes;
    for (const Mismatch& mismatch : differing.value()) hashes.push_back(mismatch.actual);
    record(hashes);
    EXPECT_THAT(check().value(), SizeIs(0));
    hashes[3] ^= 1;
    record(hashes);
    ASSERT_THAT(check().value(), SizeIs(1));
    EXPECT_EQ(check().value().front().frame, 3);
}

TEST_F(CheckFlythrough, TellsWhatCannotBeRead) {
    record({1, 2});
    EXPECT_THAT(complaint(), HasSubstr("the flight has 5 frames, but 2 others were recorded"));
    write("turn.toml", std::string(kTurn) + "nonsense = 1\n");
    EXPECT_THAT(complaint(), HasSubstr("turn.toml:7:1: error: "));
    write("turn.toml", "map = \"gone.toml\"\n[[legs]]\nwait = 1\n");
    EXPECT_THAT(complaint(), HasSubstr("gone.toml"));
    write("turn.toml", std::string(kTurn) + "to = [9, 9]\n");
    EXPECT_THAT(complaint(), HasSubstr("leg 1"));
    write("turn.toml", "renderer = \"stencil\"\n" + std::string(kTurn));
    EXPECT_NE(complaint(), "");
    EXPECT_FALSE(check_flythrough(dir_.path("none.toml")).ok());
}

TEST_F(CheckFlythrough, NeedsAWindowForOpenGl) {
    write("turn.toml", "renderer = \"stencil\"\n" + std::string(kTurn));
    write("turn.hashes",
          "picture 16x10 stencil\n0 0000000000000000\n1 0000000000000000\n2 0000000000000000\n"
          "3 0000000000000000\n4 0000000000000000\n");
    EXPECT_THAT(complaint(), HasSubstr("has no OpenGL"));
}

}  // namespace
}  // namespace enfilade
