// The one door to the TOML library: what it reads becomes a TomlTree.

#include <algorithm>
#include <exception>
#include <stdexcept>

#include "formats/toml_tree.h"

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

TextPlace place_of(const toml::node& node) { return place_of(node.source().begin); }

Finding syntax_error(TextPlace place, std::string_view description) {
    std::string sentence(description);
    if (sentence.starts_with('E')) sentence.front() = 'e';  // the library's sentences start with "Error while"
    return {place, Severity::error, "bad-toml", "not valid TOML: " + sentence};
}

/// Copies the library's tree into ours.
class Copier {
public:
    explicit Copier(TomlTree& tree) : tree_(tree) {}

    TomlValue copy(const toml::table& table) {
        const TomlValue copied = tree_.new_table(place_of(table));
        for (const auto& [key, value] : table)
            copied.members->push_back({kept(key.str()), place_of(key.source().begin), copy(value)});
        // The library sorts by name.
        std::ranges::sort(*copied.members, [](const TomlMember& a, const TomlMember& b) {
            return a.key_place != b.key_place ? a.key_place < b.key_place : a.key < b.key;
        });
        return copied;
    }

private:
    TomlValue copy(const toml::array& array) {
        const TomlValue copied = tree_.new_array(place_of(array));
        copied.items->reserve(array.size());
        for (const toml::node& item : array) copied.items->push_back(copy(item));
        return copied;
    }

    TomlValue copy(const toml::node& node) {
        if (const auto* table = node.as_table()) return copy(*table);
        if (const auto* array = node.as_array()) return copy(*array);
        TomlValue value;
        value.place = place_of(node);
        value.kind = TomlKind::date;
        if (const auto* text = node.as_string()) {
            const std::string_view kept_text = kept(text->get());
            value.kind = TomlKind::string;
            value.text = kept_text.data();
            value.length = static_cast<std::uint32_t>(kept_text.size());
        } else if (const auto* integer = node.as_integer()) {
            value.kind = TomlKind::integer;
            value.integer = integer->get();
        } else if (const auto* real = node.as_floating_point()) {
            value.kind = TomlKind::real;
            value.real = real->get();
        } else if (const auto* boolean = node.as_boolean()) {
            value.kind = TomlKind::boolean;
            value.boolean = boolean->get();
        }
        return value;
    }

    std::string_view kept(std::string_view text) { return tree_.strings.emplace_back(text); }

    TomlTree& tree_;
};

}  // namespace

std::optional<TomlTree> parse_any_toml(std::string_view text, Findings& findings) {
    try {
        const toml::table root = toml::parse(text);
        TomlTree tree;
        tree.root = Copier(tree).copy(root);
        return tree;
    } catch (const toml::parse_error& error) {
        findings.push_back(syntax_error(place_of(error.source().begin), error.description()));
    } catch (const std::logic_error& error) {
        findings.push_back(syntax_error({}, error.what()));
    }
    return {};
}

}  // namespace enfilade
