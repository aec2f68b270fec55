#include "app/accuracy/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>

#include "base/hash.h"
#include "formats/words.h"
#include "platform/clock.h"
#include "platform/gl_context.h"
#include "render/choice/renderer.h"
#include "render/reference/reference_renderer.h"
#include "render/sampling.h"
#include "space/trace.h"

namespace enfilade {
namespace {

constexpr std::uint64_t kLooksSeed = 1;
constexpr double kMostSlant = 60;       ///< from the way straight through [degrees]
constexpr double kEyeAboveFloor = 1.5;  ///< or halfway up a lower portal [m]
constexpr int kTries = 1000;            ///< for each place

/// A look through a link of a map.
struct PortalLook {
    std::size_t map = 0;
    View view;
};

std::vector<WallId> links_of(const Map& map) {
    std::vector<WallId> links;
    for (std::uint32_t w = 0; w < map.walls.size(); ++w) {
        const Wall& wall = map.walls[w];
        if (wall.kind == WallKind::portal && wall.link != Wall::kNoLink && wall.length > 0.5)
            links.push_back(WallId(w));
    }
    return links;
}

/// From here one walks to where the eye is to be, through plain doorways: doors have frames [m].
constexpr double kClose = 0.001;

/// Before a portal that is open; maybe none.
std::optional<View> look_through(const Map& map, const Snapshot& snapshot, WallId id, double distance, Random& random) {
    const Wall& wall = map[id];
    const Vec2 out = -right_of(wall.b - wall.a) * (1 / wall.length);
    const Vec2 on_it = wall.a + (wall.b - wall.a) * random.uniform(0.1, 0.9);
    const Place close{wall.sector, snap_to_point_grid(on_it - out * std::min(distance, kClose))};
    if (!contains(map, close.sector, close.point)) return {};
    const Trace way = trace(map, close, snap_to_point_grid(on_it - out * distance));
    if (way.is_stopped() || way.passage != Rigid()) return {};
    View view;
    view.sector = way.end.sector;
    view.eye = way.end.point;
    view.forward = direction(angle_of(out) + Angle::from_degrees(random.uniform(-kMostSlant, kMostSlant)));
    const SectorSnapshot &here = snapshot[wall.sector], &there = snapshot[wall.behind];
    const double rise = map.passage(wall).rise;
    const double floor_z = std::max(here.floor_z, there.floor_z - rise);
    const double ceiling_z = std::min(here.ceiling_z, there.ceiling_z - rise);
    view.eye_z = std::min(floor_z + kEyeAboveFloor, (floor_z + ceiling_z) / 2);
    if (ceiling_z <= floor_z) return {};
    return view;
}

std::vector<PortalLook> looks_from(const std::vector<OpenMap>& maps, double distance, std::size_t count) {
    Random random(kLooksSeed);
    std::vector<PortalLook> looks;
    for (int tries = 0; tries < kTries && looks.size() < count; ++tries) {
        const std::size_t number = static_cast<std::size_t>(tries) % maps.size();
        const Map& map = maps[number].map;
        const std::vector<WallId> links = links_of(map);
        if (links.empty()) continue;
        const WallId link = links[random.below(links.size())];
        if (const auto view = look_through(map, at_rest(map), link, distance, random)) looks.push_back({number, *view});
    }
    std::ranges::stable_sort(looks, {}, &PortalLook::map);
    return looks;
}

/// A picture with its surfaces.
struct JudgedLook {
    Frame frame;
    FrameFacts facts;

    explicit JudgedLook(const PortalPlan& plan) {
        frame.resize(plan.width, plan.height);
        reset(facts, plan.width, plan.height);
    }
};

/// Holds the pictures of one look against the true one.
class PortalJudge {
public:
    PortalJudge(const OpenMap& map, const Snapshot& snapshot, const View& view, const PortalPlan& plan)
        : map_(map), snapshot_(snapshot), view_(view), truth_(plan) {
        render_reference(truth_.frame, &truth_.facts, map.map, map.textures, snapshot, view);
    }

    void judge(const JudgedLook& drawn, PortalErrors& errors) const {
        for (int y = 0; y < truth_.frame.height; ++y)
            for (int x = 0; x < truth_.frame.width; ++x) {
                const std::size_t i = index_of(x, y);
                ++errors.pixels;
                const PixelSurface id = drawn.facts.ids[i];
                if (id == truth_.facts.ids[i]) continue;
                ++(id == kNothing ? errors.unwritten : is_beside(x, y, id) ? errors.at_edges : errors.elsewhere);
            }
    }

private:
    /// Rays in a pixel and those around it that are asked for what is thinner than a pixel, by column and row.
    static constexpr int kRaysPerPixel = 51, kRayStep = 6;

    /// Far floors are thinner still: graphics cards put their edges on a grid of this, upright [px].
    static constexpr int kCardRowsPerPixel = 256;

    std::size_t index_of(int x, int y) const { return static_cast<std::size_t>(y * truth_.frame.width + x); }

    /// Whether the true picture shows the surface within a pixel.
    bool is_beside(int x, int y, PixelSurface id) const {
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, truth_.frame.height - 1); ++v)
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, truth_.frame.width - 1); ++u)
                if (truth_.facts.ids[index_of(u, v)] == id) return true;
        const int middle_x = kRaysPerPixel * x + kRaysPerPixel / 2, middle_y = kRaysPerPixel * y + kRaysPerPixel / 2;
        for (int v = -kRaysPerPixel; v <= kRaysPerPixel; v += kRayStep)
            for (int u = -kRaysPerPixel; u <= kRaysPerPixel; u += kRayStep)
                if (id_at(middle_x + u, middle_y + v) == id) return true;
        for (int rows = -kCardRowsPerPixel; rows <= kCardRowsPerPixel; ++rows)
            if (id_above(x, y, rows) == id) return true;
        return false;
    }

    /// So many rows of the card above the middle of a pixel, for which the picture is moved down by as many.
    PixelSurface id_above(int x, int y, int rows) const {
        const int width = truth_.frame.width, height = truth_.frame.height;
        View moved = view_;
        moved.pitch_tangent += rows / (kCardRowsPerPixel * Projection(view_, width, height).focal_y());
        return look_through_pixel(map_.map, map_.textures, snapshot_, moved, width, height, x, y).id;
    }

    PixelSurface id_at(int x, int y) const {
        const int width = truth_.frame.width * kRaysPerPixel, height = truth_.frame.height * kRaysPerPixel;
        if (x < 0 || x >= width || y < 0 || y >= height) return kNothing;
        const View view = finer(view_, kRaysPerPixel);
        return look_through_pixel(map_.map, map_.textures, snapshot_, view, width, height, x, y).id;
    }

    const OpenMap& map_;
    const Snapshot& snapshot_;
    const View& view_;
    JudgedLook truth_;
};

/// The stencil renderer of each map by each method, and what comes of them.
class PortalTrial {
public:
    PortalTrial(const std::vector<OpenMap>& maps, const PortalPlan& plan) : maps_(maps), plan_(plan) {}

    Result<std::vector<PortalErrorRow>> run() {
        std::vector<PortalErrorRow> rows;
        for (const double distance : kPortalDistances) {
            const std::vector<PortalLook> looks = looks_from(maps_, distance, plan_.views);
            if (looks.empty()) return rows;
            std::vector<PortalErrorRow> there;
            for (const PortalMethod method : kMethods) there.push_back({method, distance, {}, 0});
            for (const PortalLook& look : looks)
                if (const Result<void> done = try_methods(look, there); !done.ok()) return done.error();
            for (auto row = there.rbegin(); row != there.rend(); ++row) row->time_ratio /= there.front().time_ratio;
            rows.insert(rows.end(), there.begin(), there.end());
        }
        std::ranges::stable_sort(rows, {}, &PortalErrorRow::method);
        return rows;
    }

private:
    static constexpr std::array kMethods{PortalMethod::exact, PortalMethod::plane24, PortalMethod::plane32,
                                         PortalMethod::oblique24, PortalMethod::oblique32};

    Result<void> try_methods(const PortalLook& look, std::vector<PortalErrorRow>& rows) {
        if (const Result<void> done = make_renderers(look.map); !done.ok()) return done.error();
        const Snapshot snapshot = at_rest(maps_[look.map].map);
        const PortalJudge judge(maps_[look.map], snapshot, look.view, plan_);
        for (std::size_t m = 0; m < rows.size(); ++m) {
            JudgedLook drawn(plan_);
            if (const Result<void> done = renderers_[m]->render(drawn.frame, &drawn.facts, snapshot, look.view);
                !done.ok())
                return done.error();
            judge.judge(drawn, rows[m].errors);
        }
        return time_methods(snapshot, look.view, rows);
    }

    /// In turn, so that whatever else the machine does is no method's fault.
    Result<void> time_methods(const Snapshot& snapshot, const View& view, std::vector<PortalErrorRow>& rows) {
        Frame frame;
        frame.resize(plan_.width, plan_.height);
        std::vector<std::int64_t> least_ns(rows.size(), std::numeric_limits<std::int64_t>::max());
        for (int round = 0; round < plan_.rounds; ++round)
            for (std::size_t m = 0; m < rows.size(); ++m) {
                const std::int64_t began = now_ns();
                if (const Result<void> done = renderers_[m]->render(frame, nullptr, snapshot, view); !done.ok())
                    return done.error();
                least_ns[m] = std::min(least_ns[m], now_ns() - began);
            }
        for (std::size_t m = 0; m < rows.size(); ++m) rows[m].time_ratio += static_cast<double>(least_ns[m]);
        return {};
    }

    /// Only those of one map at a time.
    Result<void> make_renderers(std::size_t map) {
        if (made_for_ == map) return {};
        renderers_.clear();
        for (const PortalMethod method : kMethods) {
            Dials dials;
            dials.portals = method;
            auto renderer = make_renderer({RendererKind::stencil, dials, 1, open_gl_for_pictures}, maps_[map].map,
                                          maps_[map].textures);
            if (!renderer.ok()) return renderer.error();
            renderers_.push_back(std::move(renderer).value());
        }
        made_for_ = map;
        return {};
    }

    const std::vector<OpenMap>& maps_;
    PortalPlan plan_;
    std::vector<std::unique_ptr<Renderer>> renderers_;
    std::optional<std::size_t> made_for_;
};

double ppm(std::uint64_t some, std::uint64_t all) {
    return all > 0 ? 1e6 * static_cast<double>(some) / static_cast<double>(all) : 0;
}

}  // namespace

Result<std::vector<PortalErrorRow>> measure_portals(const std::vector<OpenMap>& maps, const PortalPlan& plan) {
    return PortalTrial(maps, plan).run();
}

std::string portal_page(const Result<std::vector<PortalErrorRow>>& rows) {
    std::string text =
        "\n## Portals by the graphics card\n\nThe stencil renderer puts walls in order on the CPU, exactly. Most "
        "engines "
        "that draw portals leave that to depths, and cut off what is behind a portal by its plane, or by a near plane "
        "that is moved into it (dial `portals`). Looks through links, up to 60 degrees aslant, held against the "
        "reference: pixels of a million that show another surface, at an edge (it is there within a pixel) or "
        "elsewhere, or "
        "nothing.\n\n";
    if (!rows.ok()) return text + "There is no OpenGL here that can do it: " + rows.error().text() + "\n";
    text +=
        "| portals | eye to portal [m] | pixels | elsewhere | nothing | at edges | time, exact = 1 |\n"
        "|---|---:|---:|---:|---:|---:|---:|\n";
    for (const PortalErrorRow& row : rows.value())
        text += fmt::format("| `{}` | {} | {} | {:.1f} | {:.1f} | {:.1f} | {:.2f} |\n", to_word(row.method),
                            row.distance_m, row.errors.pixels, ppm(row.errors.elsewhere, row.errors.pixels),
                            ppm(row.errors.unwritten, row.errors.pixels), ppm(row.errors.at_edges, row.errors.pixels),
                            row.time_ratio);
    return text;
}

Result<void> check_portals(const std::vector<PortalErrorRow>& rows) {
    for (const PortalErrorRow& row : rows)
        if (row.method == PortalMethod::exact && row.errors.elsewhere + row.errors.unwritten > 0)
            return Error{
                "portals by the graphics card",
                fmt::format("expected surfaces that are there or right beside it; {} pixels of {}, {} m before "
                            "a portal, show something else, {} nothing",
                            row.errors.elsewhere, row.errors.pixels, row.distance_m, row.errors.unwritten)};
    return {};
}

}  // namespace enfilade
