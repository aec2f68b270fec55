#include "app/open_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/exit_codes.h"
#include "app/file_kind.h"
#include "app/map_cache.h"
#include "base/files.h"
#include "base/terminal.h"

namespace enfilade {
namespace {

bool is_warning(const Finding& finding) { return finding.severity == Severity::warning; }

void print_errors(const std::string& path, const Findings& findings) {
    for (const Finding& finding : findings)
        if (!is_warning(finding)) print_text(stderr, to_text(path, finding) + "\n");
}

void mention_warnings(const std::string& path, const Findings& findings) {
    const auto count = std::ranges::count_if(findings, is_warning);
    if (count == 1) print_text(stderr, to_text(path, *std::ranges::find_if(findings, is_warning)) + "\n");
    if (count > 1) print_text(stderr, fmt::format("{0}: {1} warnings; `enfilade check {0}` shows them\n", path, count));
}

}  // namespace

std::string next_map_path(const std::string& map_path, const std::string& name) {
    std::filesystem::path path = std::filesystem::path(map_path).parent_path() / name;
    if (path.extension() != ".toml") path += ".toml";
    return path.string();
}

std::optional<OpenMap> open_map(const std::string& path, const std::vector<std::string>& texture_folders,
                                std::optional<int> skill) {
    const MapStore cache = cache_of(path);
    LoadedMap loaded = load_map(path, texture_folders, read_file, skill, list_folder, &cache);
    if (!loaded.map) {
        if (Status other = refuse_as_map(path))
            fail(*other);
        else
            print_errors(path, loaded.findings);
        return {};
    }
    mention_warnings(path, loaded.findings);
    return OpenMap{std::move(*loaded.map), std::move(loaded.textures)};
}

}  // namespace enfilade
