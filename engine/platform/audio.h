// A sound device that plays what a listener hears.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "base/files.h"
#include "base/result.h"
#include "platform/mixer.h"

namespace enfilade {

/// Plays until it is destroyed. All calls from the thread that opened it.
class Audio {
public:
    virtual ~Audio() = default;

    /// See Mixer::hear. Waits, if need be, until the device has taken its next few milliseconds.
    virtual void hear(std::span<const Voice> voices, double tick, double volume) = 0;
};

/// The device, or why there is none: no sound card, or no right to it. sounds: by SoundId.
Result<std::unique_ptr<Audio>> open_audio(std::vector<Samples> sounds);

// WAV files to samples.

/// Longest sound that is read [s]; and the rates and channels that are, far beyond what sound cards do.
inline constexpr double kLongestSound = 120;
inline constexpr int kLeastRate = 1000, kMostRate = 384000;  ///< [frames/s]
inline constexpr int kMostChannels = 2;

/// Any bytes. What SDL reads (8, 16, 24 and 32 bits, floats, ADPCM, A- and mu-law), mixed into one channel and brought
/// to kMixRate; less than a frame of that is no sample. An error where it is none of these, without any frame, or
/// longer than kLongestSound.
Result<Samples> read_wav(std::span<const std::byte> bytes);

}  // namespace enfilade
