// A level converted, and the level with a doorway that most tests of the converter change a bit.
#pragma once
#include <gtest/gtest.h>

#include "wadconv/convert.h"
#include "wadconv/wad_builder.h"

namespace enfilade::wadconv::test {

/// A level converted with the pictures of picture_wad().
struct Converted {
    WadPile pile = pile_of({picture_wad().finish()});
    Pictures pictures = Pictures::list(pile, {"POSSA", "POSSB", "BAR1A", "BAR1B"}).value();
    Sounds sounds = Sounds::list(pile);
    MapFile file;
    Report report;

    explicit Converted(const Level& level, const ConvertOptions& options = {}, const std::string& name = "MAP01") {
        DoomMap doom = level.map;
        doom.name = name;
        Conversion conversion = convert_map(doom, pictures, sounds, options);
        EXPECT_EQ(conversion.report.refused, "");
        file = conversion.file.value_or(MapFile{});
        report = std::move(conversion.report);
    }

    std::vector<std::uint32_t> noted(Kind kind) const {
        const auto found = report.found.find(kind);
        return found == report.found.end() ? std::vector<std::uint32_t>{} : found->second;
    }

    /// The wall of the sector that starts at the given place, in Doom's units.
    const WallRecord& wall(const std::string& sector, double x, double y) const {
        for (const SectorRecord& s : file.sectors)
            for (const LoopRecord& loop : s.loops)
                for (std::size_t i = 0; i < loop.vertices.size(); ++i)
                    if (s.name == sector && loop.vertices[i] == Vec2{x / 32, -y / 32}) return loop.walls[i];
        ADD_FAILURE() << "no wall of " << sector << " at " << x << ", " << y;
        return file.sectors.at(0).loops.at(0).walls.at(0);
    }
};

/// Two rooms, "s0" from x = 0 to 64 and "s1" to 128, with the doorway (64, 64) -> (64, 0), line 2, between them.
struct Doorway {
    Level level;
    Doorway(int floor = 16, int ceiling = 96, const std::string& flat = "CEIL1_1") {
        level.sector(0, 128, "FLOOR0_1", flat);
        level.sector(floor, ceiling, "FLOOR0_1", flat);
        level.line({0, 0}, {0, 64}, 0);
        level.line({0, 64}, {64, 64}, 0);
        level.line({64, 64}, {64, 0}, 0, 1);
        level.line({64, 0}, {0, 0}, 0);
        level.line({64, 64}, {128, 64}, 1);
        level.line({128, 64}, {128, 0}, 1);
        level.line({128, 0}, {64, 0}, 1);
        for (std::string* name : {&right().upper, &right().lower, &right().middle}) *name = "WALL";
        level.thing(32, 32, 1);
    }

    Linedef& line() { return level.map.lines[2]; }
    Sidedef& right() { return level.map.sides[line().right]; }
};

}  // namespace enfilade::wadconv::test
