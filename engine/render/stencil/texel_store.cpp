#include "render/stencil/texel_store.h"

#include <algorithm>
#include <string>

#include "base/hash.h"

namespace enfilade::stencil {
namespace {

/// Tells sets of pictures apart, cheap enough for every frame. Those that were not read from files are told apart by
/// some of their texels.
std::uint64_t fingerprint(const TextureSet& set) {
    constexpr std::size_t kSamples = 16;
    Hash hash;
    const auto add = [&](const Texture& texture) {
        hash.add(texture.fingerprint);
        hash.add(texture.width);
        hash.add(texture.height);
        hash.add(reinterpret_cast<std::uintptr_t>(texture.pixels.data()));
        hash.add(texture.numbers.empty());
        for (std::size_t i = 0; i < kSamples; ++i) hash.add(texture.pixels[(texture.pixels.size() - 1) * i / kSamples]);
    };
    for (const Texture& texture : set.textures) add(texture);
    add(set.placeholder);
    for (const std::uint32_t color : set.color_table.levels()) hash.add(color);
    return hash.value();
}

}  // namespace

Status TexelStore::hold(const TextureSet& textures) {
    const std::uint64_t wanted = fingerprint(textures);
    if (!places_.empty() && wanted == held_) return {};
    held_ = wanted;
    return upload(textures);
}

Status TexelStore::upload(const TextureSet& textures) {
    std::vector<std::uint32_t> texels;
    places_.clear();
    const auto add = [&](const Texture& texture) {
        places_.push_back(static_cast<std::uint32_t>(texels.size()));
        texels.insert(texels.end(), texture.pixels.begin(), texture.pixels.end());
    };
    for (const Texture& texture : textures.textures) add(texture);
    add(textures.placeholder);
    if (texels.size() > ListTexture::most()) {
        places_.clear();
        return Error{"stencil renderer", "expected at most " + std::to_string(ListTexture::most()) +
                                             " pixels in all pictures of a map; found " +
                                             std::to_string(texels.size()) + ", which this graphics card cannot hold"};
    }
    texture_.hold(texels, GL_RGBA8UI, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE);
    if (!textures.color_table.is_empty()) upload_color_table(textures);
    return {};
}

void TexelStore::upload_color_table(const TextureSet& textures) {
    std::vector<std::uint8_t> numbers;
    for (const Texture& texture : textures.textures) {
        numbers.insert(numbers.end(), texture.numbers.begin(), texture.numbers.end());
        if (texture.numbers.empty()) numbers.resize(numbers.size() + texture.pixels.size());
    }
    color_numbers_.hold(numbers, GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE);
    std::vector<std::uint32_t> levels = textures.color_table.levels();
    color_table_.hold(levels, GL_RGBA8UI, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE);
}

}  // namespace enfilade::stencil
