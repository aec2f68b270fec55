// Pictures that change: which walls and flats follow one another, and which are the two faces of a switch.
// Source: the lists of Matthew S. Fell, "The Unofficial Doom Specs" (1994), §8.4.1 and §4.3.3; lumps ANIMATED and
// SWITCHES as the Boom reference (1998) describes them.
#pragma once
#include <string>
#include <vector>

#include "formats/effect_records.h"
#include "wadconv/wad.h"

namespace enfilade::wadconv {

/// A wall texture or flat: its name in the WAD, and its picture's in the map.
struct NamedPicture {
    std::string lump, picture;
};

/// All walls and all flats, each in an order in which animations run from one to another.
struct PictureOrder {
    std::vector<NamedPicture> walls, flats;
};

/// The pile's animations, of those pictures it has: from ANIMATED, else Doom's own. No picture is in two of them.
/// A lump that breaks off, or names what is not there, gives what it can.
std::vector<AnimationRecord> list_animations(const WadPile& pile, const PictureOrder& order);

/// The pile's switches: from SWITCHES, else every wall SW1… that has a SW2….
std::vector<SwitchRecord> list_switches(const WadPile& pile, const PictureOrder& order);

}  // namespace enfilade::wadconv
