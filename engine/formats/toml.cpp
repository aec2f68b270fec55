#include "formats/toml.h"

#include <algorithm>
#include <exception>
#include <span>
#include <stdexcept>

#include "base/check.h"
#include "formats/toml_guard.h"

// toml++ 3.3.0 states what it believes as assertions, and with NDEBUG as promises to the optimiser; fuzzing shows
// that texts like "[=]" break some of them. Without NDEBUG and with an empty TOML_ASSERT they are neither, and the
// code after them gives a proper error.
#undef NDEBUG
#define TOML_ASSERT(expr) static_cast<void>(0)
#define TOML_EXCEPTIONS 1
#define TOML_ENABLE_FORMATTERS 0
// It distrusts the standard library's numbers from text, which libstdc++ has since version 11, and makes a stream with
// a locale for every number instead: half of the time it took to read a map.
#define TOML_FLOAT_CHARCONV 1
#include <toml++/impl/preprocessor.h>

namespace {
[[noreturn]] void reached_the_unreachable() { throw std::logic_error("a character that is not expected here"); }
}  // namespace

// The same for places it thinks it cannot reach (with letters beyond ASCII it can): an error instead of anything.
#undef TOML_UNREACHABLE
#define TOML_UNREACHABLE reached_the_unreachable()
#include <toml++/toml.h>

namespace enfilade {
namespace {

TextPlace place_of(const toml::source_position& position) {
    return {static_cast<std::uint32_t>(position.line), static_cast<std::uint32_t>(position.column)};
}

TomlKind kind_of(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::string: return TomlKind::string;
        case toml::node_type::integer: return TomlKind::integer;
        case toml::node_type::floating_point: return TomlKind::real;
        case toml::node_type::boolean: return TomlKind::boolean;
        case toml::node_type::array: return TomlKind::array;
        case toml::node_type::table: return TomlKind::table;
        case toml::node_type::none: return TomlKind::absent;
        default: return TomlKind::date;
    }
}

/// The node as the library's type of one kind of value, which the caller has checked.
template <class T>
const T& as(const void* node) {
    return static_cast<const T&>(*static_cast<const toml::node*>(node));
}

/// Fewer members of an array than this are not worth a thread of their own.
constexpr std::size_t kLeastMembersPerThread = 512;

Finding syntax_error(TextPlace place, std::string_view description) {
    std::string sentence(description);
    if (sentence.starts_with('E')) sentence.front() = 'e';  // the library's sentences start with "Error while"
    return {place, Severity::error, "bad-toml", "not valid TOML: " + sentence};
}

}  // namespace

/// Makes nodes for TomlNode, whose header must not know the library.
struct TomlAccess {
    static TomlNode look_at(const toml::node& node) { return {&node, kind_of(node)}; }
};

struct TomlDocument::Tree {
    toml::table root;

    explicit Tree(toml::table&& table) : root(std::move(table)) {}
    Tree(const Tree&) = delete;
    Tree& operator=(const Tree&) = delete;
    /// A tree is a million small pieces of memory, and giving them back takes a tenth of the time that making them did.
    ~Tree() {
        for (auto&& [key, value] : root)
            if (toml::array* const array = value.as_array()) empty(*array);
    }

private:
    static void empty(toml::array& array) {
        const std::size_t parts = array.size() / kLeastMembersPerThread + 1;
        parallel_for(parts, hardware_threads(), [&](std::size_t part, std::size_t) {
            for (std::size_t i = part * array.size() / parts; i < (part + 1) * array.size() / parts; ++i)
                if (toml::table* const table = array[i].as_table()) table->clear();
        });
    }
};

std::string_view name_of(TomlKind kind) {
    switch (kind) {
        case TomlKind::absent: return "nothing";
        case TomlKind::string: return "a string";
        case TomlKind::integer: return "a whole number";
        case TomlKind::real: return "a number";
        case TomlKind::boolean: return "true or false";
        case TomlKind::date: return "a date or time";
        case TomlKind::array: return "an array";
        case TomlKind::table: return "a table";
    }
    return "";
}

TextPlace TomlNode::place() const { return node_ ? place_of(as<toml::node>(node_).source().begin) : TextPlace{}; }

std::string_view TomlNode::text() const {
    ENFILADE_CHECK(kind_ == TomlKind::string);
    return as<toml::value<std::string>>(node_).get();
}

std::int64_t TomlNode::integer() const {
    ENFILADE_CHECK(kind_ == TomlKind::integer);
    return as<toml::value<std::int64_t>>(node_).get();
}

double TomlNode::number() const {
    if (kind_ == TomlKind::integer) return static_cast<double>(integer());
    ENFILADE_CHECK(kind_ == TomlKind::real);
    return as<toml::value<double>>(node_).get();
}

bool TomlNode::boolean() const {
    ENFILADE_CHECK(kind_ == TomlKind::boolean);
    return as<toml::value<bool>>(node_).get();
}

std::size_t TomlNode::size() const {
    if (kind_ == TomlKind::array) return as<toml::array>(node_).size();
    ENFILADE_CHECK(kind_ == TomlKind::table);
    return as<toml::table>(node_).size();
}

TomlNode TomlNode::at(std::size_t index) const {
    ENFILADE_CHECK(kind_ == TomlKind::array);
    const auto& array = as<toml::array>(node_);
    ENFILADE_CHECK(index < array.size());
    return TomlAccess::look_at(array[index]);
}

TomlNode TomlNode::find(std::string_view key) const {
    ENFILADE_CHECK(kind_ == TomlKind::table);
    const toml::node* member = as<toml::table>(node_).get(key);
    return member ? TomlAccess::look_at(*member) : TomlNode();
}

std::vector<TomlEntry> TomlNode::entries() const {
    ENFILADE_CHECK(kind_ == TomlKind::table);
    const auto& table = as<toml::table>(node_);
    std::vector<TomlEntry> entries;
    entries.reserve(table.size());
    for (const auto& [key, value] : table)
        entries.push_back({key.str(), place_of(key.source().begin), TomlAccess::look_at(value)});
    std::sort(entries.begin(), entries.end(), [](const TomlEntry& a, const TomlEntry& b) {
        return a.key_place != b.key_place ? a.key_place < b.key_place : a.key < b.key;
    });
    return entries;
}

TomlDocument::TomlDocument(std::unique_ptr<Tree> tree) : tree_(std::move(tree)) {}
TomlDocument::TomlDocument(TomlDocument&&) noexcept = default;
TomlDocument& TomlDocument::operator=(TomlDocument&&) noexcept = default;
TomlDocument::~TomlDocument() = default;

TomlNode TomlDocument::root() const { return TomlAccess::look_at(tree_->root); }

namespace {

/// The part of a text between two offsets, with the lines before it empty, so that places in it are those in the text.
std::string part_of(std::string_view text, std::size_t begin, std::size_t end) {
    std::string part(
        static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(begin), '\n')),
        '\n');
    return part += text.substr(begin, end - begin);
}

/// Whether an array was written as [[headers]], to which others may be added.
bool is_made_of_headers(const toml::array& array) {
    return !array.empty() && array.is_array_of_tables() && !array[0].as_table()->is_inline();
}

/// Adds what a later part of a text says; false where the two say something about the same table.
bool append(toml::table& whole, toml::table&& part) {
    for (auto&& [key, value] : part) {
        toml::node* const before = whole.get(key.str());
        if (!before) {
            whole.insert(key, std::move(value));
            continue;
        }
        toml::array* const array = before->as_array();
        toml::array* const more = value.as_array();
        if (!array || !more || !is_made_of_headers(*array) || !is_made_of_headers(*more)) return false;
        for (auto& table : *more) array->push_back(std::move(*table.as_table()));
    }
    return true;
}

/// The text parsed on several cores, or none where it cannot be had that way: the text, or a part of it, is wrong, or
/// two parts speak of one table.
std::optional<toml::table> parse_in_parts(std::string_view text, std::span<const std::size_t> cuts) {
    std::vector<std::optional<toml::table>> parts(cuts.size() + 1);
    parallel_for(parts.size(), parts.size(), [&](std::size_t i, std::size_t) {
        const std::size_t begin = i == 0 ? 0 : cuts[i - 1];
        const std::size_t end = i == cuts.size() ? text.size() : cuts[i];
        try {
            parts[i] = toml::parse(part_of(text, begin, end));
        } catch (const std::exception&) {
            // The whole text will say what is wrong.
        }
    });
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (!parts[i] || (i > 0 && !append(*parts[0], std::move(*parts[i])))) return {};
    return std::move(parts[0]);
}

/// At most `count` of the cuts, evenly spread.
std::vector<std::size_t> spread(const std::vector<std::size_t>& cuts, std::size_t count) {
    count = std::min(cuts.size(), count);
    std::vector<std::size_t> chosen;
    for (std::size_t i = 1; i <= count; ++i) chosen.push_back(cuts[i * (cuts.size() + 1) / (count + 1) - 1]);
    return chosen;
}

}  // namespace

std::optional<TomlDocument> TomlDocument::parse(std::string_view text, const TomlLimits& limits, Findings& findings,
                                                std::size_t workers) {
    TomlScan scan = scan_toml(text, limits);
    if (scan.problem) {
        findings.push_back(std::move(*scan.problem));
        return {};
    }
    try {
        const auto cuts = spread(scan.cuts, workers - 1);
        if (auto root = cuts.empty() ? std::nullopt : parse_in_parts(text, cuts))
            return TomlDocument(std::make_unique<Tree>(std::move(*root)));
        return TomlDocument(std::make_unique<Tree>(toml::parse(text)));
    } catch (const toml::parse_error& error) {
        findings.push_back(syntax_error(place_of(error.source().begin), error.description()));
    } catch (const std::logic_error& error) {
        findings.push_back(syntax_error({}, error.what()));
    }
    return {};
}

}  // namespace enfilade
