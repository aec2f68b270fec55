// The list of all textures: each file here adds its own kind to the album.
#pragma once

#include "picture.h"

namespace draw_textures {

class Album {
public:
    explicit Album(std::string folder) : folder_(std::move(folder)) {}

    void add(const std::string& name, int width, int height, const Painter& painter) const {
        save_png(paint(width, height, painter), folder_ + "/" + name + ".png", false);
    }
    void add_with_alpha(const std::string& name, int width, int height, const Painter& painter) const {
        save_png(paint(width, height, painter), folder_ + "/" + name + ".png", true);
    }

    // A texel is there or it is not: what is seen of a thing's outline does not mix with what is behind.
    void add_cutout(const std::string& name, int width, int height, const Painter& painter) const {
        Picture picture = paint(width, height, painter);
        for (Surface& texel : picture.texels) {
            texel.alpha = texel.alpha < 0.5 ? 0 : 1;
        }
        save_png(picture, folder_ + "/" + name + ".png", true);
    }

private:
    std::string folder_;
};

void draw_masonry(const Album&);  // walls of stone, brick and plaster
void draw_facades(const Album&);  // whole fronts of houses
void draw_floors(const Album&);   // marble, tiles, paving, carpet
void draw_wood(const Album&);     // parquet, boards, panelling, doors, books, beams
void draw_salon(const Album&);    // the walls and ceilings of a palace
void draw_trim(const Album&);     // columns, steps, ledges, metal, and what one can look through
void draw_nature(const Album&);   // rock, earth, water, leaves
void draw_sky(const Album&);
void draw_furniture(const Album&);  // what stands in the rooms
void draw_signs(const Album&);      // what is written over doors
void draw_far_lands(const Album&);  // sand, snow, red stone, night
void draw_works(const Album&);      // machines, gates, switches, moving water
void draw_tools(const Album&);      // what lies and stands among them

}  // namespace draw_textures
