// TOML text: as a tree to look at, and laid out as this project writes it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/finding.h"
#include "base/result.h"

namespace enfilade {

enum class TomlKind : std::uint8_t { absent, string, integer, real, boolean, date, array, table };

/// How a message calls it: "a string", "a whole number", …
std::string_view name_of(TomlKind kind);

struct TomlEntry;

/// A look at one value of a document, without a copy: two words, valid as long as the document. Asking for what the
/// kind does not have is a broken contract.
class TomlNode {
public:
    TomlNode() = default;  ///< absent

    TomlKind kind() const { return kind_; }
    TextPlace place() const;

    std::string_view text() const;  ///< string, or date, as TOML writes it
    double number() const;          ///< integer or real; may be infinite or NaN
    std::int64_t integer() const;   ///< integer
    bool boolean() const;           ///< boolean

    std::size_t size() const;                   ///< array or table: how many members
    TomlNode at(std::size_t index) const;       ///< array; index < size()
    TomlNode find(std::string_view key) const;  ///< table: the member of that name, or absent
    /// table: its members in the order of the text. Cost: O(n), one allocation.
    std::vector<TomlEntry> entries() const;

private:
    friend class TomlDocument;
    friend struct TomlAccess;
    TomlNode(const void* node, TomlKind kind) : node_(node), kind_(kind) {}

    const void* node_ = nullptr;
    TomlKind kind_ = TomlKind::absent;
};

/// A member of a table.
struct TomlEntry {
    std::string_view key;  ///< as meant, without its quotes
    TextPlace key_place;
    TomlNode value;
};

/// The value as TOML text in one line, whatever a reader accepted: read again, it is the same, NaN and infinity, too.
/// value : not absent
std::string value_text(const TomlNode& value);

/// What is read before it is refused. A number, a word or an array counts as one value; what takes more memory, here
/// and in what readers make of it, counts as more.
struct TomlLimits {
    std::size_t bytes = std::size_t{1} << 20;
    std::size_t values = std::size_t{1} << 18;
};

inline constexpr std::size_t kTableWeight = 8;   ///< of a table, in braces, with a header or made by a dot in a key
inline constexpr std::size_t kKeyWeight = 3;     ///< of a key and its value
inline constexpr std::size_t kStringWeight = 1;  ///< of a string, beyond the value it is

/// What a counted value takes at most, the text aside: the tree of the library and its copy, or the tree and what
/// readers make of it [bytes]. Found by measuring (the tests hold it): a sector takes the most, 900 bytes for 9 values.
inline constexpr std::size_t kBytesPerValue = 128;

/// A parsed text. Does not refer to the text any more.
class TomlDocument {
public:
    /// The document, or none and one more finding: too-large, not-utf8, too-deep or bad-toml. Any bytes are safe.
    /// Cost: about 20 ns and 15 bytes of memory for a byte of a plain text, as write_map writes it; for one with
    /// escapes, keys with dots, dates and the like, which only the library knows how to read, ten times as much.
    static std::optional<TomlDocument> parse(std::string_view text, const TomlLimits& limits, Findings& findings);

    TomlDocument(TomlDocument&&) noexcept;
    TomlDocument& operator=(TomlDocument&&) noexcept;
    ~TomlDocument();

    TomlNode root() const;  ///< a table

    /// From now on every place is said to be so many lines further down. Cost: O(values).
    void move_lines(std::uint32_t by);

private:
    struct Tree;
    explicit TomlDocument(std::unique_ptr<Tree> tree);
    std::unique_ptr<Tree> tree_;
};

// Layout, for authors who would rather not count blanks.

/// The same document with the same comments, laid out anew:
///
/// - one blank around `=` and inside braces, one behind a comma, two between the corners of `v` and `rect`
/// - what stands in an array of several lines is indented by two blanks; the lines stay as the author broke them
/// - an empty line above each header (or above the comments right above it), never two; none at either end
/// - comments behind what they are about, two blanks away, those of neighbouring lines below one another
///
/// Keys, strings and numbers stay as they are written. What is laid out already is the same, byte for byte.
/// text : a document that TomlDocument::parse accepts; an error otherwise
Result<std::string> lay_out_toml(std::string_view text);

}  // namespace enfilade
