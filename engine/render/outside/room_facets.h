// What an outside camera sees of rooms: floors, ceilings, walls, panels and things, each from its front only, so that
// one looks through roofs and near walls as into a doll's house.
#pragma once
#include <memory>
#include <vector>

#include "render/outside/facet_painter.h"
#include "space/triangulate.h"

namespace enfilade {

/// What is worked out once for a map: floors as triangles, pictures made smaller.
class MapPieces {
public:
    /// map, textures: outlive it.
    MapPieces(const Map& map, const TextureSet& textures);

    /// Cost: that of triangulate(), the first time.
    const std::vector<Triangle>& triangles(SectorId sector);
    /// Cost: that of a TexturePyramid, the first time. id: none: the placeholder
    const TexturePyramid& pyramid(TextureId id);

private:
    const Map& map_;
    const TextureSet& textures_;
    std::vector<std::vector<Triangle>> triangles_;           ///< by sector; empty: not asked for yet
    std::vector<std::unique_ptr<TexturePyramid>> pyramids_;  ///< by texture, the placeholder last
};

/// What facets are made from.
struct OutsideScene {
    const Map& map;
    const TextureSet& textures;
    const Snapshot& snapshot;
    const View& view;
    const OutsideCamera& camera;
    MapPieces& pieces;
};

/// Adds all of a room. room: index into rooms.rooms(). Cost: its walls.
void add_room_facets(const OutsideScene& scene, const SeenRooms& rooms, std::size_t room, std::vector<Facet>& facets);

}  // namespace enfilade
