#include "app/accuracy/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "render/choice/renderer.h"
#include "render/reference/reference_renderer.h"

namespace enfilade {
namespace {

/// The map with no light but that of lamps and suns, and nothing before it.
Map dark(Map map, int links) {
    for (Sector& sector : map.sectors) {
        sector.light = 0;
        sector.light_effect.reset();
    }
    for (Thing& thing : map.things)
        if (thing.light) thing.light = 0;
    map.render.light = LightModel::smooth;
    map.render.fog_reach = 0;
    map.render.max_depth = std::min(map.render.max_depth, links);
    return map;
}

/// The same pictures, all white, with the same holes.
TextureSet white(TextureSet textures) {
    constexpr std::uint32_t kWhite = 0x00FFFFFFu;
    const auto whiten = [](Texture& texture) {
        for (std::uint32_t& pixel : texture.pixels) pixel |= kWhite;
        texture.numbers.clear();
    };
    for (Texture& texture : textures.textures) whiten(texture);
    whiten(textures.placeholder);
    textures.color_table = {};
    return textures;
}

struct LitPicture {
    Frame frame;
    FrameFacts facts;

    LitPicture(int width, int height) {
        frame.resize(width, height);
        reset(facts, width, height);
    }
};

/// The larger of the differences of the three colours [1/255].
int apart(std::uint32_t a, std::uint32_t b) {
    int most = 0;
    for (const int shift : {0, 8, 16})
        most = std::max(most, std::abs(static_cast<int>(a >> shift & 0xFF) - static_cast<int>(b >> shift & 0xFF)));
    return most;
}

void add(const LitPicture& truth, const LitPicture& drawn, LightErrors& errors) {
    for (std::size_t i = 0; i < truth.frame.pixels.size(); ++i) {
        const PixelSurface id = truth.facts.ids[i];
        const bool is_sky = !std::isfinite(truth.facts.depths[i]);
        if (drawn.facts.ids[i] != id || is_sky || id == kRecursionEnd) continue;
        const std::uint32_t light = truth.frame.pixels[i];
        const int off = apart(light, drawn.frame.pixels[i]);
        ++errors.pixels;
        errors.lit += (light & 0x00FFFFFFu) != 0;
        errors.off += off > 1;
        errors.sum += off;
        errors.largest = std::max(errors.largest, off);
    }
}

}  // namespace

Result<LightErrors> measure_light(const OpenMap& map, const std::vector<View>& views, int width, int height,
                                  const Dials& dials) {
    const Map rooms = dark(map.map, dials.links);
    const TextureSet textures = white(map.textures);
    const Snapshot snapshot = at_rest(rooms);
    RendererChoice choice;
    choice.dials = dials;
    choice.dials.light = LightSteps::as_map;
    auto renderer = make_renderer(choice, rooms, textures);
    if (!renderer.ok()) return renderer.error();
    LightErrors errors;
    for (const View& view : views) {
        LitPicture truth(width, height), drawn(width, height);
        render_reference(truth.frame, &truth.facts, rooms, textures, snapshot, view,
                         {.samples = dials.samples, .own_light = true});
        if (const Result<void> done = renderer.value()->render(drawn.frame, &drawn.facts, snapshot, view); !done.ok())
            return done.error();
        add(truth, drawn, errors);
    }
    return errors;
}

Result<std::vector<LightErrorRow>> measure_light_grids(const std::string& scene, const OpenMap& map,
                                                       const std::vector<View>& views, int width, int height) {
    std::vector<LightErrorRow> rows;
    if (map.map.lights.empty()) return rows;
    for (const int points : {1, 2, 4, 8, 16, 64}) {
        Dials dials;
        dials.light_grid = points;
        const auto errors = measure_light(map, views, width, height, dials);
        if (!errors.ok()) return errors.error();
        rows.push_back({scene, points, errors.value()});
    }
    return rows;
}

std::string light_page(const std::vector<LightErrorRow>& rows) {
    std::string text(
        "\n## Light\n\nThe light of lamps is kept on grids (dial `light_grid`, points per metre; 4 is usual). It is "
        "held against the reference's own, which follows a straight way to each lamp for every pixel and shares no "
        "grid; colours and effects of lamps, and the light of suns, are shared.\n\n"
        "A promise never makes the grid coarser: at the edges of shadows light jumps, so the largest error does not "
        "shrink with the grid, and no bound could be kept. Finer grids make fewer pixels wrong.\n\n"
        "| map | points a metre | pixels lit | off by more than 1/255 [%] | mean [1/255] | largest [1/255] |\n"
        "|---|---|---|---|---|---|\n");
    for (const LightErrorRow& row : rows)
        text += fmt::format("| {} | {} | {} | {:.2f} | {:.3f} | {} |\n", row.scene, row.points_per_m, row.errors.lit,
                            100 * row.errors.share_off(), row.errors.mean(), row.errors.largest);
    return text;
}

}  // namespace enfilade
