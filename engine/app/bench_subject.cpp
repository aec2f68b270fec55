#include "app/bench_subject.h"

#include "app/exit_codes.h"
#include "app/viewing.h"
#include "base/files.h"
#include "formats/script_toml.h"
#include "world/deed.h"

namespace enfilade {
namespace {

constexpr double kUsualFov = 90;  ///< [degrees], as `render` has it
constexpr std::string_view kWalkEnding = ".csv";

std::optional<std::vector<View>> views_of_walk(const Map& map, const std::string& path) {
    const auto rows = open_views(path);
    if (!rows) return {};
    std::vector<View> views;
    for (const ViewRow& row : *rows) {
        const auto view = view_from(map, row, {kUsualFov, map.render.stretch});
        if (!view.ok()) {
            fail({path + ":" + std::to_string(row.line), view.error().what});
            return {};
        }
        views.push_back(view.value());
    }
    if (views.empty()) {
        fail({path, "expected at least one view to measure; the list has none"});
        return {};
    }
    return views;
}

std::optional<std::vector<View>> view_of_player(const Map& map, const std::string& path) {
    const auto view = view_at_start(map, {kUsualFov, map.render.stretch});
    if (view.ok()) return std::vector{view.value()};
    fail({path, "the map has no player to look from; give it a walk: " + path + ":WALK.csv"});
    return {};
}

Snapshot at_the_start(const Map& map) {
    Snapshot snapshot = at_rest(map);
    const History history = begun(map);
    show({map, history, 0}, snapshot);
    return snapshot;
}

bool names_script(const std::string& path) {
    const auto bytes = read_file(path);
    return bytes.ok() && is_script(as_text(bytes.value()));
}

}  // namespace

std::optional<WalkName> walk_name(const std::string& name) {
    if (!name.ends_with(kWalkEnding)) return {};
    const std::size_t colon = name.rfind(':');
    if (colon == std::string::npos) return {};
    return WalkName{name.substr(0, colon), name.substr(colon + 1)};
}

std::optional<BenchSubject> BenchSubject::open(const std::string& name,
                                               const std::vector<std::string>& texture_folders) {
    BenchSubject subject;
    const auto walk = walk_name(name);
    if (!walk && name.ends_with(kWalkEnding)) {
        fail({name, "expected MAP:WALK.csv, for a list of views does not say of which map they are"});
        return {};
    }
    if (!walk && names_script(name)) {
        subject.flight_ = open_flight(name, texture_folders, kUsualSkill);
        return subject.flight_ ? std::optional(std::move(subject)) : std::nullopt;
    }
    subject.map_ = open_map(walk ? walk->map : name, texture_folders, kUsualSkill);
    if (!subject.map_) return {};
    auto views = walk ? views_of_walk(subject.map(), walk->views) : view_of_player(subject.map(), name);
    if (!views) return {};
    subject.views_ = std::move(*views);
    subject.snapshot_ = at_the_start(subject.map());
    return subject;
}

FlightFrame BenchSubject::frame(int number) const {
    return flight_ ? flight_->flight.at(map(), number)
                   : FlightFrame{views_[static_cast<std::size_t>(number)], snapshot_};
}

}  // namespace enfilade
