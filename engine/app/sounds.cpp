#include "app/sounds.h"

#include <filesystem>

#include "formats/quoted.h"
#include "platform/wav.h"

namespace enfilade {
namespace {

Result<Samples> load_sound(const std::string& path, const FileReader& read) {
    const auto bytes = read(path);
    if (!bytes.ok()) return bytes.error();
    auto samples = read_wav(bytes.value());
    if (!samples.ok()) return Error{path, samples.error().what};
    return samples;
}

}  // namespace

LoadedSounds load_sounds(const Map& map, const std::string& map_path, const FileReader& read) {
    LoadedSounds loaded;
    const std::filesystem::path folder = std::filesystem::path(map_path).parent_path();
    for (std::size_t i = 0; i < map.sounds.size(); ++i) {
        const Sound& sound = map.sounds[i];
        auto samples = load_sound((folder / sound.file).string(), read);
        if (!samples.ok())
            loaded.faults.push_back(
                {SoundId(i), "sound " + enfilade::quoted(sound.name) + " is silent: " + samples.error().text()});
        loaded.samples.push_back(samples.ok() ? std::move(samples).value() : Samples{});
    }
    return loaded;
}

}  // namespace enfilade
