#include "render/column/texel_dials.h"

#include <limits>

#include "base/result.h"

namespace enfilade::column {
namespace {

template <NumberKind kNumber>
void fill_flats(const PlainFlats& f) {
    fill_flats_at(f, [&](int i, int y) {
        const double depth = std::min(f.row_depths[y], f.farthest[i]);
        return TexelPosition{flat_position<kNumber>(f.base_u, depth, f.step_u[i], f.texture->width),
                             flat_position<kNumber>(f.base_v, depth, f.step_v[i], f.texture->height)};
    });
}

}  // namespace

double least_texels_per_m(const Map& map, const TextureSet& textures) {
    double least = std::numeric_limits<double>::infinity();
    for (const Surface& surface : map.surfaces) {
        const Texture& picture = textures[surface.texture];
        least = std::min({least, picture.width / surface.tile_m.x, picture.height / surface.tile_m.y});
    }
    return least;
}

bool is_promise_too_narrow(const TexelDials& dials, const RayTables& screen) {
    constexpr double kNear = 1;  // the floor under an eye 1.7 m high is nowhere nearer, unless one looks down [m]
    const double texels_apart = kNear / screen.column_scale * dials.least_texels_per_m;  // of neighbouring columns
    return is_only_promise(dials.dials) && texels_apart > 2 * dials.dials.texel_error;
}

double in_16_16(double number) {
    constexpr double kShift = 0x1.8p36;  // whose last bit is one step
    return number + kShift - kShift;
}

double flat_position(NumberKind number, double base, double depth, double step, std::uint32_t size) {
    switch (number) {
        case NumberKind::real64: return flat_position<NumberKind::real64>(base, depth, step, size);
        case NumberKind::real32: return flat_position<NumberKind::real32>(base, depth, step, size);
        case NumberKind::fixed16: return flat_position<NumberKind::fixed16>(base, depth, step, size);
        case NumberKind::vanilla: break;
    }
    return base;
}

void fill_flats_in(NumberKind number, const PlainFlats& flats) {
    ENFILADE_CHECK(number == NumberKind::real32 || number == NumberKind::fixed16);
    number == NumberKind::real32 ? fill_flats<NumberKind::real32>(flats) : fill_flats<NumberKind::fixed16>(flats);
}

}  // namespace enfilade::column
