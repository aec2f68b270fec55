// Outlines in short, as an author writes them: what the reader makes loops of.
#pragma once
#include "base/boxed.h"
#include "base/finding.h"
#include "formats/effect_records.h"
#include "math/vec.h"

namespace enfilade {

/// An upright rectangle on the drawing, by any two corners that lie opposite.
struct RectRecord {
    Vec2 a, b;  ///< [m]
    TextPlace place{};
    bool operator==(const RectRecord&) const = default;
};

/// A regular polygon.
struct PolygonRecord {
    Vec2 center;        ///< [m]
    double radius = 1;  ///< from the centre to each corner [m]
    int corners = 8;
    double turn = 0;  ///< where the first corner lies: 0 is along +x, and it grows to the right [degrees]
    TextPlace place{};
    KeyPlaces places{};
    bool operator==(const PolygonRecord&) const = default;
};

/// A loop in short: its shape instead of its corners, and one wall for all that say nothing. Empty once a map is read.
template <class Wall>
struct Shorthand {
    Boxed<RectRecord> rect;
    Boxed<PolygonRecord> polygon;
    Boxed<Wall> wall;
    bool operator==(const Shorthand&) const = default;
};

}  // namespace enfilade
