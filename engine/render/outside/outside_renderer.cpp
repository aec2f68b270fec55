#include "render/outside/outside_renderer.h"

#include <algorithm>

#include "render/outside/marks.h"

namespace enfilade {
namespace {

constexpr std::uint32_t kBackground = 0xFF281C14;  ///< a dark blue

}  // namespace

void OutsideRenderer::render(Frame& frame, const Map& map, const TextureSet& textures, const Snapshot& snapshot,
                             const View& view, const OutsideLook& look, std::size_t workers) {
    const OutsideCamera camera = look.camera ? OutsideCamera(*look.camera, frame.width, frame.height)
                                             : OutsideCamera(look.from, view, look.reach_m, frame.width, frame.height);
    const View& middle = look.camera ? *look.camera : view;
    pieces_.start(map, textures);
    const OutsideScene scene{map, textures, snapshot, view, camera, pieces_};
    rooms_.look(map, snapshot, view, look.seen_width, look.seen_height);
    facets_.clear();
    add_eye_marks(scene, rooms_, facets_);
    add_portal_marks(scene, rooms_, facets_);
    rooms_.add_surroundings(map, middle.sector, middle.eye, look.reach_m);
    for (std::size_t room = 0; room < rooms_.rooms().size(); ++room) add_room_facets(scene, rooms_, room, facets_);
    std::ranges::fill(frame.pixels, kBackground);
    frame.is_cut_short = false;
    paint_facets(frame, facets_, rooms_, camera, workers);
}

}  // namespace enfilade
