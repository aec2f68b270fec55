#include "app/accuracy/motion.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/bench.h"
#include "map/load.h"
#include "platform/clock.h"

namespace enfilade {

SectorRecord plain_room(std::string name, std::vector<Vec2> outline, const std::vector<std::string>& behind) {
    constexpr double kCeiling = 3;
    const TextureSpec picture{"plain", {}, {}, {}};
    SectorRecord room;
    room.name = std::move(name);
    room.ceiling.z = kCeiling;
    room.floor.texture = room.ceiling.texture = picture;
    LoopRecord loop;
    loop.walls.resize(outline.size());
    for (std::size_t i = 0; i < outline.size(); ++i) {
        loop.walls[i].texture = picture;
        if (i < behind.size()) loop.walls[i].next = behind[i];
    }
    loop.vertices = std::move(outline);
    room.loops.push_back(std::move(loop));
    return room;
}

Map plain_map(std::vector<SectorRecord> rooms) {
    MapFile file;
    file.format = 1;
    file.name = "motion";
    file.sectors = std::move(rooms);
    Findings findings;
    const TextureSet textures = load_textures(
        file, {}, [](const std::string& path) { return Error{path, "no picture is looked at"}; }, findings);
    std::optional<Map> map = build_map(file, textures, findings);
    ENFILADE_CHECK(map.has_value());
    return std::move(*map);
}

std::vector<MotionPrice> prices_in_turn(const std::vector<std::function<void()>>& ways, std::uint64_t count,
                                        std::size_t rounds) {
    std::vector<std::vector<std::int64_t>> times(ways.size());
    for (std::size_t round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < ways.size(); ++i) {
            const std::int64_t began_ns = now_ns();
            ways[i]();
            times[i].push_back(now_ns() - began_ns);
        }
    std::vector<MotionPrice> prices;
    for (std::vector<std::int64_t>& of_way : times) {
        const auto least = static_cast<double>(*std::ranges::min_element(of_way));
        prices.push_back(
            {least / static_cast<double>(count), static_cast<double>(median_of(of_way)) / static_cast<double>(count)});
    }
    return prices;
}

namespace {

constexpr std::string_view kEngine = "engine";

std::string drift_table(const std::vector<DriftRow>& rows) {
    std::string text =
        "| link turned by | way | passes | position off [m] | heading off [rad] | back to the same bits [%] | ns a "
        "pass, least | median |\n"
        "|---|---|---:|---:|---:|---:|---:|---:|\n";
    for (const DriftRow& row : rows)
        text += fmt::format("| {} | {} | {} | {:.1e} | {:.1e} | {:.1f} | {:.2f} | {:.2f} |\n", row.link, row.way,
                            row.passes, row.position_m, row.heading_rad, 100 * row.same_again, row.price.least_ns,
                            row.price.median_ns);
    return text;
}

std::string crossing_table(const std::vector<CrossingRow>& rows) {
    std::string text =
        "| ticks of a second | way | moves | into another room | wrong room | ppm | on a line, other side | "
        "ns a move, least | median |\n"
        "|---:|---|---:|---:|---:|---:|---:|---:|---:|\n";
    for (const CrossingRow& row : rows)
        text += fmt::format("| {} | {} | {} | {} | {} | {:.0f} | {} | {:.1f} | {:.1f} |\n", row.rate_hz, row.way,
                            row.moves, row.crossings, row.wrong, row.wrong_ppm(), row.on_line, row.price.least_ns,
                            row.price.median_ns);
    return text;
}

}  // namespace

std::string motion_page(const std::vector<DriftRow>& drifts, const std::vector<CrossingRow>& crossings) {
    return "Drift through links, against numbers of 113 bits: the largest so far.\n\n" + drift_table(drifts) +
           "\nRooms at the end of a tick's move at up to 8 m/s, half of the legs through corners.\n\n" +
           crossing_table(crossings);
}

std::string motion_csv(const std::vector<DriftRow>& drifts, const std::vector<CrossingRow>& crossings) {
    std::string text = "link,way,passes,position_m,heading_rad,same_again,ns_least,ns_median\n";
    for (const DriftRow& row : drifts)
        text += fmt::format("{},\"{}\",{},{:.6e},{:.6e},{:.6f},{:.3f},{:.3f}\n", row.link, row.way, row.passes,
                            row.position_m, row.heading_rad, row.same_again, row.price.least_ns, row.price.median_ns);
    text += "rate_hz,way,moves,crossings,wrong,on_line,ns_least,ns_median\n";
    for (const CrossingRow& row : crossings)
        text += fmt::format("{},\"{}\",{},{},{},{},{:.3f},{:.3f}\n", row.rate_hz, row.way, row.moves, row.crossings,
                            row.wrong, row.on_line, row.price.least_ns, row.price.median_ns);
    return text;
}

Result<void> check_motion(const std::vector<DriftRow>& drifts, const std::vector<CrossingRow>& crossings) {
    for (const DriftRow& row : drifts) {
        const double most_m = most_drift_m(row.passes), most_rad = most_drift_rad(row.passes);
        if (row.way == kEngine && row.same_again != 1)
            return Error{row.link + ", engine",
                         fmt::format("expected everyone who goes back and comes again to be where he was, to the bit; "
                                     "found {:.4f} of them",
                                     row.same_again)};
        if (row.way == kEngine && !(row.position_m <= most_m && row.heading_rad <= most_rad))
            return Error{
                row.link + ", engine",
                fmt::format("expected to drift by at most {:.1e} m and {:.1e} rad in {} passes; found {:.1e} m "
                            "and {:.1e} rad",
                            most_m, most_rad, row.passes, row.position_m, row.heading_rad)};
    }
    for (const CrossingRow& row : crossings)
        if (row.way == kEngine && row.wrong + row.on_line != 0)
            return Error{fmt::format("{} ticks of a second, engine", row.rate_hz),
                         fmt::format("expected every move to end in the room that its place is in; of {} moves {} do "
                                     "not",
                                     row.moves, row.wrong + row.on_line)};
    return {};
}

}  // namespace enfilade
