// Looking at documents.
#include "formats/toml_tree.h"

#include <algorithm>

#include "base/result.h"

namespace enfilade {
namespace {

const TomlValue& as_value(const void* node) { return *static_cast<const TomlValue*>(node); }

}  // namespace

TomlValue TomlTree::new_array(TextPlace place) {
    TomlValue value;
    value.kind = TomlKind::array;
    value.place = place;
    value.items = &arrays.emplace_back();
    return value;
}

TomlValue TomlTree::new_table(TextPlace place) {
    TomlValue value;
    value.kind = TomlKind::table;
    value.place = place;
    value.members = &tables.emplace_back();
    return value;
}

struct TomlDocument::Tree : TomlTree {};

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

TextPlace TomlNode::place() const { return node_ ? as_value(node_).place : TextPlace{}; }

std::string_view TomlNode::text() const {
    ENFILADE_CHECK(kind_ == TomlKind::string);
    return {as_value(node_).text, as_value(node_).length};
}

std::int64_t TomlNode::integer() const {
    ENFILADE_CHECK(kind_ == TomlKind::integer);
    return as_value(node_).integer;
}

double TomlNode::number() const {
    if (kind_ == TomlKind::integer) return static_cast<double>(integer());
    ENFILADE_CHECK(kind_ == TomlKind::real);
    return as_value(node_).real;
}

bool TomlNode::boolean() const {
    ENFILADE_CHECK(kind_ == TomlKind::boolean);
    return as_value(node_).boolean;
}

std::size_t TomlNode::size() const {
    if (kind_ == TomlKind::array) return as_value(node_).items->size();
    ENFILADE_CHECK(kind_ == TomlKind::table);
    return as_value(node_).members->size();
}

TomlNode TomlNode::at(std::size_t index) const {
    ENFILADE_CHECK(kind_ == TomlKind::array);
    const std::vector<TomlValue>& items = *as_value(node_).items;
    ENFILADE_CHECK(index < items.size());
    return TomlAccess::look_at(items[index]);
}

TomlNode TomlNode::find(std::string_view key) const {
    ENFILADE_CHECK(kind_ == TomlKind::table);
    const std::vector<TomlMember>& members = *as_value(node_).members;
    const auto found = std::ranges::find(members, key, &TomlMember::key);
    return found == members.end() ? TomlNode() : TomlAccess::look_at(found->value);
}

std::vector<TomlEntry> TomlNode::entries() const {
    ENFILADE_CHECK(kind_ == TomlKind::table);
    std::vector<TomlEntry> entries;
    entries.reserve(size());
    for (const TomlMember& member : *as_value(node_).members)
        entries.push_back({member.key, member.key_place, TomlAccess::look_at(member.value)});
    return entries;
}

TomlDocument::TomlDocument(std::unique_ptr<Tree> tree) : tree_(std::move(tree)) {}
TomlDocument::TomlDocument(TomlDocument&&) noexcept = default;
TomlDocument& TomlDocument::operator=(TomlDocument&&) noexcept = default;
TomlDocument::~TomlDocument() = default;

TomlNode TomlDocument::root() const { return TomlAccess::look_at(tree_->root); }

void TomlDocument::move_lines(std::uint32_t by) {
    tree_->root.place.line += by;
    for (std::vector<TomlValue>& items : tree_->arrays)
        for (TomlValue& item : items) item.place.line += by;
    for (std::vector<TomlMember>& members : tree_->tables)
        for (TomlMember& member : members) {
            member.key_place.line += by;
            member.value.place.line += by;
        }
}

std::optional<TomlDocument> TomlDocument::parse(std::string_view text, const TomlLimits& limits, Findings& findings) {
    if (auto problem = scan_toml(text, limits)) {
        findings.push_back(std::move(*problem));
        return {};
    }
    std::optional<TomlTree> tree = parse_plain_toml(text);
    if (!tree) {
        if (auto problem = scan_for_library(text)) {
            findings.push_back(std::move(*problem));
            return {};
        }
        tree = parse_any_toml(text, findings);
    }
    if (!tree) return {};
    return TomlDocument(std::make_unique<Tree>(Tree{std::move(*tree)}));
}

}  // namespace enfilade
