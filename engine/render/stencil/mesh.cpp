#include "render/stencil/mesh.h"

#include <algorithm>
#include <limits>

#include "render/sprite.h"
#include "render/stencil/plan.h"

namespace enfilade::stencil {

void Mesh::clear() {
    vertices_.clear();
    indices_.clear();
    has_ = {};
    sheet_ = {};
}

void Mesh::add_sheet() {
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    sheet_ = {indices_.size(), indices_.size() + 6};
    for (const auto& [x, y] : {PixelPoint{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        vertices_.push_back({static_cast<float>(x), static_cast<float>(y), {}});
    indices_.insert(indices_.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
}

void Mesh::add_sheet_in_space(const RayField& rays) {
    const double right = rays.right.at(rays.width, 0), top = rays.up.at(0, 0), bottom = rays.up.at(0, rays.height);
    const std::size_t begin = indices_.size();
    add_polygon({SpacePoint{{-right, 1}, bottom}, SpacePoint{{right, 1}, bottom}, SpacePoint{{right, 1}, top},
                 SpacePoint{{-right, 1}, top}},
                {});
    sheet_ = {begin, indices_.size()};
}

void Mesh::add_polygon(std::initializer_list<SpacePoint> corners, const PaintParams& params) {
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    for (const SpacePoint& corner : corners) {
        MeshVertex& vertex =
            vertices_.emplace_back(static_cast<float>(corner.v.x), static_cast<float>(corner.up), params);
        vertex.params.order = static_cast<float>(corner.v.y);
    }
    for (std::uint32_t i = 2; i < corners.size(); ++i)
        indices_.insert(indices_.end(), {first, first + i - 1, first + i});
}

namespace {

constexpr double kEverything = std::numeric_limits<double>::infinity();

/// Seen at an angle of more than a quarter.
bool is_wide(const WallOnScreen& wall) { return dot(wall.left_v, wall.right_v) < 0; }

}  // namespace

void Mesh::add_strip(const RayField& rays, const WallOnScreen& wall, const RelativeHeights& heights,
                     const PaintParams& params) {
    if (heights.is_empty()) return;
    if (rays.is_tilted && is_wide(wall)) {
        if (heights.ceiling > 0) add_half(rays, wall, {std::max(heights.floor, 0.0), heights.ceiling}, params, 1);
        if (heights.floor < 0) add_half(rays, wall, {heights.floor, std::min(heights.ceiling, 0.0)}, params, -1);
        return;
    }
    set_between_ends(outline_, rays, wall);
    keep_between(outline_, rays, wall, heights);
    add_outline(rays, params);
}

/// Only what rays see that lead up (up: 1), which come above the eye alone, or down (-1). The lines of all heights run
/// on beyond the point where a wall vanishes. If that is at its very ends, as almost all of what is seen from next to a
/// wall, the graphics card's grid might take a pixel between them for one beyond.
void Mesh::add_half(const RayField& rays, const WallOnScreen& wall, const RelativeHeights& heights,
                    const PaintParams& params, double up) {
    set_between_ends(outline_, rays, wall);
    outline_.keep(climb(rays) * up);
    keep_between(
        outline_, rays, wall,
        {heights.floor == 0 ? -kEverything : heights.floor, heights.ceiling == 0 ? kEverything : heights.ceiling});
    add_outline(rays, params);
}

void Mesh::add_outline(const RayField& rays, const PaintParams& params) {
    if (outline_.is_empty()) return;
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    for (const PixelPoint& corner : outline_.corners())
        vertices_.push_back({static_cast<float>(corner.x * 2 / rays.width - 1),
                             static_cast<float>(corner.y * 2 / rays.height - 1), params});
    for (std::uint32_t i = 2; i < outline_.corners().size(); ++i)
        indices_.insert(indices_.end(), {first, first + i - 1, first + i});
}

std::vector<KindRange> Mesh::sort_by_kind(std::size_t begin) {
    for (std::size_t i = begin; i < indices_.size(); i += 3) {
        const auto triangle = indices_.begin() + static_cast<std::ptrdiff_t>(i);
        auto& sorted = sorted_[kind_of(vertices_[indices_[i]].params)];
        sorted.insert(sorted.end(), triangle, triangle + 3);
    }
    indices_.resize(begin);
    std::vector<KindRange> ranges;
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
        if (sorted_[kind].empty()) continue;
        const std::size_t first = indices_.size();
        indices_.insert(indices_.end(), sorted_[kind].begin(), sorted_[kind].end());
        ranges.push_back({static_cast<Kind>(kind), {first, indices_.size()}});
        sorted_[kind].clear();
        has_[kind] = true;
    }
    return ranges;
}

KindRange Mesh::with_holes(const IndexRange& range) {
    Kind kind = kWithHoles;
    for (std::size_t i = range.begin; i < range.end; i += 3) kind |= kind_of(vertices_[indices_[i]].params);
    if (!range.is_empty()) has_[kind] = true;
    return {kind, range};
}

namespace {

class LayerBuilder {
public:
    LayerBuilder(Mesh& mesh, const DrawInput& scene, const Layer& layer, LayerRanges& out)
        : mesh_(mesh), scene_(scene), layer_(layer), out_(out) {}

    void build() {
        const std::size_t begin = mesh_.index_count();
        if (scene_.rays.is_tilted) tilted_ = tilted_order(layer_, scene_.input);
        for (const WallOnScreen& place : walls()) add_wall(place);
        for (const Exit& exit : layer_.exits)
            if (exit.layer == Exit::kCut) add_opening(exit.wall, true);
        out_.surfaces = mesh_.sort_by_kind(begin);
        for (const Exit& exit : layer_.exits) out_.exits.push_back(added([&] { add_opening(exit.wall, false); }));
        out_.panes = mesh_.with_holes(added([&] {
            for (auto pane = panes().rbegin(); pane != panes().rend(); ++pane)
                std::visit([&](const auto& it) { add_pane(it); }, *pane);
        }));
    }

private:
    const std::vector<WallOnScreen>& walls() const { return scene_.rays.is_tilted ? tilted_.walls : layer_.walls; }
    const std::vector<Pane>& panes() const { return scene_.rays.is_tilted ? tilted_.panes : layer_.panes; }

    template <class Add>
    IndexRange added(Add add) {
        const std::size_t begin = mesh_.index_count();
        add();
        return {begin, mesh_.index_count()};
    }

    void add_strip(const WallOnScreen& place, const RelativeHeights& heights, const PaintParams& params) {
        mesh_.add_strip(scene_.rays, place, heights, params);
    }

    SeenWall seen(const WallOnScreen& place) const {
        return {layer_.pose, place, parts_of(scene_.map(), scene_.input.snapshot, place.wall, layer_.pose.eye_z)};
    }

    using Ask = const LightGrid* (LightGrids::*)(const Snapshot&, SectorId);
    const LightGrid* lamplight_on(Ask flat, SectorId sector) const {
        return scene_.lights ? (scene_.lights->*flat)(scene_.input.snapshot, sector) : nullptr;
    }

    void add_wall(const WallOnScreen& place) {
        const Wall& wall = scene_.map()[place.wall];
        const SeenWall seen_wall = seen(place);
        const RelativeHeights room = seen_wall.parts.room;
        add_strip(
            place, {room.ceiling, kEverything},
            flat_params(scene_, seen_wall, ceiling_now(scene_.map(), scene_.input.snapshot, wall.sector), room.ceiling,
                        lamplight_on(&LightGrids::on_ceiling, wall.sector), ceiling_id(wall.sector)));
        add_strip(place, {-kEverything, room.floor},
                  flat_params(scene_, seen_wall, floor_now(scene_.map(), scene_.input.snapshot, wall.sector),
                              room.floor, lamplight_on(&LightGrids::on_floor, wall.sector), floor_id(wall.sector)));
        if (kind_now(scene_.map(), scene_.input.snapshot, place.wall) == WallKind::solid)
            return add_strip(place, room, wall_params(scene_, seen_wall, wall.texture, WallPart::middle));
        add_steps(seen_wall, wall);
    }

    void add_steps(const SeenWall& wall, const Wall& portal) {
        const RelativeHeights room = wall.parts.room, opening = wall.parts.opening;
        if (wall.parts.upper)
            add_strip(wall.place, {opening.ceiling, room.ceiling},
                      wall_params(scene_, wall, portal.upper, WallPart::upper));
        if (wall.parts.lower)
            add_strip(wall.place, {room.floor, opening.floor},
                      wall_params(scene_, wall, portal.lower, WallPart::lower));
    }

    /// What one sees through a portal: as a mask, or filled where its chain ends.
    void add_opening(WallId portal, bool filled) {
        for (const WallOnScreen& place : walls()) {
            if (place.wall != portal) continue;
            const SeenWall wall = seen(place);
            add_strip(place, wall.parts.opening, filled ? end_params(scene_, wall) : plain_params(scene_, place));
        }
    }

    void add_pane(const ThingOnScreen& thing) { add_strip(thing.place, thing.shown, thing_params(scene_, thing)); }

    void add_pane(const PanelOnScreen& panel) {
        add_strip(panel.place, panel.shown, panel_params(scene_, panel, layer_.pose));
    }

    void add_pane(const Hanging& hanging) {
        const SeenWall wall = seen(hanging.place);
        const RelativeHeights picture = picture_in(wall.parts, scene_.map()[scene_.map()[hanging.place.wall].middle]);
        const RelativeHeights opening = wall.parts.opening;
        add_strip(hanging.place, {std::max(picture.floor, opening.floor), std::min(picture.ceiling, opening.ceiling)},
                  hanging_params(scene_, wall, picture.ceiling));
    }

    Mesh& mesh_;
    const DrawInput& scene_;
    const Layer& layer_;
    LayerRanges& out_;
    TiltedLayer tilted_;  ///< where the picture is
};

}  // namespace

std::vector<LayerRanges> build_mesh(Mesh& mesh, const DrawInput& scene, const Plan& plan) {
    std::vector<LayerRanges> ranges(plan.layers.size());
    if (plan.deepest > kDeepestLevel) mesh.add_sheet();
    for (std::size_t i = 0; i < plan.layers.size(); ++i) LayerBuilder(mesh, scene, plan.layers[i], ranges[i]).build();
    return ranges;
}

}  // namespace enfilade::stencil
