#include "platform/audio.h"

#include <algorithm>
#include <cmath>

#include "world/input.h"

namespace enfilade {
namespace {

/// What begins less than this ago begins at its full level: its attack is part of the sound [samples].
constexpr std::size_t kFresh = kMixRate / 10;

Gains operator*(Gains g, double volume) {
    return {static_cast<float>(g.left * volume), static_cast<float>(g.right * volume)};
}

}  // namespace

std::vector<double> lengths_of(std::span<const Samples> sounds) {
    std::vector<double> lengths;
    for (const Samples& sound : sounds) lengths.push_back(static_cast<double>(sound.size()) / kMixRate);
    return lengths;
}

Gains gains_of(const Voice& voice) {
    return {static_cast<float>(std::sqrt((1 - voice.side) / 2)), static_cast<float>(std::sqrt((1 + voice.side) / 2))};
}

void Mixer::hear(std::span<const Voice> voices, double tick, double volume) {
    for (Playing& playing : playing_) {
        const auto told =
            std::find_if(voices.begin(), voices.end(), [&](const Voice& v) { return v.is_same(playing.voice); });
        if (playing.ends) continue;
        playing.ends = told == voices.end() || !is_in_place(playing, tick);
        tell(playing, playing.ends ? Gains{} : gains_of(*told) * (told->level * volume));
    }
    for (const Voice& voice : voices) {
        const auto is_it = [&](const Playing& playing) { return !playing.ends && playing.voice.is_same(voice); };
        if (std::none_of(playing_.begin(), playing_.end(), is_it)) start(voice, tick, volume);
    }
}

void Mixer::start(const Voice& voice, double tick, double volume) {
    Playing playing;
    playing.voice = voice;
    playing.at = sample_at(voice, tick);
    if (playing.at >= sounds_[voice.sound.index].size()) return;
    const Gains goal = gains_of(voice) * (voice.level * volume);
    if (playing.at < kFresh) playing.now = goal;
    tell(playing, goal);
    playing_.push_back(playing);
}

void Mixer::tell(Playing& playing, const Gains& goal) {
    playing.goal = goal;
    playing.glides = kGlide;
}

std::size_t Mixer::sample_at(const Voice& voice, double tick) const {
    const std::size_t length = sounds_[voice.sound.index].size();
    const double samples = std::max(0.0, (tick - voice.since) / kTickRate * kMixRate);
    if (!voice.loops) return samples < static_cast<double>(length) ? static_cast<std::size_t>(samples) : length;
    if (length == 0) return 0;
    return static_cast<std::size_t>(std::fmod(samples, static_cast<double>(length)));
}

bool Mixer::is_in_place(const Playing& playing, double tick) const {
    const std::size_t length = sounds_[playing.voice.sound.index].size();
    const std::size_t wanted = sample_at(playing.voice, tick);
    std::size_t off = std::max(wanted, playing.at) - std::min(wanted, playing.at);
    if (playing.voice.loops) off = std::min(off, length - off);
    return static_cast<double>(off) <= kMostDrift * kMixRate;
}

void Mixer::render(std::span<float> stereo) {
    std::fill(stereo.begin(), stereo.end(), 0.0f);
    for (Playing& playing : playing_) add(playing, stereo);
    std::erase_if(playing_, [this](const Playing& p) {
        return (p.ends && p.glides == 0) || p.at >= sounds_[p.voice.sound.index].size();
    });
    for (float& value : stereo) value = std::clamp(value, -1.0f, 1.0f);
}

void Mixer::add(Playing& playing, std::span<float> stereo) const {
    const Samples& sound = sounds_[playing.voice.sound.index];
    for (std::size_t i = 0; i + 1 < stereo.size() && playing.at < sound.size(); i += 2) {
        if (playing.glides > 0) {
            const float part = 1.0f / static_cast<float>(playing.glides--);
            playing.now.left += (playing.goal.left - playing.now.left) * part;
            playing.now.right += (playing.goal.right - playing.now.right) * part;
        }
        stereo[i] += sound[playing.at] * playing.now.left;
        stereo[i + 1] += sound[playing.at] * playing.now.right;
        if (++playing.at == sound.size() && playing.voice.loops) playing.at = 0;
    }
}

}  // namespace enfilade
