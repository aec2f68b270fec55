#include "render/stencil/surfaces.h"

#include <algorithm>
#include <bit>
#include <string>

#include "render/sprite.h"

namespace enfilade::stencil {

Result<void> TexelStore::hold(const TextureSet& textures) {
    std::vector<std::uint32_t> texels;
    const auto add = [&](const Texture& texture) {
        places_.push_back(static_cast<std::uint32_t>(texels.size()));
        texels.insert(texels.end(), texture.pixels.begin(), texture.pixels.end());
    };
    for (const Texture& texture : textures.textures) add(texture);
    add(textures.placeholder);
    if (texels.size() > ListTexture::most())
        return Error{"stencil renderer", "expected at most " + std::to_string(ListTexture::most()) +
                                             " pixels in all pictures of a map; found " +
                                             std::to_string(texels.size()) + ", which this graphics card cannot hold"};
    texture_.hold(texels, GL_RGBA8UI, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE);
    if (!textures.color_table.is_empty()) hold_color_table(textures);
    return {};
}

void TexelStore::hold_color_table(const TextureSet& textures) {
    std::vector<std::uint8_t> numbers;
    for (const Texture& texture : textures.textures) {
        numbers.insert(numbers.end(), texture.numbers.begin(), texture.numbers.end());
        if (texture.numbers.empty()) numbers.resize(numbers.size() + texture.pixels.size());
    }
    color_numbers_.hold(numbers, GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE);
    std::vector<std::uint32_t> levels = textures.color_table.levels();
    color_table_.hold(levels, GL_RGBA8UI, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE);
}

namespace {

Records::Pair pair_of(Vec2 v) {
    return {std::bit_cast<std::uint32_t>(static_cast<float>(v.x)),
            std::bit_cast<std::uint32_t>(static_cast<float>(v.y))};
}

Records::Pair picture_of(const LayerSource& from, const Surface& layer) {
    return {from.store.place_of(layer.texture), size_of(from.textures[layer.texture])};
}

}  // namespace

void Records::clear() {
    pairs_.resize(1);
    skies_.clear();
    grids_.clear();
}

std::uint32_t Records::add(std::span<const Pair> pairs) {
    const auto place = static_cast<std::uint32_t>(pairs_.size());
    pairs_.insert(pairs_.end(), pairs.begin(), pairs.end());
    return place;
}

std::uint32_t Records::sky(const LayerSource& from, const FlatNow& sky) {
    if (sky.layer_count == 0) return 0;
    skies_.resize(from.map.flat_layers.size());
    std::uint32_t& place = skies_[sky.first_layer];
    if (place != 0) return place;
    place = add(std::array<Pair, 1>{{{sky.layer_count, 0}}});
    for (std::uint32_t i = 0; i < sky.layer_count; ++i) {
        const Surface layer = layer_now(from.map, from.snapshot, sky, i);
        add(std::array{picture_of(from, layer), pair_of(layer.tile_m), pair_of(layer.offset_tiles)});
    }
    return place;
}

std::uint32_t Records::level(const LayerSource& from, const FlatNow& flat, Vec2 eye, std::uint32_t lamplight) {
    const std::uint32_t place = add(std::array<Pair, 1>{{{flat.layer_count, lamplight}}});
    for (std::uint32_t i = 0; i < flat.layer_count; ++i) {
        const Surface layer = layer_now(from.map, from.snapshot, flat, i);
        const Vec2 tile = layer.tile_m, own_tile = flat.surface.tile_m, from_origin = eye - flat.origin;
        const Vec2 start{fraction(from_origin.x / tile.x - layer.offset_tiles.x),
                         fraction(from_origin.y / tile.y - layer.offset_tiles.y)};
        const Pair way{from.textures[layer.texture].numbers.empty() ? 0u : 1u, 0};
        add(std::array{picture_of(from, layer), pair_of({own_tile.x / tile.x, own_tile.y / tile.y}), pair_of(start),
                       way});
    }
    return place;
}

std::uint32_t Records::lamplight(const LightGrid& grid, Vec2 scale, Vec2 start) {
    const auto [known, is_new] = grids_.try_emplace(&grid, static_cast<std::uint32_t>(pairs_.size()));
    if (is_new)
        for (const LightCell cell : grid.cells) pairs_.push_back({lane(cell, 0) | lane(cell, 1) << 16, lane(cell, 2)});
    const Pair place{known->second, static_cast<std::uint32_t>(grid.columns) | static_cast<std::uint32_t>(grid.rows)
                                                                                   << 16};
    return add(std::array{place, pair_of(scale), pair_of(start)});
}

Result<void> Records::upload() {
    if (pairs_.size() <= 1) return {};
    if (pairs_.size() > ListTexture::most())
        return Error{"stencil renderer", "there is more light in view than this graphics card has room for: " +
                                             std::to_string(pairs_.size()) + " pairs of numbers, of at most " +
                                             std::to_string(ListTexture::most())};
    texture_.hold(pairs_, GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT);
    return {};
}

}  // namespace enfilade::stencil
