#include "render/stencil/mesh.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "math/vec.h"

namespace enfilade::stencil {
namespace {

/// Where what has no end above or below ends: a sky over a wall [m].
constexpr double kEndOfSky = 1e6;

/// So far away that nothing hides it: how far a flat may reach [m].
constexpr float kFarAway = 1e30f;

/// The plane of the doorway that a layer is seen through: how far beyond it a point is [m], as parts of right and
/// ahead.
struct EntryPlane {
    double right, ahead, offset;

    explicit EntryPlane(const WallOnScreen& doorway) {
        const Vec2 along = doorway.right_v - doorway.left_v;
        const double length = std::sqrt(dot(along, along));
        right = -along.y / length;
        ahead = along.x / length;
        offset = -(right * doorway.left_v.x + ahead * doorway.left_v.y);
    }
};

float single(double x) { return static_cast<float>(x); }

}  // namespace

SpaceLens lens_of(const Layer& layer, const RayField& rays, PortalMethod method) {
    const double left = rays.right.at(0, 0), right = rays.right.at(rays.width, 0);
    const double top = rays.up.at(0, 0), bottom = rays.up.at(0, rays.height);
    const double half_width = (right - left) / 2, half_height = (top - bottom) / 2;
    SpaceLens lens;
    lens.picture = {single(1 / half_width), single(-(left + right) / 2 / half_width), single(-1 / half_height),
                    single((top + bottom) / 2 / half_height)};
    const double range = has_24_bits(method) ? 2 : 1;  // of depths
    lens.depth_row = {0, 0, single(1 - range), single(range * kNearPlane)};
    if (!layer.entry) return lens;
    const EntryPlane plane(layer.opened);
    if (!is_oblique(method)) {
        lens.clip = {single(plane.right), 0, single(plane.ahead), single(plane.offset)};
        return lens;
    }
    // The corner of the picture that is farthest beyond the plane gets the least depth.
    const double farthest = std::max(plane.right * left, plane.right * right) + plane.ahead;
    const double scale = range / std::max(farthest, 1e-30);
    lens.clips_at_near_plane = true;
    lens.depth_row = {single(-scale * plane.right), 0, single(1 - scale * plane.ahead), single(-scale * plane.offset)};
    return lens;
}

const std::vector<Triangle>& Ground::of(const Map& map, SectorId sector) {
    const auto [found, is_new] = triangles_.try_emplace(sector.index);
    if (is_new) found->second = triangulate(map, sector);
    return found->second;
}

namespace {

/// Of one layer.
class SpaceBuilder {
public:
    SpaceBuilder(Mesh& mesh, const DrawInput& scene, const Layer& layer, Ground& ground)
        : mesh_(mesh), scene_(scene), layer_(layer), ground_(ground) {}

    LayerRanges build() {
        LayerRanges out;
        const std::size_t begin = mesh_.index_count();
        for (const SectorId sector : layer_.sectors) add_sector(sector);
        for (const Exit& exit : layer_.exits)
            if (exit.layer == Exit::kCut) add_opening(exit.wall, true);
        out.surfaces = mesh_.sort_by_kind(begin);
        for (const Exit& exit : layer_.exits) out.exits.push_back(added([&] { add_opening(exit.wall, false); }));
        out.panes = mesh_.with_holes(added([&] {
            for (auto pane = layer_.panes.rbegin(); pane != layer_.panes.rend(); ++pane)
                std::visit([&](const auto& it) { add_pane(it); }, *pane);
        }));
        return out;
    }

private:
    const Map& map() const { return scene_.map(); }
    const Snapshot& snapshot() const { return scene_.input.snapshot; }

    template <class Add>
    IndexRange added(Add add) {
        const std::size_t begin = mesh_.index_count();
        add();
        return {begin, mesh_.index_count()};
    }

    void add_quad(const WallOnScreen& place, const RelativeHeights& heights, const PaintParams& params) {
        if (heights.is_empty()) return;
        const double floor = std::max(heights.floor, -kEndOfSky), ceiling = std::min(heights.ceiling, kEndOfSky);
        mesh_.add_polygon({SpacePoint{place.left_v, floor}, SpacePoint{place.right_v, floor},
                           SpacePoint{place.right_v, ceiling}, SpacePoint{place.left_v, ceiling}},
                          params);
    }

    SeenWall seen(const WallOnScreen& place) const {
        return {layer_.pose, place, parts_of(map(), snapshot(), place.wall, layer_.pose.eye_z)};
    }

    void add_sector(SectorId sector) {
        const Sector& room = map()[sector];
        for (std::uint32_t w = room.first_wall; w < room.first_wall + room.wall_count; ++w)
            if (auto place = on_screen(map(), WallId(w), layer_.pose, scene_.screen, nullptr)) add_wall(*place);
        const RelativeHeights heights = heights_of(snapshot(), sector, layer_.pose.eye_z);
        add_flat(sector, ceiling_now(map(), snapshot(), sector), heights.ceiling,
                 lamplight_on(&LightGrids::on_ceiling, sector), ceiling_id(sector));
        add_flat(sector, floor_now(map(), snapshot(), sector), heights.floor,
                 lamplight_on(&LightGrids::on_floor, sector), floor_id(sector));
    }

    using Ask = const LightGrid* (LightGrids::*)(const Snapshot&, SectorId);
    const LightGrid* lamplight_on(Ask flat, SectorId sector) const {
        return scene_.lights ? (scene_.lights->*flat)(snapshot(), sector) : nullptr;
    }

    /// A wall that every ray meets far away, since a flat ends at none.
    SeenWall no_wall_of(SectorId sector, WallOnScreen& place) const {
        place.wall = WallId(map()[sector].first_wall);
        place.end = scene_.screen.width;
        place.left_v = place.right_v = {0, static_cast<double>(kFarAway)};
        return {layer_.pose, place, {}};
    }

    void add_flat(SectorId sector, const FlatNow& flat, double height, const LightGrid* grid, PixelSurface id) {
        WallOnScreen far_away;
        const SeenWall wall = no_wall_of(sector, far_away);
        const PaintParams params = flat_params(scene_, wall, flat, height, grid, id);
        for (const Triangle& triangle : ground_.of(map(), sector)) {
            const auto corner = [&](int i) {
                return SpacePoint{to_view(map()[triangle[std::size_t(i)]].a, layer_.pose), height};
            };
            mesh_.add_polygon({corner(0), corner(1), corner(2)}, params);
        }
    }

    void add_wall(const WallOnScreen& place) {
        const Wall& wall = map()[place.wall];
        const SeenWall seen_wall = seen(place);
        const RelativeHeights room = seen_wall.parts.room, opening = seen_wall.parts.opening;
        add_sky(seen_wall, ceiling_now(map(), snapshot(), wall.sector), {room.ceiling, kEndOfSky}, room.ceiling,
                ceiling_id(wall.sector));
        add_sky(seen_wall, floor_now(map(), snapshot(), wall.sector), {-kEndOfSky, room.floor}, room.floor,
                floor_id(wall.sector));
        if (kind_now(map(), snapshot(), place.wall) == WallKind::solid)
            return add_quad(place, room, wall_params(scene_, seen_wall, wall.texture, WallPart::middle));
        if (seen_wall.parts.upper)
            add_quad(place, {opening.ceiling, room.ceiling},
                     wall_params(scene_, seen_wall, wall.upper, WallPart::upper));
        if (seen_wall.parts.lower)
            add_quad(place, {room.floor, opening.floor}, wall_params(scene_, seen_wall, wall.lower, WallPart::lower));
    }

    /// Over a wall under the sky one sees the sky, not what stands behind.
    void add_sky(const SeenWall& wall, const FlatNow& flat, const RelativeHeights& heights, double height,
                 PixelSurface id) {
        if (flat.sky) add_quad(wall.place, heights, flat_params(scene_, wall, flat, height, nullptr, id));
    }

    /// What one sees through a portal: as a mask, or filled where its chain ends.
    void add_opening(WallId portal, bool filled) {
        const auto place = on_screen(map(), portal, layer_.pose, scene_.screen, nullptr);
        if (!place) return;
        const SeenWall wall = seen(*place);
        add_quad(*place, wall.parts.opening, filled ? end_params(scene_, wall) : plain_params(scene_, *place));
    }

    void add_pane(const ThingOnScreen& thing) {
        if (is_first(thing.id)) add_quad(thing.place, thing.shown, thing_params(scene_, thing));
    }

    void add_pane(const PanelOnScreen& panel) {
        if (is_first(panel_id(map(), panel.panel)))
            add_quad(panel.place, panel.shown, panel_params(scene_, panel, layer_.pose));
    }

    void add_pane(const Hanging& hanging) {
        if (!is_first(wall_id(map(), hanging.place.wall, WallPart::middle))) return;
        const SeenWall wall = seen(hanging.place);
        const RelativeHeights picture = picture_in(wall.parts, map()[map()[hanging.place.wall].middle]);
        const RelativeHeights opening = wall.parts.opening;
        add_quad(hanging.place, {std::max(picture.floor, opening.floor), std::min(picture.ceiling, opening.ceiling)},
                 hanging_params(scene_, wall, picture.ceiling));
    }

    /// The planner has a pane once for each room and run of columns that show it.
    bool is_first(PixelSurface id) { return drawn_.insert(id).second; }

    Mesh& mesh_;
    const DrawInput& scene_;
    const Layer& layer_;
    Ground& ground_;
    std::set<PixelSurface> drawn_;  ///< panes
};

}  // namespace

std::vector<LayerRanges> build_mesh_in_space(Mesh& mesh, const DrawInput& scene, const Plan& plan, Ground& ground) {
    std::vector<LayerRanges> ranges;
    if (plan.deepest > kDeepestLevel) mesh.add_sheet_in_space(scene.rays);
    for (const Layer& layer : plan.layers) ranges.push_back(SpaceBuilder(mesh, scene, layer, ground).build());
    return ranges;
}

}  // namespace enfilade::stencil
