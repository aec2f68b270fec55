// Panels and things in the rooms of maps made in code, at random and where they touch.
#pragma once
#include "support/map_builder.h"

namespace enfilade::test {

/// With the picture "lattice", a little off the lattice on which things and eyes are put.
PanelRecord panel(Vec2 a, Vec2 b, double bottom = 0.25, double top = 1.75);

/// As many panels as find a place among the rooms' walls and each other; half of them on a lattice of half metres, so
/// that they touch walls, corners and each other.
void scatter_panels(MapFile& file, int tries, std::uint64_t seed);

/// Things with the picture "lattice" that nothing but their place tells apart, anywhere or on a lattice.
void scatter_things(MapFile& file, int count, std::uint64_t seed);

/// Lamps of all colours, some of them restless, anywhere in the rooms.
void scatter_lights(MapFile& file, int count, std::uint64_t seed);

/// Paints every other picture, holes aside, in squares of the colours of a table that darkens them to quite other ones.
void paint_by_table(TextureSet& textures);

/// Lets everything go that moves and shines by itself: floors and ceilings bob, things turn and float, panels scroll, a
/// sun shines on every other room, and every third is unlit.
void enliven(MapFile& file);

/// A lattice: every other square of 8 x 8 is a hole, some squares are coloured glass.
Texture lattice();

}  // namespace enfilade::test
