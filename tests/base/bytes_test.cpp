// Little-endian reading and writing, and what a reader does at the end of its bytes.
#include "base/files.h"

#include <gtest/gtest.h>

#include <limits>

namespace enfilade {
namespace {

Bytes bytes_of(std::initializer_list<int> values) {
    Bytes bytes;
    for (int v : values) bytes.push_back(static_cast<std::byte>(v));
    return bytes;
}

TEST(ByteReader, ReadsLittleEndian) {
    const Bytes bytes = bytes_of({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15});
    ByteReader reader(bytes);
    EXPECT_EQ(reader.u8(), 0x01u);
    EXPECT_EQ(reader.u16(), 0x0302u);
    EXPECT_EQ(reader.u32(), 0x07060504u);
    EXPECT_EQ(reader.u64(), 0x0F0E0D0C0B0A0908u);
    EXPECT_EQ(reader.remaining(), 0u);
    EXPECT_FALSE(reader.failed());
}

TEST(ByteReader, ReadsNegativeNumbers) {
    const Bytes bytes = bytes_of({0xFE, 0xFF, 0x00, 0x00, 0x00, 0x80});
    ByteReader reader(bytes);
    EXPECT_EQ(reader.i16(), -2);
    EXPECT_EQ(reader.i32(), std::numeric_limits<std::int32_t>::min());
}

TEST(ByteReader, TakesBytesWithoutCopying) {
    const Bytes bytes = bytes_of({1, 2, 3});
    ByteReader reader(bytes);
    EXPECT_EQ(reader.u8(), 1);
    EXPECT_EQ(reader.take(2).data(), bytes.data() + 1);
    EXPECT_EQ(reader.position(), 3u);
}

TEST(ByteReader, FailsAtEveryTruncationWithZerosAndNothingElse) {
    ByteWriter writer;
    for (int i = 0; i < 15; ++i) writer.u8(0xFF);
    for (std::size_t length = 0; length < 15; ++length) {
        const Bytes cut(writer.bytes().begin(), writer.bytes().begin() + static_cast<std::ptrdiff_t>(length));
        ByteReader reader(cut);
        EXPECT_EQ(reader.u8(), length >= 1 ? 0xFFu : 0u);
        EXPECT_EQ(reader.u16(), length >= 3 ? 0xFFFFu : 0u);
        EXPECT_EQ(reader.u32(), length >= 7 ? 0xFFFFFFFFu : 0u);
        EXPECT_EQ(reader.u64(), 0u);
        EXPECT_TRUE(reader.failed()) << length;
        EXPECT_EQ(reader.remaining(), 0u);
    }
}

TEST(ByteReader, StaysFailedAndEmptyAfterOneReadTooMany) {
    const Bytes bytes = bytes_of({1, 2, 3});
    ByteReader reader(bytes);
    EXPECT_TRUE(reader.take(4).empty());
    EXPECT_EQ(reader.u8(), 0u);
    EXPECT_TRUE(reader.failed());
}

TEST(ByteReader, RefusesLengthsThatWouldOverflow) {
    const Bytes bytes = bytes_of({1, 2, 3});
    ByteReader reader(bytes);
    EXPECT_EQ(reader.u8(), 1u);
    EXPECT_TRUE(reader.take(std::numeric_limits<std::size_t>::max()).empty());
    EXPECT_TRUE(reader.failed());
}

TEST(ByteReader, TakesNothingFromNothing) {
    ByteReader reader({});
    EXPECT_TRUE(reader.take(0).empty());
    EXPECT_FALSE(reader.failed());
}

TEST(ByteWriter, WritesWhatAReaderReadsBack) {
    ByteWriter writer;
    writer.u8(0x12);
    writer.u16(0x3456);
    writer.u32(0x789ABCDE);
    writer.u64(0xF0123456789ABCDE);
    writer.text("door\xFF");
    ByteReader reader(writer.bytes());
    EXPECT_EQ(reader.u8(), 0x12u);
    EXPECT_EQ(reader.u16(), 0x3456u);
    EXPECT_EQ(reader.u32(), 0x789ABCDEu);
    EXPECT_EQ(reader.u64(), 0xF0123456789ABCDEu);
    EXPECT_EQ(as_text(reader.take(5)), "door\xFF");
    EXPECT_EQ(reader.remaining(), 0u);
}

}  // namespace
}  // namespace enfilade
