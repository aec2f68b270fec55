// A picture by the reference renderer, and what it shows where.
#pragma once
#include "render/reference/reference_renderer.h"
#include "support/map_builder.h"

namespace enfilade::test {

struct Picture {
    Frame frame;
    FrameFacts facts;

    std::size_t at(int x, int y) const { return static_cast<std::size_t>(y * frame.width + x); }
    PixelSurface id(int x, int y) const { return facts.ids[at(x, y)]; }
    double depth(int x, int y) const { return facts.depths[at(x, y)]; }
    TexelPosition texel(int x, int y) const { return facts.texels[at(x, y)]; }
};

/// The rooms a test is about, built, with pictures.
struct Rooms {
    Map map;
    TextureSet textures;

    explicit Rooms(const MapFile& file) : map(built(file)), textures(textures_for(file)) {}

    Picture look(const View& view, int width = 64, int height = 48, const ReferenceOptions& options = {}) const {
        return look_at(0, view, width, height, options);
    }

    /// The same at another time than the start [s].
    Picture look_at(double time_s, const View& view, int width = 64, int height = 48,
                    const ReferenceOptions& options = {}) const {
        Picture picture;
        picture.frame.resize(width, height);
        Snapshot snapshot = at_rest(map);
        snapshot.time_s = time_s;
        render_reference(picture.frame, &picture.facts, map, textures, snapshot, view, options);
        return picture;
    }
};

}  // namespace enfilade::test
