#include "formats/map_keys.h"
#include "formats/map_toml.h"

namespace enfilade {
namespace {

Dialect dialect_of(TomlNode root) {
    return root.find("format").kind() == TomlKind::absent ? Dialect::tutorial : Dialect::enfilade;
}

}  // namespace

MapReading read_map(std::string_view text) {
    MapReading result;
    const auto document = TomlDocument::parse(text, {kMaxMapBytes, kMaxMapValues}, result.findings);
    if (!document) return result;
    Reading reading{result.findings, dialect_of(document->root())};
    read_record(reading, document->root(), result.map);
    sort_by_place(result.findings);
    return result;
}

bool is_map(std::string_view text) {
    Findings ignored;
    const auto document = TomlDocument::parse(text, {kMaxMapBytes, kMaxMapValues}, ignored);
    return document && document->root().find("sectors").kind() == TomlKind::array;
}

}  // namespace enfilade
