#include "render/column/texel_dials.h"

#include "base/result.h"

namespace enfilade::column {
namespace {

template <NumberKind kNumber>
void fill_flats(const PlainFlats& f) {
    const Texture& picture = *f.texture;
    for (int i = 0; i < f.runs.count; ++i)
        for (int y = f.runs.tops[i]; y < f.runs.bottoms[i]; ++y) {
            const double depth = std::min(f.row_depths[y], f.farthest[i]);
            const double at_u = flat_position<kNumber>(f.base_u, depth, f.step_u[i], picture.width);
            const double at_v = flat_position<kNumber>(f.base_v, depth, f.step_v[i], picture.height);
            const std::uint32_t u = texel_of(place_on_tile(at_u), picture.width);
            const std::uint32_t v = texel_of(place_on_tile(at_v), picture.height);
            f.runs.pixels[i * f.runs.pitch + y] =
                darkened(f.color_table, picture, std::size_t{u} * picture.height + v, f.row_darkness[y]);
        }
}

}  // namespace

double in_16_16(double number) {
    constexpr double kShift = 0x1.8p36;  // whose last bit is one step
    return number + kShift - kShift;
}

double flat_position(NumberKind number, double base, double depth, double step, std::uint32_t size) {
    switch (number) {
        case NumberKind::real64: return flat_position<NumberKind::real64>(base, depth, step, size);
        case NumberKind::real32: return flat_position<NumberKind::real32>(base, depth, step, size);
        case NumberKind::fixed16: return flat_position<NumberKind::fixed16>(base, depth, step, size);
    }
    return base;
}

void fill_flats_in(NumberKind number, const PlainFlats& flats) {
    ENFILADE_CHECK(number != NumberKind::real64);
    number == NumberKind::real32 ? fill_flats<NumberKind::real32>(flats) : fill_flats<NumberKind::fixed16>(flats);
}

}  // namespace enfilade::column
