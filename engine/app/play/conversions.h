// Levels of Doom: where WADs are, and the maps they were converted to, each once.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace enfilade {

/// The WADs that are installed: those in $DOOMWADDIR, /usr/share/games/doom, /usr/local/share/games/doom, and in the
/// folder wads of the user's folder for data; sorted within each folder.
std::vector<std::string> installed_wads();

/// The path of the WAD that is meant: by its path, or where there is none, by the name, with or without .wad, of one
/// that is installed. None where it is neither.
std::optional<std::string> find_wad(const std::string& word);

/// Whether the word names a level, in any case: E1M1 to E9M9, MAP00 to MAP99.
bool is_level_name(std::string_view word);

/// Where wadconv is: beside this program, or where the build puts it, or wherever PATH leads.
std::optional<std::string> find_converter();

/// Says how far a conversion is, in a sentence.
using Teller = std::function<void(const std::string& sentence)>;

/// How many conversions are kept: those that were played longest ago go, and are made again when somebody wants them.
inline constexpr std::size_t kMostConversions = 16;

/// The folder of the maps that the WADs, a game and the patches that follow it, were converted to: in the user's folder
/// for caches, named after the first WAD and the contents of all of them. Where it is not there, not whole, or by
/// another converter than the one there is now, they are converted first, which takes seconds and says so. One process
/// converts at a time; others wait. An error says what the converter said.
/// Cost of finding it: to read the WADs and the folder, some ten ms.
/// converter : wadconv, or a program that takes the same words
Result<std::string> convert_wads(const std::vector<std::string>& wads, const Teller& tell = {},
                                 const std::optional<std::string>& converter = find_converter());

/// The map of that level in a converted folder, or of the first where no name is given.
Result<std::string> level_in(const std::string& folder, const std::string& level = {});

/// A folder that was converted before.
struct KeptConversion {
    std::string name;  ///< of the WADs: "freedoom2"
    std::string folder;
};
/// All there are, by their names. What is in them is not looked at.
std::vector<KeptConversion> kept_conversions();

}  // namespace enfilade
