#include "render/stencil/stencil_renderer.h"

#include <algorithm>
#include <string>

#include "base/result.h"
#include "render/stencil/layer_painter.h"
#include "render/stencil/mesh.h"
#include "render/stencil/panorama.h"
#include "space/triangulate.h"

namespace enfilade {

using namespace stencil;

struct StencilRenderer::State {
    /// The OpenGL objects, which end before the context they live in.
    struct Objects {
        TexelStore store;
        Records records;
        RenderTarget target;
        LayerPainter painter;
    };

    const Map& map;
    const TextureSet& textures;
    std::unique_ptr<GlContext> context;
    std::unique_ptr<Objects> objects;
    Mesh mesh;
    LightGrids lights;
    MapFacts facts;
    PortalMethod portals;
    Ground ground;  ///< where they are not exact
    StencilCounts counts;
    std::vector<SeenRoom> rooms;  ///< of the last frame
    bool was_tilted = false;      ///< the last frame

    State(std::unique_ptr<GlContext> drawn_by, const Map& of, const TextureSet& pictures, int light_points_per_m,
          PortalMethod method)
        : map(of),
          textures(pictures),
          context(std::move(drawn_by)),
          lights(of, light_points_per_m),
          facts{overlapping_sectors(of)},
          portals(method) {}

    ~State() {
        if (!context->make_current().ok()) static_cast<void>(objects.release());  // they were lost with the context
        objects.reset();
        context->release();
    }

    Result<void> prepare();
    /// For portals that are not exact.
    Result<void> prepare_depths();
    /// Into the target; what it holds of the picture is in the result.
    Result<GlPicture> draw(int width, int height, bool with_facts, const Snapshot& snapshot, const View& view);
    Result<void> draw(Frame& frame, FrameFacts* frame_facts, const Snapshot& snapshot, const View& view);
};

namespace {

/// OpenGL ES 3.0 and OpenGL 3.3 as epoxy counts versions.
constexpr int kLeastEs = 30, kLeastDesktop = 33, kClipControl = 45;

Result<void> check_version() {
    const int version = epoxy_gl_version();
    if (version >= (epoxy_is_desktop_gl() ? kLeastDesktop : kLeastEs)) return {};
    return Error{"stencil renderer", std::string("expected OpenGL 3.3 or OpenGL ES 3.0, or newer; this graphics card "
                                                 "or its driver has OpenGL ") +
                                         (epoxy_is_desktop_gl() ? "" : "ES ") + std::to_string(version / 10) + "." +
                                         std::to_string(version % 10)};
}

/// What went wrong since the last question.
Result<void> gl_failure() {
    const GLenum error = glGetError();
    switch (error) {
        case GL_NO_ERROR: return {};
        case GL_OUT_OF_MEMORY: return Error{"stencil renderer", "the graphics card has no memory left"};
        case GL_CONTEXT_LOST: return Error{"stencil renderer", "the graphics card was reset and lost the picture"};
        default: return Error{"stencil renderer", "OpenGL reports error " + std::to_string(error)};
    }
}

}  // namespace

Result<void> StencilRenderer::State::prepare_depths() {
    if (portals == PortalMethod::exact) return {};
    if (!epoxy_is_desktop_gl())
        return Error{"stencil renderer",
                     "the dial portals needs OpenGL, and this graphics card or its driver has "
                     "OpenGL ES"};
    if (has_24_bits(portals)) {
        objects->target.use_24_bits_of_depth();
        return {};
    }
    if (epoxy_gl_version() < kClipControl && !epoxy_has_gl_extension("GL_ARB_clip_control"))
        return Error{"stencil renderer",
                     "depths of 32 bits need OpenGL 4.5 or ARB_clip_control, which this graphics card "
                     "or its driver has not; those of 24 bits do not"};
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    return {};
}

/// In the current context.
Result<void> StencilRenderer::State::prepare() {
    if (const Result<void> done = check_version(); !done.ok()) return done.error();
    objects = std::make_unique<Objects>();
    if (const Result<void> done = prepare_depths(); !done.ok()) return done.error();
    if (const Result<void> done = objects->painter.prepare(); !done.ok()) return done.error();
    if (const Result<void> done = objects->target.prepare(1, 1, false); !done.ok()) return done.error();
    if (const Result<void> done = objects->store.hold(textures); !done.ok()) return done.error();
    return gl_failure();
}

Result<GlPicture> StencilRenderer::State::draw(int width, int height, bool with_facts, const Snapshot& snapshot,
                                               const View& view) {
    const bool is_in_space = portals != PortalMethod::exact;
    if (is_in_space && view.tilt)
        return Error{"stencil renderer", "the dial portals has no true pitch; leave out one of the two"};
    const Projection projection(view, width, height);
    const RayField rays(view, projection);
    const Screen screen = view.tilt ? panorama_screen() : Screen(projection);
    const FrameInput input{map, facts, textures, snapshot};
    Plan plan = make_plan(input, screen, rays, view);
    if (const Result<void> done = objects->target.prepare(width, height, with_facts, times_kept(plan.deepest));
        !done.ok())
        return done.error();
    objects->records.clear();
    const DrawInput scene{input, objects->store, screen, rays, objects->records, lights.where_lit()};
    const VertexPlacing placing = is_in_space      ? VertexPlacing::in_space
                                  : rays.is_tilted ? VertexPlacing::tilted
                                                   : VertexPlacing::upright;
    mesh.clear();
    const std::vector<LayerRanges> ranges =
        is_in_space ? build_mesh_in_space(mesh, scene, plan, ground) : build_mesh(mesh, scene, plan);
    std::vector<SpaceLens> lenses;
    for (std::size_t i = 0; is_in_space && i < plan.layers.size(); ++i)
        lenses.push_back(lens_of(plan.layers[i], rays, portals));
    if (const Result<void> done = objects->records.upload(); !done.ok()) return done.error();
    if (const Result<void> done = objects->painter.prepare_for(mesh, placing); !done.ok()) return done.error();
    objects->target.clear();
    objects->painter.paint(objects->target, scene, plan, mesh, ranges, lenses, with_facts);
    counts = {plan.layers.size(),     0,           plan.rooms.size(), plan.cut, objects->painter.draws(),
              mesh.index_count() / 3, plan.deepest};
    for (const Layer& layer : plan.layers) counts.sectors += layer.sectors.size();
    rooms = std::move(plan.rooms);
    was_tilted = rays.is_tilted;
    return GlPicture{objects->target.framebuffer(), width, height, plan.is_cut_short};
}

Result<void> StencilRenderer::State::draw(Frame& frame, FrameFacts* frame_facts, const Snapshot& snapshot,
                                          const View& view) {
    const auto picture = draw(frame.width, frame.height, frame_facts != nullptr, snapshot, view);
    if (!picture.ok()) return picture.error();
    objects->target.read(frame);
    if (frame_facts) objects->target.read(*frame_facts);
    frame.is_cut_short = picture.value().is_cut_short;
    return gl_failure();
}

StencilRenderer::StencilRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
StencilRenderer::~StencilRenderer() = default;

Result<std::unique_ptr<StencilRenderer>> StencilRenderer::make(std::unique_ptr<GlContext> context, const Map& map,
                                                               const TextureSet& textures, int light_points_per_m,
                                                               PortalMethod portals) {
    auto state = std::make_unique<State>(std::move(context), map, textures, light_points_per_m, portals);
    if (const Result<void> done = state->context->make_current(); !done.ok()) return done.error();
    const Result<void> prepared = state->prepare();
    state->context->release();
    if (!prepared.ok()) return prepared.error();
    return std::unique_ptr<StencilRenderer>(new StencilRenderer(std::move(state)));
}

Result<void> StencilRenderer::render(Frame& frame, FrameFacts* facts, const Snapshot& snapshot, const View& view) {
    State& state = *state_;
    const std::size_t sectors = state.map.sectors.size();
    ENFILADE_CHECK(view.sector.index < sectors && snapshot.sectors.size() == sectors);
    if (const Result<void> done = state.context->make_current(); !done.ok()) return done.error();
    frame.resize(frame.width, frame.height);
    Result<void> drawn = state.draw(frame, facts, snapshot, view);
    state.context->release();
    return drawn;
}

Result<GlPicture> StencilRenderer::render_on_card(int width, int height, const Snapshot& snapshot, const View& view) {
    State& state = *state_;
    const std::size_t sectors = state.map.sectors.size();
    ENFILADE_CHECK(view.sector.index < sectors && snapshot.sectors.size() == sectors);
    if (const Result<void> done = state.context->make_current(); !done.ok()) return done.error();
    auto picture = state.draw(width, height, false, snapshot, view);
    const Result<void> drawn = gl_failure();
    state.context->release();
    if (!drawn.ok()) return drawn.error();
    return picture;
}

StencilCounts StencilRenderer::counts() const { return state_->counts; }

std::vector<StencilViewport> StencilRenderer::viewports() const {
    std::vector<StencilViewport> viewports;
    for (const SeenRoom& room : state_->rooms) {
        StencilViewport& viewport = viewports.emplace_back();
        viewport.sector = room.sector;
        viewport.depth = room.depth;
        if (state_->was_tilted) continue;
        viewport.begin = room.window.begin;
        viewport.end = room.window.end();
        for (const OpenRows& rows : room.window.rows) {
            viewport.top.push_back(rows.top);
            viewport.bottom.push_back(std::max(rows.top, rows.bottom));
        }
    }
    return viewports;
}

}  // namespace enfilade
