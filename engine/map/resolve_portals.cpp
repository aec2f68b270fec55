// Portals: which sector each leads into, and which of its walls one comes out of.
#include <algorithm>
#include <vector>

#include "formats/text_parts.h"
#include "map/draft.h"
#include "map/names.h"
#include "map/say.h"
#include "map/twins.h"

namespace enfilade {
namespace {

NameIndex sector_names(const Draft& draft) {
    std::vector<ScopedName> names;
    names.reserve(draft.map.sectors.size());
    for (std::uint32_t i = 0; i < draft.map.sectors.size(); ++i) names.push_back({0, draft.map.sectors[i].name, i});
    return NameIndex(std::move(names));
}

NameIndex wall_names(const Draft& draft) {
    std::vector<ScopedName> names;
    for (std::uint32_t i = 0; i < draft.walls.size(); ++i)
        if (!draft.walls[i].record->name.empty())
            names.push_back({draft.map.walls[i].sector.index, draft.walls[i].record->name, i});
    return NameIndex(std::move(names));
}

/// One pass over all portals with the indexes it needs.
class Resolver {
public:
    explicit Resolver(Draft& draft)
        : draft_(draft), sectors_(sector_names(draft)), walls_(wall_names(draft)), twins_(draft.map) {}

    void resolve(WallId id) {
        const WallRecord& record = *draft_.walls[id.index].record;
        refuse_stray_rise(id);
        if (record.mirror) return resolve_mirror(id);
        if (record.next.empty()) return refuse_stray_link(id);
        Wall& wall = draft_.map.walls[id.index];
        wall.behind = sector_behind(id);
        if (wall.behind.is_none() || !draft_.sectors[wall.behind.index].measurable) return;
        if (!draft_.sectors[wall.sector.index].measurable) return;
        wall.kind = WallKind::portal;
        if (record.via.empty())
            wall.exit = twin_of(id);
        else
            wall.exit = named_exit(id);
    }

private:
    void resolve_mirror(WallId id) {
        Wall& wall = draft_.map.walls[id.index];
        const WallDraft& written = draft_.walls[id.index];
        if (!written.record->next.empty() || !written.record->via.empty())
            draft_.error(std::max(key_place(*written.record, "mirror"), key_place(*written.record, "next")),
                         "mirror-portal", "a wall is a mirror or a portal, this one is both; drop mirror or next");
        wall.kind = WallKind::mirror;
        wall.behind = wall.sector;
        wall.exit = id;
    }

    /// What only a link can have.
    void refuse_stray_rise(WallId id) {
        const WallDraft& written = draft_.walls[id.index];
        if (written.record->rise && written.record->via.empty())
            draft_.error(*written.record, "rise", "rise-without-via",
                         "rise is what a link adds to heights, but this wall has no via; drop rise, or name the wall "
                         "to come out of in via");
    }

    void refuse_stray_link(WallId id) {
        const WallDraft& written = draft_.walls[id.index];
        if (!written.record->via.empty())
            draft_.error(*written.record, "via", "via-without-next",
                         "via names a wall of the sector in next, but there is no next; add next = \"its sector\"");
    }

    SectorId sector_behind(WallId id) {
        const WallDraft& written = draft_.walls[id.index];
        const std::string& name = written.record->next;
        if (const auto found = sectors_.find(0, name)) return SectorId(*found);
        if (draft_.has_nameless_sectors) return {};
        draft_.error(*written.record, "next", "unknown-sector",
                     "expected the name of a sector in next, found " + quoted(name) + sectors_.suggestion(0, name));
        return {};
    }

    WallId named_exit(WallId id) {
        const SectorId behind = draft_.map[id].behind;
        const WallDraft& written = draft_.walls[id.index];
        const std::string& name = written.record->via;
        if (const auto found = walls_.find(behind.index, name)) return WallId(*found);
        draft_.error(*written.record, "via", "unknown-wall",
                     "expected the name of a wall of sector " + quoted(draft_.map[behind].name) + " in via, found " +
                         quoted(name) + walls_.suggestion(behind.index, name));
        return {};
    }

    WallId twin_of(WallId id) {
        const Wall& wall = draft_.map[id];
        if (const WallId twin = twins_.find(wall.behind, wall.a, wall.b)) return twin;
        // The tutorial never looks at the neighbour's edge; one that is longer still takes whoever passes in.
        const WallId longer = draft_.is_strict() ? WallId() : twins_.covering(wall.behind, wall.a, wall.b);
        if (draft_.sectors[wall.behind.index].is_only_one) report_missing_twin(id, longer);
        return longer;
    }

    void report_missing_twin(WallId id, WallId longer) {
        const Wall& wall = draft_.map[id];
        const std::string& behind = draft_.map[wall.behind].name;
        std::string sentence = "expected an edge " + edge_text(wall.b, wall.a) + " in sector " + quoted(behind) +
                               ", which this portal leads into, found none";
        if (twins_.find(wall.behind, wall.b, wall.a))
            sentence += "; it has that edge the same way round, so both sectors lie on one side of it";
        else if (const WallId near = twins_.nearest(wall.behind, wall.a, wall.b))
            sentence += "; its nearest edge is " + edge_text(draft_.map[near].a, draft_.map[near].b);
        sentence += "; give both sectors the same vertices, or link the walls by name with via";
        if (longer)
            draft_.warning(draft_.walls[id.index].place, "missing-twin", std::move(sentence));
        else
            draft_.error(draft_.walls[id.index].place, "missing-twin", std::move(sentence));
    }

    Draft& draft_;
    NameIndex sectors_, walls_;
    TwinIndex twins_;
};

/// What keeps a wall from leaving a way back; empty: nothing does.
std::string fault_of_way_back(const Draft& draft, WallId id) {
    const Wall& wall = draft.map[id];
    if (wall.kind != WallKind::portal)
        return "way_back is for portals, and this wall is none; give it next, or drop way_back";
    const Wall& exit = draft.map[wall.exit];
    const std::string there = "the wall one comes out of, in sector " + quoted(draft.map[wall.behind].name) + ", ";
    if (draft.walls[id.index].record->blocks) return "nobody passes a wall that blocks; drop blocks or way_back";
    if (exit.exit == id) return there + "leads back already; drop way_back here, or next there";
    if (exit.kind == WallKind::way_back)
        return there + "is the way back to another wall; let each of the two have a wall of its own to come out of";
    if (exit.kind != WallKind::solid || !draft.walls[wall.exit.index].record->next.empty())
        return there + "must be a plain wall to become a way back; drop its next or its mirror, or way_back here";
    if (draft.walls[id.index].record->via.empty() && (exit.a != wall.b || exit.b != wall.a))
        return there + "is longer than this one; cut it at the ends of this wall";
    return {};
}

void make_way_back(Draft& draft, WallId id) {
    const WallRecord& record = *draft.walls[id.index].record;
    const Wall& wall = draft.map[id];
    // A portal whose other end was not found has been reported as that.
    if (!record.way_back || !record.places.is_sound() ||
        (wall.kind == WallKind::portal ? !wall.exit : !record.next.empty()))
        return;
    if (std::string fault = fault_of_way_back(draft, id); !fault.empty())
        return draft.error(record, "way_back", "no-way-back", std::move(fault));
    Wall& exit = draft.map.walls[wall.exit.index];
    exit.kind = WallKind::way_back;
    exit.behind = wall.sector;
    exit.exit = id;
    draft.map.has_ways_back = true;
}

/// A room that opens onto the solid wall of its neighbour: one gets in, and not back.
void check_open_one_way(Draft& draft, WallId id) {
    const Wall& wall = draft.map[id];
    if (wall.kind != WallKind::portal || !wall.exit || !draft.walls[id.index].record->via.empty()) return;
    const Wall& exit = draft.map[wall.exit];
    const WallDraft &written = draft.walls[wall.exit.index], &from = draft.walls[id.index];
    if (exit.kind != WallKind::solid || !written.record->next.empty() || exit.a != wall.b) return;
    const std::string here = quoted(draft.map[wall.sector].name);
    const std::string line = from.place.line != 0 ? " in line " + std::to_string(from.place.line) : std::string();
    draft.warning(known(written.record->place, written.place), "open-one-way",
                  "sector " + here + " opens onto this edge " + edge_text(exit.a, exit.b) + " of sector " +
                      quoted(draft.map[exit.sector].name) + line +
                      ", but from here it is a solid wall: one looks and gets in there, and not back; give it next = " +
                      here + ", or if that is meant, name this wall and add via there");
}

/// What blocks one way blocks the way back.
void block(Draft& draft, WallId id) {
    Wall& wall = draft.map.walls[id.index];
    if (wall.kind != WallKind::portal || !draft.walls[id.index].record->blocks) return;
    wall.blocks = true;
    if (wall.exit && draft.map[wall.exit].exit == id) draft.map.walls[wall.exit.index].blocks = true;
}

}  // namespace

void resolve_portals(Draft& draft) {
    Resolver resolver(draft);
    for (std::size_t i = 0; i < draft.map.walls.size(); ++i) resolver.resolve(WallId(i));
    for (std::size_t i = 0; i < draft.map.walls.size(); ++i) make_way_back(draft, WallId(i));
    for (std::size_t i = 0; i < draft.map.walls.size(); ++i) check_open_one_way(draft, WallId(i));
    for (std::size_t i = 0; i < draft.map.walls.size(); ++i) block(draft, WallId(i));
}

}  // namespace enfilade
