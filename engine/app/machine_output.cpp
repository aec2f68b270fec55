#include "app/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "formats/text_parts.h"

namespace enfilade {
namespace {

using Json = nlohmann::ordered_json;

/// Of ASCII only, whatever bytes are in the names of files.
std::string text_of(const Json& json) { return json.dump(2, ' ', true, Json::error_handler_t::replace) + "\n"; }

const char* word_for(Severity severity) { return severity == Severity::error ? "error" : "warning"; }

Json json_of(const Finding& finding) {
    Json json{{"severity", word_for(finding.severity)}, {"code", finding.code}, {"message", finding.sentence}};
    if (finding.place.line > 0) json["line"] = finding.place.line;
    if (finding.place.column > 0) json["column"] = finding.place.column;
    if (finding.file) json["file"] = *finding.file;
    return json;
}

/// A path as the URI that SARIF wants (RFC 3986).
std::string uri_of(const std::string& path) {
    constexpr std::string_view kPlain = "-._~/";
    std::string uri;
    for (const char c : path) {
        const bool is_plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                              kPlain.find(c) != std::string_view::npos;
        uri += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return uri;
}

Json sarif_result(const std::string& path, const Finding& finding) {
    Json place{{"artifactLocation", {{"uri", uri_of(finding.file ? *finding.file : path)}}}};
    if (finding.place.line > 0) place["region"]["startLine"] = finding.place.line;
    if (finding.place.line > 0 && finding.place.column > 0) place["region"]["startColumn"] = finding.place.column;
    return {{"ruleId", finding.code},
            {"level", word_for(finding.severity)},
            {"message", {{"text", finding.sentence}}},
            {"locations", Json::array({Json{{"physicalLocation", place}}})}};
}

}  // namespace

std::size_t count_of(const std::vector<CheckedMap>& maps, Severity severity) {
    std::size_t count = 0;
    for (const CheckedMap& map : maps)
        count += static_cast<std::size_t>(std::ranges::count(map.findings, severity, &Finding::severity));
    return count;
}

std::string check_json(const std::vector<CheckedMap>& maps) {
    Json list = Json::array();
    for (const CheckedMap& map : maps) {
        Json findings = Json::array();
        for (const Finding& finding : map.findings) findings.push_back(json_of(finding));
        list.push_back({{"path", map.path}, {"refused", map.is_refused}, {"findings", findings}});
    }
    return text_of({{"version", ENFILADE_VERSION},
                    {"refused", std::ranges::count(maps, true, &CheckedMap::is_refused)},
                    {"errors", count_of(maps, Severity::error)},
                    {"warnings", count_of(maps, Severity::warning)},
                    {"maps", list}});
}

std::string check_sarif(const std::vector<CheckedMap>& maps) {
    Json results = Json::array();
    for (const CheckedMap& map : maps)
        for (const Finding& finding : map.findings) results.push_back(sarif_result(map.path, finding));
    const Json driver{{"name", "enfilade check"}, {"version", ENFILADE_VERSION}};
    const Json run{{"tool", {{"driver", driver}}}, {"results", results}};
    return text_of({{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                    {"version", "2.1.0"},
                    {"runs", Json::array({run})}});
}

std::string flight_json(const CheckedFlight& flight) {
    const bool is_passed = flight.verdict.differing.empty();
    Json json{{"version", ENFILADE_VERSION}, {"script", flight.script},
              {"renderer", flight.renderer}, {"compared_with", flight.compared_with},
              {"first", flight.first},       {"last", flight.last},
              {"passed", is_passed},         {"differing", flight.verdict.differing}};
    if (!is_passed) json["report"] = flight.verdict.report;
    return text_of(json);
}

std::string flight_junit(const CheckedFlight& flight) {
    const std::vector<int>& differing = flight.verdict.differing;
    const std::string script = xml_escaped(flight.script);
    std::string xml = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n<testsuite name=\"{}\" tests=\"{}\" "
        "failures=\"{}\">\n",
        script, flight.last - flight.first + 1, differing.size());
    for (int frame = flight.first; frame <= flight.last; ++frame) {
        xml += fmt::format("<testcase classname=\"{}\" name=\"frame {}\"", script, frame);
        if (std::ranges::binary_search(differing, frame))
            xml += fmt::format("><failure message=\"differs from the {}; see {}\"/></testcase>\n",
                               xml_escaped(flight.compared_with), xml_escaped(flight.verdict.report));
        else
            xml += "/>\n";
    }
    return xml + "</testsuite>\n</testsuites>\n";
}

std::string bench_json(const BenchSetting& setting, const std::vector<BenchFrame>& frames) {
    Json list = Json::array();
    for (const BenchFrame& frame : frames) {
        const BenchCounts& counts = frame.counts;
        list.push_back({{"subject", setting.subjects[frame.subject]},
                        {"frame", frame.number},
                        {"minimum_ns", frame.minimum_ns},
                        {"median_ns", frame.median_ns},
                        {"walls", counts.walls},
                        {"runs", counts.runs},
                        {"viewports", counts.viewports},
                        {"pixels", counts.pixels},
                        {"hash", fmt::format("{:016x}", counts.hash)}});
    }
    return text_of({{"version", ENFILADE_VERSION},
                    {"width", setting.width},
                    {"height", setting.height},
                    {"renderer", setting.renderer},
                    {"kernels", setting.kernels},
                    {"dials", to_text(setting.dials)},
                    {"threads", setting.threads},
                    {"rounds", setting.rounds},
                    {"frames", list}});
}

}  // namespace enfilade
