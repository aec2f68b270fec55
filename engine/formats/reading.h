// How values of a TOML document become fields of records: typed, in range, and every complaint noted with its place.
#pragma once
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/finding.h"
#include "formats/map_file.h"
#include "formats/toml.h"
#include "formats/words.h"
#include "math/vec.h"

namespace enfilade {

/// Which files a key may stand in.
enum class Dialect : std::uint8_t { tutorial, enfilade };

/// What a value may be, beyond its type.
struct Range {
    double low = std::numeric_limits<double>::lowest();
    double high = std::numeric_limits<double>::max();
};

/// "from LOW to HIGH", or "at least LOW".
std::string range_text(Range range);

/// Findings that are kept of one file; a hostile file must not fill the memory with them.
inline constexpr std::size_t kMaxFindings = 1000;

/// What goes along while a document is read: where complaints go, and which dialect it is.
struct Reading {
    Findings& findings;
    Dialect dialect = Dialect::enfilade;
    bool lacks_format = false;  ///< a key of the other dialect was met, which was noted once

    /// Notes an error. Beyond kMaxFindings only the fact that there are more.
    void error(TextPlace place, std::string_view code, std::string sentence);
    /// Nothing more will be noted; loops over a file's values may stop.
    bool is_full() const { return findings.size() > kMaxFindings; }
};

/// A value and what a message calls it.
struct NamedValue {
    std::string_view name;
    TomlNode node;
};

/// Notes wrong-type unless the value is of this kind; true if it is.
bool expect(Reading& reading, const NamedValue& value, TomlKind kind);
/// Whether it is a table. key: one that it may have, for the finding's example.
bool expect_table(Reading& reading, const NamedValue& value, std::string_view key);
/// Whether it is an array, as for tables; where it is one table, the finding says how several are written.
bool expect_tables(Reading& reading, const NamedValue& value);
void wrong_type(Reading& reading, const NamedValue& value, std::string_view expected);

// Each reads a value of its field's type; where it cannot, it notes why and leaves the field as it is. A number out
// of range is brought into it, so that what is checked later does not stumble over it once more.
void read_value(Reading& reading, const NamedValue& value, Range range, double& field);
void read_value(Reading& reading, const NamedValue& value, Range range, std::optional<double>& field);
void read_value(Reading& reading, const NamedValue& value, Range range, int& field);
void read_value(Reading& reading, const NamedValue& value, Range range, bool& field);
void read_value(Reading& reading, const NamedValue& value, Range range, Vec2& field);
/// "[x0, y0, x1, y1]"
void read_value(Reading& reading, const NamedValue& value, Range range, RectRecord& field);
/// Strings must not be empty.
void read_value(Reading& reading, const NamedValue& value, Range range, std::string& field);
void read_value(Reading& reading, const NamedValue& value, Range range, std::vector<std::string>& field);
void read_value(Reading& reading, const NamedValue& value, Range range, TextureSpec& field);
void read_value(Reading& reading, const NamedValue& value, Range range, std::optional<TextureSpec>& field);

/// Which of the words the value is, or none and unknown-word is noted.
std::optional<std::size_t> read_word(Reading& reading, const NamedValue& value,
                                     std::span<const std::string_view> words);

template <Word W>
void read_value(Reading& reading, const NamedValue& value, Range, W& field) {
    if (const auto index = read_word(reading, value, kWords<W>)) field = static_cast<W>(*index);
}

}  // namespace enfilade
