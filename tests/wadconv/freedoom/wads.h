// FreeDoom's WADs as Debian packages them: where they are, and their maps converted and loaded.
#pragma once
#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "map/load.h"
#include "support/temp_dir.h"
#include "wadconv/convert.h"
#include "wadconv/pictures.h"
#include "wadconv/wad.h"

namespace enfilade::test {

/// One of the WADs of Debian's packages freedoom and freedm.
struct FreeDoomWad {
    const char* name;  ///< without ".wad"
    std::size_t maps;
};

/// All three, 100 maps together, for tests with a parameter.
inline auto freedoom_wads() {
    return ::testing::Values(FreeDoomWad{"freedoom1", 36}, FreeDoomWad{"freedoom2", 32}, FreeDoomWad{"freedm", 32});
}

/// Names tests after their WADs.
inline std::string name_of(const ::testing::TestParamInfo<FreeDoomWad>& info) { return info.param.name; }

/// The WAD's path: in the folder where Debian puts it, or where DOOMWADDIR says, as for other Doom engines.
std::string path_of(const FreeDoomWad& wad);

/// Whether a test of that WAD should be skipped: the file is not there, and ENFILADE_REQUIRE_FREEDOOM is not set, as it
/// is in CI.
bool is_missing(const FreeDoomWad& wad);

/// Said where is_missing.
inline constexpr const char* kMissing = "not installed; Debian's packages freedoom and freedm hold the WADs";

/// True where ENFILADE_LONG is set: more poses, larger pictures, longer walks.
bool is_long_run();

/// A WAD and its maps, read but not converted. A WAD that cannot be read stops the program.
struct ReadWad {
    explicit ReadWad(const FreeDoomWad& wad);
    ReadWad(const ReadWad&) = delete;  // pictures and sounds point into the pile

    wadconv::WadPile pile;
    wadconv::Pictures pictures;
    wadconv::Sounds sounds;
    std::vector<wadconv::DoomMap> maps;
};

enum class Doors : std::uint8_t { as_they_are, open };

/// In lower case.
std::string lower(std::string text);

/// A WAD converted by a whole run into a folder, as a player would have it.
class ConvertedWad {
public:
    /// `only`: the maps to convert; empty: all.
    ConvertedWad(const FreeDoomWad& wad, Doors doors, std::vector<std::string> only = {});

    /// Lower-case names of the maps, in the order of the WAD; none where the run failed.
    const std::vector<std::string>& maps() const { return maps_; }
    const std::string& error() const { return error_; }
    /// One of them, read, built and checked from its file; with all things, or as one meets it at a skill.
    LoadedMap load(const std::string& map, std::optional<int> skill = {}) const;

private:
    enfilade::test::TempDir dir_;
    std::vector<std::string> maps_;
    std::string error_;
};

}  // namespace enfilade::test
