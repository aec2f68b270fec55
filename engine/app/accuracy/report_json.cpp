// The report for programs: written, and read again.
#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/accuracy/report.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

using Json = nlohmann::ordered_json;

std::string processor() {
    constexpr std::string_view kName = "model name";
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with(kName) && line.find(": ") != line.npos) return line.substr(line.find(": ") + 2);
    return "not known";
}

// The fields of errors and prices, once for both ways. `field(name, value)`.

template <class Errors, class Field>
void each_error(Errors& e, const Field& field) {
    field("pixels", e.pixels);
    field("wrong_ids", e.wrong_ids);
    field("unwritten", e.unwritten);
    field("written_more", e.written_more);
    field("judged", e.judged);
    field("wrong_texels", e.wrong_texels);
    field("broken", e.broken);
    field("beyond", e.beyond);
    field("mean", e.mean);
    field("per_mille", e.per_mille);
    field("largest", e.largest);
    field("psnr_db", e.psnr);
    field("ssim", e.ssim);
    field("shimmer_turned", e.shimmer_turned);
    field("shimmer_stepped", e.shimmer_stepped);
}

template <class Price, class Field>
void each_price(Price& p, const Field& field) {
    field("minimum_ns", p.minimum_ns);
    field("median_ns", p.median_ns);
    field("low_ratio", p.low_ratio);
    field("high_ratio", p.high_ratio);
}

Json json_of(const AccuracyErrors& errors) {
    Json json;
    each_error(errors, [&](const char* name, auto value) { json[name] = value; });
    return json;
}

Json json_of(const AccuracyPrice& price) {
    Json json;
    each_price(price, [&](const char* name, double value) { json[name] = value; });
    if (price.instructions) json["instructions"] = *price.instructions;
    return json;
}

Json json_of(const AccuracyScene& scene) {
    Json rows = Json::array();
    for (const AccuracyRow& row : scene.rows) {
        std::string command =
            fmt::format("enfilade bench {0}.toml:views/{0}.csv --threads 1 --size 1280x800 --instructions", scene.name);
        for (const std::string& option : row.setting.options) command += " " + option;
        rows.push_back({{"poses", name_of(row.poses)},
                        {"setting", name_of(row.setting)},
                        {"promise", row.setting.promise},
                        {"errors", json_of(row.errors)},
                        {"price", json_of(row.price)},
                        {"command", command}});
    }
    return {{"name", scene.name}, {"map_hash", fmt::format("{:016x}", scene.map_hash)}, {"rows", rows}};
}

std::uint64_t hash_in(const Json& json) { return std::stoull(json.get<std::string>(), nullptr, 16); }

/// Throws where anything is missing or another thing.
AccuracyRow row_of(const Json& json, const std::vector<AccuracySetting>& settings) {
    AccuracyRow row;
    const auto poses =
        std::ranges::find(kPoseKinds, json.at("poses").get<std::string>(), [](PoseKind kind) { return name_of(kind); });
    const auto setting = std::ranges::find(settings, json.at("setting").get<std::string>(),
                                           [](const AccuracySetting& s) { return name_of(s); });
    if (poses == kPoseKinds.end() || setting == settings.end())
        throw std::invalid_argument("unknown poses or setting " + json.at("setting").get<std::string>());
    row.poses = *poses;
    row.setting = *setting;
    const Json &errors = json.at("errors"), &price = json.at("price");
    each_error(row.errors, [&](const char* name, auto& value) { errors.at(name).get_to(value); });
    each_price(row.price, [&](const char* name, double& value) { price.at(name).get_to(value); });
    if (price.contains("instructions")) row.price.instructions = price["instructions"].get<double>();
    return row;
}

bool are_equal(const AccuracyErrors& a, const AccuracyErrors& b) { return json_of(a) == json_of(b); }

Status compare_rows(const std::string& where, const AccuracyScene& report, const AccuracyScene& scene) {
    for (std::size_t i = 0; i < scene.rows.size(); ++i) {
        const AccuracyRow& row = scene.rows[i];
        const auto same = std::ranges::find_if(report.rows, [&](const AccuracyRow& other) {
            return other.poses == row.poses && name_of(other.setting) == name_of(row.setting);
        });
        const std::string what = fmt::format("{}, {} poses, {}", scene.name, name_of(row.poses), name_of(row.setting));
        if (same == report.rows.end()) return Error{where, "expected a row of " + what};
        if (!are_equal(same->errors, row.errors))
            return Error{where, fmt::format("expected of {} the errors {}; found {}", what, json_of(row.errors).dump(),
                                            json_of(same->errors).dump())};
    }
    return {};
}

}  // namespace

std::string accuracy_json(const AccuracyRun& run, const std::vector<AccuracyScene>& scenes) {
    Json list = Json::array();
    for (const AccuracyScene& scene : scenes) list.push_back(json_of(scene));
    const Json json{{"version", ENFILADE_VERSION},
                    {"command", run.command},
                    {"quick", run.is_quick},
                    {"program_hash", fmt::format("{:016x}", run.program_hash)},
                    {"machine", fmt::format("{} x {}", std::thread::hardware_concurrency(), processor())},
                    {"compiler", __VERSION__},
                    {"flags", ENFILADE_FLAGS},
                    {"scenes", list}};
    return json.dump(1, ' ', true, Json::error_handler_t::replace) + "\n";
}

Result<ReadAccuracy> read_accuracy_json(const std::string& path, std::string_view text) {
    try {
        const Json json = Json::parse(text);
        ReadAccuracy read;
        json.at("command").get_to(read.run.command);
        json.at("quick").get_to(read.run.is_quick);
        read.run.program_hash = hash_in(json.at("program_hash"));
        const std::vector<AccuracySetting> settings = accuracy_settings(false);
        for (const Json& scene : json.at("scenes")) {
            AccuracyScene into{scene.at("name").get<std::string>(), hash_in(scene.at("map_hash")), {}};
            for (const Json& row : scene.at("rows")) into.rows.push_back(row_of(row, settings));
            read.scenes.push_back(std::move(into));
        }
        return read;
    } catch (const std::exception& wrong) {
        return Error{path, std::string("expected a report.json of `enfilade accuracy`; ") + wrong.what()};
    }
}

Status compare_errors(const std::string& path, const std::vector<AccuracyScene>& report,
                      const std::vector<AccuracyScene>& scenes) {
    for (const AccuracyScene& scene : scenes) {
        const auto same = std::ranges::find(report, scene.name, &AccuracyScene::name);
        if (same == report.end()) return Error{path, "expected the scene " + scene.name};
        if (same->map_hash != scene.map_hash)
            return Error{path, "expected the scene " + scene.name + " of the same map, which was changed since"};
        if (Status other = compare_rows(path, *same, scene)) return other;
    }
    return {};
}

}  // namespace enfilade
