#include "wadconv/parts.h"

#include <algorithm>
#include <optional>

namespace enfilade::wadconv {
namespace {

std::string sector_name(std::size_t sector) { return "sector " + std::to_string(sector); }

Error cannot_close(std::size_t sector, const std::vector<OpenEnd>& ends) {
    const Point p = ends.front().point;
    return {"", sector_name(sector) + " is not closed: its lines end in " + std::to_string(ends.size()) +
                    " open points, the first at (" + std::to_string(p.x) + ", " + std::to_string(-p.y) +
                    "); a gap of one line can be closed, this cannot"};
}

Error inside_out(std::size_t sector, const Edge& edge) {
    return {"", sector_name(sector) + " is inside out: the loop with line " + std::to_string(edge.line) +
                    " is a hole that lies in no outline of the sector"};
}

Error tangled(std::size_t sector) { return {"", sector_name(sector) + " is bounded by lines that cross each other"}; }

/// The middle of an edge, in fine steps.
Point middle_of(const Edge& e) { return {(e.a.x + e.b.x) * (kFineSteps / 2), (e.a.y + e.b.y) * (kFineSteps / 2)}; }

bool box_contains(const Part& part, Point fine) {
    const Point min = to_fine(part.min), max = to_fine(part.max);
    return min.x <= fine.x && fine.x <= max.x && min.y <= fine.y && fine.y <= max.y;
}

/// Whether the outline goes around the loop. A hole never shares an edge with an outline around it, so its edges'
/// middles lie strictly inside or outside; the areas tell it from the outlines that fill it.
bool goes_around(const std::vector<Edge>& edges, const Part& part, const Loop& hole) {
    if (part.loops[0].double_area <= -hole.double_area) return false;
    const Point middle = middle_of(edges[hole.edges[0]]);
    return box_contains(part, middle) && loop_contains(edges, part.loops[0], middle);
}

/// The candidate with the smallest outline that goes around the hole, or null.
Part* smallest_around(const std::vector<Edge>& edges, std::span<Part> candidates, const Loop& hole) {
    Part* best = nullptr;
    for (Part& part : candidates)
        if (goes_around(edges, part, hole) &&
            (best == nullptr || part.loops[0].double_area < best->loops[0].double_area))
            best = &part;
    return best;
}

Part part_from(const std::vector<Edge>& edges, std::uint32_t sector, Loop outline) {
    Part part;
    part.sector = sector;
    part.min = part.max = edges[outline.edges[0]].a;
    for (std::uint32_t e : outline.edges) {
        const Point p = edges[e].a;
        part.min = {std::min(part.min.x, p.x), std::min(part.min.y, p.y)};
        part.max = {std::max(part.max.x, p.x), std::max(part.max.y, p.y)};
    }
    part.loops.push_back(std::move(outline));
    return part;
}

/// One sector, traced and put together.
struct SectorParts {
    std::vector<Part> parts;
    std::vector<Loop> orphans;  ///< holes that lie in no outline of the sector
    std::vector<std::uint32_t> lone;
};

/// Turns all sectors of a map into parts.
class PartMaker {
public:
    PartMaker(std::vector<Edge> edges, std::size_t sector_count, Report& report)
        : report_(report), own_(sector_count), sectors_(sector_count) {
        all_.edges = std::move(edges);
        for (std::uint32_t e = 0; e < all_.edges.size(); ++e) own_[all_.edges[e].sector].push_back(e);
    }

    Result<Parts> make() {
        for (std::uint32_t s = 0; s < own_.size(); ++s)
            if (const Result<void> done = make_sector(s); !done.ok()) return done.error();
        for (std::uint32_t s = 0; s < own_.size(); ++s)
            if (const Result<void> done = house_orphans(s); !done.ok()) return done.error();
        for (std::uint32_t s = 0; s < own_.size(); ++s) lose_clashing_parts(s);
        for (std::uint32_t s = 0; s < own_.size(); ++s) take(s);
        std::ranges::sort(all_.lone);
        std::ranges::sort(all_.lost);
        all_.lost.erase(std::ranges::unique(all_.lost).begin(), all_.lost.end());
        return std::move(all_);
    }

private:
    Result<void> make_sector(std::uint32_t sector) {
        Tracing tracing = trace_loops(all_.edges, own_[sector]);
        if (!tracing.open_ends.empty()) {
            if (!close_gap(sector, tracing.open_ends)) return cannot_close(sector, tracing.open_ends);
            tracing = trace_loops(all_.edges, own_[sector]);
        }
        if (tracing.is_tangled) return lose_sector(sector, tangled(sector));
        SectorParts& made = sectors_[sector] = {};
        made.lone = std::move(tracing.lone);
        for (Loop& loop : tracing.loops) {
            if (loop.double_area == 0) return lose_sector(sector, tangled(sector));
            if (loop.is_outline()) made.parts.push_back(part_from(all_.edges, sector, std::move(loop)));
        }
        for (Loop& loop : tracing.loops)
            if (!loop.edges.empty() && !loop.is_outline()) give_hole(made, std::move(loop));
        return {};
    }

    void give_hole(SectorParts& made, Loop hole) {
        if (Part* part = smallest_around(all_.edges, made.parts, hole))
            part->loops.push_back(std::move(hole));
        else
            made.orphans.push_back(std::move(hole));
    }

    /// A gap of one edge: one point where an edge is missing that would leave, one where it would arrive.
    bool close_gap(std::uint32_t sector, const std::vector<OpenEnd>& ends) {
        if (ends.size() != 2 || ends[0].surplus * ends[1].surplus != -1) return false;
        Edge edge;
        edge.sector = sector;
        edge.a = ends[0].surplus < 0 ? ends[0].point : ends[1].point;
        edge.b = ends[0].surplus < 0 ? ends[1].point : ends[0].point;
        own_[sector].push_back(static_cast<std::uint32_t>(all_.edges.size()));
        all_.edges.push_back(edge);
        report_.note(Kind::closed_gap, sector);
        return true;
    }

    /// Deep water: the outside of each orphan goes to the sector it lies in.
    Result<void> house_orphans(std::uint32_t sector) {
        for (const Loop& orphan : std::vector<Loop>(sectors_[sector].orphans)) {
            const Edge first = all_.edges[orphan.edges[0]];
            const std::optional<std::uint32_t> host = host_of(sector, orphan);
            if (!host) return lose_sector(sector, inside_out(sector, first));
            for (std::uint32_t e : orphan.edges) {
                all_.edges[e].sector = *host;
                report_.note(Kind::deep_water, all_.edges[e].line);
            }
            std::erase_if(own_[sector], [&](std::uint32_t e) { return all_.edges[e].sector != sector; });
            own_[*host].insert(own_[*host].end(), orphan.edges.begin(), orphan.edges.end());
            std::ranges::sort(own_[*host]);
            if (const Result<void> done = make_sector(*host); !done.ok()) return done.error();
        }
        sectors_[sector].orphans.clear();
        return {};
    }

    /// The sector with the smallest outline around the orphan, provided that the orphan has its own sector inside.
    std::optional<std::uint32_t> host_of(std::uint32_t sector, const Loop& orphan) {
        for (std::uint32_t e : orphan.edges)
            if (const std::uint32_t o = all_.edges[e].opposite; o == kNone || all_.edges[o].sector != sector) return {};
        const Part* best = nullptr;
        for (SectorParts& candidate : sectors_) {
            const Part* part = smallest_around(all_.edges, candidate.parts, orphan);
            if (part && part->sector != sector && (!best || part->loops[0].double_area < best->loops[0].double_area))
                best = part;
        }
        return best ? std::optional(best->sector) : std::nullopt;
    }

    /// Leaves the whole sector out for lines that cross; the error where none do.
    Result<void> lose_sector(std::uint32_t sector, const Error& error) {
        if (!lose_if_clashing(sector, own_[sector])) return error;
        sectors_[sector] = {};
        return {};
    }

    void lose_clashing_parts(std::uint32_t sector) {
        std::erase_if(sectors_[sector].parts, [&](const Part& part) {
            std::vector<std::uint32_t> own;
            for (const Loop& loop : part.loops) own.insert(own.end(), loop.edges.begin(), loop.edges.end());
            return lose_if_clashing(sector, own);
        });
    }

    /// Leaves out the room that these edges bound if lines of them cross, and closes the doorways into it.
    bool lose_if_clashing(std::uint32_t sector, std::span<const std::uint32_t> edges) {
        const std::vector<std::uint32_t> lines = clashing_lines(all_.edges, edges);
        if (lines.empty()) return false;
        all_.lost.push_back(sector);
        report_.note(Kind::lost_room, sector);
        for (const std::uint32_t line : lines) report_.note(Kind::clashing_line, line);
        for (const std::uint32_t e : edges) {
            Edge& edge = all_.edges[e];
            if (edge.line != kNone) ++report_.sides.dropped;
            if (!edge.is_open) continue;
            edge.is_open = all_.edges[edge.opposite].is_open = false;
            all_.edges[edge.opposite].was_open = true;
            report_.note(Kind::closed_doorway, edge.line);
        }
        return true;
    }

    void take(std::uint32_t sector) {
        SectorParts& made = sectors_[sector];
        if (own_[sector].empty()) report_.note(Kind::unused_sector, sector);
        if (made.parts.size() > 1) report_.note(Kind::split_sector, sector);
        all_.part_of_edge.resize(all_.edges.size(), kNone);
        all_.count_of.push_back(static_cast<std::uint32_t>(made.parts.size()));
        std::uint32_t number = 0;
        for (Part& part : made.parts) {
            part.number = number++;
            for (const Loop& loop : part.loops)
                for (std::uint32_t e : loop.edges) all_.part_of_edge[e] = static_cast<std::uint32_t>(all_.parts.size());
            all_.parts.push_back(std::move(part));
        }
        all_.lone.insert(all_.lone.end(), made.lone.begin(), made.lone.end());
    }

    Report& report_;
    Parts all_;
    std::vector<std::vector<std::uint32_t>> own_;  // edges of each sector, rising
    std::vector<SectorParts> sectors_;
};

}  // namespace

Result<Parts> make_parts(std::vector<Edge> edges, std::size_t sector_count, Report& report) {
    return PartMaker(std::move(edges), sector_count, report).make();
}

std::string part_name(const Part& part) {
    std::string letters;
    for (std::uint32_t n = part.number + 1; part.number > 0 && n > 0; n = (n - 1) / 26)
        letters.insert(letters.begin(), static_cast<char>('a' + (n - 1) % 26));
    return "s" + std::to_string(part.sector) + letters;
}

std::int64_t double_area(const Part& part) {
    std::int64_t area = 0;
    for (const Loop& loop : part.loops) area += loop.double_area;
    return area;
}

bool contains(const Parts& parts, const Part& part, Point fine) {
    if (!box_contains(part, fine)) return false;
    bool inside = false;
    for (const Loop& loop : part.loops) inside ^= loop_contains(parts.edges, loop, fine);
    return inside;
}

std::uint32_t part_at(const Parts& parts, Point fine) {
    for (std::uint32_t i = 0; i < parts.parts.size(); ++i)
        if (contains(parts, parts.parts[i], fine)) return i;
    return kNone;
}

}  // namespace enfilade::wadconv
