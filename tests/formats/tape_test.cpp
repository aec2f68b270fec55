// Tapes survive the way out and back, and nothing that is not one is taken for one.
#include "formats/tape.h"

#include <gtest/gtest.h>

#include "formats/hostile.h"

namespace enfilade {
namespace {

Tape some_tape() {
    return {"maps/enfilade.toml",
            0x0123456789ABCDEF,
            60,
            {{127, -127, -2147483647 - 1, 2147483647, kButtonRun | kButtonUse}, {}, {1, 2, 3, 4, kButtonCrouch}},
            0xFEDCBA9876543210};
}

// Where things are in the bytes of some_tape().
constexpr std::size_t kVersionAt = 7, kRateAt = 8, kNameAt = 14, kCountAt = 40, kFirstTickAt = 44;

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

TEST(Tape, MayBeEmpty) {
    const auto tape = read_tape(write_tape({}));
    ASSERT_TRUE(tape.ok());
    EXPECT_EQ(tape.value(), Tape{});
}

TEST(Tape, IsRefusedWhenCutAnywhere) {
    for_each_cut(write_tape(some_tape()),
                 [](std::span<const std::byte> cut) { EXPECT_FALSE(read_tape(cut).ok()) << cut.size() << " bytes"; });
}

TEST(Tape, IsRefusedWithOneByteMore) {
    Bytes bytes = write_tape(some_tape());
    bytes.push_back({});
    const auto tape = read_tape(bytes);
    ASSERT_FALSE(tape.ok());
    EXPECT_EQ(tape.error().text(), "byte 85: the tape should end here, found 1 more bytes");
}

TEST(Tape, IsRefusedWithoutItsMagic) { EXPECT_FALSE(read_tape(with_byte(0, 'X')).ok()); }

TEST(Tape, NamesAVersionItDoesNotKnow) {
    const auto tape = read_tape(with_byte(kVersionAt, 2));
    ASSERT_FALSE(tape.ok());
    EXPECT_EQ(tape.error().text(), "byte 8: the tape has version 2; only 1 can be read");
}

TEST(Tape, IsRefusedWithNoTicksASecond) { EXPECT_FALSE(read_tape(with_byte(kRateAt, 0)).ok()); }

TEST(Tape, IsRefusedWithTooManyTicksASecond) { EXPECT_FALSE(read_tape(with_byte(kRateAt + 3, 1)).ok()); }

TEST(Tape, IsRefusedWithANameThatIsNotText) { EXPECT_FALSE(read_tape(with_byte(kNameAt, 0xFF)).ok()); }

TEST(Tape, TakesNoMemoryForTicksThatAreNotThere) { EXPECT_FALSE(read_tape(with_byte(kCountAt + 3, 0xFF)).ok()); }

TEST(Tape, IsRefusedWithAPaceBeyondTheFull) { EXPECT_FALSE(read_tape(with_byte(kFirstTickAt, 0x80)).ok()); }

TEST(Tape, IsRefusedWithAnUnknownButton) { EXPECT_FALSE(read_tape(with_byte(kFirstTickAt + 10, 0x10)).ok()); }

}  // namespace
}  // namespace enfilade
