// What a listener hears: which sounds, since when, how loud, and from which side. A function of the map, of what has
// happened and of the time: nothing has to have been heard before.
#pragma once
#include <span>
#include <vector>

#include "map/map.h"
#include "space/hearing.h"
#include "world/instant.h"

namespace enfilade {

/// What makes a sound.
enum class Maker : std::uint8_t {
    thing,    ///< number: its ThingId
    trigger,  ///< number: index into History::firings()
    start,    ///< of a floor or ceiling; number: twice its SectorId, one more for the ceiling
    stop,     ///< the same, on arrival
};

/// A sound at one moment. Voices with the same sound, maker, number and since are the same one at different moments.
struct Voice {
    SoundId sound;
    Maker maker = Maker::thing;
    std::uint32_t number = 0;
    double since = 0;    ///< when it began; before the start of the world, too [ticks]
    bool loops = false;  ///< from its end to its beginning, over and over
    double level = 0;    ///< 0..1, > 0
    double side = 0;     ///< from -1, left, to 1, right

    bool is_same(const Voice& v) const {
        return sound == v.sound && maker == v.maker && number == v.number && since == v.since;
    }
};

struct Listener {
    Place place;
    Angle yaw;
};

/// What part of a sound's volume is left at the end of a way: (1 - d / r)^2 with r its reach, 0 beyond it.
double loudness(double way_m, double reach_m);

/// All that is heard at a moment, the loudest kMostVoices of it.
///
/// hearing   : of the same map; it listens anew, if anything sounds anywhere
/// lengths_s : of the sounds, by SoundId [s]: whatever plays once is heard for so long
/// slice     : of a listening that takes long (Hearing::listen); until it ends, ways are those of the one before
/// Cost: a look at each sector that ever moved and at what began in the last longest length; where something sounds,
/// also the ways to it (Hearing::listen), or if things sound, those within the reach of any sound. A map without sounds
/// costs nothing.
std::vector<Voice> voices_at(const Instant& now, Hearing& hearing, const Listener& listener,
                             std::span<const double> lengths_s, std::size_t slice = Hearing::kMostBeams);

/// More at once are a noise [voices].
inline constexpr std::size_t kMostVoices = 32;

/// Nearer than this, a sound moves into the middle, so that it does not jump from ear to ear of who walks through it
/// [m].
inline constexpr double kAroundHead = 1;

}  // namespace enfilade
