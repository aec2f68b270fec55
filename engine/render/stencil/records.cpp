#include "render/stencil/records.h"

#include <bit>
#include <string>

#include "render/picture_now.h"

namespace enfilade::stencil {
namespace {

Records::Pair pair_of(Vec2 v) {
    return {std::bit_cast<std::uint32_t>(static_cast<float>(v.x)),
            std::bit_cast<std::uint32_t>(static_cast<float>(v.y))};
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

std::uint32_t Records::sky(const Map& map, const Snapshot& snapshot, const TextureSet& textures,
                           const TexelStore& store, const FlatNow& sky) {
    if (sky.layer_count == 0) return 0;
    skies_.resize(map.sky_layers.size());
    std::uint32_t& place = skies_[sky.first_layer];
    if (place != 0) return place;
    place = add(std::array<Pair, 1>{{{sky.layer_count, 0}}});
    for (std::uint32_t i = 0; i < sky.layer_count; ++i) {
        const Surface layer = layer_now(map, snapshot, map.sky_layers[sky.first_layer + i]);
        const Pair picture{store.place_of(layer.texture), size_of(textures[layer.texture])};
        add(std::array{picture, pair_of(layer.tile_m), pair_of(layer.offset_tiles)});
    }
    return place;
}

std::uint32_t Records::glow(const LightGrid& grid, Vec2 scale, Vec2 start) {
    const auto [known, is_new] = grids_.try_emplace(&grid, static_cast<std::uint32_t>(pairs_.size()));
    if (is_new)
        for (const LightCell cell : grid.cells) pairs_.push_back({lane(cell, 0) | lane(cell, 1) << 16, lane(cell, 2)});
    const Pair place{known->second, static_cast<std::uint32_t>(grid.columns) | static_cast<std::uint32_t>(grid.rows)
                                                                                   << 16};
    return add(std::array{place, pair_of(scale), pair_of(start)});
}

Status Records::upload() {
    if (pairs_.size() <= 1) return {};
    if (pairs_.size() > ListTexture::most())
        return Error{"stencil renderer", "there is more light in view than this graphics card has room for: " +
                                             std::to_string(pairs_.size()) + " pairs of numbers, of at most " +
                                             std::to_string(ListTexture::most())};
    texture_.hold(pairs_, GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT);
    return {};
}

}  // namespace enfilade::stencil
