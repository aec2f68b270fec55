// Looking at documents.
#include "formats/toml_tree.h"

#include <algorithm>
#include <cmath>

#include "base/result.h"
#include "formats/text_parts.h"

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
    ENFILADE_CHECK(kind_ == TomlKind::string || kind_ == TomlKind::date);
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

namespace {

/// Without a point or an exponent it would be read as a whole number.
std::string real_text(double number) {
    if (std::isnan(number)) return "nan";
    if (std::isinf(number)) return number < 0 ? "-inf" : "inf";
    const std::string text = number_text(number);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string array_text(const TomlNode& array) {
    std::string text = "[";
    for (std::size_t i = 0; i < array.size(); ++i) text += (i == 0 ? "" : ", ") + value_text(array.at(i));
    return text + "]";
}

std::string table_text(const TomlNode& table) {
    TableText text(TableText::Style::braces);
    for (const TomlEntry& entry : table.entries()) text.add(string_text(entry.key), value_text(entry.value));
    return text.text();
}

}  // namespace

std::string value_text(const TomlNode& value) {
    switch (value.kind()) {
        case TomlKind::absent: break;
        case TomlKind::string: return string_text(value.text());
        case TomlKind::integer: return std::to_string(value.integer());
        case TomlKind::real: return real_text(value.number());
        case TomlKind::boolean: return value_text(value.boolean());
        case TomlKind::date: return std::string(value.text());
        case TomlKind::array: return array_text(value);
        case TomlKind::table: return table_text(value);
    }
    ENFILADE_CHECK(false);
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
