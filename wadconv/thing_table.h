// Every type of thing that Doom and Doom II maps place, with its size, its looks and how it stands or hangs.
// Source: the numbers of Matthew S. Fell's "The Unofficial Doom Specs" (1994), §4.2.1, sizes and idle frames as in
// Doom's own tables (id Software, info.c, 1993).
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace enfilade::wadconv {

/// One picture of an idle animation.
struct IdleFrame {
    char letter;        ///< of the sprite's frames
    std::uint8_t tics;  ///< how long it is shown [1/35 s]; 0: for ever
    bool is_bright;     ///< drawn at full light
};

struct ThingType {
    int number;                   ///< as in THINGS
    std::string_view kind;        ///< what it is, e.g. "Zombieman"
    std::int16_t radius, height;  ///< [map units]
    bool is_solid;
    bool hangs;               ///< from the ceiling
    std::string_view sprite;  ///< four letters; empty: nothing to be seen (starts, exits, targets)
    std::string_view frames;  ///< idle animation as "A10 B10*": letter, tics, '*' where bright; no tics: for ever
};

/// Whether the type can be shot: it holds up what moves until it is crushed, where mere decoration never does.
bool can_be_shot(int number);

/// Tics in a second.
inline constexpr double kTicsPerSecond = 35;

/// Types with a meaning of their own.
inline constexpr int kFirstStart = 1, kLastStart = 4, kDeathmatchStart = 11, kTeleportExit = 14;

/// All types, by rising number.
std::span<const ThingType> thing_types();

/// The type of that number, or null.
const ThingType* find_thing_type(int number);

/// Every frame of every thing that stands idle, as "POSSA"; some several times.
std::vector<std::string> idle_frames();

/// Takes the first frame off a text of frames; a text that is none gives letter 0.
IdleFrame take_frame(std::string_view& frames);

}  // namespace enfilade::wadconv
