// Keys for colours: "#rrggbb", or the number 0xrrggbb.
#pragma once
#include <optional>
#include <string>

#include "formats/key.h"
#include "formats/table_text.h"

namespace enfilade {

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

}  // namespace enfilade
