// WAV files to samples.
#pragma once
#include "base/files.h"
#include "platform/mixer.h"

namespace enfilade {

/// Longest sound that is read [s]; and the rates and channels that are, far beyond what sound cards do.
inline constexpr double kLongestSound = 120;
inline constexpr int kLeastRate = 1000, kMostRate = 384000;  ///< [frames/s]
inline constexpr int kMostChannels = 2;

/// Any bytes. What SDL reads (8, 16, 24 and 32 bits, floats, ADPCM, A- and mu-law), mixed into one channel and brought
/// to kMixRate; less than a frame of that is no sample. An error where it is none of these, without any frame, or
/// longer than kLongestSound.
Result<Samples> read_wav(std::span<const std::byte> bytes);

}  // namespace enfilade
