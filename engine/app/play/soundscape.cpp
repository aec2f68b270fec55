#include "app/play/soundscape.h"

#include "app/sounds.h"

namespace enfilade {

std::vector<std::string> Soundscape::begin(const Map& map, const std::string& map_path) {
    end();
    if (map.sounds.empty()) return {};
    LoadedSounds loaded = load_sounds(map, map_path, read_file);
    lengths_s_ = lengths_of(loaded.samples);
    std::vector<std::string> faults;
    for (SoundFault& fault : loaded.faults) faults.push_back(std::move(fault.sentence));
    auto audio = open_audio(std::move(loaded.samples));
    if (!audio.ok()) {
        faults.push_back(audio.error().text());
        return faults;
    }
    audio_ = std::move(audio).value();
    hearing_.emplace(map);
    return faults;
}

void Soundscape::end() {
    audio_.reset();
    heard_tick_.reset();
    hearing_.reset();
}

void Soundscape::hear(const Map& map, const World& world, double volume) {
    if (!audio_ || heard_tick_ == world.tick) return;
    heard_tick_ = world.tick;
    const Listener listener{world.player.place, world.player.yaw};
    const auto tick = static_cast<double>(world.tick);
    audio_->hear(voices_at(now(map, world), *hearing_, listener, lengths_s_, Hearing::kBeamsATick), tick, volume);
}

void Soundscape::fall_silent() {
    heard_tick_.reset();
    if (audio_) audio_->hear({}, 0, 0);
}

}  // namespace enfilade
