// The levels of an archive, as they were and as they became, for tests that go through all their lines.
#pragma once
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "map/load.h"
#include "wadconv/convert.h"
#include "wadconv/freedoom/doom_rules.h"
#include "wadconv/freedoom/firing_range.h"
#include "wadconv/freedoom/wads.h"

namespace enfilade::test {

/// One level of the archive, as it was and as it became.
struct ConvertedLevel {
    const wadconv::DoomMap& doom;
    const Map& map;
    const TextureHeight& height_of;
    FiringRange range;

    std::string name_of(const wadconv::Linedef& line) const {
        return doom.name + " line " + std::to_string(&line - doom.lines.data()) + ", special " +
               std::to_string(line.special);
    }
    std::vector<Motion> motions_of(const wadconv::Linedef& line) const {
        const auto special = special_of(line.special);
        return special ? test::motions_of(doom, line, *special, height_of) : std::vector<Motion>{};
    }
};

/// How many were compared, by special.
using Counts = std::map<int, std::size_t>;

inline void print(const char* what, const Counts& counts) {
    std::size_t sum = 0;
    std::printf("%s:", what);
    for (const auto& [special, count] : counts) {
        std::printf(" %dx%zu", special, count);
        sum += count;
    }
    std::printf("; %zu in all\n", sum);
}

/// A test that looks at every level of an archive.
class FreeDoomLevels : public ::testing::TestWithParam<FreeDoomWad> {
protected:
    void each_level(const std::function<void(const ConvertedLevel&)>& visit) {
        const ReadWad wad(GetParam());
        const TextureHeight height_of = [&](const std::string& texture) {
            const wadconv::PictureFile* file = wad.pictures.wall(texture);
            return file ? static_cast<double>(file->height) : 0;
        };
        for (const wadconv::DoomMap& doom : wad.maps) {
            const wadconv::Conversion conversion = wadconv::convert_map(doom, wad.pictures, wad.sounds, {});
            Findings findings;
            const std::optional<Map> map = build_map(conversion.file.value(), wad.pictures.sizes(), findings);
            ASSERT_TRUE(map) << doom.name;
            visit({doom, *map, height_of, FiringRange(doom, *map)});
        }
    }
};

}  // namespace enfilade::test
