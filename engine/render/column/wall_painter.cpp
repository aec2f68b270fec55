#include "render/column/wall_painter.h"

#include <algorithm>

#include "render/column/kernels.h"

namespace enfilade::column {

void WallPainter::start(const Scene& scene, const Wall& wall, const Surface& surface, double peg, double light,
                        SurfaceId id) {
    texture_ = &scene.textures[surface.texture];
    id_ = id;
    model_ = scene.map.render.light;
    light_ = light;
    contrast_ = wall.contrast;
    u_per_along_ = wall.length / surface.tile_m.x;
    u_offset_ = surface.offset_tiles.x;
    v_per_m_ = 1 / surface.tile_m.y;
    v_at_peg_ = peg * v_per_m_ - surface.offset_tiles.y;
}

void WallPainter::paint(const Scene& scene, int x, int top, int bottom, const WallHit& hit) const {
    if (top >= bottom) return;
    const double u = hit.along * u_per_along_ - u_offset_;
    const double v_per_row = hit.depth / scene.screen.focal_y * v_per_m_;
    const double v_at_row_0 = v_at_peg_ - (scene.screen.horizon - 0.5) * v_per_row;
    const std::uint32_t column = texel_index(fraction(u), texture_->width);
    fill_wall(scene.canvas.run(x, top, bottom),
              {&texture_->pixels[std::size_t{column} * texture_->height], texture_->height, tile_steps(v_at_row_0),
               tile_steps(v_per_row), shade_at(model_, light_, contrast_, hit.depth)});
    if (scene.facts == nullptr) return;
    for (int y = top; y < bottom; ++y) note(scene, x, y, id_, hit.depth, u, v_at_row_0 + y * v_per_row);
}

double peg_height(Peg peg, const RelativeHeights& here, const RelativeHeights* behind) {
    switch (peg) {
        case Peg::ceiling: return here.ceiling;
        case Peg::floor: return here.floor;
        case Peg::opening_top: return behind ? std::min(here.ceiling, behind->ceiling) : here.ceiling;
        case Peg::opening_bottom: return behind ? std::max(here.floor, behind->floor) : here.floor;
    }
    return here.ceiling;
}

}  // namespace enfilade::column
