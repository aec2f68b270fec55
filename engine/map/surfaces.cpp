// How pictures lie on walls and flats: texture specs become tiles and offsets, and each direction its contrast.
#include <cmath>
#include <unordered_map>

#include "base/hash.h"
#include "formats/text_parts.h"
#include "map/draft.h"

namespace enfilade {

namespace {

/// The part of x after the point, in [0, 1); 0 where there is none.
double fraction_of(double x) {
    const double f = x - std::floor(x);
    return f >= 0 && f < 1 ? f : 0;
}

/// Keeps each different surface once. Looked up only, never gone through: the order is that of the map.
class SurfaceList {
public:
    explicit SurfaceList(std::vector<Surface>& surfaces) : surfaces_(surfaces) {}

    SurfaceId add(const Surface& surface) {
        const auto [known, is_new] = ids_.try_emplace(surface, surfaces_.size());
        if (is_new) surfaces_.push_back(surface);
        return known->second;
    }

private:
    struct HashOf {
        std::size_t operator()(const Surface& surface) const {
            Hash hash;
            hash.add(surface.texture.index);
            for (const Vec2 part : {surface.tile_m, surface.offset_tiles, surface.scroll}) {
                hash.add(part.x);
                hash.add(part.y);
            }
            hash.add(static_cast<std::uint32_t>(surface.peg));
            return hash.value();
        }
    };

    std::vector<Surface>& surfaces_;
    std::unordered_map<Surface, SurfaceId, HashOf> ids_;
};

/// What all surfaces of one wall or flat have in common.
struct SurfaceMaker {
    const TextureSet& textures;
    Vec2 scroll;
    std::optional<double> size;        ///< texels per metre, instead of metres per tile
    std::optional<double> usual_size;  ///< the map's, where neither is given

    Vec2 tile(const TextureSpec& spec, const Texture& texture) const {
        if (spec.tile_m) return *spec.tile_m;
        const std::optional<double> texels_per_metre = size ? size : usual_size;
        return texels_per_metre ? Vec2{texture.width / *texels_per_metre, texture.height / *texels_per_metre}
                                : Vec2{1, 1};
    }

    Surface surface(const std::optional<TextureSpec>& spec, Peg peg) const {
        Surface s = single(spec, peg);
        s.offset_tiles = {fraction_of(s.offset_tiles.x), fraction_of(s.offset_tiles.y)};
        return s;
    }

    /// For a picture that is shown once from top to bottom: how far it is moved is more than where a tile begins.
    Surface single(const std::optional<TextureSpec>& spec, Peg peg) const {
        Surface s;
        s.peg = peg;
        s.scroll = scroll;
        if (!spec) return s;
        s.texture = spec->name == "-" ? TextureId() : textures.find(spec->name);
        const Texture& texture = textures[s.texture];
        s.tile_m = tile(*spec, texture);
        s.offset_tiles = {spec->offset_tx.x / texture.width + spec->moved_m().x / s.tile_m.x,
                          spec->offset_tx.y / texture.height + spec->moved_m().y / s.tile_m.y};
        return s;
    }
};

/// Smooth light: from 0.8 on walls along x to 1 on walls along y, by the square of the normal's x. Classic light:
/// Doom's "fake contrast" (id Software, r_segs.c, 1993): only walls exactly along an axis differ.
double contrast_of(LightModel model, Vec2 edge) {
    if (model == LightModel::classic) return edge.y == 0 ? kLeastContrast : edge.x == 0 ? kMostContrast : 1;
    return kLeastContrast + (1 - kLeastContrast) * (edge.y * edge.y / dot(edge, edge));
}

bool is_tutorial(const Draft& draft) { return draft.file.format == 0; }

/// The tutorial has no light by direction; nor has what has no direction.
double contrast_in(const Draft& draft, Vec2 edge) {
    return is_tutorial(draft) || edge == Vec2{} ? 1 : contrast_of(draft.file.render.light, edge);
}

void lay_wall(Draft& draft, SurfaceList& surfaces, WallId id) {
    Wall& wall = draft.map.walls[id.index];
    const WallRecord& record = *draft.walls[id.index].record;
    const SurfaceMaker maker{draft.textures, record.scroll, record.size, draft.file.size};
    wall.contrast = contrast_in(draft, wall.b - wall.a);
    if (wall.kind != WallKind::portal) wall.texture = surfaces.add(maker.surface(record.texture, record.texture_peg));
    if (wall.kind != WallKind::portal && wall.kind != WallKind::way_back) return;
    wall.upper = surfaces.add(maker.surface(record.upper ? record.upper : record.texture, record.upper_peg));
    wall.lower = surfaces.add(maker.surface(record.lower ? record.lower : record.texture, record.lower_peg));
    if (wall.kind == WallKind::portal) wall.middle = surfaces.add(maker.single(record.middle, record.middle_peg));
}

/// sector's i-th panel.
void lay_panel(Draft& draft, const SectorDraft& sector, std::size_t i, Panel& panel) {
    const PanelRecord& record = sector.record->panels[i];
    const SurfaceMaker maker{draft.textures, record.scroll, record.size, draft.file.size};
    panel.contrast = contrast_in(draft, panel.b - panel.a);
    panel.surface = maker.surface(record.texture, Peg::ceiling);
    panel.one_sided = record.one_sided;
}

/// How fast a layer moves: over a sky as that does, [degrees/s].
Vec2 layer_scroll(Draft& draft, const FlatLayerRecord& layer, bool is_over_sky) {
    if (!is_over_sky && layer.turn != 0)
        draft.warning(key_place(layer, "turn"), "turn-without-sky",
                      "only over a sky does a layer turn, and this floor or ceiling is none; give the layer a scroll "
                      "in metres per second, or the floor or ceiling parallax = true");
    if (is_over_sky && layer.scroll != Vec2{})
        draft.warning(key_place(layer, "scroll"), "scroll-over-sky",
                      "a layer over a sky does not scroll; give it a turn in degrees per second");
    return is_over_sky ? Vec2{layer.turn, 0} : layer.scroll;
}

void lay_layers(Draft& draft, const FlatRecord& record, Flat& flat) {
    flat.first_layer = static_cast<std::uint32_t>(draft.map.flat_layers.size());
    flat.layer_count = static_cast<std::uint32_t>(record.layers.size());
    for (const FlatLayerRecord& layer : record.layers)
        draft.map.flat_layers.push_back(SurfaceMaker{
            draft.textures, layer_scroll(draft, layer, flat.sky), {}, flat.sky ? std::nullopt : draft.file.size}
                                            .surface(layer.texture, Peg::ceiling));
}

/// In the tutorial (chapter 7, Camera.js and Flat.js) a sky's picture begins a quarter turn before x, and the first
/// number is how many turns one tile takes.
void lay_tutorial_sky(Surface& sky) {
    sky.tile_m.x = 1 / sky.tile_m.x;
    sky.offset_tiles.x = fraction_of(sky.offset_tiles.x - sky.tile_m.x / 4);
}

void lay_flat(Draft& draft, SurfaceList& surfaces, const SectorDraft& sector, const FlatRecord& record, Flat& flat) {
    // A sky's two numbers are wraps and a tangent, which texels per metre say nothing about.
    const SurfaceMaker maker = record.parallax
                                   ? SurfaceMaker{draft.textures, record.scroll, {}, {}}
                                   : SurfaceMaker{draft.textures, record.scroll, record.size, draft.file.size};
    Surface surface = maker.surface(record.texture, Peg::ceiling);
    flat.sky = record.parallax;
    if (flat.sky && record.texture && record.texture->offset_m)
        draft.error(record.texture->place, "metres-on-sky",
                    "a sky is not so many metres wide; give the offset in texels, without 'm'");
    if (flat.sky && is_tutorial(draft)) lay_tutorial_sky(surface);
    flat.surface = surfaces.add(surface);
    flat.carries = record.carries;
    lay_layers(draft, record, flat);
    if (record.is_relative && sector.loop_count > 0)
        flat.origin = draft.map.walls[draft.loops[sector.first_loop].first_wall].a;
}

void lay_bobs(Draft& draft, const SectorRecord& record, Sector& sector) {
    if (record.floor.bob) sector.floor_bob = *record.floor.bob;
    if (record.ceiling.bob) sector.ceiling_bob = *record.ceiling.bob;
    draft.map.has_bobs |= sector.floor_bob || sector.ceiling_bob;
}

}  // namespace

void lay_surfaces(Draft& draft) {
    SurfaceList surfaces(draft.map.surfaces);
    for (std::size_t i = 0; i < draft.map.walls.size(); ++i) lay_wall(draft, surfaces, WallId(i));
    for (std::size_t i = 0; i < draft.map.sectors.size(); ++i) {
        const SectorDraft& sector = draft.sectors[i];
        const Sector& laid = draft.map.sectors[i];
        for (std::size_t p = 0; p < laid.panel_count; ++p)
            lay_panel(draft, sector, p, draft.map.panels[laid.first_panel + p]);
        lay_flat(draft, surfaces, sector, sector.record->floor, draft.map.sectors[i].floor);
        lay_flat(draft, surfaces, sector, sector.record->ceiling, draft.map.sectors[i].ceiling);
        lay_bobs(draft, *sector.record, draft.map.sectors[i]);
    }
}

// Which pictures follow which, and which are the two faces of a switch.

namespace {

void note_animation(Draft& draft, const AnimationRecord& record) {
    PictureChanges& pictures = draft.map.pictures;
    Animation animation{{}, record.seconds};
    for (const std::string& frame : record.frames)
        if (const TextureId id = draft.textures.find(frame)) animation.frames.push_back(id);
    if (animation.frames.empty()) return;
    const auto number = static_cast<std::uint32_t>(pictures.animations.size());
    for (const TextureId id : animation.frames) {
        std::uint32_t& owner = pictures.animation_of[id.index];
        if (owner != PictureChanges::kNone && owner != number)
            draft.error(record, "frames", "animated-twice",
                        "the picture " + in_quotes(draft.textures[id].name) +
                            " belongs to another animation already; a picture can only be in one");
        owner = number;
    }
    pictures.animations.push_back(std::move(animation));
}

void note_switch(Draft& draft, const SwitchRecord& record) {
    const TextureId off = draft.textures.find(record.off), on = draft.textures.find(record.on);
    if (!off || !on) return;
    draft.map.pictures.other_face[off.index] = on;
    draft.map.pictures.other_face[on.index] = off;
}

}  // namespace

void note_picture_changes(Draft& draft) {
    PictureChanges& pictures = draft.map.pictures;
    const std::size_t count = draft.textures.textures.size();
    if (!draft.file.animations.empty()) pictures.animation_of.assign(count, PictureChanges::kNone);
    if (!draft.file.switches.empty()) pictures.other_face.assign(count, TextureId());
    for (const AnimationRecord& record : draft.file.animations) note_animation(draft, record);
    for (const SwitchRecord& record : draft.file.switches) note_switch(draft, record);
}

}  // namespace enfilade
