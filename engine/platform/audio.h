// A sound device that plays what a listener hears.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "base/files.h"
#include "base/result.h"
#include "world/voices.h"

namespace enfilade {

// Voices to sound: mixed into stereo, frame by frame, without a sound card.

/// One frame of stereo is a left and a right value.
inline constexpr int kMixRate = 48000;  ///< [frames/s]

/// A sound ready for mixing: one channel, kMixRate values a second, each within -1..1.
using Samples = std::vector<float>;

/// How long they play, by SoundId: what voices_at() wants to know [s].
std::vector<double> lengths_of(std::span<const Samples> sounds);

/// What a voice at the full level is worth on each side: left^2 + right^2 = 1, so that a sound that goes round the head
/// keeps its power.
struct Gains {
    float left = 0, right = 0;
};
Gains gains_of(const Voice& voice);

/// Plays what it is told is heard. Levels glide from one telling to the next, so that nothing clicks; a voice that is
/// told of first in its middle is faded in there, one that is told of no more is faded out.
class Mixer {
public:
    /// sounds : by SoundId; an empty one is silent
    explicit Mixer(std::vector<Samples> sounds) : sounds_(std::move(sounds)) {}

    /// What is heard from the next frame on. tick: the time in the world, to which each voice's place in its sound
    /// belongs, as if there were kTickRate ticks a second; where what is played is farther than kMostDrift from there,
    /// it jumps. volume: of everything, 0..1.
    void hear(std::span<const Voice> voices, double tick, double volume);

    /// Fills the buffer with frames, left and right by turns, each value within -1..1. Cost: the frames times the
    /// voices; allocates nothing.
    void render(std::span<float> stereo);

    /// Voices that are mixed, those that fade out included.
    std::size_t playing() const { return playing_.size(); }

    /// How long levels glide [frames]: 5 ms.
    static constexpr int kGlide = kMixRate / 200;

    /// The clocks of a sound card and of the world differ, and a slow picture holds the world up [s].
    static constexpr double kMostDrift = 0.25;

private:
    struct Playing {
        Voice voice;
        std::size_t at = 0;  ///< the next sample
        Gains now, goal;
        int glides = 0;  ///< frames until `now` is `goal`
        bool ends = false;
    };

    void start(const Voice& voice, double tick, double volume);
    void tell(Playing& playing, const Gains& goal);
    bool is_in_place(const Playing& playing, double tick) const;
    void add(Playing& playing, std::span<float> stereo) const;
    /// Where in its sound the voice is at a time [samples]; beyond the end where it is over.
    std::size_t sample_at(const Voice& voice, double tick) const;

    std::vector<Samples> sounds_;
    std::vector<Playing> playing_;
};

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
