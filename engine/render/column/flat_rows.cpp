#include "render/column/flat_rows.h"

#include <algorithm>
#include <cmath>

namespace enfilade::column {

double level_depth(const RayTables& screen, double height, int row) {
    const auto y = static_cast<std::size_t>(row);
    const RowClimb tied{screen.tied_rises[y], screen.focal_y};
    if (screen.row_rises[y] < kAlmostLevel * tied.run && tied.rise > 0)
        return std::max(depth_on_plane(screen.row_rises[y] / tied.run, tied, height), 0.0);
    const double depth = height * screen.row_depths[y];
    return depth > 0 ? depth : 0;
}

void FlatRows::start(const FlatRowsKey& key, const RayTables& screen) {
    key_ = key;
    dimming_ = dimming_of(key.lighting);
    known_ = {};
    const std::size_t rows = screen.row_depths.size() + kRowsBeyond;
    depths_.resize(rows);
    shades_.resize(rows);
    darkness_.resize(rows);
    if (is_there(key.fog)) fog_parts_.resize(rows);
}

void FlatRows::prepare(const RayTables& screen, int top, int bottom) {
    if (top >= known_.top && bottom <= known_.bottom) return;
    if (known_.is_closed()) known_ = {top, top};
    if (top < known_.top) prepare_more(screen, top, known_.top);
    if (bottom > known_.bottom) prepare_more(screen, known_.bottom, bottom);
    known_ = {std::min(known_.top, top), std::max(known_.bottom, bottom)};
}

void FlatRows::prepare_more(const RayTables& screen, int top, int bottom) {
    for (int row = top; row < bottom; ++row) depths_[row] = level_depth(screen, key_.height, row);
    shade(top, bottom, &depths_[static_cast<std::size_t>(top)]);
}

void FlatRows::shade(int top, int bottom, const double* depths) {
    dimming_.at_all(depths, bottom - top, &shades_[static_cast<std::size_t>(top)]);
    for (int row = top; row < bottom; ++row) {
        darkness_[row] = darkness_of(key_.color_table, shades_[row]);
        shades_[row] = darkness_of(nullptr, shades_[row]);
    }
    if (is_there(key_.fog))
        for (int row = top; row < bottom; ++row)
            fog_parts_[row] = fog_part_at(key_.fog.reach, depths[row - top], key_.fog.step);
}

FlatRows& FlatRowsCache::of(const FlatRowsKey& key, const RayTables& screen) {
    std::size_t i = 0;
    while (i < used_ && !(rows_[i].key() == key)) ++i;
    if (i == used_) {
        if (used_ < kKept)
            ++used_;
        else
            i = static_cast<std::size_t>(std::ranges::min_element(asked_) - asked_.begin());
        rows_[i].start(key, screen);
    }
    asked_[i] = ++now_;
    return rows_[i];
}

}  // namespace enfilade::column
