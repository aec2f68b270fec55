// The sounds of a map: read from their files, ready to be played.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/files.h"
#include "map/map.h"
#include "platform/audio.h"
#include "world/world.h"

namespace enfilade {

struct SoundFault {
    SoundId sound;
    std::string sentence;
};

struct LoadedSounds {
    std::vector<Samples> samples;    ///< by SoundId; silent where the file could not be read
    std::vector<SoundFault> faults;  ///< one for each of those
};

/// How long all sounds of a map may play together, one after the other [s]: half an hour, fifteen of the longest
/// that are read, 330 MiB of samples. Those of FreeDoom II's doors and lifts play for ten seconds.
inline constexpr double kMostSound = 1800;

/// Files are seen from the map's folder. A sound for which there is no room, counted in the order of their ids, is
/// silent, with a fault that says so; memory is never taken for more than kMostSound and one sound.
LoadedSounds load_sounds(const Map& map, const std::string& map_path, const FileReader& read);

/// What is heard at a moment, by the ticks that sound devices count: kTickRate of a second (platform/audio.h).
struct HeardMoment {
    std::vector<Voice> voices;
    double tick;
};

/// voices, tick: of a world that takes `rate` ticks in a second.
HeardMoment at_usual_rate(std::vector<Voice> voices, std::uint64_t tick, TickRate rate);

// What the player hears: the map's sounds, from where they are, on the sound device.

class Soundscape {
public:
    /// Begins with a map, which must stay where it is until the next one. A device is opened only if the map has
    /// sounds. Returns what the player should know: sounds that cannot be read, no device; then it is silent.
    std::vector<std::string> begin(const Map& map, const std::string& map_path);
    /// Closes the device; silent until the next map.
    void end();

    /// Whether the map called for a device, and there was one.
    bool is_open() const { return audio_ != nullptr; }

    /// What the player hears now; costs nothing where no tick has passed since. volume: 0..1
    void hear(const Map& map, const World& world, double volume);
    /// Time stands still, or runs backwards.
    void fall_silent();

private:
    std::optional<Hearing> hearing_;
    std::vector<double> lengths_s_;
    std::unique_ptr<Audio> audio_;
    std::optional<std::uint64_t> heard_tick_;
};

}  // namespace enfilade
