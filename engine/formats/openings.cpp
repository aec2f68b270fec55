// Openings cut walls: each becomes up to three, and what lies between two rooms becomes sectors.
#include <algorithm>
#include <cmath>
#include <map>

#include "formats/expand.h"
#include "formats/map_keys.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

/// Depth of what a linked opening needs room for, where it gives none [m]: a wall's.
constexpr double kUsualDepth = 0.25;

/// Sectors of a door that is lower than its rooms: frame, leaf, frame.
constexpr int kFramedParts = 3;

/// Names of sectors take no more than a wall takes as long as they are not longer together [bytes].
constexpr std::size_t kUsualNames = 256;

/// Names are suggested for so many that are not known: each is compared with all that are.
constexpr int kMostSuggestions = 16;

WallRecord moved(WallRecord wall, Vec2 metres) {
    wall.move_pictures(metres);
    return wall;
}

/// A wall from so many metres behind its beginning on: its pictures go on there.
WallRecord rest_of(const WallRecord& wall, double metres) { return moved(wall, {-metres, 0}); }

double distance(Vec2 a, Vec2 b) { return std::sqrt(dot(b - a, b - a)); }

/// From where a wall of the loop begins to a point of it [m].
double way_along(const LoopRecord& loop, std::size_t wall, Vec2 point) {
    return distance(snap_to_vertex_grid(loop.vertices[wall]), point);
}

struct FlatHeights {
    double floor = 0, ceiling = 0;
};

/// Everything that one opening becomes.
class OpeningCut {
public:
    OpeningCut(Reading& reading, MapFile& map, const OpeningRecord& opening, std::string name, TwoGaps gaps)
        : reading_(reading), map_(map), opening_(opening), name_(std::move(name)), gaps_(gaps) {
        near_wall_ = wall(gaps_.near.wall);
        far_wall_ = wall(gaps_.far.wall);
        near_ = &map_.sectors[gaps_.near.wall.sector];
        far_ = &map_.sectors[gaps_.far.wall.sector];
        near_name_ = near_->name;
        far_name_ = far_->name;
    }

    /// How many sectors lie between; none and a finding where there is no room for what is wanted.
    std::optional<int> parts() const {
        const bool wants_room = opening_.leaf || opening_.steps > 0 || opening_.bottom || opening_.top ||
                                opening_.depth || opening_.places.has("floor") || opening_.places.has("ceiling");
        if (!opening_.to && gaps_.touch) {
            if (!wants_room) return 0;
            reading_.error(opening_.place, "opening-without-depth",
                           "sectors " + in_quotes(near_name_) + " and " + in_quotes(far_name_) +
                               " touch here, and a door, a window, steps, 'bottom', 'top', 'floor' and 'ceiling' need "
                               "room between the two walls; move one of them by the thickness of a wall, as 0.25 m");
            return {};
        }
        if (opening_.to && !wants_room) return 0;
        if (opening_.steps > 0) return opening_.steps;
        return opening_.leaf && opening_.top ? kFramedParts : 1;
    }

    /// Notes what of it lies above or below a room that it leads out of: that part leads nowhere.
    void look_past_rooms() const {
        for (const SectorRecord* room : {near_, far_}) {
            if (room == far_ && opening_.to) continue;  // there, heights are counted from the other floor
            if (opening_.top && *opening_.top > room->ceiling.z)
                warn("top", *opening_.top, "above the ceiling", *room, room->ceiling.z);
            if (opening_.bottom && *opening_.bottom < room->floor.z)
                warn("bottom", *opening_.bottom, "below the floor", *room, room->floor.z);
        }
    }

    /// False where its sectors would have no height.
    bool has_height(int parts) const {
        for (int i = 0; i < parts; ++i)
            if (const FlatHeights heights = heights_of(i, parts);
                !is_leaf(i, parts) && heights.ceiling <= heights.floor) {
                reading_.error(key_place(opening_, opening_.bottom ? "bottom" : "top"), "opening-without-height",
                               "the opening's floor would be at " + number_text(heights.floor) +
                                   " m and its ceiling at " + number_text(heights.ceiling) +
                                   " m; give it a 'bottom' below its 'top'");
                return false;
            }
        return true;
    }

    /// What each of its sectors takes at most, and what is cut of the walls, counted in usual walls.
    std::size_t weight() const {
        std::size_t weight = weight_of(near_wall_) + weight_of(far_wall_) + weight_of(opening_.wall);
        weight += opening_.sector.triggers.size() + opening_.sector.tags.size();
        return 4 * weight + (name_.size() + near_name_.size() + far_name_.size()) / kUsualNames;
    }

    std::vector<SectorRecord> sectors(int parts) const {
        std::vector<SectorRecord> all;
        for (int i = 0; i < parts; ++i) all.push_back(sector(i, parts));
        return all;
    }

    /// The wall that takes the place of the near or the far gap.
    WallRecord near_portal(int parts) const {
        WallRecord portal = outer_portal(gaps_.near, parts > 0 ? part_name(0, parts) : far_name_, is_leaf(0, parts));
        portal.middle = opening_.wall.middle;
        portal.blocks = opening_.wall.blocks;
        if (opening_.to && parts == 0) link(portal, near_link(), far_link());
        return checked(portal);
    }
    WallRecord far_portal(int parts) const {
        const std::string next = parts > 0 ? part_name(parts - 1, parts) : near_name_;
        WallRecord portal = outer_portal(gaps_.far, next, is_leaf(parts - 1, parts));
        if (parts == 0) portal.middle = opening_.wall.middle;
        if (opening_.to) {
            link(portal, far_link(), near_link());
            if (portal.rise) portal.rise = -*portal.rise;
        }
        return checked(portal);
    }

private:
    void warn(std::string_view key, double z, std::string_view where, const SectorRecord& room, double flat) const {
        if (reading_.is_full()) return;
        reading_.findings.push_back({key_place(opening_, key), Severity::warning, "opening-past-room",
                                     in_quotes(key) + ", " + number_text(z) + " m, is " + std::string(where) +
                                         " of sector " + in_quotes(room.name) + ", " + number_text(flat) +
                                         " m: what is beyond it leads nowhere"});
    }

    const LoopRecord& loop_of(WallIndex at) const { return map_.sectors[at.sector].loops[at.loop]; }
    const WallRecord& wall(WallIndex at) const { return loop_of(at).walls[at.wall]; }

    bool is_leaf(int part, int parts) const { return opening_.leaf && parts > 0 && part == parts / 2; }

    std::string part_name(int part, int parts) const {
        if (parts == 1 || is_leaf(part, parts)) return name_;
        return name_ + " " + std::to_string(part + 1);
    }

    // The two walls of a link; in one sector they must not be called alike.
    std::string near_link() const { return name_; }
    std::string far_link() const { return name_ + " (far)"; }

    void link(WallRecord& portal, const std::string& name, const std::string& via) const {
        portal.name = name;
        portal.via = via;
        portal.rise = opening_.wall.rise;
    }

    /// What is seen of an opening from a room: the room's own wall goes on above and below it, unless it says
    /// otherwise.
    WallRecord outer_portal(const Gap& gap, const std::string& next, bool to_leaf) const {
        const WallRecord& cut = wall(gap.wall);
        WallRecord portal = rest_of(cut, way_along(loop_of(gap.wall), gap.wall.wall, gap.begin));
        portal.next = next;
        portal.mirror = false;
        portal.triggers.clear();
        portal.doom.reset();
        portal.upper_peg = portal.lower_peg = cut.texture_peg;
        dress(portal, to_leaf);
        portal.place = opening_.place;
        portal.places = opening_.places;
        return portal;
    }

    void dress(WallRecord& portal, bool to_leaf) const {
        const WallRecord& given = opening_.wall;
        const auto give = [&](std::optional<TextureSpec>& to, const std::optional<TextureSpec>& from, Peg& peg,
                              Peg usual) {
            if (!from) return;
            to = from;
            peg = usual;
            if (given.size) portal.size = given.size;
        };
        give(portal.upper, to_leaf ? opening_.leaf : given.upper, portal.upper_peg, Peg::opening_top);
        give(portal.lower, given.lower, portal.lower_peg, Peg::opening_bottom);
    }

    /// The walls inside: to its sides, and its own steps.
    WallRecord inner_wall(bool in_leaf) const {
        WallRecord side;
        const bool is_own = opening_.wall.texture.has_value();
        side.texture = is_own ? opening_.wall.texture : near_wall_.texture;
        side.size = is_own ? opening_.wall.size : near_wall_.size;
        side.texture_peg = in_leaf ? Peg::floor : Peg::ceiling;
        side.place = opening_.place;
        side.places = opening_.places;
        return side;
    }

    WallRecord inner_portal(const std::string& next, bool to_leaf) const {
        WallRecord portal = inner_wall(false);
        portal.next = next;
        dress(portal, to_leaf);
        return checked(portal);
    }

    /// A size in texels per metre excludes one in metres, also where the two come together only now.
    WallRecord checked(WallRecord wall) const {
        for (const auto* spec : {&wall.texture, &wall.upper, &wall.lower, &wall.middle})
            if (wall.size && *spec && (*spec)->tile_m) {
                refuse_tile_and_size(reading_, **spec);
                wall.size.reset();
            }
        return wall;
    }

    FlatHeights heights_of(int part, int parts) const {
        const FlatHeights here{near_->floor.z, near_->ceiling.z};
        FlatHeights there{far_->floor.z, far_->ceiling.z};
        if (opening_.to) there = {here.floor, here.floor + there.ceiling - there.floor};  // floor meets floor
        FlatHeights heights{std::max(here.floor, there.floor), std::min(here.ceiling, there.ceiling)};
        if (opening_.steps > 0) {
            const double way = double(part + 1) / (parts + 1);
            heights = {here.floor + (there.floor - here.floor) * way,
                       here.ceiling + (there.ceiling - here.ceiling) * way};
        }
        heights.floor = opening_.bottom.value_or(heights.floor);
        heights.ceiling = opening_.top.value_or(heights.ceiling);
        if (is_leaf(part, parts)) heights.ceiling = heights.floor;
        return heights;
    }

    /// A floor or ceiling as the author wants it, or else as in the first room that has one under a roof.
    FlatRecord flat(FlatRecord own, FlatRecord SectorRecord::* which, double z) const {
        if (!own.texture) {
            const FlatRecord &here = near_->*which, &there = far_->*which;
            const FlatRecord& like = here.parallax ? there : here;
            own.texture = like.parallax ? inner_wall(false).texture : like.texture;
            if (!own.size) own.size = like.parallax ? inner_wall(false).size : like.size;
            if (own.size && own.texture && own.texture->tile_m) own.size.reset();
        }
        if (own.place.line == 0) own.place = opening_.place;
        own.z = z;
        return own;
    }

    SectorRecord sector(int part, int parts) const {
        SectorRecord made = opening_.sector;
        const FlatHeights heights = heights_of(part, parts);
        made.name = part_name(part, parts);
        made.floor = flat(opening_.sector.floor, &SectorRecord::floor, heights.floor);
        made.ceiling = flat(opening_.sector.ceiling, &SectorRecord::ceiling, heights.ceiling);
        if (!opening_.places.has("light")) made.light = near_->light;
        if (opening_.leaf && !is_leaf(part, parts)) made.triggers.clear();
        if (is_leaf(part, parts) && !opening_.places.has("triggers")) made.triggers = {usual_door()};
        made.secret = opening_.sector.secret && part == 0;
        made.loops = {loop(part, parts)};
        made.place = opening_.place;
        made.places = opening_.places;
        return made;
    }

    TriggerRecord usual_door() const {
        TriggerRecord trigger;
        trigger.on = Activation::use;
        trigger.action = TriggerAction::door;
        trigger.place = opening_.place;
        return trigger;
    }

    /// Where the boundary before a part is, on the side of the near gap's beginning or end.
    Vec2 boundary(int part, int parts, bool at_begin) const {
        const Vec2 from = at_begin ? gaps_.near.begin : gaps_.near.end;
        if (opening_.to) return from + snap_to_vertex_grid(outward() * (double(part) / parts));
        const Vec2 to = at_begin ? gaps_.far.end : gaps_.far.begin;
        if (part == parts) return to;
        return snap_to_vertex_grid(from + (to - from) * (double(part) / parts));
    }

    /// Away from the first room, as far as the opening of a link is deep.
    Vec2 outward() const {
        const Vec2 along = gaps_.near.end - gaps_.near.begin;
        return -right_of(along) * (opening_.depth.value_or(kUsualDepth) / std::sqrt(dot(along, along)));
    }

    /// A wall to the side, whose picture goes on along all parts, however high they are.
    WallRecord side(int part, int parts, bool at_begin) const {
        const Vec2 from = boundary(at_begin ? 0 : parts, parts, at_begin);
        const double way = distance(from, boundary(at_begin ? part : part + 1, parts, at_begin));
        const double peg = heights_of(part, parts).ceiling - heights_of(0, parts).ceiling;
        return moved(inner_wall(is_leaf(part, parts)), {-way, peg});
    }

    LoopRecord loop(int part, int parts) const {
        LoopRecord made;
        made.place = opening_.place;
        made.vertices = {boundary(part, parts, false), boundary(part, parts, true), boundary(part + 1, parts, true),
                         boundary(part + 1, parts, false)};
        made.vertex_places.assign(made.vertices.size(), opening_.place);
        const bool is_first = part == 0, is_last = part + 1 == parts;
        WallRecord back =
            inner_portal(is_first ? near_name_ : part_name(part - 1, parts), !is_first && is_leaf(part - 1, parts));
        WallRecord on =
            inner_portal(is_last ? far_name_ : part_name(part + 1, parts), !is_last && is_leaf(part + 1, parts));
        if (is_first) back.middle = opening_.wall.middle;
        if (is_last && opening_.to) link(on, near_link(), far_link());
        made.walls = {checked(back), side(part, parts, true), checked(on), side(part, parts, false)};
        return made;
    }

    Reading& reading_;
    const MapFile& map_;
    const OpeningRecord& opening_;
    std::string name_;
    TwoGaps gaps_;
    WallRecord near_wall_, far_wall_;
    const SectorRecord *near_ = nullptr, *far_ = nullptr;
    std::string near_name_, far_name_;
};

/// Puts the portal into the gap; what is left of the wall stays on either side. Returns how many walls there are more.
std::size_t cut(MapFile& map, const Gap& gap, WallRecord portal, TextPlace place) {
    LoopRecord& loop = map.sectors[gap.wall.sector].loops[gap.wall.loop];
    const std::size_t at = gap.wall.wall, next = (at + 1) % loop.vertices.size();
    const bool has_before = snap_to_vertex_grid(loop.vertices[at]) != gap.begin;
    const bool has_after = snap_to_vertex_grid(loop.vertices[next]) != gap.end;
    const auto insert = [&](std::size_t index, Vec2 vertex, WallRecord wall) {
        loop.vertices.insert(loop.vertices.begin() + std::ptrdiff_t(index), vertex);
        loop.vertex_places.insert(loop.vertex_places.begin() + std::ptrdiff_t(index), place);
        loop.walls.insert(loop.walls.begin() + std::ptrdiff_t(index), std::move(wall));
    };
    if (has_after) insert(at + 1, gap.end, rest_of(loop.walls[at], way_along(loop, at, gap.end)));
    if (has_before)
        insert(at + 1, gap.begin, std::move(portal));
    else
        loop.walls[at] = std::move(portal);
    return std::size_t(has_before) + std::size_t(has_after);
}

/// All openings of a map, one after the other: a later one may cut what an earlier one left.
class Openings {
public:
    Openings(Reading& reading, Expansion& expansion, MapFile& map)
        : reading_(reading), expansion_(expansion), map_(map), gaps_(reading, map) {
        for (std::size_t i = 0; i < map_.sectors.size(); ++i) sectors_.try_emplace(map_.sectors[i].name, i);
        has_unknown_ = sectors_.contains("");
    }

    void cut_all() {
        const std::vector<OpeningRecord> openings = std::move(map_.openings);
        map_.openings.clear();
        for (const OpeningRecord& opening : openings)
            if ((!opening.places.is_sound() || !cut_one(opening)) && !reading_.is_full()) leave_unknown(opening);
    }

private:
    std::optional<std::size_t> sector_of(const OpeningRecord& opening, const std::string& name) {
        const auto found = sectors_.find(name);
        if (found != sectors_.end()) return found->second;
        if (has_unknown_) return {};
        std::vector<std::string_view> known;
        if (++unknown_ <= kMostSuggestions)
            for (const auto& [known_name, index] : sectors_) known.push_back(known_name);
        reading_.error(key_place(opening, "between"), "unknown-sector",
                       "there is no sector " + in_quotes(name) + nearest_suggestion(name, known));
        return {};
    }

    /// What the opening is called: as it says, or after its rooms, and then as no other sector.
    std::string name_of(const OpeningRecord& opening) {
        if (!opening.sector.name.empty()) return opening.sector.name;
        const std::string rooms = opening.between[0] + "-" + opening.between[1];
        for (;;) {
            const int number = ++numbers_[rooms];
            std::string name = number == 1 ? rooms : rooms + " (" + std::to_string(number) + ")";
            if (!sectors_.contains(name)) return name;
        }
    }

    /// In the place of sectors that could not be made: whoever names what is not there may have meant one of them.
    void leave_unknown(const OpeningRecord& opening) {
        map_.sectors.emplace_back().place = opening.place;
        has_unknown_ = true;
    }

    /// False where something is wrong with it, which was noted.
    bool cut_one(const OpeningRecord& opening) {
        const auto near = sector_of(opening, opening.between[0]);
        const auto far = sector_of(opening, opening.between[1]);
        if (!near || !far) return false;
        const auto gaps = gaps_.find(opening, *near, *far);
        if (!gaps) return false;
        const std::string name = name_of(opening);
        const OpeningCut made(reading_, map_, opening, name, *gaps);
        const auto parts = made.parts();
        if (!parts || !made.has_height(*parts)) return false;
        made.look_past_rooms();
        if (!expansion_.take(std::size_t(*parts + 1) * made.weight(), opening.place)) return false;
        const std::vector<SectorRecord> between = made.sectors(*parts);
        const WallRecord near_portal = made.near_portal(*parts), far_portal = made.far_portal(*parts);
        put_in(opening, *gaps, near_portal, far_portal);
        for (const SectorRecord& sector : between) {
            sectors_.try_emplace(sector.name, map_.sectors.size());
            map_.sectors.push_back(sector);
        }
        return true;
    }

    /// The second gap may be in a wall behind the first of the same loop, or in what the first cut leaves of its wall.
    void put_in(const OpeningRecord& opening, const TwoGaps& gaps, const WallRecord& near_portal,
                const WallRecord& far_portal) {
        const std::size_t more = cut(map_, gaps.near, near_portal, opening.place);
        Gap far = gaps.far;
        const WallIndex &a = gaps.near.wall, &b = gaps.far.wall;
        if (a.sector == b.sector && a.loop == b.loop) {
            if (b.wall > a.wall) far.wall.wall += more;
            if (b.wall == a.wall) {
                const auto again = gaps_.around(opening, b.sector, *opening.to, {}, key_place(opening, "to"));
                if (!again) return;
                far = *again;
            }
        }
        cut(map_, far, far_portal, opening.place);
    }

    Reading& reading_;
    Expansion& expansion_;
    MapFile& map_;
    GapFinder gaps_;
    std::map<std::string, std::size_t> sectors_;
    std::map<std::string, int> numbers_;  ///< how many openings are called after two rooms
    bool has_unknown_ = false;            ///< there are sectors whose names are not known
    int unknown_ = 0;
};

}  // namespace

void cut_openings(Reading& reading, Expansion& expansion, MapFile& map) {
    if (!map.openings.empty()) Openings(reading, expansion, map).cut_all();
}

}  // namespace enfilade
