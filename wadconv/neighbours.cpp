#include "wadconv/neighbours.h"

#include <algorithm>

namespace enfilade::wadconv {

Neighbours::Neighbours(const DoomMap& doom) : doom_(doom) {
    struct Beside {
        std::uint32_t sector;
        Neighbour neighbour;
    };
    std::vector<Beside> found;
    for (std::uint32_t i = 0; i < doom.lines.size(); ++i) {
        const Linedef& line = doom.lines[i];
        if (!(line.flags & kTwoSided) || line.right >= doom.sides.size() || line.left >= doom.sides.size()) continue;
        const std::uint32_t right = doom.sides[line.right].sector, left = doom.sides[line.left].sector;
        if (right >= doom.sectors.size() || left >= doom.sectors.size()) continue;
        found.push_back({right, {i, left, true}});
        found.push_back({left, {i, right, false}});
    }
    std::ranges::stable_sort(found, {}, &Beside::sector);
    first_.resize(doom.sectors.size() + 1);
    for (const Beside& beside : found) {
        ++first_[beside.sector + 1];
        all_.push_back(beside.neighbour);
    }
    for (std::size_t s = 0; s < doom.sectors.size(); ++s) first_[s + 1] += first_[s];
}

std::span<const Neighbour> Neighbours::of(std::uint32_t sector) const {
    return std::span(all_).subspan(first_[sector], first_[sector + 1] - first_[sector]);
}

std::int16_t Neighbours::darkest(std::uint32_t sector) const {
    std::int16_t darkest = doom_.sectors[sector].light;
    for (const Neighbour& n : of(sector)) darkest = std::min(darkest, doom_.sectors[n.sector].light);
    return darkest;
}

std::int16_t Neighbours::lowest_floor(std::uint32_t sector) const {
    std::int16_t lowest = doom_.sectors[sector].floor;
    for (const Neighbour& n : of(sector)) lowest = std::min(lowest, doom_.sectors[n.sector].floor);
    return lowest;
}

}  // namespace enfilade::wadconv
