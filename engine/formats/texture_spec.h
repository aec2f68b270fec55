// The texture specification of a map, "NAME [SU,SV [OU,OV] [OUm,OVm]]", as text and as numbers.
#pragma once
#include <string>
#include <string_view>

#include "base/result.h"
#include "formats/map_file.h"

namespace enfilade {

/// Smallest and largest size of a tile that is read, whatever its sign [metres per tile]: between them texel
/// coordinates stay exact enough to count single texels anywhere in the world.
inline constexpr double kMinTile = 0x1p-16, kMaxTile = 0x1p16;

/// Largest offset that is read [texels, metres]: more than the largest picture has, or the world.
inline constexpr double kMaxTextureOffset = 0x1p20;

/// The numbers a specification stands for, without a place, or what is wrong with it. A half-given pair is an error;
/// negative tiles mirror the picture. "NAME - OU,OV" gives an offset alone: the tile is then 1, 1 or set by `size`. An
/// offset in metres has the letter at both numbers: "NAME 3,3 -1.5m,0m" goes on where 1.5 m of the picture were shown.
/// A name is a file's name, perhaps in a folder below, never "..".
Result<TextureSpec> parse_texture_spec(std::string_view text);

/// The shortest specification that reads back as the same numbers.
std::string to_text(const TextureSpec& spec);

}  // namespace enfilade
