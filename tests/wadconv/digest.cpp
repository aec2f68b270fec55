#include "wadconv/digest.h"

#include "map/load.h"
#include "render/choice/renderer.h"
#include "support/map_builder.h"
#include "wadconv/convert.h"
#include "wadconv/wad.h"

namespace enfilade::wadconv::test {
namespace {

using enfilade::test::textures_for;

void note(Outcome& outcome, const std::string& error) {
    if (outcome.error.empty()) outcome.error = error;
}

void draw_all(const Pictures& pictures, Outcome& outcome) {
    for (const PictureFile& file : pictures.files()) {
        const Result<Picture> picture = file.draw();
        if (!picture)
            note(outcome, picture.error().text());
        else
            outcome.pictures += !to_png(picture.value(), pictures.palette()).empty();
    }
}

/// Its pictures are placeholders.
void draw(const MapFile& file) {
    const TextureSet pictures = textures_for(file);
    Findings findings;
    const std::optional<Map> map = build_map(file, pictures, findings);
    if (!map || !map->player) return;
    const auto renderer = make_renderer({RendererKind::column, {}, 1, {}}, *map, pictures);
    Frame frame;
    frame.resize(16, 12);
    const View view = view_at_start(*map, lens_for(map->render)).value();
    ENFILADE_CHECK(renderer.value()->render(frame, nullptr, at_rest(*map), view).ok());
}

void convert(const WadPile& pile, const std::string& name, const Pictures& pictures, const TextureSet& sizes,
             Outcome& outcome) {
    const Result<MapLumps> lumps = find_map(pile, name);
    if (!lumps) return note(outcome, lumps.error().text());
    const Result<DoomMap> doom = decode_map(lumps.value());
    if (!doom) return note(outcome, doom.error().text());
    const Conversion conversion = convert_map(doom.value(), pictures, Sounds::list(pile), {.open_doors = true});
    if (!conversion.file) return note(outcome, conversion.report.refused);
    outcome.has_all_sides = outcome.has_all_sides && conversion.report.sides.is_complete();
    Findings findings;
    if (!build_map(*conversion.file, sizes, findings)) return note(outcome, "not sound");
    ++outcome.maps;
    draw(*conversion.file);
}

}  // namespace

Outcome digest(std::vector<Bytes> archives) {
    Outcome outcome;
    std::vector<Wad> wads;
    for (Bytes& bytes : archives) {
        Result<Wad> wad = Wad::read("x.wad", std::move(bytes));
        if (!wad) return {.error = wad.error().text()};
        wads.push_back(std::move(wad).value());
    }
    const WadPile pile(std::move(wads));
    const Result<Pictures> pictures = Pictures::list(pile, {"POSSA", "POSSB", "BAR1A", "BAR1B"});
    if (!pictures) return {.error = pictures.error().text()};
    draw_all(pictures.value(), outcome);
    const TextureSet sizes = pictures.value().sizes();
    for (const std::string& name : map_names(pile)) convert(pile, name, pictures.value(), sizes, outcome);
    return outcome;
}

}  // namespace enfilade::wadconv::test
