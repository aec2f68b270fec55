// The hash and the random sequence: known values, so that no machine and no later change can differ unnoticed.
#include "base/hash.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace enfilade {
namespace {

template <class... Values>
std::uint64_t hash_of(Values... values) {
    Hash hash;
    (hash.add(values), ...);
    return hash.value();
}

// The expected values come from a second implementation of the same description, in Python.
TEST(Hash, HasKnownValues) {
    EXPECT_EQ(hash_of(), 0xF52A15E9A9B5E89Bu);
    EXPECT_EQ(hash_of(std::uint64_t{0}), 0xC385FB0A5B698A7Du);
    EXPECT_EQ(hash_of(1, 2, 3), 0x80A67F4B21BEACBEu);
    EXPECT_EQ(hash_of(-1), 0x94F2F32E58CAC646u);
    EXPECT_EQ(hash_of(1.5), 0xC974A9B85CB1C462u);
    EXPECT_EQ(hash_of(std::string_view("door")), 0xBAFA9645F489A36Eu);
    EXPECT_EQ(hash_of(std::string_view("\xC3\xB6")), 0xECBEB8CEF66485D3u);
}

TEST(Hash, TakesNegativeZeroForZero) { EXPECT_EQ(hash_of(-0.0), hash_of(0.0)); }

TEST(Hash, DependsOnOrder) { EXPECT_NE(hash_of(1, 2), hash_of(2, 1)); }

TEST(Hash, GivesEqualNumbersOfAnyWidthTheSameHash) {
    EXPECT_EQ(hash_of(std::int32_t{-7}), hash_of(std::int64_t{-7}));
    EXPECT_EQ(hash_of(std::uint32_t{7}), hash_of(std::uint64_t{7}));
    EXPECT_EQ(hash_of(true), hash_of(1));
}

TEST(Hash, TellsWhereOneTextEndsAndTheNextBegins) {
    EXPECT_NE(hash_of(std::string_view("ab"), std::string_view("c")),
              hash_of(std::string_view("a"), std::string_view("bc")));
}

TEST(Hash, TakesALiteralForTextAndNotForABool) { EXPECT_EQ(hash_of("door"), hash_of(std::string_view("door"))); }

// Published values of the generator for the seeds 1234567 and 0.
TEST(Random, FollowsTheWrittenDownSequence) {
    Random random(1234567);
    EXPECT_EQ(random.bits(), 6457827717110365317u);
    EXPECT_EQ(random.bits(), 3203168211198807973u);
    EXPECT_EQ(Random(0).bits(), 0xE220A8397B1DCDAFu);
}

TEST(Random, HasKnownSmallNumbers) {
    Random random(42);
    for (std::uint64_t expected : {7u, 1u, 2u, 3u, 0u, 8u}) EXPECT_EQ(random.below(10), expected);
}

TEST(Random, HasKnownFractions) {
    Random random(42);
    for (double expected : {0x1.7bae644c5fd6dp-1, 0x1.477f199d93378p-3, 0x1.1d499d5c4c3e6p-2})
        EXPECT_EQ(random.uniform(0, 1), expected);
}

TEST(Random, StaysBelowItsBound) {
    Random random(1);
    for (int i = 0; i < 10000; ++i) {
        const auto count = random.bits() | 1;
        EXPECT_LT(random.below(count), count);
        EXPECT_EQ(random.below(1), 0u);
    }
}

TEST(Random, FillsItsIntervalAndStaysInside) {
    Random random(2);
    double least = 5, most = -3;
    for (int i = 0; i < 10000; ++i) {
        const double x = random.uniform(-3, 5);
        least = std::min(least, x);
        most = std::max(most, x);
    }
    EXPECT_GE(least, -3);
    EXPECT_LT(least, -2.99);
    EXPECT_GT(most, 4.99);
    EXPECT_LT(most, 5);
}

// The expected values come from the same second implementation.
TEST(HashOfBytes, HasKnownValues) {
    std::vector<std::byte> bytes(77);
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = std::byte(i);
    const auto hash_of_first = [&](std::size_t count) { return hash_of_bytes(std::span(bytes).first(count)); };
    EXPECT_EQ(hash_of_first(0), 0x3A315B4585D4F4C6u);
    EXPECT_EQ(hash_of_first(5), 0xA442A59882FBBE7Eu);
    EXPECT_EQ(hash_of_first(32), 0x7514B0577328BB1Cu);
    EXPECT_EQ(hash_of_first(77), 0x236D2C746F87175Fu);
}

TEST(HashOfBytes, TellsEveryByteAndTheLength) {
    for (std::size_t size = 0; size < 80; ++size) {
        std::vector<std::byte> bytes(size);
        std::set<std::uint64_t> hashes{hash_of_bytes(bytes)};
        for (std::byte& byte : bytes) {
            byte = std::byte{1};
            hashes.insert(hash_of_bytes(bytes));
            byte = std::byte{0};
        }
        bytes.push_back(std::byte{0});
        hashes.insert(hash_of_bytes(bytes));
        EXPECT_EQ(hashes.size(), size + 2);
    }
}

}  // namespace
}  // namespace enfilade
