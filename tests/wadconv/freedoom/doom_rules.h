// What Doom's lines do to floors and ceilings, by Doom's own rules and by nothing of the converter's: what converted
// maps are held against.
// Source: id Software, linuxdoom-1.10 (1997), p_spec.c, p_doors.c, p_floor.c, p_plats.c and p_ceilng.c; where Boom
// (TeamTNT, 1998) mended them, as Boom has it.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "wadconv/freedoom/doom_specials.h"
#include "wadconv/wad.h"

namespace enfilade::test {

/// A height that a floor or ceiling goes to, and how.
struct MotionLeg {
    double height;    ///< [map units]
    double speed;     ///< [map units / tic]
    double wait = 0;  ///< once it is there, before it goes on [tics]
};

/// What a line does to one sector.
struct Motion {
    std::uint32_t sector;
    bool is_ceiling;
    std::vector<MotionLeg> legs;
    bool loops = false;
};

/// What the rules ask about pictures: the height of a wall's texture, 0 where there is none [texels].
using TextureHeight = std::function<double(const std::string&)>;

/// What a line with that special does in a level where nothing has happened yet, by rising sectors and, of stairs, in
/// the order of building.
std::vector<Motion> motions_of(const wadconv::DoomMap& map, const wadconv::Linedef& line, const DoomSpecial& special,
                               const TextureHeight& height_of);

}  // namespace enfilade::test
