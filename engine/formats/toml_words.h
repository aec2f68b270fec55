// What the TOML library says is wrong with a text, in the words of this program.
#pragma once
#include <string>
#include <string_view>

namespace enfilade {

/// "expected …, found …; do …" for one of the library's sentences ("Error while parsing SCOPE: REASON").
///
/// is_line_end : whether the place it names is the end of a line, which its sentences do not always tell.
/// A reason that is not known comes out as it is, so that nothing is lost with another version of the library.
std::string toml_words(std::string_view description, bool is_line_end);

/// Whether there are words of ours for this reason, with whatever was found in it left out.
bool has_toml_words(std::string_view scope, std::string_view reason);

}  // namespace enfilade
