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

/// Files are seen from the map's folder.
LoadedSounds load_sounds(const Map& map, const std::string& map_path, const FileReader& read);

}  // namespace enfilade
