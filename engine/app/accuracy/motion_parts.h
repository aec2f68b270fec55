// What both experiments of motion need: maps made by a rule, and times of several ways in turn.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "app/accuracy/motion.h"
#include "map/map.h"

namespace enfilade {

/// A room without pictures, clockwise on the drawing; each side leads to the room named, if any.
SectorRecord plain_room(std::string name, std::vector<Vec2> outline, const std::vector<std::string>& behind);

/// The map of these rooms, which are sound.
Map plain_map(std::vector<SectorRecord> rooms);

/// Lets each way do all of its `count` steps, one way after the other, round after round. Times are of a step.
std::vector<MotionPrice> prices_in_turn(const std::vector<std::function<void()>>& ways, std::uint64_t count,
                                        std::size_t rounds);

}  // namespace enfilade
