#include "app/open_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "app/messages.h"
#include "app/user_folders.h"
#include "base/file_name.h"
#include "base/files.h"
#include "base/hash.h"
#include "base/owned_folder.h"
#include "base/text.h"
#include "formats/script.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".map";

/// Empty: nothing is kept.
fs::path cache_folder() {
    const char* const wish = std::getenv("ENFILADE_MAP_CACHE");
    return wish && std::string_view(wish) == "off" ? "" : user_folder(UserFolder::cache);
}

/// A number for this very program, which changes whenever it is built or installed anew.
std::uint64_t edition_of_program() {
    std::error_code unknown;
    const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
    Hash hash;
    hash.add(ENFILADE_VERSION);
    hash.add(program.string());
    hash.add(static_cast<std::uint64_t>(fs::file_size(program, unknown)));
    hash.add(static_cast<std::int64_t>(fs::last_write_time(program, unknown).time_since_epoch().count()));
    return hash.value();
}

/// A map on another skill, or for another program, is another file.
fs::path file_for(const fs::path& folder, const std::string& map_path, std::uint64_t edition) {
    std::error_code unknown;
    const fs::path map = fs::weakly_canonical(map_path, unknown);
    Hash hash;
    hash.add(map.string());
    hash.add(edition);
    return folder / fmt::format("{}-{:016x}{}", safe_file_name(file_stem_of(map.string())), hash.value(), kEnding);
}

/// Removes the oldest files but `kept` until the others fit beside it.
void prune(const fs::path& folder, const fs::path& kept) {
    struct Old {
        fs::file_time_type written;
        fs::path path;
        std::uint64_t bytes;
    };
    std::vector<Old> files;
    std::error_code gone;  // another process may remove them, too
    std::uint64_t bytes = 0;
    for (const std::string& name : list_folder(folder.string())) {
        const fs::path path = folder / name;
        if (path.extension() != kEnding) continue;
        const std::uint64_t size = fs::file_size(path, gone);
        if (gone) continue;
        bytes += size;
        if (path != kept) files.push_back({fs::last_write_time(path, gone), path, size});
    }
    std::ranges::sort(files, {}, &Old::written);
    std::vector<std::string> surplus;
    for (auto file = files.begin(); file != files.end() && bytes > kMostCacheBytes; ++file) {
        surplus.push_back(file->path.string());
        bytes -= file->bytes;
    }
    static_cast<void>(remove_superseded(surplus, kept.string()));
}

}  // namespace

MapStore cache_of(const std::string& map_path) {
    const fs::path folder = cache_folder();
    if (folder.empty()) return {0, [] { return Result<Bytes>(Error{"", "nothing is kept"}); }, {}};
    const std::uint64_t edition = edition_of_program();
    const fs::path file = file_for(folder, map_path, edition);
    const auto find = [file] { return read_file(file.string()); };
    const auto keep = [folder, file](const Bytes& bytes) {
        std::error_code failed;
        fs::create_directories(folder, failed);
        if (failed || bytes.size() > kMaxFileBytes) return;
        if (const Result<void> done = write_file(file.string(), bytes); !done.ok()) return;
        prune(folder, file);
    };
    return {edition, find, keep};
}

namespace {

bool is_warning(const Finding& finding) { return finding.severity == Severity::warning; }

/// Findings that show their line of text: more are seen faster without.
constexpr std::size_t kMostCarets = 64;

/// Texts of the files that findings are in, each read once.
class Texts {
public:
    std::string_view of(const std::string& path) {
        const auto [found, is_new] = texts_.try_emplace(path);
        if (is_new)
            if (auto bytes = read_file(path); bytes.ok()) found->second = std::move(bytes).value();
        return as_text(found->second);
    }

private:
    std::map<std::string, Bytes> texts_;
};

void mention_warnings(const std::string& path, const Findings& findings) {
    const auto count = std::ranges::count_if(findings, is_warning);
    if (count == 1) print_findings(path, {*std::ranges::find_if(findings, is_warning)}, Talk::usual);
    if (count > 1) print_to_stderr(fmt::format("{0}: {1} warnings; `enfilade check {0}` shows them\n", path, count));
}

}  // namespace

std::string findings_text(const std::string& path, const Findings& findings, Talk talk) {
    Texts texts;
    std::string text;
    std::size_t shown = 0;
    for (const Finding& finding : findings) {
        if (talk == Talk::errors_only && is_warning(finding)) continue;
        text += to_text(path, finding) + "\n";
        if (finding.place.line > 0 && ++shown <= kMostCarets)
            text += caret_lines(texts.of(finding.file ? *finding.file : path), finding.place);
    }
    return text;
}

bool print_findings(const std::string& path, const Findings& findings, Talk talk) {
    print_to_stderr(findings_text(path, findings, talk));
    return has_errors(findings);
}

std::string next_map_path(const std::string& map_path, const std::string& name) {
    std::filesystem::path path = std::filesystem::path(map_path).parent_path() / name;
    if (path.extension() != ".toml") path += ".toml";
    return path.string();
}

std::optional<OpenMap> open_map(const std::string& path, const std::vector<std::string>& texture_folders,
                                std::optional<int> skill, Talk talk) {
    const MapStore cache = cache_of(path);
    LoadedMap loaded = load_map(path, texture_folders, read_file, skill, list_folder, &cache);
    if (!loaded.map) {
        if (const Result<void> valid = refuse_as_map(path); !valid.ok())
            fail(valid.error());
        else
            print_findings(path, loaded.findings, Talk::errors_only);
        return {};
    }
    if (talk == Talk::usual) mention_warnings(path, loaded.findings);
    return OpenMap{std::move(*loaded.map), std::move(loaded.textures)};
}

namespace {

std::optional<ScriptFile> open_script(const std::string& path, Talk talk) {
    const auto bytes = read_file(path);
    if (!bytes.ok()) {
        fail(refuse_as_script(path).error_or(bytes.error()));
        return {};
    }
    ScriptReading reading = read_script(as_text(bytes.value()));
    const Result<void> valid = has_errors(reading.findings) ? refuse_as_script(path) : Result<void>();
    if (!valid.ok()) fail(valid.error());
    if (!valid.ok() || print_findings(path, reading.findings, talk)) return {};
    return std::move(reading.script);
}

}  // namespace

std::optional<OpenFlight> open_flight(const std::string& script_path, const std::vector<std::string>& texture_folders,
                                      int skill, Talk talk) {
    auto script = open_script(script_path, talk);
    if (!script) return {};
    auto map = open_map(beside_script(script_path, script->map), texture_folders, skill, talk);
    if (!map) return {};
    Findings findings;
    auto flight = plan_flight(script_path, *script, map->map, read_file, findings);
    print_findings(script_path, findings, talk);
    if (!flight) return {};
    return OpenFlight{std::move(*script), std::move(*map), std::move(*flight)};
}

}  // namespace enfilade
