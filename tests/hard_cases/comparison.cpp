#include "hard_cases/comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <sstream>
#include <vector>

#include "base/parallel.h"
#include "render/column/column_renderer.h"
#include "render/reference/reference_renderer.h"
#include "support/trials.h"

namespace enfilade::test {
namespace {

constexpr std::size_t kThreads = 2;

PixelSurface first_thing(const Map& map) { return thing_id(map, ThingId(std::size_t{0})); }

PixelSurface first_panel(const Map& map) { return panel_id(map, PanelId(std::size_t{0})); }

std::string hex(std::uint32_t color) {
    char text[16];
    std::snprintf(text, sizeof text, "%08x", color);
    return text;
}

double yaw_degrees(const View& view) { return std::atan2(view.forward.y, view.forward.x) * 180 / std::numbers::pi; }

const Texture& texture_of(const Subject& subject, PixelSurface id) {
    const Map& map = subject.map;
    const auto first_wall = static_cast<PixelSurface>(1 + 2 * map.sectors.size());
    if (id < first_wall) {
        const Sector& sector = map.sectors[(id - 1) / 2];
        return subject.textures[map[(id % 2 ? sector.floor : sector.ceiling).surface].texture];
    }
    if (id >= first_panel(map)) return subject.textures[map.panels[id - first_panel(map)].surface.texture];
    if (id >= first_thing(map)) {
        // All pictures of a thing at rest are of one size in any map that is drawn here.
        const SpriteId sprite = map.things[id - first_thing(map)].sprite;
        return subject.textures[map[sprite].frames.front().views.front()];
    }
    const Wall& wall = map.walls[(id - first_wall) / 3];
    const SurfaceId parts[] = {wall.kind == WallKind::portal ? wall.middle : wall.texture, wall.upper, wall.lower};
    return subject.textures[map[parts[(id - first_wall) % 3]].texture];
}

/// So near a texel's edge that rounding may choose either side.
bool is_on_edge(TexelPosition p, const Texture& texture) {
    constexpr double kNear = 1e-6;  // [texels]
    const auto is_near = [](double texels) { return std::fabs(texels - std::round(texels)) < kNear; };
    return is_near(p.u * texture.width) || is_near(p.v * texture.height);
}

/// So near the depth at which classic light steps from one level to the next that rounding may choose either.
bool is_on_light_step(const Map& map, double depth) {
    constexpr double kStepDepth = 40;  // levels won back at 1 m: render/shade.h
    constexpr double kNear = 1e-9;     // [levels]
    const double level = kStepDepth / depth;
    return map.render.light == LightModel::classic && std::fabs(level - std::round(level)) < kNear * level;
}

/// Whether two colours differ by no more than what shines through the texel. What lies behind may show either of two
/// texels, of which the facts of the pixel say nothing.
bool is_what_shines_through(TexelPosition p, const Texture& texture, std::uint32_t a, std::uint32_t b) {
    const auto texel = [](double tile, std::uint32_t size) {
        return std::min(static_cast<std::uint32_t>(tile * size), size - 1);
    };
    const int alpha = static_cast<int>(texture.at(texel(p.u, texture.width), texel(p.v, texture.height)) >> 24);
    for (const int shift : {0, 8, 16}) {
        const int difference = std::abs(static_cast<int>(a >> shift & 0xFF) - static_cast<int>(b >> shift & 0xFF));
        if (difference > 255 - alpha + 1) return false;  // each is rounded
    }
    return alpha < 255;
}

/// Two colours as far apart as a step of the place makes them, on a surface that lamps may light: between the points of
/// their grid the place counts in whole 256ths, of which rounding may choose either. From one point to the next light
/// goes at most from none to twice the full colour.
bool is_on_step_of_lamps(const Map& map, std::uint32_t a, std::uint32_t b) {
    constexpr int kMostLight = 512, kPlaces = 256;
    for (const int shift : {0, 8, 16})
        if (std::abs(static_cast<int>(a >> shift & 0xFF) - static_cast<int>(b >> shift & 0xFF)) > kMostLight / kPlaces)
            return false;
    return !map.lights.empty();
}

void note_pixel(const Subject& subject, const BothPictures& both, std::size_t i, Comparison& result) {
    const PixelSurface shown = both.column_facts.ids[i], truth = both.reference_facts.ids[i];
    const int writes = both.column_facts.writes[i];
    result.unwritten += writes == 0;
    result.written_twice += writes > 1;
    result.wrong += shown != truth;
    if (shown == truth && shown != kRecursionEnd && both.column.pixels[i] != both.reference.pixels[i]) {
        const TexelPosition texel = both.reference_facts.texels[i];
        const Texture& texture = texture_of(subject, truth);
        const bool on_edge = is_on_edge(texel, texture) ||
                             is_on_light_step(subject.map, both.reference_facts.depths[i]) ||
                             is_what_shines_through(texel, texture, both.column.pixels[i], both.reference.pixels[i]) ||
                             is_on_step_of_lamps(subject.map, both.column.pixels[i], both.reference.pixels[i]);
        ++(on_edge ? result.other_texel : result.wrong_color);
    }
}

std::string fault_text(const Subject& subject, const BothPictures& both, std::size_t i) {
    const std::size_t width = static_cast<std::size_t>(both.column.width);
    return "pixel (" + std::to_string(i % width) + ", " + std::to_string(i / width) + "), written " +
           std::to_string(both.column_facts.writes[i]) + " times, shows " +
           surface_text(subject.map, both.column_facts.ids[i]) + " instead of " +
           surface_text(subject.map, both.reference_facts.ids[i]) + ", color " + hex(both.column.pixels[i]) +
           " instead of " + hex(both.reference.pixels[i]);
}

Comparison compare_uncounted(const Subject& subject, const Snapshot& snapshot, const View& view, PictureSize size) {
    const BothPictures both = draw_by_both(subject, snapshot, view, size);
    Comparison result = differences(subject, both);
    if (result.is_faultless()) return result;
    std::size_t i = 0;
    for (Comparison pixel; pixel.is_faultless(); ++i) note_pixel(subject, both, i, pixel);
    result.first_fault =
        fault_text(subject, both, i - 1) + "\n  " + command_line(subject.name, subject.map, view, size);
    return result;
}

}  // namespace

std::string surface_text(const Map& map, PixelSurface id) {
    if (id == kNothing) return "nothing";
    if (id == kRecursionEnd) return "the end of a chain of links";
    const auto first_wall = static_cast<PixelSurface>(1 + 2 * map.sectors.size());
    if (id < first_wall) return (id % 2 ? "the floor of '" : "the ceiling of '") + map.sectors[(id - 1) / 2].name + "'";
    if (id >= first_panel(map)) return "panel " + std::to_string(id - first_panel(map));
    if (id >= first_thing(map)) return "thing " + std::to_string(id - first_thing(map));
    const PixelSurface wall = (id - first_wall) / 3;
    const char* const part[] = {"", "upper step of ", "lower step of "};
    char text[200];
    const Wall& w = map.walls[wall];
    std::snprintf(text, sizeof text, "wall %u (%.10g,%.10g -> %.10g,%.10g)", wall, w.a.x, w.a.y, w.b.x, w.b.y);
    return std::string(part[(id - first_wall) % 3]) + text + " of '" + map[w.sector].name + "'";
}

BothPictures draw_by_both(const Subject& subject, const Snapshot& snapshot, const View& view, PictureSize size) {
    BothPictures both;
    both.column.resize(size.width, size.height);
    both.reference.resize(size.width, size.height);
    reset(both.column_facts, size.width, size.height);
    LightGrids lights(subject.map);
    ColumnRenderer renderer(subject.map, subject.textures, {lights});
    renderer.render(both.column, &both.column_facts, snapshot, view);
    render_reference(both.reference, &both.reference_facts, subject.map, subject.textures, snapshot, view,
                     {.lights = &lights});
    return both;
}

Comparison differences(const Subject& subject, const BothPictures& both) {
    Comparison result;
    result.pixels = both.column.pixels.size();
    for (std::size_t i = 0; i < result.pixels; ++i) note_pixel(subject, both, i, result);
    return result;
}

Comparison difference_at(const Subject& subject, const BothPictures& both, std::size_t pixel) {
    Comparison result;
    result.pixels = 1;
    note_pixel(subject, both, pixel, result);
    return result;
}

Comparison& Comparison::operator+=(const Comparison& other) {
    pixels += other.pixels;
    unwritten += other.unwritten;
    written_twice += other.written_twice;
    wrong += other.wrong;
    other_texel += other.other_texel;
    wrong_color += other.wrong_color;
    if (first_fault.empty()) first_fault = other.first_fault;
    return *this;
}

std::string describe(const Comparison& c) {
    const auto per_million = [&](std::uint64_t n) {
        return 1e6 * static_cast<double>(n) / static_cast<double>(c.pixels);
    };
    std::ostringstream text;
    text << "of " << c.pixels << " pixels " << c.unwritten << " unwritten, " << c.written_twice << " written twice, "
         << c.wrong << " wrong, " << c.wrong_color << " of a wrong colour; " << per_million(c.other_texel)
         << " per million of a neighbouring texel";
    if (!c.first_fault.empty()) text << "\n  " << c.first_fault;
    return text.str();
}

std::string command_line(const std::string& map_name, const Map& map, const View& view, PictureSize size) {
    char text[600];
    std::snprintf(text, sizeof text,
                  "enfilade render %s --view %.17g,%.17g,%.17g,%.17g,%.17g --sector '%s' --size %dx%d --fov %.17g "
                  "--stretch %.17g --renderer reference --out fault.png",
                  map_name.c_str(), view.eye.x, view.eye.y, view.eye_z, yaw_degrees(view),
                  std::atan(view.pitch_tangent) * 180 / std::numbers::pi, map[view.sector].name.c_str(), size.width,
                  size.height, view.fov_degrees, view.stretch);
    return std::string(text) + (view.ray_offset == Vec2{} ? "" : "  # the map's rays = \"corner\"");
}

Comparison compare(const Subject& subject, const Snapshot& snapshot, const View& view, PictureSize size) {
    Comparison result = compare_uncounted(subject, snapshot, view, size);
    count_trials(result.pixels, "pixels");
    return result;
}

Comparison compare_at_start(const Subject& subject, PictureSize size) {
    const Snapshot snapshot = at_rest(subject.map);
    Comparison sum;
    for (const RayPoint point : {RayPoint::middle, RayPoint::corner}) {
        Lens lens = lens_for(subject.map.render);
        lens.ray_offset = ray_offset(point);
        sum += compare(subject, snapshot, view_at_start(subject.map, lens).value(), size);
    }
    return sum;
}

Comparison compare_poses(const Subject& subject, PoseKind kind, int count, PictureSize size, std::uint64_t seed) {
    const Snapshot snapshot = at_rest(subject.map);
    Random random(seed);
    std::vector<View> views;
    for (int i = 0; i < count; ++i)
        views.push_back(kind == PoseKind::random ? random_pose(subject.map, random)
                                                 : lattice_pose(subject.map, size, random));
    std::vector<Comparison> results(views.size());
    parallel_for(views.size(), kThreads, [&](std::size_t i, std::size_t) {
        results[i] = compare_uncounted(subject, snapshot, views[i], size);
    });
    Comparison sum;
    for (const Comparison& result : results) sum += result;
    count_trials(sum.pixels, "pixels");
    return sum;
}

}  // namespace enfilade::test
