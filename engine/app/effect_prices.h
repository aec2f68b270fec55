// What the effects of a map cost, measured: the same views drawn with each of them and without it.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "formats/map_file.h"
#include "map/textures.h"

namespace enfilade {

// What a map calls for beyond plain rooms, and what each of it costs.

/// One kind of effect.
struct Effect {
    const char* name;     ///< "linked portals"
    const char* counted;  ///< what is counted, one of it: "wall"
    const char* cost;     ///< in words: what is paid, and when
    /// How many of them the map has.
    std::size_t (*count)(const MapFile&);
    /// Takes it out of the map, so that the map can be drawn without it; null: then it would be another map.
    void (*take_out)(MapFile&);
};

/// All kinds, in a fixed order.
const std::vector<Effect>& all_effects();

/// One kind of effect that a map uses.
struct EffectUse {
    const Effect* effect;
    std::size_t count;  ///< > 0
};

/// In the order of all_effects(); what the map does not use is not in the list.
std::vector<EffectUse> effects_in(const MapFile& map);

/// What one effect costs. A look shows it where its picture is another one without it.
struct Price {
    std::size_t looks = 0;         ///< that show it
    std::optional<double> seen;    ///< of a frame that shows it; none where none does [ms]
    std::optional<double> unseen;  ///< of a frame that does not; none where all do [ms]
};

struct EffectPrice {
    EffectUse use;
    std::optional<Price> price;  ///< none where it cannot be taken out
};

struct Prices {
    int width = 0, height = 0;  ///< of the pictures [px]
    std::size_t looks = 0;      ///< how many were drawn
    double frame_ms = 0;        ///< of a frame with everything [ms]
    std::vector<EffectPrice> effects;
};

/// How prices are measured.
struct PriceChoices {
    int width = 640, height = 400;  ///< of the pictures [px]
    /// How often each look is drawn with the effect and without it, in each of two builds; even, >= 2, because the two
    /// take turns in being drawn first.
    std::size_t rounds = 10;
};

/// Draws eight looks around from the player's start and from some other places of the map, by the column renderer on
/// one thread, in turn with and without each effect, and takes each look's middle difference of processor time. Shows
/// on a terminal how far it is. file: sound, with a player; else there are no prices.
/// Cost: as it is chosen by default, some seconds for each effect that can be taken out.
Prices effect_prices(const MapFile& file, const TextureSet& textures, const PriceChoices& choices = {});

/// The prices as aligned lines for a terminal.
std::string to_text(const Prices& prices);

/// The prices as a table in Markdown, for a README.
std::string to_markdown(const Prices& prices);

}  // namespace enfilade
