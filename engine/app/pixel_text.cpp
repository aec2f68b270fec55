#include "app/pixel_text.h"

#include <fmt/format.h>

#include <cmath>

#include "formats/text_parts.h"
#include "render/reference/reference_renderer.h"
#include "render/shade.h"
#include "render/sprite.h"

namespace enfilade {
namespace {

/// What the words are made from.
struct ShownSurface {
    const Map& map;
    const Snapshot& snapshot;
    const SurfaceOwner& owner;

    SectorId sector() const {
        switch (owner.kind) {
            case SurfaceKind::wall: return map.walls[owner.index].sector;
            case SurfaceKind::panel: return map.panels[owner.index].sector;
            case SurfaceKind::thing: return map.things[owner.index].sector;
            default: return SectorId(owner.index);
        }
    }
    const Flat& flat() const { return owner.kind == SurfaceKind::floor ? map[sector()].floor : map[sector()].ceiling; }
};

std::string wall_text(const Wall& wall, WallPart part, std::uint32_t number) {
    if (wall.kind != WallKind::portal && part == WallPart::middle) return fmt::format("wall {}", number);
    const char* const names[] = {"picture in", "upper part of", "lower part of"};
    return fmt::format("{} wall {}", names[std::size_t(part)], number);
}

std::string thing_text(const Thing& thing, std::uint32_t number) {
    const std::string& name = thing.name.empty() ? thing.kind : thing.name;
    return name.empty() ? fmt::format("thing {}", number) : fmt::format("thing {} ({})", number, in_quotes(name));
}

std::string surface_text(const ShownSurface& shown) {
    const Sector& sector = shown.map[shown.sector()];
    const std::uint32_t index = shown.owner.index;
    switch (shown.owner.kind) {
        case SurfaceKind::floor: return shown.flat().sky ? "sky in the floor" : "floor";
        case SurfaceKind::ceiling: return shown.flat().sky ? "sky" : "ceiling";
        case SurfaceKind::wall: return wall_text(shown.map.walls[index], shown.owner.part, index - sector.first_wall);
        case SurfaceKind::panel: return fmt::format("panel {}", index - sector.first_panel);
        case SurfaceKind::thing: return thing_text(shown.map.things[index], index);
    }
    return {};
}

SurfaceId surface_of(const Wall& wall, WallPart part) {
    if (wall.kind != WallKind::portal && part == WallPart::middle) return wall.texture;
    return part == WallPart::upper ? wall.upper : part == WallPart::lower ? wall.lower : wall.middle;
}

/// The picture that is seen there; none: a thing's, of which there may be many.
TextureId picture_of(const ShownSurface& shown) {
    const std::uint32_t index = shown.owner.index;
    switch (shown.owner.kind) {
        case SurfaceKind::floor: return floor_now(shown.map, shown.snapshot, shown.sector()).surface.texture;
        case SurfaceKind::ceiling: return ceiling_now(shown.map, shown.snapshot, shown.sector()).surface.texture;
        case SurfaceKind::panel: return shown.map.panels[index].surface.texture;
        case SurfaceKind::wall:
            return picture_now(shown.map, shown.snapshot, WallId(index),
                               surface_of(shown.map.walls[index], shown.owner.part))
                .texture;
        case SurfaceKind::thing: return {};
    }
    return {};
}

std::string texel_text(const ShownSurface& shown, const TextureSet& textures, TexelPosition at) {
    const TextureId id = picture_of(shown);
    if (!id) return fmt::format("at {:.3f}, {:.3f} of its picture", at.u, at.v);
    const Texture& texture = textures[id];
    return fmt::format("texel {}, {} of {}", texel_of(place_on_picture(double(at.u)), texture.width),
                       texel_of(place_on_picture(double(at.v)), texture.height), in_quotes(texture.name));
}

TextPlace place_of(const SurfaceOwner& owner, const MapPlaces& places) {
    const std::vector<TextPlace>* const lists[] = {&places.floors, &places.ceilings, &places.walls, &places.things,
                                                   &places.panels};
    const std::vector<TextPlace>& list = *lists[std::size_t(owner.kind)];
    return owner.index < list.size() ? list[owner.index] : TextPlace{};
}

/// "maps/hall.toml:17"
std::string place_text(const ShownSurface& shown, const std::string& path, const MapPlaces& places) {
    TextPlace place = place_of(shown.owner, places);
    if (place.line == 0 && shown.sector().index < places.sectors.size()) place = places.sectors[shown.sector().index];
    const SourceFile* const source = source_of(place, places.sources);
    return place.line == 0 ? path : fmt::format("{}:{}", source ? source->path : path, place.line);
}

}  // namespace

std::string pixel_text(const OpenMap& map, const Snapshot& snapshot, const PixelOf& pixel, const std::string& path,
                       const MapPlaces& places) {
    const PixelFacts facts =
        look_through_pixel(map.map, map.textures, snapshot, pixel.view, pixel.width, pixel.height, pixel.x, pixel.y);
    const auto owner = owner_of(map.map, facts.id);
    if (!owner) return fmt::format("the end of a chain of links, {} m ahead", number_text(facts.depth));
    const ShownSurface shown{map.map, snapshot, *owner};
    const std::string away = std::isinf(facts.depth) ? "" : fmt::format(", {:.2f} m ahead", facts.depth);
    return fmt::format("{} of sector {}{}, {}; {}", surface_text(shown), in_quotes(map.map[shown.sector()].name), away,
                       texel_text(shown, map.textures, facts.texel), place_text(shown, path, places));
}

std::string surfaces_csv(const Map& map, const Snapshot& snapshot, const std::string& path, const MapPlaces& places) {
    std::string csv = "id,surface,sector,place\n";
    for (PixelSurface id = kNothing + 1; const auto owner = owner_of(map, id); ++id) {
        const ShownSurface shown{map, snapshot, *owner};
        csv += fmt::format("{},{},{},{}\n", id, csv_field(surface_text(shown)), csv_field(map[shown.sector()].name),
                           csv_field(place_text(shown, path, places)));
    }
    return csv + fmt::format("{},the end of a chain of links,,\n", kRecursionEnd);
}

}  // namespace enfilade
