#include "render/choice/renderer.h"

#include <algorithm>
#include <optional>

#include "formats/text_parts.h"
#include "formats/words.h"
#include "render/column/column_renderer.h"
#include "render/column/kernels.h"
#include "render/reference/reference_renderer.h"
#include "render/sampling.h"
#include "render/stencil/stencil_renderer.h"

namespace enfilade {
namespace {

/// Whether a viewport of one strip goes on in the strip to its right.
bool goes_on_in(const ViewportShape& left, const ViewportShape& right) {
    const bool meets = !left.top.empty() && !right.top.empty() && left.end == right.begin &&
                       left.top.back() < right.bottom.front() && right.top.front() < left.bottom.back();
    return meets && left.sector == right.sector && left.depth == right.depth;
}

/// Adds what a strip shows: strips are how a picture is drawn, and not what it shows.
void add_strip(std::vector<ViewportShape> strip, std::vector<ViewportShape>& shapes) {
    const std::size_t before = shapes.size();
    for (ViewportShape& shape : strip) {
        const auto end = shapes.begin() + static_cast<std::ptrdiff_t>(before);
        const auto left = std::find_if(shapes.begin(), end, [&](const auto& l) { return goes_on_in(l, shape); });
        if (left == end) {
            shapes.push_back(std::move(shape));
            continue;
        }
        left->end = shape.end;
        left->top.insert(left->top.end(), shape.top.begin(), shape.top.end());
        left->bottom.insert(left->bottom.end(), shape.bottom.begin(), shape.bottom.end());
    }
}

class ColumnDrawer final : public Renderer {
public:
    ColumnDrawer(const Map& map, const TextureSet& textures, std::size_t threads, const Dials& dials)
        : strips_(map, textures, threads, dials) {}

    Result<void> render(Frame& frame, FrameFacts* facts, const Snapshot& snapshot, const View& view) override {
        strips_.render(frame, facts, snapshot, view);
        return {};
    }

    std::vector<ViewportShape> viewports() const override {
        std::vector<ViewportShape> shapes;
        for (std::vector<ViewportOutline>& strip : strips_.viewports()) {
            std::vector<ViewportShape> here;
            for (ViewportOutline& outline : strip)
                here.push_back({outline.sector, outline.depth, outline.begin, outline.end, std::move(outline.top),
                                std::move(outline.bottom)});
            add_strip(std::move(here), shapes);
        }
        return shapes;
    }

    std::string_view kernels() const override { return column::chosen_kernels().name; }

private:
    ColumnStrips strips_;
};

class Reference final : public Renderer {
public:
    Reference(const Map& map, const TextureSet& textures, std::size_t threads, const Dials& dials)
        : map_(map), textures_(textures), threads_(threads), lights_(map, dials.light_grid), sampling_(dials.sampling) {
        if (needs_smaller_pictures(sampling_)) mips_.emplace(textures);
    }

    Result<void> render(Frame& frame, FrameFacts* facts, const Snapshot& snapshot, const View& view) override {
        render_reference(frame, facts, map_, textures_, snapshot, view,
                         {.workers = static_cast<int>(threads_),
                          .lights = &lights_,
                          .sampling = sampling_,
                          .mips = mips_ ? &*mips_ : nullptr});
        return {};
    }

private:
    const Map& map_;
    const TextureSet& textures_;
    std::size_t threads_;
    LightGrids lights_;
    Sampling sampling_;
    std::optional<MipChains> mips_;  ///< where it needs them
};

class Stencil final : public Renderer {
public:
    explicit Stencil(std::unique_ptr<StencilRenderer> renderer) : renderer_(std::move(renderer)) {}

    Result<void> render(Frame& frame, FrameFacts* facts, const Snapshot& snapshot, const View& view) override {
        return renderer_->render(frame, facts, snapshot, view);
    }

    bool keeps_on_card() const override { return true; }
    Result<GlPicture> render_on_card(int width, int height, const Snapshot& snapshot, const View& view) override {
        return renderer_->render_on_card(width, height, snapshot, view);
    }

    std::vector<ViewportShape> viewports() const override {
        std::vector<ViewportShape> shapes;
        for (StencilViewport& seen : renderer_->viewports())
            shapes.push_back(
                {seen.sector, seen.depth, seen.begin, seen.end, std::move(seen.top), std::move(seen.bottom)});
        return shapes;
    }

private:
    std::unique_ptr<StencilRenderer> renderer_;
};

Result<std::unique_ptr<Renderer>> make_stencil(const RendererChoice& choice, const Map& map,
                                               const TextureSet& textures) {
    auto context = choice.open_gl();
    if (!context.ok()) return context.error();
    auto renderer =
        StencilRenderer::make(std::move(context).value(), map, textures, choice.dials.light_grid, choice.dials.portals);
    if (!renderer.ok()) return renderer.error();
    return std::unique_ptr<Renderer>(std::make_unique<Stencil>(std::move(renderer).value()));
}

Result<std::unique_ptr<Renderer>> make_column(const RendererChoice& choice, const Map& map,
                                              const TextureSet& textures) {
    if (const Result<void> valid = column::check_kernels(); !valid.ok()) return valid.error();
    return std::unique_ptr<Renderer>(std::make_unique<ColumnDrawer>(map, textures, choice.threads, choice.dials));
}

Result<std::unique_ptr<Renderer>> make_plain(const RendererChoice& choice, const Map& map, const TextureSet& textures) {
    switch (choice.kind) {
        case RendererKind::column: return make_column(choice, map, textures);
        case RendererKind::stencil: return make_stencil(choice, map, textures);
        case RendererKind::reference: break;
    }
    return std::unique_ptr<Renderer>(std::make_unique<Reference>(map, textures, choice.threads, choice.dials));
}

/// Lets another renderer draw a larger picture, and takes means.
class Supersampler final : public Renderer {
public:
    Supersampler(std::unique_ptr<Renderer> renderer, int samples) : renderer_(std::move(renderer)), samples_(samples) {}

    Result<void> render(Frame& frame, FrameFacts* facts, const Snapshot& snapshot, const View& view) override {
        if (facts)
            if (const Result<void> done = renderer_->render(frame, facts, snapshot, view); !done.ok())
                return done.error();
        fine_.resize(frame.width * samples_, frame.height * samples_);
        if (const Result<void> done = renderer_->render(fine_, nullptr, snapshot, finer(view, samples_)); !done.ok())
            return done.error();
        frame.resize(frame.width, frame.height);
        take_means(fine_, samples_, frame);
        frame.is_cut_short = fine_.is_cut_short;
        return {};
    }

    std::vector<ViewportShape> viewports() const override {
        std::vector<ViewportShape> shapes = renderer_->viewports();
        for (ViewportShape& shape : shapes) shrink(shape);
        return shapes;
    }

    std::string_view kernels() const override { return renderer_->kernels(); }

private:
    /// The columns of the picture that begin in it, and their rows.
    void shrink(ViewportShape& shape) const {
        const int first = (shape.begin + samples_ - 1) / samples_, end = (shape.end + samples_ - 1) / samples_;
        std::vector<int> top, bottom;
        for (int x = first; x < end && !shape.top.empty(); ++x) {
            const auto column = static_cast<std::size_t>(x * samples_ - shape.begin);
            top.push_back(shape.top[column] / samples_);
            bottom.push_back(shape.bottom[column] / samples_);
        }
        shape = {shape.sector, shape.depth, first, end, std::move(top), std::move(bottom)};
    }

    std::unique_ptr<Renderer> renderer_;
    int samples_;
    Frame fine_;
};

/// Fog in bands grows by this, so that there are 32 of them [1/256].
constexpr FogPart kFogBand = 8;

/// A map that says of light, fog and links what the dials say, and a renderer made for it.
class WithOwnMap final : public Renderer {
public:
    WithOwnMap(const Map& map, const Dials& dials) : map_(map) {
        if (dials.light != LightSteps::as_map)
            map_.render.light = dials.light == LightSteps::smooth ? LightModel::smooth : LightModel::classic;
        if (dials.fog == FogSteps::bands) map_.render.fog_step = kFogBand;
        map_.render.max_depth = std::min(map_.render.max_depth, dials.links);
    }

    Result<void> make(const RendererChoice& choice, const TextureSet& textures) {
        auto renderer = make_plain(choice, map_, textures);
        if (!renderer.ok()) return renderer.error();
        renderer_ = std::move(renderer).value();
        return {};
    }

    Result<void> render(Frame& frame, FrameFacts* facts, const Snapshot& snapshot, const View& view) override {
        return renderer_->render(frame, facts, snapshot, view);
    }
    std::vector<ViewportShape> viewports() const override { return renderer_->viewports(); }
    std::string_view kernels() const override { return renderer_->kernels(); }

private:
    Map map_;
    std::unique_ptr<Renderer> renderer_;
};

Result<std::unique_ptr<Renderer>> make_dialled(const RendererChoice& choice, const Map& map,
                                               const TextureSet& textures) {
    const Dials& dials = choice.dials;
    const bool needs_own_map =
        dials.light != LightSteps::as_map || dials.fog != FogSteps::smooth || dials.links < map.render.max_depth;
    if (!needs_own_map) return make_plain(choice, map, textures);
    auto renderer = std::make_unique<WithOwnMap>(map, dials);
    if (const Result<void> done = renderer->make(choice, textures); !done.ok()) return done.error();
    return std::unique_ptr<Renderer>(std::move(renderer));
}

}  // namespace

Result<GlPicture> Renderer::render_on_card(int, int, const Snapshot&, const View&) {
    ENFILADE_CHECK(keeps_on_card());
    return Error{"", "this renderer keeps no pictures on a graphics card"};
}

Result<RendererKind> parse_renderer(const std::string& name) {
    const auto& words = kWords<RendererKind>;
    const auto found = std::ranges::find(words, name);
    if (found == words.end())
        return Error{"--renderer", "expected column, stencil or reference; found " + in_quotes(name)};
    return static_cast<RendererKind>(found - words.begin());
}

std::string name_of(RendererKind kind) { return std::string(to_word(kind)); }

Dials dials_for(RendererKind kind, const Dials& dials) {
    Dials some;
    if (kind == RendererKind::column) {
        some = dials;
        some.portals = PortalMethod::exact;
        some.tick_rate = TickRate::hz60;
        some.crossing = CrossingMethod::exact;
        return some;
    }
    some.samples = dials.samples;
    some.light = dials.light;
    some.fog = dials.fog;
    some.light_grid = dials.light_grid;
    some.links = dials.links;
    if (kind == RendererKind::reference) some.sampling = dials.sampling;
    if (kind == RendererKind::stencil) some.portals = dials.portals;
    return some;
}

namespace {

std::string names_of_dials(RendererKind kind) {
    switch (kind) {
        case RendererKind::column: return "accuracy, span, number, sampling, samples, light, fog, light_grid and links";
        case RendererKind::stencil:
            return "samples, light, fog, light_grid, portals and links; the column renderer has more";
        case RendererKind::reference:
            return "sampling, samples, light, fog, light_grid and links; the column renderer has more";
    }
    return {};
}

}  // namespace

Result<void> check_dials(RendererKind kind, const Dials& dials) {
    if (dials.motion() != MotionDials())
        return Error{
            "", "nothing moves in a picture: expected tick_rate and crossing only of `play`, found " + to_text(dials)};
    if (dials != dials_for(kind, dials))
        return Error{"", "the " + name_of(kind) + " renderer cannot draw by " + to_text(dials) + "; it has the dials " +
                             names_of_dials(kind)};
    if (dials.texel_error > 0 && (dials.span > 1 || dials.number != NumberKind::real64))
        return Error{"", "an accuracy is a promise that span and number would break; expected it without them, found " +
                             to_text(dials)};
    return {};
}

Result<std::unique_ptr<Renderer>> make_renderer(const RendererChoice& choice, const Map& map,
                                                const TextureSet& textures) {
    if (const Result<void> valid = check_dials(choice.kind, choice.dials); !valid.ok()) return valid.error();
    auto renderer = make_dialled(choice, map, textures);
    const int samples = choice.dials.samples;
    if (!renderer.ok() || samples == 1) return renderer;
    return std::unique_ptr<Renderer>(std::make_unique<Supersampler>(std::move(renderer).value(), samples));
}

}  // namespace enfilade
