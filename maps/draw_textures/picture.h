// A texture on its way to a PNG: paint a surface texel by texel, light its relief, save it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "noise.h"

namespace draw_textures {

struct Color {
    double r, g, b;  // 0..1
};

// 0xRRGGBB, as every paint program writes it.
constexpr Color rgb(int hex) { return {(hex >> 16 & 255) / 255.0, (hex >> 8 & 255) / 255.0, (hex & 255) / 255.0}; }

constexpr Color operator*(Color c, double k) { return {c.r * k, c.g * k, c.b * k}; }
constexpr Color operator+(Color a, Color b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
constexpr Color mix(Color a, Color b, double t) { return a * (1 - t) + b * t; }

// What a surface is at one place. Height is in texels, so a slope of 1 is 45 degrees at any size of texture.
struct Surface {
    Color color{0, 0, 0};
    double height = 0;
    double alpha = 1;
};

struct Picture {
    int width, height;
    std::vector<Surface> texels;
};

// A painter is asked for the surface at (x, y) in texels and at the same place (u, v) in tiles, 0..1.
using Painter = std::function<Surface(double x, double y, double u, double v)>;

// Paints with 3 x 3 samples a texel, then lights the relief from the upper left and darkens its hollows.
Picture paint(int width, int height, const Painter& painter);

void save_png(const Picture& picture, const std::string& path, bool with_alpha);

}  // namespace draw_textures
