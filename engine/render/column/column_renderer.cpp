#include "render/column/column_renderer.h"

#include <limits>
#include <optional>

#include "base/check.h"
#include "render/built_in.h"
#include "render/column/viewport_drawer.h"
#include "render/look_budget.h"

namespace enfilade {

using namespace column;

struct ColumnRenderer::Scratch {
    Screen screen;
    Canvas own_canvas;  ///< without memory as long as others are given
    FrameState state;
    ViewportDrawer drawer;
    std::optional<LightGrids> own_lights;
    LightGrids& lights;
    ColumnScratch column;
    PlainKernels kernels = chosen_kernels();
    Passes passes = passes_beside(kernels);

    Scratch() : lights(own_lights.emplace()) {}
    explicit Scratch(LightGrids& of_several) : lights(of_several) {}
};

namespace {

void start_frame(FrameState& state, const Map& map, const View& view, ColumnRange columns, int height) {
    state.pool.take_all_back();
    state.stack.clear();
    state.projections.start_frame();
    state.masked.clear();
    state.poses.assign(1, pose_of(view));
    state.deepest = 0;
    state.cut = 0;
    state.is_cut_short = false;
    Viewport& first = state.pool.take(columns.begin, columns.end);
    first.sector = view.sector;
    first.entry = {};
    first.pose = 0;
    first.depth = 0;
    first.spent = cost_of_look_into(map[view.sector]);
    for (int x = columns.begin; x < columns.end; ++x) {
        first.rows_at(x) = {0, height};
        first.boundary_at(x) = std::numeric_limits<double>::infinity();
    }
    state.stack.push_back(&first);
}

}  // namespace

ColumnRenderer::ColumnRenderer() : scratch_(std::make_unique<Scratch>()) {}
ColumnRenderer::ColumnRenderer(LightGrids& lights) : scratch_(std::make_unique<Scratch>(lights)) {}
ColumnRenderer::~ColumnRenderer() = default;
ColumnRenderer::ColumnRenderer(ColumnRenderer&&) noexcept = default;
ColumnRenderer& ColumnRenderer::operator=(ColumnRenderer&&) noexcept = default;

void ColumnRenderer::render(Frame& frame, FrameFacts* facts, const Map& map, const TextureSet& textures,
                            const Snapshot& snapshot, const View& view) {
    render_columns(frame, facts, map, textures, snapshot, view, {0, frame.width});
    frame.is_cut_short = scratch_->state.is_cut_short;
}

void ColumnRenderer::render_columns(Frame& frame, FrameFacts* facts, const Map& map, const TextureSet& textures,
                                    const Snapshot& snapshot, const View& view, ColumnRange columns) {
    render_columns(frame, facts, map, textures, snapshot, view, columns, scratch_->own_canvas);
}

void ColumnRenderer::render_columns(Frame& frame, FrameFacts* facts, const Map& map, const TextureSet& textures,
                                    const Snapshot& snapshot, const View& view, ColumnRange columns, Canvas& canvas) {
    ENFILADE_CHECK(view.sector.index < map.sectors.size() && snapshot.sectors.size() == map.sectors.size());
    ENFILADE_CHECK(0 <= columns.begin && columns.begin < columns.end && columns.end <= frame.width);
    ENFILADE_CHECK(!view.tilt);  // columns stay upright
    Scratch& s = *scratch_;
    s.screen.set(Projection(view, frame.width, frame.height));
    canvas.set(columns.begin, columns.end, frame.height);
    s.column.start_frame(frame.width, frame.height);
    LightGrids* lights = built_in::kPointLights && s.lights.start(map) ? &s.lights : nullptr;
    const Scene scene{map, textures, snapshot, s.screen, canvas, facts, lights, s.column, s.kernels, s.passes};
    start_frame(s.state, map, view, columns, frame.height);
    while (!s.state.stack.empty()) {
        Viewport& next = *s.state.stack.back();
        s.state.stack.pop_back();
        s.drawer.draw(scene, s.state, next);
    }
    s.state.masked.draw(scene);
    canvas.copy_to(frame);
}

ColumnCounts ColumnRenderer::counts() const {
    const FrameState& state = scratch_->state;
    return {state.pool.used(), state.deepest, state.cut, state.is_cut_short};
}

std::vector<ViewportOutline> ColumnRenderer::viewports() const {
    std::vector<ViewportOutline> outlines;
    const ViewportPool& pool = scratch_->state.pool;
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

}  // namespace enfilade
