// What the player is told while playing: news, health, keys.
#pragma once
#include <string>

#include "app/draw/overlay.h"
#include "map/map.h"
#include "world/world.h"

namespace enfilade {

/// The news as a sentence; empty where it is shown otherwise.
std::string news_text(const Map& map, const News& news);

/// In the lower left corner: health, once it is less than full, and the keys one has. Nothing in a map without either.
void draw_status(Overlay& overlay, const Map& map, const World& world);

/// Above the middle: where one flies.
void draw_flight(Overlay& overlay, const std::string& text);

/// Across the middle: that one is dead, or how far back one has gone [ticks].
void draw_death(Overlay& overlay);
void draw_rewind(Overlay& overlay, std::size_t ticks_back);

}  // namespace enfilade
