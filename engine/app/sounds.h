// The sounds of a map: read from their files, ready to be played.
#pragma once
#include <string>
#include <vector>

#include "base/files.h"
#include "map/map.h"
#include "platform/mixer.h"

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

}  // namespace enfilade
