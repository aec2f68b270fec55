// Keys whose texts mean more than they say: colors, and names of files.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "formats/key.h"
#include "formats/text_parts.h"

namespace enfilade {

// Keys for colours: "#rrggbb", or the number 0xrrggbb.

/// The colour as 0xRRGGBB, or none and bad-color is noted.
std::optional<std::uint32_t> read_color(Reading& reading, const NamedValue& value);

/// "#rrggbb"
std::string color_text(std::uint32_t color);

/// A key for a field that is a colour.
template <auto member>
constexpr auto color_key(std::string_view name, Dialect since) {
    using Record = typename MemberPointer<decltype(member)>::Record;
    return Key<Record>{name,
                       since,
                       Need::optional,
                       {},
                       [](Reading& reading, const NamedValue& value, Range, Record& record) {
                           if (const auto color = read_color(reading, value)) record.*member = *color;
                       },
                       [](TableText& table, const Key<Record>& key, const Record& record, const Record& defaults) {
                           if (record.*member != defaults.*member)
                               table.add(key.name, string_text(color_text(record.*member)));
                       }};
}

// Keys for names of files. A key that names a file is one of these, and a test asks so of every key with a string.

// Which texts of a hostile file may become names of other files.

/// Nothing where the text names a file below a folder: parts with a single '/' between them, none of them "." or "..",
/// and no character that a terminal would obey (base/terminal.h). So a file has one name only, apart from upper and
/// lower case, and no name leads elsewhere. Otherwise what was expected, without a place.
Result<void> refuse_as_file_name(std::string_view text);

/// Nothing where the text is a path that may lead anywhere: no character that a terminal would obey. For what people
/// set up by hand, as the folder of their pictures.
Result<void> refuse_as_path(std::string_view text);

/// Whether a string's value may name a file, by the rules above; if not, bad-file-name is noted at it.
/// files : below_folder or anywhere
bool expect_file_name(Reading& reading, const NamedValue& value, Files files);

/// Reads the name of a file, or notes what is wrong with it and leaves the field as it is.
void read_file_name(Reading& reading, const NamedValue& value, Files files, std::string& field);
void read_file_name(Reading& reading, const NamedValue& value, Files files, std::vector<std::string>& field);

/// A key for a field that is the name of a file, or several.
template <auto member, Files files = Files::below_folder>
constexpr auto file_key(std::string_view name, Dialect since, Need need = Need::optional) {
    auto checked = key<member>(name, since, need);
    checked.files = files;
    checked.read = [](Reading& reading, const NamedValue& value, Range, auto& record) {
        read_file_name(reading, value, files, record.*member);
    };
    return checked;
}

}  // namespace enfilade
