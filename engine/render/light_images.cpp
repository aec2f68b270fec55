#include "render/light_images.h"

#include <algorithm>

#include "math/grid.h"
#include "space/reach.h"

namespace enfilade {
namespace {

struct Reached {
    SectorId sector;
    LightImage image;
};

bool is_known(const std::vector<Reached>& all, std::size_t first, const Reached& reached) {
    return std::any_of(all.begin() + static_cast<std::ptrdiff_t>(first), all.end(), [&](const Reached& other) {
        return other.sector == reached.sector && is_same_place(other.image.from, reached.image.from) &&
               other.image.z == reached.image.z;
    });
}

void add_light(const Map& map, std::uint32_t number, std::vector<Reached>& all) {
    const PointLight& light = map.lights[number];
    const std::size_t first = all.size();
    for (const ReachedSector& there : reach(map, {light.sector, light.position}, light.reach).sectors) {
        const LightImage image{number, there.passage, snap_to_point_grid(there.passage.apply(light.position)),
                               there.passage.apply_height(light.z)};
        if (!is_known(all, first, {there.sector, image})) all.push_back({there.sector, image});
    }
}

}  // namespace

LightImages::LightImages(const Map& map) {
    std::vector<Reached> all;
    for (std::size_t i = 0; i < map.lights.size(); ++i) add_light(map, static_cast<std::uint32_t>(i), all);
    std::stable_sort(all.begin(), all.end(), [](const Reached& a, const Reached& b) { return a.sector < b.sector; });
    first_.assign(map.sectors.size() + 1, 0);
    for (const Reached& reached : all) {
        images_.push_back(reached.image);
        ++first_[reached.sector.index + 1];
    }
    for (std::size_t i = 0; i < map.sectors.size(); ++i) first_[i + 1] += first_[i];
}

}  // namespace enfilade
