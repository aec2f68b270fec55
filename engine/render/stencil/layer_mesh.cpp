#include "render/stencil/layer_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include "render/picture_now.h"

namespace enfilade::stencil {
namespace {

constexpr double kEverything = std::numeric_limits<double>::infinity();

/// Ends of walls this near to the entry's ends are the same place [px]: behind a link the eye is rounded onto its
/// grid, and a wall that ends at the doorway might stop a rounding short of it.
constexpr double kSamePlace = 4 * kTieShift;

class LayerBuilder {
public:
    LayerBuilder(Mesh& mesh, const Scene& scene, const Layer& layer, LayerRanges& out)
        : mesh_(mesh), scene_(scene), layer_(layer), out_(out) {}

    void build() {
        const std::size_t begin = mesh_.index_count();
        for (const SeenSector& seen : layer_.sectors) add_sector(seen);
        for (const Exit& exit : layer_.exits)
            if (exit.layer == Exit::kCut) add_opening(exit, true);
        out_.surfaces = {begin, mesh_.index_count()};
        for (const Exit& exit : layer_.exits) out_.exits.push_back(added([&] { add_opening(exit, false); }));
        for (auto pane = layer_.panes.rbegin(); pane != layer_.panes.rend(); ++pane) add(*pane);
    }

private:
    template <class Add>
    Range added(Add add) {
        const std::size_t begin = mesh_.index_count();
        add();
        return {begin, mesh_.index_count()};
    }

    void add_sector(const SeenSector& seen) {
        const Sector& sector = scene_.map[seen.sector];
        for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i) {
            auto place = on_screen(scene_.map, WallId(i), layer_.eye, scene_.screen);
            if (!place || !fit_to_layer(*place)) continue;
            if (place->end_px < seen.begin - kMargin || place->begin_px > seen.end + kMargin) continue;
            add_wall(*place);
        }
    }

    /// Cuts off what lies before the entry; the entry's own ends are authoritative, so walls that end there are drawn
    /// a little beyond, where the mask hides them. False where nothing is left.
    bool fit_to_layer(WallOnScreen& place) const {
        if (!layer_.entry) return true;
        if (place.wall == layer_.entry) return false;
        if (!cut_at_entry(scene_.map, scene_.map[layer_.entry], layer_.eye, scene_.screen, place)) return false;
        if (std::fabs(place.begin_px - layer_.entry_begin_px) < kSamePlace) place.begin_px -= kMargin;
        if (std::fabs(place.end_px - layer_.entry_end_px) < kSamePlace) place.end_px += kMargin;
        return true;
    }

    void add_strip(const WallOnScreen& place, double floor, double ceiling, const Look& look) {
        mesh_.add_strip(scene_.screen, place, floor, ceiling, look);
    }

    void add_wall(const WallOnScreen& place) {
        const Wall& wall = scene_.map[place.wall];
        const SeenWall seen{layer_.eye, place, parts_of(scene_.map, scene_.snapshot, wall, layer_.eye.z)};
        const Heights room = seen.parts.room;
        add_strip(place, room.ceiling, kEverything,
                  flat_look(scene_, seen, ceiling_now(scene_.map, scene_.snapshot, wall.sector), room.ceiling,
                            ceiling_id(wall.sector)));
        add_strip(place, -kEverything, room.floor,
                  flat_look(scene_, seen, floor_now(scene_.map, scene_.snapshot, wall.sector), room.floor,
                            floor_id(wall.sector)));
        if (wall.kind == WallKind::solid)
            return add_strip(place, room.floor, room.ceiling, wall_look(scene_, seen, wall.texture, WallPart::middle));
        add_steps(seen, wall);
    }

    void add_steps(const SeenWall& seen, const Wall& wall) {
        const Heights room = seen.parts.room, opening = seen.parts.opening;
        if (seen.parts.upper)
            add_strip(seen.place, opening.ceiling, room.ceiling, wall_look(scene_, seen, wall.upper, WallPart::upper));
        if (seen.parts.lower)
            add_strip(seen.place, room.floor, opening.floor, wall_look(scene_, seen, wall.lower, WallPart::lower));
    }

    /// What one sees through a portal: as a mask, or filled where its chain ends.
    void add_opening(const Exit& exit, bool filled) {
        WallOnScreen place = exit.wall;
        if (!fit_to_layer(place)) return;
        const SeenWall seen{layer_.eye, place,
                            parts_of(scene_.map, scene_.snapshot, scene_.map[place.wall], layer_.eye.z)};
        add_strip(place, seen.parts.opening.floor, seen.parts.opening.ceiling,
                  filled ? end_look(scene_, seen) : plain_look(scene_, place));
    }

    void add_pane(const WallOnScreen& place) {
        const Wall& wall = scene_.map[place.wall];
        const SeenWall seen{layer_.eye, place, parts_of(scene_.map, scene_.snapshot, wall, layer_.eye.z)};
        const Surface& surface = wall.middle;
        const bool stands = surface.peg == Peg::floor || surface.peg == Peg::opening_bottom;
        const double hung = peg_height(seen.parts, surface.peg) + (stands ? surface.tile_m.y : 0);
        const double top = hung - surface.offset_tiles.y * surface.tile_m.y, bottom = top - surface.tile_m.y;
        const Heights opening = seen.parts.opening;
        const Look look = pane_look(scene_, seen, top);
        add_strip(place, std::max(bottom, opening.floor), std::min(top, opening.ceiling), look);
    }

    void add(const Pane& pane) {
        const Range range = added([&] {
            if (const auto* thing = std::get_if<ThingOnScreen>(&pane))
                add_strip(thing->place, thing->floor, thing->ceiling, thing_look(scene_, *thing));
            else if (WallOnScreen place = std::get<WallOnScreen>(pane); fit_to_layer(place))
                add_pane(place);
        });
        if (!range.is_empty()) out_.panes.push_back(range);
    }

    Mesh& mesh_;
    const Scene& scene_;
    const Layer& layer_;
    LayerRanges& out_;
};

}  // namespace

std::vector<LayerRanges> build_mesh(Mesh& mesh, const Scene& scene, const Plan& plan) {
    std::vector<LayerRanges> ranges(plan.layers.size());
    for (std::size_t i = 0; i < plan.layers.size(); ++i) LayerBuilder(mesh, scene, plan.layers[i], ranges[i]).build();
    return ranges;
}

}  // namespace enfilade::stencil
