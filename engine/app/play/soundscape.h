// What the player hears: the map's sounds, from where they are, on the sound device.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "platform/audio.h"
#include "world/world.h"

namespace enfilade {

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
