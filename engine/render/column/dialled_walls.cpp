// Walls and steps drawn by the dials of texels.
#include <cmath>

#include "render/column/painters.h"

namespace enfilade::column {

/// Of those that are looked at they are worked out once; of others, which a group or a span reaches out to, when asked.
struct WallPainter::ExactColumns {
    const ColumnScene& scene;
    const WallPainter& painter;
    const WallLooks& looks;
    ColumnTexels known[WallLooks::kMost];
    Shade shades[WallLooks::kMost];
    std::optional<VanillaWall> vanilla;  ///< where dials want its positions, and the eye is not on its line

    ExactColumns(const ColumnScene& of, const WallPainter& by, const WallLooks& at)
        : scene(of), painter(by), looks(at) {
        for (int i = 0; i < looks.count; ++i) known[i] = painter.texels_at(scene, looks.at(i));
        painter.dimming_.at_all(looks.depth, looks.count, shades);
        if (scene.dials->dials.number == NumberKind::vanilla && looks.wall->cross != 0)
            vanilla.emplace(VanillaScreen{scene.screen.width, scene.screen.column_scale},
                            looks.wall->left_v * texels_per_m(), looks.wall->right_v * texels_per_m());
    }

    double length() const {
        const Vec2 along = looks.wall->right_v - looks.wall->left_v;
        return std::sqrt(dot(along, along));
    }
    double texels_per_m() const { return painter.u_per_along_ * painter.texture_->width / length(); }

    ColumnGroup all() const { return {looks.wall->begin, looks.wall->end - 1}; }
    bool is_known(int x) const { return looks.begin <= x && x < looks.begin + looks.count; }
    WallHit hit_at(int x) const { return hit(*looks.wall, scene.screen.slopes[static_cast<std::size_t>(x)]); }
    ColumnTexels texels(int x) const {
        return is_known(x) ? known[x - looks.begin] : painter.texels_at(scene, hit_at(x));
    }
    double depth(int x) const { return is_known(x) ? looks.depth[x - looks.begin] : hit_at(x).depth; }
    Shade shade(int x) const { return is_known(x) ? shades[x - looks.begin] : painter.dimming_.at(hit_at(x).depth); }
};

struct WallPainter::DialledColumns {
    Placed placed;
    ColumnTexels at[WallLooks::kMost];
    int like[WallLooks::kMost];
    TilePlace u[WallLooks::kMost];              ///< where texels are blended
    std::uint32_t mip_parts[WallLooks::kMost];  ///< of the way to the next smaller picture
    const Texture* smaller = nullptr;           ///< null: there is none to mix with
    int count = 0;
};

/// False where exact texels are all that the dials leave.
bool WallPainter::may_any_be_alike(const ColumnScene& scene, const WallLooks& looks) const {
    const Dials& dials = scene.dials->dials;
    if (!is_only_promise(dials)) return true;
    if (light_grid_) return false;
    const double most = most_apart(dials, texture_->width) / (u_per_along_ * texture_->width);
    const auto along_at = [&](int x) {
        return hit(*looks.wall, scene.screen.slopes[static_cast<std::size_t>(x)]).along;
    };
    const int begin = looks.begin, end = begin + looks.count;
    bool is_near = false;
    for (int i = 1; i < looks.count; ++i) is_near |= std::fabs(looks.along[i] - looks.along[i - 1]) <= most;
    // Those at the ends may be like one that is drawn elsewhere.
    if (begin > looks.wall->begin) is_near |= std::fabs(looks.along[0] - along_at(begin - 1)) <= most;
    if (end < looks.wall->end) is_near |= std::fabs(looks.along[looks.count - 1] - along_at(end)) <= most;
    return is_near;
}

void WallPainter::paint_by_dials(const ColumnScene& scene, const WallLooks& looks, const int* tops,
                                 const int* bottoms) const {
    const ExactColumns exact(scene, *this, looks);
    for (int first = 0; first < looks.count;) {
        DialledColumns dialled;
        AlikeColumns alike = alike_at(scene, exact, looks.begin + first);
        const int level = alike.mip.level;
        dialled.placed.texture = level == 0 ? texture_ : &scene.dials->mips->at(*texture_, level);
        int end = first;
        while (end < looks.count && alike.mip.level == level) {
            const int leader = end - first, last = std::min(alike.columns.last - looks.begin, looks.count - 1);
            for (; end <= last; ++end) {
                place_one(alike.at, looks.depth[end], dialled.placed, end - first);
                dialled.at[end - first] = alike.at;
                dialled.like[end - first] = leader;
                dialled.u[end - first] = place_on_tile(alike.at.u);
                dialled.mip_parts[end - first] = alike.mip.part;
            }
            if (end < looks.count) alike = alike_at(scene, exact, looks.begin + end);
        }
        dialled.count = end - first;
        dialled.smaller = scene.dials->mips ? &scene.dials->mips->at(*texture_, level + 1) : nullptr;
        const ColumnRuns runs{scene.canvas.column(looks.begin + first), scene.canvas.pitch(), dialled.count,
                              tops + first, bottoms + first};
        fill_by_dials(scene, runs, dialled, looks, first);
        first = end;
    }
}

/// first: of the columns that are looked at.
void WallPainter::fill_by_dials(const ColumnScene& scene, const ColumnRuns& runs, DialledColumns& dialled,
                                const WallLooks& looks, int first) const {
    const WallBlend blend{dialled.u, dialled.smaller, dialled.mip_parts};
    const bool is_blended = is_blend(scene.dials->dials.sampling) && !texture_->has_holes;
    const double *const depths = looks.depth + first, *const along = looks.along + first;
    fill_alike(runs, dialled.like, [&](const ColumnRuns& some) {
        if (is_blended)
            fill_blended(scene, blend, some, dialled.placed, depths, along);
        else
            fill(scene, some, dialled.placed, depths, along);
    });
    for (int i = 0; i < runs.count; ++i) {
        const OpenRows rows{runs.tops[i], runs.bottoms[i]};
        if (rows.is_closed()) continue;
        const int x = looks.begin + first + i;
        if (is_there(fog_)) add_fog(scene, scene.canvas.run(x, rows.top, rows.bottom), looks.depth[first + i]);
        if (scene.facts) note_column(scene, x, rows, looks.depth[first + i], dialled.at[i]);
    }
}

/// Where column x is on the picture: between two exact ones where the dial of spans says so.
WallPainter::ColumnTexels WallPainter::texels_in_span(const ColumnScene& scene, const ExactColumns& exact,
                                                      int x) const {
    const int span = scene.dials->dials.span;
    if (span == 1) return exact.texels(x);
    const int first = std::max(x - x % span, exact.all().first), last = std::min(x - x % span + span, exact.all().last);
    const ColumnTexels a = exact.texels(first), b = exact.texels(last);
    return {on_line(a.u, b.u, first, last, x), on_line(a.v_at_row_0, b.v_at_row_0, first, last, x),
            on_line(a.v_per_row, b.v_per_row, first, last, x)};
}

/// Whether the mean of the first and the last of the columns is nowhere off by more than is promised, nor any of them
/// in another light. Depth and place on a wall never turn back from column to column: those between are between.
bool WallPainter::may_be_alike(const ColumnScene& scene, const ExactColumns& exact, ColumnGroup columns) const {
    const ColumnTexels a = exact.texels(columns.first), b = exact.texels(columns.last);
    const Dials& dials = scene.dials->dials;
    const double at_row_0 = a.v_at_row_0 - b.v_at_row_0;
    const double at_end = at_row_0 + scene.screen.height * (a.v_per_row - b.v_per_row);
    return std::fabs(a.u - b.u) * texture_->width <= most_apart(dials, texture_->width) &&
           std::max(std::fabs(at_row_0), std::fabs(at_end)) * texture_->height <= most_apart(dials, texture_->height) &&
           exact.shade(columns.first) == exact.shade(columns.last);
}

/// The largest group of columns around x that may be alike. Lamps light each column by itself.
WallPainter::AlikeColumns WallPainter::alike_at(const ColumnScene& scene, const ExactColumns& exact, int x) const {
    AlikeColumns alike{{x, x}, {}, {}};
    const int most = light_grid_ || scene.dials->dials.texel_error == 0 ? 1 : kMostHeld;
    for (int size = 2; size <= most; size *= 2) {
        const ColumnGroup columns = group_of(x, size, exact.all());
        if (!may_be_alike(scene, exact, columns)) break;
        alike.columns = columns;
    }
    const ColumnTexels a = texels_in_span(scene, exact, alike.columns.first);
    const ColumnTexels b = texels_in_span(scene, exact, alike.columns.last);
    alike.at = in_numbers(scene, exact, x,
                          {(a.u + b.u) / 2, (a.v_at_row_0 + b.v_at_row_0) / 2, (a.v_per_row + b.v_per_row) / 2});
    if (scene.dials->mips) alike.mip = mip_at(scene, exact, alike.columns.first);
    return alike;
}

/// By texels per pixel (render/sampling.h).
MipPlace WallPainter::mip_at(const ColumnScene& scene, const ExactColumns& exact, int x) const {
    const ProjectedWall& wall = *exact.looks.wall;
    const double depth = exact.depth(x);
    const double along_per_slope = wall.cross > 0 ? depth * depth * wall.inverse_cross : 0;
    const double across = along_per_slope / scene.screen.column_scale * u_per_along_ * texture_->width;
    const double down = depth / scene.screen.focal_y * v_per_m_ * texture_->height;
    const double most = std::max(across, down);
    return scene.dials->dials.sampling == Sampling::mip ? MipPlace{mip_level(most), 0} : mip_place(most);
}

/// Fixed point steps down a column from the horizon, as it was done.
WallPainter::ColumnTexels WallPainter::in_numbers(const ColumnScene& scene, const ExactColumns& exact, int x,
                                                  const ColumnTexels& at) const {
    const double width = texture_->width, height = texture_->height, rows = scene.screen.horizon - 0.5;
    switch (scene.dials->dials.number) {
        case NumberKind::real64: break;
        case NumberKind::real32: return {float(at.u), float(at.v_at_row_0), float(at.v_per_row)};
        case NumberKind::fixed16: {
            const double per_row = in_16_16(at.v_per_row * height) / height;
            const double at_horizon = in_16_16((at.v_at_row_0 + rows * at.v_per_row) * height) / height;
            return {in_16_16(at.u * width) / width, at_horizon - rows * per_row, per_row};
        }
        case NumberKind::vanilla: return exact.vanilla ? by_vanilla(scene, exact, x) : at;
    }
    return at;
}

/// Down a column it steps from the row under the horizon.
WallPainter::ColumnTexels WallPainter::by_vanilla(const ColumnScene& scene, const ExactColumns& exact, int x) const {
    const RayTables& screen = scene.screen;
    const double from_left = exact.vanilla->along_at(x) / texture_->width;
    const double u = exact.looks.wall->swapped ? u_per_along_ - from_left : from_left;
    const double depth = exact.vanilla->per_row_at(x) * screen.column_scale / exact.texels_per_m();
    const double height = texture_->height, per_row = in_16_16(depth / screen.focal_y * v_per_m_ * height) / height;
    const double at_horizon = in_16_16(v_at_peg_ * height) / height;
    return {u - in_16_16(u_offset_ * texture_->width) / texture_->width,
            at_horizon - std::floor(screen.horizon) * per_row, per_row};
}

}  // namespace enfilade::column
