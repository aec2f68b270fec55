#include "app/viewing.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/exit_codes.h"
#include "base/files.h"
#include "base/terminal.h"
#include "formats/quoted.h"
#include "formats/table_text.h"
#include "math/grid.h"
#include "space/locate.h"

namespace enfilade {
namespace {

Result<SectorId> sector_named(const Map& map, const std::string& name) {
    const auto found = std::ranges::find(map.sectors, name, &Sector::name);
    if (found == map.sectors.end()) {
        std::vector<std::string_view> known;
        for (const Sector& sector : map.sectors) known.push_back(sector.name);
        return Error{"", "the map has no sector named " + quoted(name) + nearest_suggestion(name, known)};
    }
    return SectorId(std::size_t(found - map.sectors.begin()));
}

Result<SectorId> sector_of(const Map& map, const ViewRow& row, Vec2 eye) {
    if (row.sector.empty()) {
        const SectorId found = locate(map, eye);
        if (found) return found;
        return Error{"",
                     fmt::format("expected a view inside the map; no sector holds the point ({}, {})", eye.x, eye.y)};
    }
    auto named = sector_named(map, row.sector);
    if (named.ok() && !contains(map, named.value(), eye))
        return Error{"", fmt::format("sector {} does not hold the point ({}, {}); give a point inside it, or leave "
                                     "the sector out to have it found",
                                     enfilade::quoted(row.sector), eye.x, eye.y)};
    return named;
}

View looking(Vec2 forward, double pitch_degrees, const Lens& lens) {
    View view;
    view.forward = forward;
    const Angle pitch = Angle::from_degrees(pitch_degrees);
    if (lens.true_pitch)
        view.tilt = Tilt{direction(pitch), direction(Angle::from_degrees(lens.roll_degrees))};
    else
        view.pitch_tangent = tangent(pitch);
    view.fov_degrees = lens.fov_degrees;
    view.stretch = lens.stretch;
    return view;
}

}  // namespace

std::optional<std::vector<ViewRow>> open_views(const std::string& path) {
    const auto bytes = read_file(path);
    if (!bytes.ok()) {
        fail(bytes.error());
        return {};
    }
    ViewsReading reading = read_views(as_text(bytes.value()));
    for (const Finding& finding : reading.findings) print_text(stderr, to_text(path, finding) + "\n");
    if (has_errors(reading.findings)) return {};
    return std::move(reading.views);
}

Result<View> view_from(const Map& map, const ViewRow& row, const Lens& lens) {
    View view = looking(direction(Angle::from_degrees(row.yaw_degrees)), row.pitch_degrees, lens);
    view.eye = snap_to_point_grid(Vec2{row.x, row.y});
    view.eye_z = row.z;
    const auto sector = sector_of(map, row, view.eye);
    if (!sector.ok()) return sector.error();
    view.sector = sector.value();
    return view;
}

std::optional<std::string> hidden_eye(const Map& map, const Snapshot& snapshot, const View& view) {
    const Heights room = heights_at(snapshot, view.sector);
    if (view.eye_z > room.floor_z && view.eye_z < room.ceiling_z) return {};
    const bool is_above = view.eye_z >= room.ceiling_z;
    return fmt::format("the eye at z = {} is {} of sector {} at {} m", number_text(view.eye_z),
                       is_above ? "not below the ceiling" : "not above the floor", quoted(map[view.sector].name),
                       number_text(is_above ? room.ceiling_z : room.floor_z));
}

Result<View> view_at_start(const Map& map, const Lens& lens) {
    if (!map.player) return Error{"", "the map has no player to look from; give a place with --view X,Y,Z,YAW,PITCH"};
    View view = looking(direction(map.player->yaw), 0, lens);
    view.sector = map.player->sector;
    view.eye = map.player->position;
    view.eye_z = map.player->eye_z;
    return view;
}

Status refuse_true_pitch(RendererKind renderer, bool wanted) {
    if (!wanted || renderer != RendererKind::column) return {};
    return Error{"--true-pitch",
                 "the column renderer draws upright columns and can only shift the horizon; add --renderer stencil or "
                 "--renderer reference"};
}

}  // namespace enfilade
