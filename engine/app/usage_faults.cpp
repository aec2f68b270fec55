#include "app/usage_faults.h"

#include <fmt/format.h>

#include "app/file_kind.h"
#include "formats/quoted.h"

namespace enfilade {
namespace {

/// What to do with a file that stands where a command should.
std::string command_for(const std::string& path) {
    const Status no_map = refuse_as_map(path);
    if (!no_map) return fmt::format("found a map; `enfilade play {}` walks through it", path);
    const auto found = no_map->what.find("found");
    return found == std::string::npos ? no_map->what : no_map->what.substr(found);
}

}  // namespace

std::string unknown_command(const std::string& word, std::span<const std::string_view> commands) {
    if (is_file(word)) return "expected a command, " + command_for(word);
    return "expected a command, found " + quoted(word) + suggestion(word, commands);
}

std::string unknown_option(const std::string& word, std::span<const std::string_view> options) {
    const std::string name = word.substr(0, word.find('='));
    return "there is no option " + quoted(name) + " here" + nearest_suggestion(name, options);
}

}  // namespace enfilade
