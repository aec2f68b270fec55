// Doom's sounds as WAV files: those that what lines and sectors do is heard by.
// Source: the Doom Wiki, "Sound" (the format that the DMX library plays).
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "base/result.h"
#include "wadconv/wad.h"

namespace enfilade::wadconv {

/// The folder of WAV files beside the maps.
inline constexpr std::string_view kSoundFolder = "sounds/";

/// A sound lump, 8 bits a sample, as a WAV file. Any bytes; an Error where it is not one, or is cut off.
Result<Bytes> wav_of(const Lump& lump);

/// A pile's sounds of doors, lifts, floors, switches, teleports and pick-ups.
class Sounds {
public:
    /// Those that the pile lacks are left out; so are broken ones, and told.
    static Sounds list(const WadPile& pile);

    /// By Doom's name in lower case, without "ds", as "doropn".
    bool has(std::string_view name) const { return files_.contains(name); }
    /// The same, as maps refer to it: "sounds/doropn.wav".
    static std::string file_of(std::string_view name);
    const std::vector<Error>& problems() const { return problems_; }

    /// Writes every one below the folder of the maps.
    Result<void> write(const std::string& folder) const;

private:
    std::map<std::string, Bytes, std::less<>> files_;
    std::vector<Error> problems_;
};

}  // namespace enfilade::wadconv
