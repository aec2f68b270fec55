#include "wadconv/sprites.h"

#include <algorithm>
#include <limits>
#include <span>

namespace enfilade::wadconv {
namespace {

/// A sprite lump's name is four letters, then a frame letter and a direction, then perhaps both again for the mirrored
/// view.
bool is_view(std::string_view pair) { return pair[0] >= 'A' && pair[0] <= ']' && pair[1] >= '0' && pair[1] <= '8'; }

void add_view(SpriteFrames& frames, std::string_view sprite, std::string_view pair, SpriteView view) {
    if (!is_view(pair)) return;
    frames[std::string(sprite) + pair[0]].views[static_cast<std::size_t>(pair[1] - '0')] = view;
}

/// The views of a frame that are drawn: the eight, or the one that serves all directions.
std::vector<SpriteView> views_drawn(const DoomSpriteFrame& frame) {
    if (frame.has_all_directions()) return {frame.views.begin() + 1, frame.views.end()};
    const auto first = std::ranges::find_if(frame.views, [](const SpriteView& v) { return v.lump != nullptr; });
    return first == frame.views.end() ? std::vector<SpriteView>{} : std::vector<SpriteView>{*first};
}

/// The header with the offset mirrored too, so that the thing's position stays the same point of the drawing.
Result<PatchHeader> header_of(const SpriteView& view) {
    Result<PatchHeader> header = read_patch_header(view.lump->bytes);
    if (!header) return Error{view.lump->name, header.error().what};
    PatchHeader h = header.value();
    if (view.is_mirrored) h.left = std::int32_t(h.width) - h.left;
    return h;
}

Result<Picture> picture_of(const SpriteView& view) {
    Result<Picture> picture = read_patch(view.lump->bytes);
    if (!picture) return Error{view.lump->name, picture.error().what};
    if (view.is_mirrored) return mirrored(picture.value());
    return picture;
}

/// A box around the thing's position, in texels, y down.
struct TexelBox {
    std::int32_t left = std::numeric_limits<std::int32_t>::max(), top = left;
    std::int32_t right = std::numeric_limits<std::int32_t>::min(), bottom = right;

    void include(const PatchHeader& h) {
        left = std::min(left, -h.left);
        top = std::min(top, -h.top);
        right = std::max(right, -h.left + std::int32_t(h.width));
        bottom = std::max(bottom, -h.top + std::int32_t(h.height));
    }
};

}  // namespace

bool DoomSpriteFrame::has_all_directions() const {
    return std::all_of(views.begin() + 1, views.end(), [](const SpriteView& v) { return v.lump != nullptr; });
}

SpriteFrames sort_sprites(const WadPile& pile) {
    SpriteFrames frames;
    for (const auto& [name, lump] : pile.sprites()) {
        if (name.size() != 6 && name.size() != 8) continue;
        const std::string_view sprite = name.substr(0, 4);
        add_view(frames, sprite, name.substr(4, 2), {lump, false});
        if (name.size() == 8) add_view(frames, sprite, name.substr(6, 2), {lump, true});
    }
    return frames;
}

Result<SpriteCanvas> measure_frame(const DoomSpriteFrame& frame) {
    TexelBox box;
    const std::vector<SpriteView> views = views_drawn(frame);
    if (views.empty()) return Error{"", "the sprite has no picture"};
    for (const SpriteView& view : views) {
        const Result<PatchHeader> header = header_of(view);
        if (!header) return header.error();
        box.include(header.value());
    }
    const std::int32_t width = box.right - box.left, height = box.bottom - box.top;
    if (width > std::int32_t(kMaxPictureSide) || height > std::int32_t(kMaxPictureSide))
        return Error{views[0].lump->name, "the views lie too far apart for one picture"};
    return SpriteCanvas{std::uint32_t(width), std::uint32_t(height), -box.left, -box.top, views.size() == 8};
}

Result<Picture> draw_view(const DoomSpriteFrame& frame, const SpriteCanvas& canvas, std::size_t view) {
    const SpriteView drawn = canvas.has_rotations ? frame.views[view] : views_drawn(frame).front();
    const Result<PatchHeader> header = header_of(drawn);
    if (!header) return header.error();
    const Result<Picture> picture = picture_of(drawn);
    if (!picture) return picture.error();
    Picture on_canvas(canvas.width, canvas.height);
    const auto x0 = std::uint32_t(canvas.origin_x - header.value().left);
    const auto y0 = std::uint32_t(canvas.origin_y - header.value().top);
    for (std::uint32_t y = 0; y < picture.value().height; ++y)
        for (std::uint32_t x = 0; x < picture.value().width; ++x)
            on_canvas.at(x0 + x, y0 + y) = picture.value().at(x, y);
    return on_canvas;
}

}  // namespace enfilade::wadconv
