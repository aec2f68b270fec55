// All pictures of a map in one texture of the graphics card, one after another, so that a whole layer is one draw.
#pragma once
#include <cstdint>
#include <vector>

#include "base/result.h"
#include "map/textures.h"
#include "render/stencil/list_texture.h"

namespace enfilade::stencil {

/// Width and height of a picture, each less than 2^16, as one number.
inline std::uint32_t size_of(const Texture& picture) { return picture.width | picture.height << 16; }

/// Texel (x, y) of a picture is number place + x * height + y; whole numbers are read
/// back, so nearest sampling is the same arithmetic as in the other renderers.
class TexelStore {
public:
    /// Loads the pictures unless the same ones are there already. An error where they do not fit.
    Status hold(const TextureSet& textures);

    std::uint32_t place_of(TextureId id) const { return places_[id ? id.index : places_.size() - 1]; }
    GLuint texture() const { return texture_.id(); }

    /// Where the map has a color table: the number in it of each texel of the pictures that go by it, and what the
    /// colours are at each level, level by level.
    GLuint color_numbers() const { return color_numbers_.id(); }
    GLuint color_table() const { return color_table_.id(); }

private:
    Status upload(const TextureSet& textures);
    void upload_color_table(const TextureSet& textures);

    ListTexture texture_, color_numbers_, color_table_;
    std::vector<std::uint32_t> places_;  ///< by TextureId; the placeholder comes last
    std::uint64_t held_ = 0;             ///< what hold() loaded last
};

}  // namespace enfilade::stencil
