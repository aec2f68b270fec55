// A sound device that plays what a listener hears.
#pragma once
#include <memory>
#include <span>
#include <vector>

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

}  // namespace enfilade
