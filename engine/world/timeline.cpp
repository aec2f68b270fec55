#include "world/timeline.h"

#include <utility>

#include "world/step.h"

namespace enfilade {

Timeline::Timeline(World start) : world_(std::move(start)) { keep(); }

void Timeline::keep() {
    History history = std::exchange(world_.history, {});
    kept_.push_back({world_, history.length()});
    world_.history = std::move(history);
}

void Timeline::play(const Map& map, const TickInput& input) {
    step(map, world_, input);
    inputs_.push_back(input);
    if (inputs_.size() % kBetweenKept == 0) keep();
}

World Timeline::after(const Map& map, std::size_t ticks) const {
    const Kept& kept = kept_[ticks / kBetweenKept];
    World world = kept.world;
    world.history = world_.history.beginning(kept.length);
    for (std::size_t tick = ticks - ticks % kBetweenKept; tick < ticks; ++tick) step(map, world, inputs_[tick]);
    return world;
}

void Timeline::go_back(const Map& map, std::size_t ticks) {
    world_ = after(map, ticks);
    inputs_.resize(ticks);
    kept_.resize(ticks / kBetweenKept + 1);
}

}  // namespace enfilade
