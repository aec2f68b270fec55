#include "space/hearing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace enfilade {
namespace {

/// Longer than any way [m].
constexpr double kFarAway = std::numeric_limits<double>::infinity();

/// By how much sums of lengths may be wrong, and far more: what is left out for being longer is longer.
constexpr double kRounding = 1e-9;

/// Between two boxes, 0 where they meet [m].
double gap(Vec2 min, Vec2 max, Vec2 other_min, Vec2 other_max) {
    const double x = std::max({0.0, other_min.x - max.x, min.x - other_max.x});
    const double y = std::max({0.0, other_min.y - max.y, min.y - other_max.y});
    return std::sqrt(x * x + y * y);
}

}  // namespace

Hearing::Hearing(const Map& map) : map_(map), tiling_(map), roots_(map.walls.size()) {
    for (SoundField* field : {&heard_, &field_}) {
        field->latest.resize(tiling_.tile_count());
        field->touched.resize(map.sectors.size());
        field->beams.reserve(kMostBeams);  // grown while somebody listens, all would be moved within one tick
    }
    waiting_.reserve(kMostBeams);
}

void Hearing::listen(const Place& listener, double reach_m, const MayPass& may_pass, std::size_t slice) {
    if (!is_under_way_) {
        is_seeking_ = false;
        sought_.clear();
        begin(listener, reach_m, may_pass);
    }
    follow(may_pass, slice);
}

void Hearing::listen(const Place& listener, std::span<const SoundSource> sources, const MayPass& may_pass,
                     std::size_t slice) {
    if (!is_under_way_) {
        is_seeking_ = true;
        const double reach_m = seek(sources, listener);
        begin(listener, reach_m, may_pass);
    }
    follow(may_pass, slice);
}

void Hearing::begin(const Place& listener, double reach_m, const MayPass& may_pass) {
    is_under_way_ = true;
    may_pass_ = may_pass;
    field_.listening = ++listening_;
    field_.listener = listener;
    field_.reach_m = reach_m;
    field_.beams.clear();
    field_.ways.clear();
    field_.own_tile = tiling_.find(map_, listener.sector, listener.point);
    if (field_.own_tile == Tiling::kNone) return;
    for (Sought& sought : sought_)
        if (sought.tile == field_.own_tile)
            sought.nearest = straight_way(listener.point, *sought.source.point).length_m;
        else if (!sought.source.point && map_[sought.source.sector].leader == map_[listener.sector].leader)
            sought.nearest = 0;
    look_around();
}

void Hearing::follow(const MayPass& may_pass, std::size_t slice) {
    may_pass_ = may_pass;
    double least = 0;
    for (std::size_t i = 0; i < slice && is_under_way_; ++i) {
        if (waiting_.empty() || field_.beams.size() >= kMostBeams || (is_seeking_ && is_all_found(least)))
            end();
        else
            least = follow_nearest();
    }
    may_pass_ = {};  // the caller's
}

/// What was found is heard from now on.
void Hearing::end() {
    is_under_way_ = false;
    waiting_.clear();
    field_.sectors.assign(1, field_.listener.sector);
    for (const Touched& touched : field_.ways)
        if (touched.sector != field_.listener.sector) field_.sectors.push_back(touched.sector);
    std::sort(field_.sectors.begin(), field_.sectors.end());
    std::swap(heard_, field_);
}

void Hearing::forget() {
    is_under_way_ = false;
    waiting_.clear();
    heard_.listening = ++listening_;  // so that no entry is its own
    heard_.own_tile = kNone;
    heard_.sectors.clear();
}

/// Fills sought_. A straight line is the shortest way there could be, but for links. The longest reach that is left.
double Hearing::seek(std::span<const SoundSource> sources, const Place& listener) {
    double reach_m = 0;
    sought_.clear();
    for (const SoundSource& source : sources) {
        const Sought sought = sought_as(source);
        const bool is_far = gap(listener.point, listener.point, sought.min, sought.max) >= source.reach_m;
        if (is_far && map_.links.empty()) continue;
        reach_m = std::max(reach_m, source.reach_m);
        sought_.push_back(sought);
    }
    return reach_m;
}

Hearing::Sought Hearing::sought_as(const SoundSource& source) const {
    if (source.point) {
        const Vec2 point = *source.point;
        return {source, point, point, tiling_.find(map_, source.sector, point), kFarAway};
    }
    Sought sought{source, map_[source.sector].min, map_[source.sector].max, kNone, kFarAway};
    each_of_group(map_, source.sector, [&](SectorId member) {
        sought.min = {std::min(sought.min.x, map_[member].min.x), std::min(sought.min.y, map_[member].min.y)};
        sought.max = {std::max(sought.max.x, map_[member].max.x), std::max(sought.max.y, map_[member].max.y)};
    });
    return sought;
}

/// Whether what is sought may lie behind the edge, on a shorter way than is known; `least` is that of any way over it.
bool Hearing::may_lead_to_sought(const Beam& beam, std::uint32_t edge, double least) const {
    if (!map_.links.empty()) return true;
    const Vec2 a = start_of(edge), b = end_of(edge);
    const Vec2 low{std::min(a.x, b.x), std::min(a.y, b.y)}, high{std::max(a.x, b.x), std::max(a.y, b.y)};
    return std::ranges::any_of(sought_, [&](const Sought& sought) {
        const double most = std::min(sought.source.reach_m, sought.nearest) * (1 + kRounding);
        return least + gap(low, high, sought.min, sought.max) <= most &&
               beam.length + gap(beam.root, beam.root, sought.min, sought.max) <= most;
    });
}

bool Hearing::is_all_found(double least) const {
    return std::ranges::all_of(sought_, [&](const Sought& sought) { return sought.nearest * (1 + kRounding) < least; });
}

std::optional<SoundWay> Hearing::from(const Place& source) const {
    std::optional<SoundWay> best;
    const auto take = [&](const SoundWay& way) {
        if (way.length_m < heard_.reach_m && (!best || way.length_m < best->length_m)) best = way;
    };
    for (std::uint32_t tile = 0; (tile = tiling_.find(map_, source.sector, source.point, tile)) != Tiling::kNone;
         ++tile) {
        if (tile == heard_.own_tile) take(straight_way(heard_.listener.point, source.point));
        for (std::uint32_t i = heard_.number(heard_.latest[tile]); i != kNone; i = heard_.beams[i].earlier)
            if (const auto way = way_into(heard_, heard_.beams[i], source.point)) take(*way);
    }
    return best;
}

std::optional<SoundWay> Hearing::from(SectorId sector) const {
    std::optional<SoundWay> shortest;
    each_of_group(map_, sector, [&](SectorId member) {
        const std::optional<SoundWay> way = from_part(member);
        if (way && (!shortest || way->length_m < shortest->length_m)) shortest = way;
    });
    return shortest;
}

std::optional<SoundWay> Hearing::from_part(SectorId sector) const {
    if (heard_.own_tile != kNone && sector == heard_.listener.sector) return SoundWay{};
    const std::uint32_t number = heard_.number(heard_.touched[sector.index]);
    if (number == kNone) return {};
    return heard_.ways[number].way;
}

}  // namespace enfilade
