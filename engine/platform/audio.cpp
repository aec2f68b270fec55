#include "platform/audio.h"

#include <SDL.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/files.h"
#include "platform/sdl_events.h"
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

// Sound, by SDL. Of SDL2_mixer nothing would be left to use: it knows neither a place in a sound to begin at nor levels
// that glide, its sides come in 255 steps, and it plays only into a device. So the device asks our mixer.

namespace {

/// What the device asks for at a time [frames]: 21 ms, about as long as a picture is shown.
constexpr std::uint16_t kFramesAtATime = 1024;

/// SDL's sound between start and end.
class AudioSession {
public:
    AudioSession() = default;
    AudioSession(const AudioSession&) = delete;
    AudioSession& operator=(const AudioSession&) = delete;
    ~AudioSession() { SDL_QuitSubSystem(SDL_INIT_AUDIO); }
};

class SdlAudio final : public Audio {
public:
    SdlAudio(std::unique_ptr<AudioSession> session, std::vector<Samples> sounds)
        : session_(std::move(session)), mixer_(std::move(sounds)) {}
    ~SdlAudio() override {
        if (device_ != 0) SDL_CloseAudioDevice(device_);
    }

    bool open() {
        SDL_AudioSpec wanted{};
        wanted.freq = kMixRate;
        wanted.format = AUDIO_F32SYS;
        wanted.channels = 2;
        wanted.samples = kFramesAtATime;
        wanted.userdata = this;
        wanted.callback = [](void* self, std::uint8_t* bytes, int count) {
            static_cast<SdlAudio*>(self)->mixer_.render(
                {reinterpret_cast<float*>(bytes), static_cast<std::size_t>(count) / sizeof(float)});
        };
        device_ = SDL_OpenAudioDevice(nullptr, 0, &wanted, nullptr, 0);
        if (device_ != 0) SDL_PauseAudioDevice(device_, 0);
        return device_ != 0;
    }

    void hear(std::span<const Voice> voices, double tick, double volume) override {
        SDL_LockAudioDevice(device_);
        mixer_.hear(voices, tick, volume);
        SDL_UnlockAudioDevice(device_);
    }

private:
    std::unique_ptr<AudioSession> session_;
    Mixer mixer_;  ///< used by the device's thread, too: only while the device is locked
    SDL_AudioDeviceID device_ = 0;
};

/// A WAV of the longest sound, the highest rate and a few channels fits; what is larger is no sound effect [bytes].
constexpr std::size_t kMostBytes = std::size_t{64} << 20;

struct WavFreer {
    void operator()(std::uint8_t* wav) const { SDL_FreeWAV(wav); }
};

struct Wav {
    SDL_AudioSpec spec{};
    std::unique_ptr<std::uint8_t, WavFreer> data;
    std::uint32_t bytes = 0;

    std::uint32_t frame_bytes() const { return SDL_AUDIO_BITSIZE(spec.format) / 8u * spec.channels; }
    std::uint32_t frames() const { return bytes / frame_bytes(); }
    double seconds() const { return double(frames()) / spec.freq; }
};

constexpr std::size_t kFileHeader = 12, kChunkHeader = 8;  ///< "RIFF", a length, "WAVE"; a name, a length [bytes]

/// The file with no chunk longer than what is left of the file, be it cut off or lying: SDL takes the memory for a
/// chunk before it reads it.
Bytes with_true_lengths(std::span<const std::byte> file) {
    Bytes wav(file.begin(), file.end());
    for (std::size_t at = kFileHeader; at + kChunkHeader <= wav.size();) {
        const std::size_t left = wav.size() - at - kChunkHeader;
        const std::size_t length = ByteReader(file.subspan(at + 4)).u32();
        for (std::size_t i = 0; length > left && i < 4; ++i) wav[at + 4 + i] = static_cast<std::byte>(left >> (8 * i));
        at += kChunkHeader + length + length % 2;
    }
    return wav;
}

bool is_wav(std::span<const std::byte> file) {
    const std::string_view text = as_text(file);
    return file.size() >= kFileHeader && text.starts_with("RIFF") && text.substr(8).starts_with("WAVE");
}

Result<Wav> load(std::span<const std::byte> file) {
    if (!is_wav(file) || file.size() > kMostBytes)
        return Error{"sound", "expected a WAV file of up to 64 MiB, found " +
                                  (is_wav(file) ? std::to_string(file.size()) + " bytes" : "no WAV file")};
    const Bytes bytes = with_true_lengths(file);
    Wav wav;
    std::uint8_t* data = nullptr;
    SDL_RWops* source = SDL_RWFromConstMem(bytes.data(), static_cast<int>(bytes.size()));
    if (source == nullptr || SDL_LoadWAV_RW(source, 1, &wav.spec, &data, &wav.bytes) == nullptr)
        return sdl_error("sound", "read the WAV file");
    wav.data.reset(data);
    return wav;
}

Result<void> check(const Wav& wav) {
    const SDL_AudioSpec& spec = wav.spec;
    if (spec.freq < kLeastRate || spec.freq > kMostRate)
        return Error{"sound", "expected 1000 to 384000 frames a second, found " + std::to_string(spec.freq)};
    if (spec.channels < 1 || spec.channels > kMostChannels)
        return Error{"sound", "expected one channel or two, found " + std::to_string(spec.channels)};
    if (wav.frames() == 0) return Error{"sound", "expected sound, found a WAV file without any"};
    if (wav.seconds() > kLongestSound)
        return Error{"sound", "expected two minutes at most, found " + std::to_string(wav.seconds()) + " s"};
    return {};
}

/// In one go: SDL's streams lose the end of a sound.
Result<Samples> converted(const Wav& wav) {
    const SDL_AudioSpec& spec = wav.spec;
    SDL_AudioCVT conversion{};
    if (SDL_BuildAudioCVT(&conversion, spec.format, spec.channels, spec.freq, AUDIO_F32SYS, 1, kMixRate) < 0)
        return sdl_error("sound", "convert the sound");
    const std::uint32_t whole_frames = wav.frames() * wav.frame_bytes();
    std::vector<std::uint8_t> buffer(std::size_t{whole_frames} * static_cast<std::size_t>(conversion.len_mult));
    std::copy_n(wav.data.get(), whole_frames, buffer.begin());
    conversion.buf = buffer.data();
    conversion.len = conversion.len_cvt = static_cast<int>(whole_frames);
    if (conversion.needed != 0 && SDL_ConvertAudio(&conversion) != 0) return sdl_error("sound", "convert the sound");
    Samples samples(static_cast<std::size_t>(conversion.len_cvt) / sizeof(float));
    // Of few frames at a high rate none may be left, and there is no memory behind a vector without elements.
    std::copy_n(buffer.data(), samples.size() * sizeof(float), reinterpret_cast<std::uint8_t*>(samples.data()));
    // Files of floats may hold anything.
    for (float& sample : samples) sample = sample >= -1 ? std::min(sample, 1.0f) : sample < -1 ? -1.0f : 0.0f;
    return samples;
}

}  // namespace

Result<std::unique_ptr<Audio>> open_audio(std::vector<Samples> sounds) {
    if (SDL_InitSubSystem(SDL_INIT_AUDIO) != 0)
        return Error{"sound", std::string("there is no sound device: ") + SDL_GetError()};
    auto audio = std::make_unique<SdlAudio>(std::make_unique<AudioSession>(), std::move(sounds));
    if (!audio->open()) return Error{"sound", std::string("cannot open the sound device: ") + SDL_GetError()};
    return std::unique_ptr<Audio>(std::move(audio));
}

Result<Samples> read_wav(std::span<const std::byte> bytes) {
    auto wav = load(bytes);
    if (!wav.ok()) return wav.error();
    if (const Result<void> valid = check(wav.value()); !valid.ok()) return valid.error();
    return converted(wav.value());
}

}  // namespace enfilade
