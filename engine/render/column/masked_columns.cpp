#include "render/column/masked_columns.h"

namespace enfilade::column {

void MaskedColumns::clear() {
    painters_.clear();
    columns_.clear();
}

int MaskedColumns::add(const WallPainter& painter) {
    painters_.push_back(painter);
    return static_cast<int>(painters_.size()) - 1;
}

void MaskedColumns::draw(const Scene& scene) const {
    for (auto column = columns_.rbegin(); column != columns_.rend(); ++column)
        painters_[static_cast<std::size_t>(column->painter)].lay_over(scene, column->x, column->rows.top,
                                                                      column->rows.bottom, column->hit);
}

}  // namespace enfilade::column
