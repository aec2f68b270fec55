// What a pixel shows, in words: the surface, how far away it is, the texel, and where the map's file has it.
#pragma once
#include <string>

#include "app/open_map.h"
#include "render/view.h"
#include "world/snapshot.h"

namespace enfilade {

/// A pixel of a picture.
struct PixelOf {
    const View& view;
    int width = 0, height = 0;  ///< of the picture [px]
    int x = 0, y = 0;           ///< in the picture
};

/// "upper part of wall 3 of sector 'hall', 4.21 m ahead, texel 12, 40 of 'brick'; maps/hall.toml:17". Walls, things and
/// panels are counted from 0, walls and panels in their sector, all in the order of the file. The ray is the
/// reference's, whatever drew the picture.
/// path: of the map's file. places: empty lists where they are not known; then only the file is named.
std::string pixel_text(const OpenMap& map, const Snapshot& snapshot, const PixelOf& pixel, const std::string& path,
                       const MapPlaces& places);

/// What the numbers of pictures of surface ids stand for: CSV with the header id,surface,sector,place and a row for
/// each surface that the map has, also where nothing is to be seen of it, in the words of pixel_text(). Ends in a line
/// end.
std::string surfaces_csv(const Map& map, const Snapshot& snapshot, const std::string& path, const MapPlaces& places);

}  // namespace enfilade
