// Tapes survive the way out and back, and nothing that is not one is taken for one.
#include "formats/tape.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "formats/hostile.h"

namespace enfilade {
namespace {

Tape some_tape() {
    return {"maps/enfilade.toml",
            0x0123456789ABCDEF,
            60,
            false,
            {{127, -127, -2147483647 - 1, 2147483647, kButtonRun | kButtonUse}, {}, {1, 2, 3, 4, kButtonCrouch}},
            0xFEDCBA9876543210};
}

// Where things are in the bytes of some_tape().
constexpr std::size_t kVersionAt = 7, kRateAt = 8, kNameAt = 14, kFirstTickAt = 40, kEndAt = 73;

Bytes with_byte(std::size_t at, unsigned value) {
    Bytes bytes = write_tape(some_tape());
    bytes.at(at) = static_cast<std::byte>(value);
    return bytes;
}

TEST(Tape, ReadsBackWhatWasWritten) {
    const auto tape = read_tape(write_tape(some_tape()));
    ASSERT_TRUE(tape.ok());
    EXPECT_EQ(tape.value(), some_tape());
}

TEST(Tape, RemembersHowRoomsWereFound) {
    Tape naive = some_tape();
    naive.is_naive = true;
    const auto tape = read_tape(write_tape(naive));
    ASSERT_TRUE(tape.ok());
    EXPECT_EQ(tape.value(), naive);
}

TEST(Tape, MayBeEmpty) {
    const auto tape = read_tape(write_tape({}));
    ASSERT_TRUE(tape.ok());
    EXPECT_EQ(tape.value(), Tape{});
}

/// some_tape() as version 1 wrote it: with the number of ticks before them, and no mark of the end.
Bytes with_count() {
    const Bytes now = write_tape(some_tape());
    Bytes then(now.begin(), now.begin() + kFirstTickAt);
    then[kVersionAt] = std::byte{1};
    for (const int byte : {3, 0, 0, 0}) then.push_back(static_cast<std::byte>(byte));
    then.insert(then.end(), now.begin() + kFirstTickAt, now.begin() + kEndAt);
    then.insert(then.end(), now.begin() + kEndAt + 1, now.end());
    return then;
}

TEST(Tape, ThatWasStoppedAnywhereHasTheTicksThatAreWhole) {
    const Bytes whole = write_tape(some_tape());
    for_each_cut(whole, [&](std::span<const std::byte> cut) {
        const auto tape = read_tape(cut);
        ASSERT_EQ(tape.ok(), cut.size() >= kFirstTickAt) << cut.size() << " bytes";
        if (!tape.ok()) return;
        Tape expected = some_tape();
        expected.ticks.resize(std::min((cut.size() - kFirstTickAt) / kTapeTickBytes, expected.ticks.size()));
        expected.final_hash.reset();
        EXPECT_EQ(tape.value(), expected) << cut.size() << " bytes";
    });
}

TEST(Tape, IsWrittenInPiecesAsInOne) {
    Bytes pieces = tape_beginning(some_tape());
    for (const InputRecord& tick : some_tape().ticks) {
        const Bytes piece = tape_tick(tick);
        ASSERT_EQ(piece.size(), kTapeTickBytes);
        pieces.insert(pieces.end(), piece.begin(), piece.end());
    }
    const Bytes end = tape_end(*some_tape().final_hash);
    pieces.insert(pieces.end(), end.begin(), end.end());
    EXPECT_EQ(pieces, write_tape(some_tape()));
}

TEST(Tape, OfTheFirstVersionIsStillRead) {
    const auto tape = read_tape(with_count());
    ASSERT_TRUE(tape.ok()) << tape.error().text();
    EXPECT_EQ(tape.value(), some_tape());
}

TEST(Tape, OfTheFirstVersionIsRefusedWhenCutAnywhere) {
    for_each_cut(with_count(), [](std::span<const std::byte> cut) { EXPECT_FALSE(read_tape(cut).ok()) << cut.size(); });
}

TEST(Tape, OfTheFirstVersionTakesNoMemoryForTicksThatAreNotThere) {
    Bytes bytes = with_count();
    bytes.at(kFirstTickAt + 3) = std::byte{0xFF};
    EXPECT_FALSE(read_tape(bytes).ok());
}

TEST(Tape, IsRefusedWithOneByteMore) {
    Bytes bytes = write_tape(some_tape());
    bytes.push_back({});
    const auto tape = read_tape(bytes);
    ASSERT_FALSE(tape.ok());
    EXPECT_EQ(tape.error().text(), "byte 82: the tape should end here, found 1 more bytes");
}

TEST(Tape, IsRefusedWithoutItsMagic) { EXPECT_FALSE(read_tape(with_byte(0, 'X')).ok()); }

TEST(Tape, NamesAVersionItDoesNotKnow) {
    const auto tape = read_tape(with_byte(kVersionAt, 3));
    ASSERT_FALSE(tape.ok());
    EXPECT_EQ(tape.error().text(), "byte 8: the tape has version 3; 1 and 2 can be read");
}

TEST(Tape, IsRefusedWithNoTicksASecond) { EXPECT_FALSE(read_tape(with_byte(kRateAt, 0)).ok()); }

TEST(Tape, IsRefusedWithTooManyTicksASecond) { EXPECT_FALSE(read_tape(with_byte(kRateAt + 3, 1)).ok()); }

TEST(Tape, IsRefusedWithANameThatIsNotText) { EXPECT_FALSE(read_tape(with_byte(kNameAt, 0xFF)).ok()); }

TEST(Tape, IsRefusedWithAPaceBeyondTheFull) { EXPECT_FALSE(read_tape(with_byte(kFirstTickAt + 1, 0x80)).ok()); }

TEST(Tape, IsRefusedWithAnUnknownButton) { EXPECT_FALSE(read_tape(with_byte(kFirstTickAt + 10, 0x10)).ok()); }

}  // namespace
}  // namespace enfilade
