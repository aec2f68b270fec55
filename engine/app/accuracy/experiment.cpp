#include "app/accuracy/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/messages.h"
#include "base/hash.h"
#include "formats/text_parts.h"
#include "math/predicates.h"
#include "space/trace.h"

namespace enfilade {
std::vector<AccuracySetting> accuracy_settings(bool is_quick) {
    std::vector<AccuracySetting> settings{{{}, {}, 0}};
    for (const double texels : {1e-6, 1e-4, 0.01, 0.1, 0.25, 0.5, 1.0, 4.0}) settings.push_back(promise_of(texels));
    for (const char* dial : {"span=4", "span=8", "span=16", "span=32", "number=float", "number=fixed", "number=vanilla",
                             "sampling=mip", "sampling=bilinear", "sampling=trilinear", "samples=2", "samples=4",
                             "light=bands", "light=smooth", "links=4"})
        settings.push_back(dial_of(dial));
    if (is_quick)
        std::erase_if(settings, [](const AccuracySetting& s) { return s.dials.samples > 2 || s.promise == 1e-4; });
    return settings;
}

AccuracySetting promise_of(double texels) {
    AccuracySetting setting{{"--accuracy", number_text(texels)}, {}, texels};
    setting.dials.texel_error = texels;
    return setting;
}

AccuracySetting dial_of(const std::string& text) {
    AccuracySetting setting{{"--dial", text}, {}, 0};
    ENFILADE_CHECK(set_dial(setting.dials, text).ok());
    return setting;
}

RendererChoice one_thread(const Dials& dials) {
    RendererChoice choice;
    choice.dials = dials;
    return choice;
}

std::string name_of(const AccuracySetting& setting) {
    return setting.options.empty() ? "exact" : fmt::format("{}", fmt::join(setting.options, " "));
}

std::string_view name_of(PoseKind kind) { return kind == PoseKind::random ? "random" : "lattice"; }

std::vector<View> poses_in(const Map& map, PoseKind kind, std::size_t count, std::uint64_t seed) {
    constexpr double kLattice = 0.5, kEighth = 45, kLeastRoom = 0.25, kMostPitch = 30;
    Random random(seed + static_cast<std::uint64_t>(kind));
    std::vector<View> views;
    while (views.size() < count) {
        View view;
        view.sector = SectorId(random.below(map.sectors.size()));
        const Sector& sector = map[view.sector];
        view.eye = {random.uniform(sector.min.x, sector.max.x), random.uniform(sector.min.y, sector.max.y)};
        const double room = sector.ceiling.z - sector.floor.z;
        if (kind == PoseKind::lattice)
            view.eye = {std::round(view.eye.x / kLattice) * kLattice, std::round(view.eye.y / kLattice) * kLattice};
        view.eye = snap_to_point_grid(view.eye);
        const double degrees =
            kind == PoseKind::lattice ? kEighth * static_cast<double>(random.below(8)) : random.uniform(-180, 180);
        const double part = kind == PoseKind::lattice ? 0.5 : random.uniform(0.1, 0.9);
        if (kind == PoseKind::random)
            view.pitch_tangent = tangent(Angle::from_degrees(random.uniform(-kMostPitch, kMostPitch)));
        if (room < kLeastRoom || !contains(map, view.sector, view.eye)) continue;
        view.eye_z = sector.floor.z + part * room;
        view.forward = direction(Angle::from_degrees(degrees));
        view.stretch = map.render.stretch;
        view.ray_offset = ray_offset(map.render.rays);
        views.push_back(view);
    }
    return views;
}

std::string views_csv(const std::vector<View>& views) {
    constexpr double kDegrees = 180 / 3.14159265358979323846;
    std::string text = "x,y,z,yaw,pitch\n";
    for (const View& view : views)
        text += fmt::format("{},{},{},{},{}\n", view.eye.x, view.eye.y, view.eye_z, angle_of(view.forward).degrees(),
                            std::atan(view.pitch_tangent) * kDegrees);
    return text;
}

}  // namespace enfilade
