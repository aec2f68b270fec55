#include "app/usage_faults.h"

#include "app/file_kind.h"
#include "formats/quoted.h"

namespace enfilade {

std::string unknown_command(const std::string& word, std::span<const std::string_view> commands) {
    if (is_file(word)) return "expected a command, " + about_file(word);
    return "expected a command, found " + quoted(word) + suggestion(word, commands);
}

std::string unknown_option(const std::string& word, std::span<const std::string_view> options) {
    const std::string name = word.substr(0, word.find('='));
    return "there is no option " + quoted(name) + " here" + nearest_suggestion(name, options);
}

}  // namespace enfilade
