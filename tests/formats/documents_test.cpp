// The manual and the schemas say what the readers do: the same keys, the same dialects, the same needs.
#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/files.h"
#include "formats/map_keys.h"
#include "formats/map_toml.h"
#include "formats/png.h"
#include "formats/script.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

using testing::IsEmpty;
using testing::UnorderedElementsAreArray;

std::string file_text(const std::string& path) {
    const auto bytes = read_file(ENFILADE_SOURCE_DIR "/maps/" + path);
    EXPECT_TRUE(bytes.ok());
    return bytes ? std::string(as_text(bytes.value())) : "";
}

/// A key as these tests compare it.
std::string described(const std::string& path, bool required) { return path + (required ? " (needed)" : ""); }

std::vector<std::string> described(const std::vector<KeyInfo>& keys) {
    std::vector<std::string> all;
    for (const KeyInfo& key : keys) all.push_back(described(key.path, key.required));
    return all;
}

using Json = nlohmann::json;

/// The member of that name; null where there is none.
const Json& member(const Json& object, const std::string& name) {
    static const Json kNothing;
    const auto found = object.find(name);
    return found == object.end() ? kNothing : *found;
}

/// The string in the member of that name; empty where there is none.
std::string text_member(const Json& object, const std::string& name) {
    const Json& text = member(object, name);
    return text.is_string() ? text.get<std::string>() : "";
}

/// Walks through a schema: what each key's path is and what is said about it.
class SchemaWalk {
public:
    explicit SchemaWalk(const std::string& path) : schema_(Json::parse(file_text(path))) { visit(schema_, ""); }

    std::vector<std::string> keys() const {
        std::vector<std::string> all;
        for (const auto& [path, key] : keys_) all.push_back(described(path, key.required));
        return all;
    }

    /// What the schema says about one key, references followed.
    const Json& about(const std::string& path) const { return *keys_.at(path).json; }

    std::vector<std::string> without_description() const {
        std::vector<std::string> all;
        for (const auto& [path, key] : keys_)
            if (text_member(*key.json, "description").empty() && path.find("doom.") == std::string::npos)
                all.push_back(path);
        return all;
    }

private:
    struct Key {
        const Json* json;
        bool required;
    };

    const Json& followed(const Json& json) const {
        const std::string reference = text_member(json, "$ref");
        return reference.empty() ? json : schema_.at("definitions").at(reference.substr(reference.rfind('/') + 1));
    }

    void visit(const Json& object, const std::string& prefix) {
        EXPECT_EQ(member(object, "additionalProperties"), Json(false)) << prefix;
        for (const auto& [name, written] : member(object, "properties").items()) {
            const Json& json = followed(written);
            const Json& required = member(object, "required");
            keys_[prefix + name] = {&json, std::ranges::find(required, Json(name)) != required.end()};
            const Json& items = member(json, "items");
            const Json& inner = items.is_object() ? followed(items) : json;
            if (!member(inner, "properties").empty()) visit(inner, prefix + name + ".");
        }
    }

    Json schema_;
    std::map<std::string, Key> keys_;
};

TEST(MapSchema, HasTheReadersKeys) {
    EXPECT_THAT(SchemaWalk("enfilade.schema.json").keys(), UnorderedElementsAreArray(described(map_keys())));
}

TEST(MapSchema, DescribesEveryKey) { EXPECT_THAT(SchemaWalk("enfilade.schema.json").without_description(), IsEmpty()); }

/// Strings that name no file, though nothing but this list says so: names of what is in the map, and words for people.
constexpr std::string_view kOtherStrings[] = {"name",       "sector",    "tags",  "class", "next",       "via",
                                              "target",     "key",       "like",  "sound", "move_sound", "down_sound",
                                              "stop_sound", "gives_key", "group", "sun",   "between"};

/// What a string must look like to name a file, as schemas say it.
constexpr std::string_view kNamePattern =
    R"(^(?!(.*/)?\.{0,2}(/|$))[^\u0000-\u001f\u007f-\u009f\u2028-\u202e\u2066-\u2069]+$)";
constexpr std::string_view kPathPattern = R"(^[^\u0000-\u001f\u007f-\u009f\u2028-\u202e\u2066-\u2069]+$)";

/// A string in a schema, or those of an array; null where it has other values or only words of a list.
const Json* strings_of(const Json& json) {
    const Json& items = member(json, "items");
    const Json& strings = items.is_object() ? items : json;
    const bool is_string = text_member(strings, "type") == "string" && member(strings, "enum").empty();
    return is_string ? &strings : nullptr;
}

/// A key with a string is one that names files, and then the schema has one of these patterns, or it is listed.
void expect_patterns_of_files(const SchemaWalk& schema, const std::vector<KeyInfo>& keys,
                              const std::vector<std::string>& below_folder) {
    for (const KeyInfo& key : keys) {
        const Json* const strings = strings_of(schema.about(key.path));
        if (!strings) continue;
        const std::string name = key.path.substr(key.path.rfind('.') + 1), pattern = text_member(*strings, "pattern");
        const bool is_other = std::ranges::find(kOtherStrings, name) != std::end(kOtherStrings);
        EXPECT_NE(key.files != Files::none, is_other) << key.path << ": does it name files?";
        switch (key.files) {
            case Files::none: EXPECT_EQ(pattern, "") << key.path; break;
            case Files::anywhere: EXPECT_EQ(pattern, kPathPattern) << key.path; break;
            case Files::below_folder: EXPECT_THAT(below_folder, testing::Contains(pattern)) << key.path;
        }
    }
}

TEST(MapSchema, KnowsWhichKeysNameFiles) {
    const SchemaWalk schema("enfilade.schema.json");
    const std::string of_textures = text_member(schema.about("sectors.floor.texture"), "pattern");
    expect_patterns_of_files(schema, map_keys(), {std::string(kNamePattern), of_textures});
}

TEST(FlythroughSchema, KnowsWhichKeysNameFiles) {
    expect_patterns_of_files(SchemaWalk("flythrough.schema.json"), script_keys(), {});
}

TEST(FlythroughSchema, HasTheReadersKeys) {
    EXPECT_THAT(SchemaWalk("flythrough.schema.json").keys(), UnorderedElementsAreArray(described(script_keys())));
}

TEST(FlythroughSchema, DescribesEveryKey) {
    EXPECT_THAT(SchemaWalk("flythrough.schema.json").without_description(), IsEmpty());
}

/// Checks the limits of the numbers among these keys.
void expect_same_limits(const SchemaWalk& schema, const std::vector<KeyInfo>& keys) {
    for (const KeyInfo& key : keys) {
        const Json& json = schema.about(key.path);
        for (const auto& [name, limit] : {std::pair("minimum", key.range.low), std::pair("maximum", key.range.high)}) {
            const Json& written = member(json, name);
            if (!written.is_number()) continue;
            EXPECT_NEAR(written.get<double>(), limit, 1e-6 * std::abs(limit)) << key.path << " " << name;
        }
    }
}

// Of vertices the schema knows the limit before, the reader after rounding; hence not bit for bit.
TEST(MapSchema, HasTheReadersLimits) { expect_same_limits(SchemaWalk("enfilade.schema.json"), map_keys()); }

TEST(FlythroughSchema, HasTheReadersLimits) { expect_same_limits(SchemaWalk("flythrough.schema.json"), script_keys()); }

/// The keys in the table of one section of the manual, each as "PREFIXkey", with its marks.
std::vector<std::string> manual_keys(std::string_view section, const std::string& prefix) {
    const std::string text = file_text("FORMAT.md");
    std::vector<std::string> keys;
    bool inside = false;
    for (LineReader lines(text); const auto line = lines.next();) {
        if (line->text.starts_with("##")) inside = line->text == "### " + std::string(section);
        if (!inside || !line->text.starts_with("| `")) continue;
        const std::string_view row = line->text.substr(3);
        const std::string_view before_meaning = row.substr(0, row.rfind(" | "));
        const std::string_view usual = before_meaning.substr(before_meaning.rfind("| ") + 1);
        keys.push_back(described(prefix + std::string(row.substr(0, row.find('`'))), usual == " needed") +
                       (row.find("★") < row.find('|') ? " ★" : ""));
    }
    return keys;
}

struct Section {
    const char* title;
    const char* prefix;
};

void PrintTo(const Section& section, std::ostream* out) { *out << section.title; }

/// The reader's keys directly below a prefix.
std::vector<std::string> reader_keys(const std::vector<KeyInfo>& all, const std::string& prefix, bool with_stars) {
    std::vector<std::string> keys;
    for (const KeyInfo& key : all)
        if (key.path.starts_with(prefix) && key.path.find('.', prefix.size()) == std::string::npos)
            keys.push_back(described(key.path, key.required) + (with_stars && !key.tutorial ? " ★" : ""));
    return keys;
}

class MapManual : public testing::TestWithParam<Section> {};

TEST_P(MapManual, HasTheReadersKeys) {
    const auto [title, prefix] = GetParam();
    EXPECT_THAT(manual_keys(title, prefix), testing::ElementsAreArray(reader_keys(map_keys(), prefix, true)));
}

INSTANTIATE_TEST_SUITE_P(
    Sections, MapManual,
    testing::Values(
        Section{"The map", ""}, Section{"The picture", "render."}, Section{"The player", "player."},
        Section{"A sector", "sectors."}, Section{"A floor or ceiling", "sectors.floor."},
        Section{"A floor or ceiling", "sectors.ceiling."}, Section{"A layer", "sectors.floor.layers."},
        Section{"A layer", "sectors.ceiling.layers."}, Section{"A loop", "sectors.loops."},
        Section{"A wall", "sectors.loops.walls."}, Section{"A wall", "sectors.wall."},
        Section{"A wall", "sectors.loops.wall."}, Section{"A polygon", "sectors.polygon."},
        Section{"A polygon", "sectors.loops.polygon."}, Section{"A prefab", "prefabs."},
        Section{"An opening", "openings."}, Section{"A floor or ceiling", "openings.floor."},
        Section{"A trigger", "openings.triggers."}, Section{"A panel", "sectors.panels."},
        Section{"A thing", "things."}, Section{"A sprite's frame", "things.frames."},
        Section{"A trigger", "sectors.triggers."}, Section{"A trigger", "sectors.loops.walls.triggers."},
        Section{"A trigger", "sectors.panels.triggers."}, Section{"A trigger", "things.triggers."},
        Section{"A light effect", "sectors.light_effect."}, Section{"A light effect", "sectors.triggers.effect."},
        Section{"A light effect", "lights.effect."}, Section{"A light", "lights."},
        Section{"An animation", "animations."}, Section{"A switch", "switches."}, Section{"A sound", "sounds."},
        Section{"Left-overs of Doom", "sectors.doom."}, Section{"Left-overs of Doom", "sectors.loops.walls.doom."},
        Section{"Left-overs of Doom", "sectors.panels.doom."}, Section{"Left-overs of Doom", "things.doom."}));

class FlythroughManual : public testing::TestWithParam<Section> {};

TEST_P(FlythroughManual, HasTheReadersKeys) {
    const auto [title, prefix] = GetParam();
    EXPECT_THAT(manual_keys(title, prefix), testing::ElementsAreArray(reader_keys(script_keys(), prefix, false)));
}

INSTANTIATE_TEST_SUITE_P(Sections, FlythroughManual,
                         testing::Values(Section{"A script", ""}, Section{"A start", "start."},
                                         Section{"A leg", "legs."}));

/// The manual's examples: what stands between ```toml and ```.
std::vector<std::string> examples() {
    const std::string text = file_text("FORMAT.md");
    std::vector<std::string> all;
    bool inside = false;
    for (LineReader lines(text); const auto line = lines.next();) {
        if (line->text == "```toml") all.emplace_back();
        if (inside && line->text != "```") all.back() += std::string(line->text) + "\n";
        inside = line->text == "```toml" || (inside && line->text != "```");
    }
    return all;
}

TEST(MapManual, HasASoundSmallestMap) { EXPECT_THAT(read_map(examples().at(0)).findings, IsEmpty()); }

TEST(MapManual, HasASoundTutorialMap) {
    for (const std::string& example : examples())
        if (example.find("[sectors.floor]") != std::string::npos) {
            EXPECT_THAT(read_map(example).findings, IsEmpty()) << example;
            return;
        }
    ADD_FAILURE() << "no such example";
}

TEST(FlythroughManual, HasASoundScript) {
    for (const std::string& example : examples())
        if (example.find("[[legs]]") != std::string::npos) {
            EXPECT_THAT(read_script(example).findings, IsEmpty()) << example;
            return;
        }
    ADD_FAILURE() << "no such example";
}

// Every key is in a map that is tested.

/// A key by the kind of table that it is in: those of walls are one, wherever a wall may be written.
std::string kind_of(const std::string& path) {
    static const std::map<std::string, std::string> kAlike{
        {"floor", "flat"}, {"ceiling", "flat"}, {"walls", "wall"}, {"light_effect", "effect"}};
    const std::size_t dot = path.rfind('.');
    if (dot == std::string::npos) return path;
    const std::string tables = path.substr(0, dot), table = tables.substr(tables.rfind('.') + 1);
    const auto alike = kAlike.find(table);
    return (alike == kAlike.end() ? table : alike->second) + path.substr(dot);
}

void add_keys(TomlNode table, const std::string& prefix, std::set<std::string>& keys) {
    for (const TomlEntry& entry : table.entries()) {
        const std::string path = prefix + std::string(entry.key);
        keys.insert(kind_of(path));
        if (entry.value.kind() == TomlKind::table) add_keys(entry.value, path + ".", keys);
        for (std::size_t i = 0; entry.value.kind() == TomlKind::array && i < entry.value.size(); ++i)
            if (entry.value.at(i).kind() == TomlKind::table) add_keys(entry.value.at(i), path + ".", keys);
    }
}

TEST(MapManual, HasNoKeyThatNoTestedMapHas) {
    std::set<std::string> keys;
    for (const std::string folder : {"/maps/", "/maps/prefabs/", "/tests/data/every_key/"})
        for (const std::string& name : list_folder(ENFILADE_SOURCE_DIR + folder)) {
            if (!name.ends_with(".toml")) continue;
            const auto text = read_file(ENFILADE_SOURCE_DIR + folder + name);
            Findings findings;
            const auto document = TomlDocument::parse(as_text(text.value()), {kMaxMapBytes, kMaxMapValues}, findings);
            ASSERT_TRUE(document) << name;
            add_keys(document->root(), "", keys);
        }
    for (const KeyInfo& key : map_keys()) EXPECT_TRUE(keys.contains(kind_of(key.path))) << key.path;
}

// The sizes of pictures.

/// "256 x 384" for each picture in a row of the manual's table of sizes.
std::map<std::string, std::string> sizes_in_manual() {
    std::map<std::string, std::string> sizes;
    bool inside = false;
    const std::string text = file_text("FORMAT.md");
    for (LineReader lines(text); const auto line = lines.next();) {
        if (line->text == "| width x height | names |") inside = true;
        if (line->text.empty()) inside = false;
        const std::string_view size = line->text.substr(0, line->text.find(" | ")).substr(inside ? 2 : 0);
        for (std::size_t at = line->text.find('`'); inside && at != std::string_view::npos;) {
            const std::size_t end = line->text.find('`', at + 1);
            sizes[std::string(line->text.substr(at + 1, end - at - 1))] = size;
            at = line->text.find('`', end + 1);
        }
    }
    return sizes;
}

TEST(MapManual, HasTheSizesOfAllPictures) {
    std::map<std::string, std::string> sizes;
    for (const std::string& name : list_folder(ENFILADE_SOURCE_DIR "/maps/textures")) {
        if (!name.ends_with(".png")) continue;
        const auto bytes = read_file(ENFILADE_SOURCE_DIR "/maps/textures/" + name);
        const auto size = png_size(bytes.value());
        ASSERT_TRUE(size) << name;
        sizes[name.substr(0, name.size() - 4)] = std::to_string(size->width) + " x " + std::to_string(size->height);
    }
    EXPECT_GT(sizes.size(), 100u);
    EXPECT_EQ(sizes_in_manual(), sizes);
}

}  // namespace
}  // namespace enfilade
