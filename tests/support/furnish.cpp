#include "support/furnish.h"

#include <gtest/gtest.h>

#include "base/hash.h"
#include "math/vec.h"
#include "space/trace.h"

namespace enfilade::test {

PanelRecord panel(Vec2 a, Vec2 b, double bottom, double top) {
    PanelRecord record;
    record.a = a;
    record.b = b;
    record.bottom = bottom;
    record.top = top;
    record.texture = spec("lattice");
    record.texture.offset_tx = {3.3, 1.7};  // rims not on the lattice of the eyes
    return record;
}

void scatter_panels(MapFile& file, int tries, std::uint64_t seed) {
    const Map rooms = built(file);
    Random random(seed);
    for (int i = 0; i < tries; ++i) {
        const std::size_t home = random.below(file.sectors.size());
        const Sector& sector = rooms.sectors[home];
        const bool on_lattice = random.below(2) == 0;
        const auto place = [&] {
            const Vec2 p{random.uniform(sector.min.x, sector.max.x), random.uniform(sector.min.y, sector.max.y)};
            return on_lattice ? Vec2{double(int(p.x * 2)) / 2, double(int(p.y * 2)) / 2} : snap_to_vertex_grid(p);
        };
        const double bottom = random.uniform(sector.floor.z - 1, sector.ceiling.z);
        file.sectors[home].panels.push_back(panel(place(), place(), bottom, bottom + random.uniform(0.5, 3)));
        file.sectors[home].panels.back().one_sided = i % 3 == 0;
        if (has_errors(findings_of(file))) file.sectors[home].panels.pop_back();
    }
    EXPECT_GE(built(file).panels.size(), std::size_t(tries) / 4);
}

void scatter_things(MapFile& file, int count, std::uint64_t seed) {
    const Map rooms = built(file);
    Random random(seed);
    while (count > 0) {
        const SectorId home(random.below(rooms.sectors.size()));
        const Sector& sector = rooms[home];
        Vec2 p{random.uniform(sector.min.x, sector.max.x), random.uniform(sector.min.y, sector.max.y)};
        if (random.below(2) == 0) p = {double(int(p.x * 2)) / 2, double(int(p.y * 2)) / 2};
        if (!contains(rooms, home, snap_to_point_grid(p))) continue;
        ThingRecord thing;
        thing.position = p;
        thing.sector = sector.name;
        thing.frames = {{"lattice", 0, Vec2{31.3, 60}}};
        thing.size = 40;
        file.things.push_back(thing);
        --count;
    }
}

void scatter_lights(MapFile& file, int count, std::uint64_t seed) {
    const Map rooms = built(file);
    Random random(seed);
    while (count > 0) {
        const SectorId home(random.below(rooms.sectors.size()));
        const Sector& sector = rooms[home];
        PointLightRecord light;
        light.sector = sector.name;
        light.position = {random.uniform(sector.min.x, sector.max.x), random.uniform(sector.min.y, sector.max.y)};
        if (!contains(rooms, home, snap_to_point_grid(light.position))) continue;
        light.z = random.uniform(sector.floor.z, sector.ceiling.z);
        light.color = static_cast<std::uint32_t>(random.below(1 << 24));
        light.brightness = random.uniform(0.5, 2);
        light.reach = random.uniform(2, 7);
        if (random.below(2)) light.effect = LightEffectRecord{};
        file.lights.push_back(light);
        --count;
    }
}

void paint_by_table(TextureSet& textures) {
    Random random(5);
    Texture table;
    table.width = ColorTable::kMostColors;
    table.height = ColorTable::kLevels + 1;
    for (std::size_t i = 0; i < std::size_t{table.width} * table.height; ++i)
        table.pixels.push_back(0xFF000000u | static_cast<std::uint32_t>(random.below(1 << 24)));
    textures.color_table = ColorTable::read(table).value();
    for (std::size_t i = 0; i < textures.textures.size(); i += 2) {
        Texture& picture = textures.textures[i];
        for (std::uint32_t x = 0; x < picture.width; ++x)
            for (std::uint32_t y = 0; y < picture.height; ++y) {
                std::uint32_t& pixel = picture.pixels[std::size_t{x} * picture.height + y];
                const std::uint32_t number = (x / 16 * 7 + y / 16 + static_cast<std::uint32_t>(i) * 37) % table.width;
                pixel = (pixel & 0xFF000000u) | (table.at(number, 0) & 0x00FFFFFFu);
            }
        picture.numbers = textures.color_table.numbers_in(picture);
    }
}

void enliven(MapFile& file) {
    SunRecord sun;
    sun.name = "sun";
    sun.yaw_degrees = 70;
    sun.color = 0xFFB060;
    file.suns = {sun};
    for (std::size_t i = 0; i < file.sectors.size(); ++i) {
        SectorRecord& sector = file.sectors[i];
        const double phase = 0.37 * static_cast<double>(i % 3);
        sector.light = 0.4;
        sector.unlit = i % 3 == 0;
        if (i % 2 == 0) sector.sun = "sun";
        sector.floor.bob = BobRecord{0.2, 3, phase};
        sector.ceiling.bob = BobRecord{0.3, 4, phase, BobShape::triangle};
        for (PanelRecord& panel : sector.panels) panel.scroll = {0.7, -1.1};
    }
    for (ThingRecord& thing : file.things) {
        thing.turn = 50;
        thing.bob = BobRecord{0.25, 3};
    }
}

Texture lattice() {
    Texture texture;
    texture.name = "lattice";
    texture.width = texture.height = 64;
    texture.has_holes = true;
    for (std::uint32_t x = 0; x < 64; ++x)
        for (std::uint32_t y = 0; y < 64; ++y) {
            const std::uint32_t square = x / 8 + y / 8;
            texture.pixels.push_back(square % 2 ? 0xFF4080C0u : square % 3 ? 0 : 0x60FF2010u);
        }
    return texture;
}

}  // namespace enfilade::test
