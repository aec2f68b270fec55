#include "formats/both_parsers.h"

#include <bit>

#include "formats/toml_tree.h"

namespace enfilade {
namespace {

constexpr TomlLimits kLimits{std::size_t{16} << 20, std::size_t{1} << 22};

void tell(TomlNode node, std::string& told) {
    told += std::to_string(node.place().line) + ':' + std::to_string(node.place().column) + ' ';
    switch (node.kind()) {
        case TomlKind::table:
            for (const TomlEntry& entry : node.entries()) {
                told += std::string(entry.key) + '@' + std::to_string(entry.key_place.line) + ':' +
                        std::to_string(entry.key_place.column) + ' ';
                tell(entry.value, told);
            }
            break;
        case TomlKind::array:
            for (std::size_t i = 0; i < node.size(); ++i) tell(node.at(i), told);
            break;
        case TomlKind::string: told += '"' + std::string(node.text()) + '"'; break;
        case TomlKind::boolean: told += node.boolean() ? "true" : "false"; break;
        case TomlKind::integer: told += std::to_string(node.integer()); break;
        case TomlKind::real: told += "real " + std::to_string(std::bit_cast<std::uint64_t>(node.number())); break;
        default: told += "?";
    }
    told += '\n';
}

std::string told(const std::optional<TomlTree>& tree) {
    std::string all;
    if (tree) tell(TomlAccess::look_at(tree->root), all);
    return all;
}

}  // namespace

ParsedTwice parse_twice(std::string_view text) {
    Findings findings;
    if (scan_toml(text, kLimits)) return {};
    const auto plain = parse_plain_toml(text);
    if (!plain) return {};
    return {true, told(plain), told(parse_any_toml(text, findings))};
}

}  // namespace enfilade
