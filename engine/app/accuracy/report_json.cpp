// The report for programs: written, and read again.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <thread>
#include <type_traits>

#include "app/accuracy/report.h"
#include "base/files.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

using Json = nlohmann::ordered_json;

std::string processor() {
    constexpr std::string_view kName = "model name";
    constexpr std::size_t kOneProcessor = 4096;  // what the file says of one takes no more [bytes]
    const auto file = read_beginning("/proc/cpuinfo", kOneProcessor);
    if (!file.ok()) return "not known";
    for (LineReader lines(as_text(file.value())); const auto line = lines.next();)
        if (const auto colon = line->text.find(": "); line->text.starts_with(kName) && colon != line->text.npos)
            return std::string(line->text.substr(colon + 2));
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

// Reading: any bytes are safe, and nothing throws where it is asked first what a value is.

template <class T>
bool is_a(const Json& json) {
    if constexpr (std::is_same_v<T, std::string>) return json.is_string();
    if constexpr (std::is_same_v<T, bool>) return json.is_boolean();
    if constexpr (std::is_same_v<T, std::uint64_t>) return json.is_number_unsigned();
    return json.is_number();
}

/// Takes what has to be there, and remembers the first that was not.
class Taking {
public:
    template <class T>
    void take(const Json& from, const char* name, T& into) {
        if (!from.is_object() || !from.contains(name) || !is_a<T>(from[name])) return refuse(name);
        into = from[name].get<T>();
    }

    void take_hash(const Json& from, const char* name, std::uint64_t& into) {
        std::string text;
        take(from, name, text);
        const auto end = std::from_chars(text.data(), text.data() + text.size(), into, 16);
        if (text.empty() || end.ec != std::errc() || end.ptr != text.data() + text.size()) refuse(name);
    }

    const Json& list(const Json& from, const char* name) {
        static const Json kNone = Json::array();
        if (from.is_object() && from.contains(name) && from[name].is_array()) return from[name];
        refuse(name);
        return kNone;
    }

    const Json& object(const Json& from, const char* name) {
        static const Json kNone = Json::object();
        if (from.is_object() && from.contains(name)) return from[name];
        refuse(name);
        return kNone;
    }

    void refuse(const std::string& what) {
        if (refused_.empty()) refused_ = what;
    }
    const std::string& refused() const { return refused_; }

private:
    std::string refused_;
};

AccuracyRow row_of(const Json& json, const std::vector<AccuracySetting>& settings, Taking& taking) {
    AccuracyRow row;
    std::string poses_name, setting_name;
    taking.take(json, "poses", poses_name);
    taking.take(json, "setting", setting_name);
    const auto poses = std::ranges::find(kPoseKinds, poses_name, [](PoseKind kind) { return name_of(kind); });
    const auto setting = std::ranges::find(settings, setting_name, [](const AccuracySetting& s) { return name_of(s); });
    if (poses == kPoseKinds.end() || setting == settings.end()) {
        taking.refuse("setting");
        return row;
    }
    row.poses = *poses;
    row.setting = *setting;
    const Json &errors = taking.object(json, "errors"), &price = taking.object(json, "price");
    each_error(row.errors, [&](const char* name, auto& value) { taking.take(errors, name, value); });
    each_price(row.price, [&](const char* name, double& value) { taking.take(price, name, value); });
    if (price.is_object() && price.contains("instructions"))
        taking.take(price, "instructions", row.price.instructions.emplace());
    return row;
}

AccuracyScene scene_of(const Json& json, const std::vector<AccuracySetting>& settings, Taking& taking) {
    AccuracyScene scene;
    taking.take(json, "name", scene.name);
    taking.take_hash(json, "map_hash", scene.map_hash);
    for (const Json& row : taking.list(json, "rows")) scene.rows.push_back(row_of(row, settings, taking));
    return scene;
}

bool are_equal(const AccuracyErrors& a, const AccuracyErrors& b) { return json_of(a) == json_of(b); }

Result<void> compare_rows(const std::string& where, const AccuracyScene& report, const AccuracyScene& scene) {
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
    const Json json = Json::parse(text, nullptr, false);
    Taking taking;
    ReadAccuracy read;
    taking.take(json, "command", read.run.command);
    taking.take(json, "quick", read.run.is_quick);
    taking.take_hash(json, "program_hash", read.run.program_hash);
    const std::vector<AccuracySetting> settings = accuracy_settings(false);
    for (const Json& scene : taking.list(json, "scenes")) read.scenes.push_back(scene_of(scene, settings, taking));
    if (taking.refused().empty()) return read;
    return Error{path, "expected a report.json of `enfilade accuracy`; '" + taking.refused() +
                           "' is missing or another thing than it should be"};
}

Result<void> compare_errors(const std::string& path, const std::vector<AccuracyScene>& report,
                            const std::vector<AccuracyScene>& scenes) {
    for (const AccuracyScene& scene : scenes) {
        const auto same = std::ranges::find(report, scene.name, &AccuracyScene::name);
        if (same == report.end()) return Error{path, "expected the scene " + scene.name};
        if (same->map_hash != scene.map_hash)
            return Error{path, "expected the scene " + scene.name + " of the same map, which was changed since"};
        if (const Result<void> valid = compare_rows(path, *same, scene); !valid.ok()) return valid.error();
    }
    return {};
}

}  // namespace enfilade
