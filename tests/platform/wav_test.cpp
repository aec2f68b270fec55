// WAV files, and what pretends to be one.
#include "platform/audio.h"

#include <SDL.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "base/hash.h"
#include "support/wav.h"

namespace enfilade {
namespace {

using namespace test;

TEST(Wav, OfTheMixersOwnRateIsReadAsItIs) {
    const auto samples = read_wav(wav_of({0, 0.5, -0.5, 1, -1}));
    ASSERT_TRUE(samples.ok()) << samples.error().text();
    ASSERT_EQ(samples.value().size(), 5u);
    const double expected[] = {0, 0.5, -0.5, 1, -1};
    // 16 bits.
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(samples.value()[i], expected[i], 1.0 / 32767) << i;
}

TEST(Wav, OfAnotherRateKeepsItsLengthInSeconds) {
    const auto samples = read_wav(wav_of(tone(11025, 440, 11025), {11025, 1}));
    ASSERT_TRUE(samples.ok());
    EXPECT_NEAR(double(samples.value().size()), kMixRate, kMixRate * 0.01);  // the filter's tail
}

TEST(Wav, OfTwoChannelsBecomesOne) {
    const auto samples = read_wav(wav_of({0.5, 0, 0.5, 0, 0.5, 0}, {48000, 2}));
    ASSERT_TRUE(samples.ok());
    ASSERT_EQ(samples.value().size(), 3u);
    EXPECT_NEAR(samples.value()[1], 0.25, 1.0 / 32767);
}

TEST(Wav, ThatIsNoneIsRefused) {
    EXPECT_FALSE(read_wav({}).ok());
    EXPECT_FALSE(read_wav(Bytes(1000, std::byte{'?'})).ok());
}

TEST(Wav, OfAnAbsurdRateIsRefusedBeforeItTakesMemory) {
    EXPECT_FALSE(read_wav(wav_of(tone(4800, 440), {1, 1})).ok());
    EXPECT_FALSE(read_wav(wav_of(tone(4800, 440), {4000000000u, 1})).ok());
}

TEST(Wav, LongerThanTwoMinutesIsRefused) {
    EXPECT_TRUE(read_wav(wav_of(std::vector<double>(119 * 1000, 0.0), {1000, 1})).ok());
    EXPECT_FALSE(read_wav(wav_of(std::vector<double>(121 * 1000, 0.0), {1000, 1})).ok());
}

TEST(Wav, WithoutAnySoundIsRefused) {
    for (const WavShape shape : {WavShape{}, WavShape{11025, 1}, WavShape{48000, 2}}) {
        const auto samples = read_wav(wav_of({}, shape));
        ASSERT_FALSE(samples.ok());
        EXPECT_EQ(samples.error().text(), "sound: expected sound, found a WAV file without any");
    }
    EXPECT_FALSE(read_wav(wav_of({0.5}, {48000, 2})).ok());  // half a frame
}

TEST(Wav, OfLessThanASampleHasNone) {
    const auto samples = read_wav(wav_of({0.5}, {384000, 1}));
    ASSERT_TRUE(samples.ok()) << samples.error().text();
    EXPECT_TRUE(samples.value().empty());
}

/// The most that SDL asked for at once [bytes].
std::size_t most_asked = 0;

void* noting_malloc(std::size_t bytes) {
    most_asked = std::max(most_asked, bytes);
    return std::malloc(bytes);
}

/// Reads with an eye on what SDL asks for.
std::optional<std::size_t> samples_read(const Bytes& file) {
    SDL_malloc_func allocate = nullptr;
    SDL_calloc_func allocate_zeros = nullptr;
    SDL_realloc_func reallocate = nullptr;
    SDL_free_func free = nullptr;
    SDL_GetMemoryFunctions(&allocate, &allocate_zeros, &reallocate, &free);
    most_asked = 0;
    SDL_SetMemoryFunctions(noting_malloc, std::calloc, std::realloc, std::free);
    const auto samples = read_wav(file);
    SDL_SetMemoryFunctions(allocate, allocate_zeros, reallocate, free);
    return samples.ok() ? std::optional(samples.value().size()) : std::nullopt;
}

TEST(Wav, TakesNoMemoryForWhatTheFileOnlyClaimsToHave) {
    const Bytes sound = wav_of(tone(200, 440));
    ASSERT_EQ(samples_read(sound), 200u);
    EXPECT_GT(most_asked, 0u);
    Bytes lying = sound;
    for (const std::size_t at : {40, 41, 42, 43}) lying[at] = std::byte{0xD5};  // the length of its data
    EXPECT_EQ(samples_read(lying), 200u);
    EXPECT_LE(most_asked, std::size_t{1} << 20);
}

TEST(Wav, WithAnyBytesChangedIsReadOrRefused) {
    const Bytes sound = wav_of(tone(200, 440));
    Random random(5);
    for (int i = 0; i < 3000; ++i) {
        Bytes broken = sound;
        for (int n = 0; n < 3; ++n) broken[random.below(64)] = static_cast<std::byte>(random.below(256));
        broken.resize(random.below(broken.size() + 1));
        const auto samples = read_wav(broken);
        const Samples read = samples.ok() ? samples.value() : Samples{};
        EXPECT_TRUE(std::ranges::all_of(read, [](float s) { return s >= -1 && s <= 1; }));
    }
}

}  // namespace
}  // namespace enfilade
