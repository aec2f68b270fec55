#include "render/outside/outside_renderer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/parallel.h"

namespace enfilade {

namespace {

/// The mean of four pixels; colours count as much as they cover.
std::uint32_t mean(const std::array<std::uint32_t, 4>& pixels) {
    std::uint32_t alpha = 0, red = 0, green = 0, blue = 0;
    for (const std::uint32_t pixel : pixels) {
        const std::uint32_t weight = pixel >> 24;
        alpha += weight;
        red += (pixel & 0xFF) * weight;
        green += (pixel >> 8 & 0xFF) * weight;
        blue += (pixel >> 16 & 0xFF) * weight;
    }
    if (alpha == 0) return 0;
    return (alpha + 2) / 4 << 24 | blue / alpha << 16 | green / alpha << 8 | red / alpha;
}

}  // namespace

TexturePyramid::TexturePyramid(const Texture& texture) {
    levels_.push_back({texture.width, texture.height, texture.pixels});
    while (levels_.back().width > 1 || levels_.back().height > 1) levels_.push_back(halved(levels_.back()));
}

TexturePyramid::MipLevel TexturePyramid::halved(const MipLevel& from) {
    MipLevel to{std::max(from.width / 2, 1u), std::max(from.height / 2, 1u), {}};
    const auto pixel = [&](std::uint32_t x, std::uint32_t y) {
        return from.pixels[std::size_t{std::min(x, from.width - 1)} * from.height + std::min(y, from.height - 1)];
    };
    for (std::uint32_t x = 0; x < to.width; ++x)
        for (std::uint32_t y = 0; y < to.height; ++y)
            to.pixels.push_back(mean(
                {pixel(2 * x, 2 * y), pixel(2 * x + 1, 2 * y), pixel(2 * x, 2 * y + 1), pixel(2 * x + 1, 2 * y + 1)}));
    return to;
}

std::uint32_t TexturePyramid::at(TilePlace u, TilePlace v, double texels_per_px) const {
    const auto whole = static_cast<std::uint32_t>(std::clamp(texels_per_px / 2, 0.0, 65536.0));
    const MipLevel& level =
        levels_[std::min<std::size_t>(static_cast<std::size_t>(std::bit_width(whole)), levels_.size() - 1)];
    return level.pixels[std::size_t{texel_of(u, level.width)} * level.height + texel_of(v, level.height)];
}

namespace {

/// The line through two points; positive to its right where it runs from a to b. Swapped, exactly the opposite.
PicturePoint line_through(const PicturePoint& a, const PicturePoint& b) {
    return {a.y * b.w - a.w * b.y, a.w * b.x - a.x * b.w, a.x * b.y - a.y * b.x};
}

double value_at(const PicturePoint& line, double x, double y) { return line.x * x + (line.y * y + line.w); }

/// A pixel on the very line belongs to one side of it.
bool is_inside(const PicturePoint& line, double value) {
    if (value != 0) return value > 0;
    return line.x > 0 || (line.x == 0 && line.y > 0);
}

double middle_of(int pixel) { return pixel + 0.5; }

/// The first pixel of [begin, end) that is right of the place, by a guess that is then put right.
int guess(double place, int begin, int end) {
    return static_cast<int>(std::clamp(std::ceil(place - 0.5), double(begin), double(end)));
}

/// Takes from the span what is outside one rim. Values never fall along a row where line.x > 0, never grow where it is
/// < 0, so that what is inside is one run of pixels.
void cut(Facet::Span& span, const PicturePoint& line, double y) {
    const auto inside = [&](int x) { return is_inside(line, value_at(line, middle_of(x), y)); };
    if (line.x == 0) {
        if (!inside(span.begin)) span.end = span.begin;
        return;
    }
    int at = guess(-(line.y * y + line.w) / line.x, span.begin, span.end);
    const bool grows = line.x > 0;
    while (at > span.begin && inside(at - 1) == grows) --at;
    while (at < span.end && inside(at) != grows) ++at;
    (grows ? span.begin : span.end) = at;
}

/// How much darker what is not seen is [1/256].
constexpr Shade kUnseen[] = {256, 256, 104, 64};

/// The rows of one band, with what is nearest in each pixel so far.
class Band {
public:
    Band(Frame& frame, const SeenRooms& rooms, const OutsideCamera& camera, int first_row, int end_row)
        : frame_(frame),
          rooms_(rooms),
          camera_(camera),
          first_row_(first_row),
          end_row_(end_row),
          cells_(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(end_row - first_row)) {}

    void paint(const Facet& facet) {
        for (int y = std::max(first_row_, facet.first_row()); y < std::min(end_row_, facet.end_row()); ++y) {
            const Facet::Span span = facet.span(y, frame_.width);
            if (facet.look().texture)
                for (int x = span.begin; x < span.end; ++x) paint_surface(facet, x, y);
            else
                for (int x = span.begin; x < span.end; ++x) paint_mark(facet, x, y);
        }
    }

private:
    struct Cell {
        FacetLayer layer = FacetLayer::unfolded;
        std::size_t room = std::numeric_limits<std::size_t>::max();  ///< unfolded ones lie in and through one another:
                                                                     ///< the one found first hides the others
        double depth = std::numeric_limits<double>::infinity();
    };

    void paint_surface(const Facet& facet, int x, int y) {
        const FacetLook& look = facet.look();
        const FacetCorner at = facet.at(x, y);
        const double depth = camera_.depth(at.p, at.z);
        const Cell& before = cell(x, y);
        if (before.layer == FacetLayer::mark || (before.layer == FacetLayer::seen && before.depth <= depth)) return;
        const std::uint32_t color = look.texture->at(place_on_tile(at.uv.x), place_on_tile(at.uv.y),
                                                     look.texels_per_m * camera_.metres_per_px(depth));
        if (color >> 24 < kSolidAlpha) return;
        const bool is_seen = rooms_.shows(look.room, look.wall, at.p, at.z);
        const FacetLayer layer = is_seen ? FacetLayer::seen : look.unseen_layer;
        put(x, y, {layer, layer == FacetLayer::unfolded ? look.room : 0, depth},
            shaded(color, look.shade * kUnseen[static_cast<std::size_t>(layer)] / 256));
    }

    void paint_mark(const Facet& facet, int x, int y) {
        const FacetCorner at = facet.at(x, y);
        put(x, y, {FacetLayer::mark, 0, camera_.depth(at.p, at.z)}, facet.look().color);
    }

    Cell& cell(int x, int y) {
        return cells_[static_cast<std::size_t>(y - first_row_) * static_cast<std::size_t>(frame_.width) +
                      static_cast<std::size_t>(x)];
    }

    void put(int x, int y, const Cell& fresh, std::uint32_t color) {
        Cell& before = cell(x, y);
        if (!(std::tie(fresh.layer, fresh.room, fresh.depth) < std::tie(before.layer, before.room, before.depth)))
            return;
        before = fresh;
        frame_.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(frame_.width) +
                      static_cast<std::size_t>(x)] = color;
    }

    Frame& frame_;
    const SeenRooms& rooms_;
    const OutsideCamera& camera_;
    int first_row_, end_row_;
    std::vector<Cell> cells_;
};

}  // namespace

std::optional<Facet> Facet::triangle(const OutsideCamera& camera, const std::array<FacetCorner, 3>& corners,
                                     const FacetLook& look, FacetSides sides) {
    Facet facet(corners, look);
    std::array<PicturePoint, 3> points;
    for (std::size_t i = 0; i < 3; ++i) points[i] = camera.project(corners[i].p, corners[i].z);
    for (std::size_t i = 0; i < 3; ++i) facet.opposite_[i] = line_through(points[(i + 1) % 3], points[(i + 2) % 3]);
    const PicturePoint& first = facet.opposite_[0];
    const double area = first.x * points[0].x + first.y * points[0].y + first.w * points[0].w;
    if (area == 0 || (area < 0 && sides == FacetSides::front)) return {};
    if (area < 0) return triangle(camera, {corners[0], corners[2], corners[1]}, look, sides);
    std::copy(facet.opposite_.begin(), facet.opposite_.end(), facet.rims_.begin());
    facet.rim_count_ = 3;
    facet.bound_rows(points);
    return facet;
}

std::optional<Facet> Facet::upright(const OutsideCamera& camera, const FacetCorner& upper_left,
                                    const FacetCorner& lower_right, const FacetLook& look, FacetSides sides) {
    if (!(upper_left.z > lower_right.z)) return {};
    const FacetCorner upper_right{lower_right.p, upper_left.z, {lower_right.uv.x, upper_left.uv.y}};
    const FacetCorner lower_left{upper_left.p, lower_right.z, {upper_left.uv.x, lower_right.uv.y}};
    auto facet = triangle(camera, {upper_left, upper_right, lower_right}, look, FacetSides::front);
    if (!facet)
        return sides == FacetSides::front ? std::nullopt
                                          : upright(camera, upper_right, lower_left, look, FacetSides::front);
    const PicturePoint up = camera.upright(), left = camera.project(upper_left.p, 0),
                       right = camera.project(lower_right.p, 0);
    std::array<PicturePoint, 4> points;
    std::size_t i = 0;
    for (const FacetCorner& corner : {upper_left, upper_right, lower_right, lower_left})
        points[i++] = camera.project(corner.p, corner.z);
    // An upright rim depends on its place alone: walls of any height meet there exactly.
    facet->rims_ = {line_through(points[0], points[1]), line_through(up, right), line_through(points[2], points[3]),
                    line_through(left, up)};
    facet->rim_count_ = 4;
    facet->bound_rows(points);
    return facet;
}

void Facet::bound_rows(std::span<const PicturePoint> points) {
    double top = kMaxPictureSide, bottom = 0;
    for (const PicturePoint& point : points) {
        const bool is_ahead = point.w > 0;
        top = std::min(top, is_ahead ? point.y / point.w - 1 : 0.0);
        bottom = std::max(bottom, is_ahead ? point.y / point.w + 1 : double(kMaxPictureSide));
    }
    first_row_ = static_cast<int>(std::clamp(top, 0.0, double(kMaxPictureSide)));
    end_row_ = static_cast<int>(std::clamp(bottom, 0.0, double(kMaxPictureSide)));
}

Facet::Span Facet::span(int row, int width) const {
    Span span{0, width};
    for (std::size_t i = 0; i < rim_count_ && span.begin < span.end; ++i) cut(span, rims_[i], middle_of(row));
    if (rim_count_ == 4 && span.begin < span.end) {  // its rims alone also hold what is seen of it behind the camera
        const PicturePoint ahead{opposite_[0].x + opposite_[1].x + opposite_[2].x,
                                 opposite_[0].y + opposite_[1].y + opposite_[2].y,
                                 opposite_[0].w + opposite_[1].w + opposite_[2].w};
        cut(span, ahead, middle_of(row));
    }
    return span;
}

FacetCorner Facet::at(int x, int row) const {
    std::array<double, 3> part;
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += part[i] = value_at(opposite_[i], middle_of(x), middle_of(row));
    const double scale = 1 / sum;
    FacetCorner at{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double share = part[i] * scale;
        at.p = at.p + corners_[i].p * share;
        at.z += corners_[i].z * share;
        at.uv = at.uv + corners_[i].uv * share;
    }
    return at;
}

void paint_facets(Frame& frame, std::span<const Facet> facets, const SeenRooms& rooms, const OutsideCamera& camera,
                  std::size_t workers) {
    constexpr int kBandRows = 16;  // small enough that all threads have work until the end
    const int bands = (frame.height + kBandRows - 1) / kBandRows;
    parallel_for(static_cast<std::size_t>(bands), workers, [&](std::size_t index, std::size_t) {
        const int first = static_cast<int>(index) * kBandRows;
        Band band(frame, rooms, camera, first, std::min(first + kBandRows, frame.height));
        for (const Facet& facet : facets) band.paint(facet);
    });
}

}  // namespace enfilade
