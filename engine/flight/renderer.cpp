#include "flight/renderer.h"

#include "render/column/strips.h"
#include "render/reference/reference_renderer.h"

namespace enfilade {
namespace {

class Column final : public Renderer {
public:
    explicit Column(std::size_t threads) : strips_(threads) {}

    void render(Frame& frame, FrameFacts* facts, const Map& map, const TextureSet& textures, const Snapshot& snapshot,
                const View& view) override {
        strips_.render(frame, facts, map, textures, snapshot, view);
    }

    std::vector<ViewportShape> viewports() const override {
        std::vector<ViewportShape> shapes;
        for (const ColumnRenderer& strip : strips_.renderers())
            for (ViewportOutline& outline : strip.viewports())
                shapes.push_back({outline.sector, outline.depth, outline.begin, outline.end, std::move(outline.top),
                                  std::move(outline.bottom)});
        return shapes;
    }

private:
    ColumnStrips strips_;
};

class Reference final : public Renderer {
public:
    explicit Reference(std::size_t threads) : threads_(threads) {}

    void render(Frame& frame, FrameFacts* facts, const Map& map, const TextureSet& textures, const Snapshot& snapshot,
                const View& view) override {
        render_reference(frame, facts, map, textures, snapshot, view, {.workers = static_cast<int>(threads_)});
    }

private:
    std::size_t threads_;
};

}  // namespace

Result<RendererKind> parse_renderer(const std::string& name) {
    if (name == "column") return RendererKind::column;
    if (name == "reference") return RendererKind::reference;
    if (name == "stencil") return Error{"--renderer", "the stencil renderer is not there yet; use column or reference"};
    return Error{"--renderer", "expected column or reference; found '" + name + "'"};
}

std::string name_of(RendererKind kind) { return kind == RendererKind::column ? "column" : "reference"; }

std::unique_ptr<Renderer> make_renderer(RendererKind kind, std::size_t threads) {
    if (kind == RendererKind::reference) return std::make_unique<Reference>(threads);
    return std::make_unique<Column>(threads);
}

}  // namespace enfilade
