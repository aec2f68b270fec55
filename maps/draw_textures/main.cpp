// draw_textures OUTDIR: draws every texture of the maps into OUTDIR. Running it again gives the same bytes.
#include <cstdio>
#include <exception>

#include "album.h"

int main(int count, char** arguments) {
    if (count != 2) {
        std::fprintf(stderr, "usage: draw_textures OUTDIR\n");
        return 2;
    }
    try {
        const draw_textures::Album album(arguments[1]);
        draw_textures::draw_masonry(album);
        draw_textures::draw_facades(album);
        draw_textures::draw_floors(album);
        draw_textures::draw_wood(album);
        draw_textures::draw_salon(album);
        draw_textures::draw_trim(album);
        draw_textures::draw_nature(album);
        draw_textures::draw_sky(album);
        draw_textures::draw_furniture(album);
        draw_textures::draw_signs(album);
        draw_textures::draw_far_lands(album);
        draw_textures::draw_works(album);
        draw_textures::draw_tools(album);
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "draw_textures: %s\n", problem.what());
        return 1;
    }
}
