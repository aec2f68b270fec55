#include "app/sounds.h"

#include <filesystem>

#include "formats/text_parts.h"
#include "platform/audio.h"

namespace enfilade {
namespace {

Result<Samples> load_sound(const std::string& path, const FileReader& read) {
    const auto bytes = read(path);
    if (!bytes.ok()) return bytes.error();
    auto samples = read_wav(bytes.value());
    if (!samples.ok()) return Error{path, samples.error().what};
    return samples;
}

/// Where a sound would take more than what is left, that is the fault.
Result<Samples> keep_within(std::size_t& room, Result<Samples> samples, const std::string& path) {
    if (!samples.ok()) return samples;
    const std::size_t length = samples.value().size();
    if (length > room)
        return Error{path, "expected sounds that play for at most " + number_text(kMostSound) +
                               " s together, found no room for this one of " +
                               number_text(static_cast<double>(length) / kMixRate) +
                               " s; make sounds shorter, or use fewer"};
    room -= length;
    return samples;
}

}  // namespace

LoadedSounds load_sounds(const Map& map, const std::string& map_path, const FileReader& read) {
    LoadedSounds loaded;
    const std::filesystem::path folder = std::filesystem::path(map_path).parent_path();
    auto room = static_cast<std::size_t>(kMostSound * kMixRate);
    for (std::size_t i = 0; i < map.sounds.size(); ++i) {
        const Sound& sound = map.sounds[i];
        const std::string path = (folder / sound.file).string();
        auto samples = keep_within(room, load_sound(path, read), path);
        if (!samples.ok())
            loaded.faults.push_back(
                {SoundId(i), "sound " + in_quotes(sound.name) + " is silent: " + samples.error().text()});
        loaded.samples.push_back(samples.ok() ? std::move(samples).value() : Samples{});
    }
    return loaded;
}

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

HeardMoment at_usual_rate(std::vector<Voice> voices, std::uint64_t tick, TickRate rate) {
    const double usual_ticks = double{kTickRate} / ticks_per_second(rate);
    for (Voice& voice : voices) voice.since *= usual_ticks;
    return {std::move(voices), static_cast<double>(tick) * usual_ticks};
}

void Soundscape::hear(const Map& map, const World& world, double volume) {
    if (!audio_ || heard_tick_ == world.tick) return;
    heard_tick_ = world.tick;
    const Listener listener{world.player.place, world.player.yaw};
    std::vector<Voice> voices = voices_at(now(map, world), *hearing_, listener, lengths_s_, Hearing::kBeamsATick);
    const HeardMoment heard = at_usual_rate(std::move(voices), world.tick, world.history.rate());
    audio_->hear(heard.voices, heard.tick, volume);
}

void Soundscape::fall_silent() {
    heard_tick_.reset();
    if (audio_) audio_->hear({}, 0, 0);
}

}  // namespace enfilade
