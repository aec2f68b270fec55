// What is said about words of a command line that nobody knows.
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace enfilade {

/// "expected a command, found 'chekc'; did you mean 'check'?", or which command takes the file of that name.
std::string unknown_command(const std::string& word, std::span<const std::string_view> commands);

/// "there is no option '--siez' here; did you mean '--size'?" word : starts with '-'
std::string unknown_option(const std::string& word, std::span<const std::string_view> options);

}  // namespace enfilade
