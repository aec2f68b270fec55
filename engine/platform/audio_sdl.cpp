// Sound, by SDL. Of SDL2_mixer nothing would be left to use: it knows neither a place in a sound to begin at nor levels
// that glide, its sides come in 255 steps, and it plays only into a device. So the device asks our mixer.
#include <SDL.h>

#include "platform/audio.h"

namespace enfilade {
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

}  // namespace

Result<std::unique_ptr<Audio>> open_audio(std::vector<Samples> sounds) {
    if (SDL_InitSubSystem(SDL_INIT_AUDIO) != 0)
        return Error{"sound", std::string("there is no sound device: ") + SDL_GetError()};
    auto audio = std::make_unique<SdlAudio>(std::make_unique<AudioSession>(), std::move(sounds));
    if (!audio->open()) return Error{"sound", std::string("cannot open the sound device: ") + SDL_GetError()};
    return std::unique_ptr<Audio>(std::move(audio));
}

}  // namespace enfilade
