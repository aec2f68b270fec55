#include "formats/file_key.h"

#include "formats/file_name.h"

namespace enfilade {

bool expect_file_name(Reading& reading, const NamedValue& value, Files files) {
    const std::string_view name = value.node.text();
    const Status refused = files == Files::anywhere ? refuse_as_path(name) : refuse_as_file_name(name);
    if (refused) reading.error(value.node.place(), "bad-file-name", quoted(value.name) + ": " + refused->what);
    return !refused;
}

void read_file_name(Reading& reading, const NamedValue& value, Files files, std::string& field) {
    std::string name;
    read_value(reading, value, {}, name);
    if (!name.empty() && expect_file_name(reading, value, files)) field = std::move(name);
}

void read_file_name(Reading& reading, const NamedValue& value, Files files, std::vector<std::string>& field) {
    if (!expect(reading, value, TomlKind::array)) return;
    field.clear();
    for (std::size_t i = 0; i < value.node.size() && !reading.is_full(); ++i)
        read_file_name(reading, {value.name, value.node.at(i)}, files, field.emplace_back());
}

}  // namespace enfilade
