#include "render/column/column_renderer.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>

#include "base/result.h"
#include "render/built_in.h"
#include "render/column/canvas.h"
#include "render/column/viewport_drawer.h"
#include "render/openings.h"

namespace enfilade {

using namespace column;

// Aligned, and so padded, for threads write into neighbouring ones all the time.
class alignas(kCacheLineBytes) ColumnRenderer::Workspace {
public:
    /// Before each part of a picture.
    void start(const View& view, const Frame& frame, std::uint64_t picture) {
        ENFILADE_CHECK(picture != kNone);
        if (picture == picture_) return;
        picture_ = kNone;  // until all is worked out: memory may be missing on the way
        screen.set(Projection(view, frame.width, frame.height));
        column.start_frame(frame.width, frame.height);
        state.projections.start_frame();
        state.poses.assign(1, pose_of(view));
        picture_ = picture;
    }

    Canvas canvas;
    RayTables screen;
    ColumnScratch column;
    FrameState state;
    ViewportDrawer drawer;

private:
    static constexpr std::uint64_t kNone = 0;

    std::uint64_t picture_ = kNone;  ///< that what is known is of
};

struct alignas(kCacheLineBytes) ColumnRenderer::Parts {
    const Map& map;
    const TextureSet& textures;
    std::optional<LightGrids> own_lights;
    LightGrids& lights;
    PlainKernels kernels = chosen_kernels();
    Passes passes = passes_beside(kernels);
    const TexelDials* dials = nullptr;
    ViewportRecord record;
    std::unique_ptr<Workspace> own_workspace;  ///< none as long as others are given
    std::uint64_t own_pictures = 0;            ///< drawn in it

    Parts(const Map& of, const TextureSet& pictures) : map(of), textures(pictures), lights(own_lights.emplace(of)) {}
    Parts(const Map& of, const TextureSet& pictures, const Shared& shared)
        : map(of), textures(pictures), lights(shared.lights), dials(shared.dials) {}
};

ColumnRenderer::ColumnRenderer(const Map& map, const TextureSet& textures)
    : parts_(std::make_unique<Parts>(map, textures)) {}
ColumnRenderer::ColumnRenderer(const Map& map, const TextureSet& textures, const Shared& shared)
    : parts_(std::make_unique<Parts>(map, textures, shared)) {}
ColumnRenderer::~ColumnRenderer() = default;
ColumnRenderer::ColumnRenderer(ColumnRenderer&&) noexcept = default;
ColumnRenderer& ColumnRenderer::operator=(ColumnRenderer&&) noexcept = default;

void ColumnRenderer::render(Frame& frame, FrameFacts* facts, const Snapshot& snapshot, const View& view) {
    render_columns(frame, facts, snapshot, view, {0, frame.width});
    frame.is_cut_short = parts_->record.is_cut_short;
}

void ColumnRenderer::render_columns(Frame& frame, FrameFacts* facts, const Snapshot& snapshot, const View& view,
                                    ColumnRange columns) {
    if (!parts_->own_workspace) parts_->own_workspace = std::make_unique<Workspace>();
    render_columns(frame, facts, snapshot, view, columns, *parts_->own_workspace, ++parts_->own_pictures);
}

namespace {

/// The whole of the columns is open on the eye's own sector.
void start_columns(FrameState& state, const Map& map, const View& view, ColumnRange columns, int height) {
    state.record->start();
    state.stack.clear();
    state.masked.clear(columns.end);
    Viewport& first = state.record->pool.take(columns.begin, columns.end);
    first.sector = view.sector;
    first.entry = {};
    first.pose = 0;
    first.depth = 0;
    first.spent = cost_of_look_into(map[view.sector], 0);
    for (int x = columns.begin; x < columns.end; ++x) {
        first.rows_at(x) = {0, height};
        first.boundary_at(x) = std::numeric_limits<double>::infinity();
    }
    state.stack.push_back(&first);
}

}  // namespace

void ColumnRenderer::render_columns(Frame& frame, FrameFacts* facts, const Snapshot& snapshot, const View& view,
                                    ColumnRange columns, Workspace& workspace, std::uint64_t picture) {
    Parts& p = *parts_;
    const std::size_t sectors = p.map.sectors.size();
    ENFILADE_CHECK(view.sector.index < sectors && snapshot.sectors.size() == sectors);
    ENFILADE_CHECK(0 <= columns.begin && columns.begin < columns.end && columns.end <= frame.width);
    ENFILADE_CHECK(!view.tilt);  // columns stay upright
    workspace.start(view, frame, picture);
    workspace.canvas.set(columns.begin, columns.end, frame.height);
    const RayTables& screen = workspace.screen;
    LightGrids* lights = built_in::kPointLights ? p.lights.where_lit() : nullptr;
    const TexelDials* const dials = p.dials && is_promise_too_narrow(*p.dials, screen) ? nullptr : p.dials;
    const ColumnScene scene{p.map,     p.textures, snapshot, screen, workspace.canvas, facts, lights, workspace.column,
                            p.kernels, p.passes,   dials};
    FrameState& state = workspace.state;
    state.record = &p.record;
    start_columns(state, p.map, view, columns, frame.height);
    while (!state.stack.empty()) {
        Viewport& next = *state.stack.back();
        state.stack.pop_back();
        workspace.drawer.draw(scene, state, next);
    }
    state.masked.draw(scene);
    workspace.canvas.copy_to(frame);
}

ColumnCounts ColumnRenderer::counts() const {
    const ViewportRecord& record = parts_->record;
    return {record.pool.used(), record.deepest, record.cut, record.is_cut_short};
}

std::vector<ViewportOutline> ColumnRenderer::viewports() const {
    std::vector<ViewportOutline> outlines;
    const ViewportPool& pool = parts_->record.pool;
    for (std::size_t i = 0; i < pool.used(); ++i) {
        const Viewport& v = pool[i];
        ViewportOutline outline{v.sector, v.depth, v.begin, v.end, {}, {}, v.boundary};
        for (const OpenRows& rows : v.rows) {
            outline.top.push_back(rows.top);
            outline.bottom.push_back(rows.bottom);
        }
        outlines.push_back(std::move(outline));
    }
    return outlines;
}

namespace {

/// A strip's canvas, drawn and then copied, stays in a core's second-level cache, of which it takes half at most: most
/// have 1 MiB or more. A picture in one piece would go through memory twice.
constexpr int kCanvasBytes = 512 << 10;

/// Columns that a canvas may have [pixels].
int widest_strip(int height) {
    const int columns = kCanvasBytes / static_cast<int>(sizeof(std::uint32_t)) / std::max(height, 1);
    return std::max(columns / kLinePixels, 1) * kLinePixels;
}

/// Several threads take one of so many parts of what is left of a share at a time. Of halves the last are wider, and
/// one thread waits longer for the other; narrower strips meet more walls twice.
constexpr int kPartsOfShare = 3;

/// The quotient, rounded up.
int divided_up(int all, int by) { return (all + by - 1) / by; }

}  // namespace

void cut_into_strips(int width, std::size_t threads, int widest, std::vector<Strip>& strips) {
    ENFILADE_CHECK(width >= 1 && threads >= 1 && widest >= kLinePixels);
    const auto lines = static_cast<std::size_t>(divided_up(width, kLinePixels));
    const int most = widest / kLinePixels;
    strips.clear();
    for (std::size_t share = 0; share < threads; ++share) {
        const int end = static_cast<int>(lines * (share + 1) / threads);
        for (int line = static_cast<int>(lines * share / threads), next; line < end; line = next) {
            const int left = end - line;
            next = line + divided_up(left, std::max(divided_up(left, most), threads > 1 ? kPartsOfShare : 1));
            strips.push_back({{line * kLinePixels, std::min(next * kLinePixels, width)}, share});
        }
    }
}

ColumnStrips::ColumnStrips(const Map& map, const TextureSet& textures, std::size_t threads, const Dials& dials)
    : map_(map),
      textures_(textures),
      threads_(threads),
      lights_(std::make_unique<LightGrids>(map, dials.light_grid)),
      pool_(threads) {
    while (workspaces_.size() < threads) workspaces_.push_back(std::make_unique<ColumnRenderer::Workspace>());
    if (needs_smaller_pictures(dials.sampling)) mips_ = std::make_unique<MipChains>(textures);
    if (!are_texels_exact(dials))
        dials_ = std::make_unique<TexelDials>(TexelDials{dials, mips_.get(), least_texels_per_m(map, textures)});
}

ColumnStrips::~ColumnStrips() = default;

void ColumnStrips::render(Frame& frame, FrameFacts* facts, const Snapshot& snapshot, const View& view) {
    cut_into_strips(frame.width, threads_, widest_strip(frame.height), strips_);
    while (renderers_.size() < strips_.size())
        renderers_.emplace_back(map_, textures_, ColumnRenderer::Shared{*lights_, dials_.get()});
    const std::size_t strips = strips_.size();
    if (is_taken_.size() < strips) is_taken_ = std::vector<std::atomic_flag>(strips);
    for (std::atomic_flag& is_taken : is_taken_) is_taken.clear();
    ++pictures_;
    const auto draw = [&](std::size_t i, std::size_t worker) {
        if (is_taken_[i].test_and_set()) return;
        renderers_[i].render_columns(frame, facts, snapshot, view, strips_[i].columns, *workspaces_[worker], pictures_);
    };
    const auto draw_some = [&](std::size_t, std::size_t worker) {
        for (std::size_t i = 0; i < strips; ++i)
            if (strips_[i].share == worker) draw(i, worker);
        for (std::size_t i = 0; i < strips; ++i) draw(i, worker);
    };
    pool_.run(std::min(threads_, strips), std::cref(draw_some));  // a copied task would take memory in every frame
    frame.is_cut_short =
        std::any_of(renderers_.begin(), renderers_.begin() + static_cast<std::ptrdiff_t>(strips_.size()),
                    [](const ColumnRenderer& strip) { return strip.counts().is_cut_short; });
}

std::vector<std::vector<ViewportOutline>> ColumnStrips::viewports() const {
    std::vector<std::vector<ViewportOutline>> all;
    for (std::size_t i = 0; i < strips_.size(); ++i) all.push_back(renderers_[i].viewports());
    return all;
}

}  // namespace enfilade
