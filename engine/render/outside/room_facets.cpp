#include "render/outside/outside_renderer.h"

#include <algorithm>

#include "math/vec.h"
#include "render/openings.h"
#include "render/sprite.h"

namespace enfilade {
namespace {

/// How bright a room is in full and in no light: nobody should have to look for dark rooms [1/256].
constexpr double kBrightest = 256, kDarkest = 96;

/// A thing's picture is taken as it looks from so far away, towards the camera [m].
constexpr double kLookedAtFrom = 8;

Shade shade_of(double light, double contrast) {
    return static_cast<Shade>(std::clamp((kDarkest + (kBrightest - kDarkest) * light) * contrast, 0.0, kBrightest));
}

/// Heights between which something is [m].
struct HeightRange {
    double bottom, top;
};

/// From floor to ceiling, in a space that is `rise` lower.
HeightRange range_of(const Heights& room, double rise) { return {room.floor_z - rise, room.ceiling_z - rise}; }

class RoomFacets {
public:
    RoomFacets(const OutsideScene& scene, const UnfoldedRoom& room, std::size_t number, std::vector<Facet>& facets)
        : scene_(scene),
          room_(room),
          sector_(scene.map[room.sector]),
          number_(number),
          own_(range_of(heights_at(scene.snapshot, room.sector), 0)),
          facets_(facets),
          light_(light_now(scene.snapshot, room.sector)) {}

    void add_flats() {
        const FlatNow floor = floor_now(scene_.map, scene_.snapshot, room_.sector);
        const FlatNow ceiling = ceiling_now(scene_.map, scene_.snapshot, room_.sector);
        for (const Triangle& triangle : scene_.pieces.triangles(room_.sector)) {
            add_flat(triangle, floor, own_.bottom);
            add_flat({triangle[2], triangle[1], triangle[0]}, ceiling, own_.top);
        }
    }

    void add_walls() {
        for (std::uint32_t i = 0; i < sector_.wall_count; ++i) add_wall(WallId(sector_.first_wall + i));
    }

    void add_panels() {
        for (std::uint32_t i = 0; i < sector_.panel_count; ++i) {
            const Panel& panel = scene_.map.panels[sector_.first_panel + i];
            if (!panel.surface.texture) continue;
            const HeightRange seen{std::max(panel.bottom, own_.bottom), std::min(panel.top, own_.top)};
            add_upright(panel.a, panel.b, panel.length, panel.surface, seen, panel.top,
                        look_of(panel.surface, panel.contrast), panel.one_sided ? FacetSides::front : FacetSides::both);
        }
    }

    void add_things() {
        for (const Presence& presence : scene_.snapshot.things.in(room_.sector))
            if (scene_.map[presence.thing].sector == room_.sector && presence.passage.is_identity())
                add_thing(presence);
    }

private:
    void add_flat(const Triangle& triangle, const FlatNow& flat, double z) {
        if (flat.sky) return;
        std::array<FacetCorner, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec2 vertex = scene_.map[triangle[i]].a, place = vertex - flat.origin;
            corners[i] = {room_.to_eye.apply(vertex),
                          room_.to_eye.apply_height(z),
                          {place.x / flat.surface.tile_m.x - flat.surface.offset_tiles.x,
                           place.y / flat.surface.tile_m.y - flat.surface.offset_tiles.y}};
        }
        if (room_.to_eye.flip < 0) std::swap(corners[0], corners[2]);
        add(Facet::triangle(scene_.camera, corners, look_of(flat.surface, 1), FacetSides::front));
    }

    void add_wall(WallId id) {
        const Wall& wall = scene_.map[id];
        const WallKind kind = kind_now(scene_.map, scene_.snapshot, id);
        if (kind == WallKind::solid) return add_part(id, wall.texture, own_, own_);
        if (kind == WallKind::mirror) return;
        const double rise = scene_.map.passage(wall).rise;
        const HeightRange behind = range_of(heights_at(scene_.snapshot, wall.behind), rise);
        const double top = std::clamp(behind.top, own_.bottom, own_.top);
        if (has_upper_step(scene_.map, wall)) add_part(id, wall.upper, {top, own_.top}, behind);
        if (has_lower_step(scene_.map, wall))
            add_part(id, wall.lower, {own_.bottom, std::clamp(behind.bottom, own_.bottom, top)}, behind);
        if (scene_.map[wall.middle].texture) add_middle(id, behind);
    }

    double peg_height(Peg peg, const HeightRange& behind) const {
        switch (peg) {
            case Peg::ceiling: return own_.top;
            case Peg::floor: return own_.bottom;
            case Peg::opening_top: return std::min(own_.top, behind.top);
            case Peg::opening_bottom: return std::max(own_.bottom, behind.bottom);
        }
        return own_.top;
    }

    void add_part(WallId id, SurfaceId at_rest, const HeightRange& part, const HeightRange& behind) {
        const Wall& wall = scene_.map[id];
        const Surface surface = picture_now(scene_.map, scene_.snapshot, id, at_rest);
        FacetLook look = look_of(surface, wall.contrast);
        look.wall = id;
        add_upright(wall.a, wall.b, wall.length, surface, part, peg_height(surface.peg, behind), look,
                    FacetSides::front);
    }

    /// The picture in a portal, shown once from top to bottom.
    void add_middle(WallId id, const HeightRange& behind) {
        const Wall& wall = scene_.map[id];
        const Surface& at_rest = scene_.map[wall.middle];
        const bool stands = at_rest.peg == Peg::floor || at_rest.peg == Peg::opening_bottom;
        const double hung = peg_height(at_rest.peg, behind) + (stands ? at_rest.tile_m.y : 0);
        const double top = hung - at_rest.offset_tiles.y * at_rest.tile_m.y;
        const Surface surface = picture_now(scene_.map, scene_.snapshot, id, wall.middle);
        FacetLook look = look_of(surface, wall.contrast);
        look.wall = id;
        const HeightRange opening{std::max(own_.bottom, behind.bottom), std::min(own_.top, behind.top)};
        add_upright(wall.a, wall.b, wall.length, surface,
                    {std::max(opening.bottom, top - surface.tile_m.y), std::min(opening.top, top)}, hung, look,
                    FacetSides::both);
    }

    /// hung: the height of the picture's top row.
    void add_upright(Vec2 a, Vec2 b, double length, const Surface& surface, const HeightRange& part, double hung,
                     const FacetLook& look, FacetSides sides) {
        const auto v = [&](double z) { return (hung - z) / surface.tile_m.y - surface.offset_tiles.y; };
        const double u = -surface.offset_tiles.x, u_end = length / surface.tile_m.x + u;
        const Rigid& to_eye = room_.to_eye;
        FacetCorner left{to_eye.apply(a), to_eye.apply_height(part.top), {u, v(part.top)}};
        FacetCorner right{to_eye.apply(b), to_eye.apply_height(part.bottom), {u_end, v(part.bottom)}};
        if (to_eye.flip < 0) std::swap(left.p, right.p), std::swap(left.uv.x, right.uv.x);
        add(Facet::upright(scene_.camera, left, right, look, sides));
    }

    void add_thing(const Presence& presence) {
        const Rigid& to_eye = room_.to_eye;
        const Vec2 place = to_eye.apply(presence.position);
        const Vec2 from = inverse(to_eye).apply(place - scene_.camera.forward() * kLookedAtFrom);
        const SpritePicture picture =
            picture_of(scene_.map, scene_.textures, scene_.snapshot, presence, snap_to_point_grid(from));
        if (!picture.texture) return;
        const Vec2 to_right = scene_.camera.right() * to_eye.flip;
        const Vec2 start = place - to_right * picture.origin_m.x;
        const double top = to_eye.apply_height(picture.foot_z) + picture.origin_m.y;
        Surface shown;
        shown.texture = picture.texture;
        shown.tile_m = picture.size_m;
        FacetLook look = look_of(shown, 1);
        look.shade = shade_of(picture.lighting.light, picture.lighting.contrast);
        add(Facet::upright(scene_.camera, {start, top, {0, 0}},
                           {start + to_right * picture.size_m.x, top - picture.size_m.y, {kLastPlace, kLastPlace}},
                           look, FacetSides::both));
    }

    FacetLook look_of(const Surface& surface, double contrast) const {
        FacetLook look;
        look.texture = &scene_.pieces.pyramid(surface.texture);
        look.shade = shade_of(light_, contrast);
        look.texels_per_m = scene_.textures[surface.texture].width / surface.tile_m.x;
        look.unseen_layer = room_.to_eye.is_identity() ? FacetLayer::around : FacetLayer::unfolded;
        look.room = number_;
        return look;
    }

    void add(const std::optional<Facet>& facet) {
        if (facet) facets_.push_back(*facet);
    }

    const OutsideScene& scene_;
    const UnfoldedRoom& room_;
    const Sector& sector_;
    std::size_t number_;
    HeightRange own_;
    std::vector<Facet>& facets_;
    double light_;
};

}  // namespace

MapPieces::MapPieces(const Map& map, const TextureSet& textures)
    : map_(map), textures_(textures), triangles_(map.sectors.size()), pyramids_(textures.textures.size() + 1) {}

const std::vector<Triangle>& MapPieces::triangles(SectorId sector) {
    std::vector<Triangle>& known = triangles_[sector.index];
    if (known.empty()) known = triangulate(map_, sector);
    return known;
}

const TexturePyramid& MapPieces::pyramid(TextureId id) {
    std::unique_ptr<TexturePyramid>& known = id ? pyramids_[id.index] : pyramids_.back();
    if (!known) known = std::make_unique<TexturePyramid>(textures_[id]);
    return *known;
}

void add_room_facets(const OutsideScene& scene, const SeenRooms& rooms, std::size_t room, std::vector<Facet>& facets) {
    RoomFacets all(scene, rooms.rooms()[room], room, facets);
    all.add_flats();
    all.add_walls();
    all.add_panels();
    all.add_things();
}

}  // namespace enfilade
