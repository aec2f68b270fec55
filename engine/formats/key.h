// One list of keys for each kind of record: reading, writing, messages, and the tests of schema and manual use it.
#pragma once
#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/containers.h"
#include "base/parallel.h"
#include "formats/reading.h"
#include "formats/text_parts.h"

namespace enfilade {

/// The dialect since which there is a key: both have it, or the maps of the tutorial do not.
inline constexpr Dialect kBoth = Dialect::tutorial, kNew = Dialect::enfilade;

/// Whether a file must have a key. `written`: it need not, but write_map always gives it, because what a file without
/// it gets depends on the rest of the file.
enum class Need : std::uint8_t { optional, written, required };

/// Which files the strings of a key name: none, those below the folder they are looked for in, or any.
enum class Files : std::uint8_t { none, below_folder, anywhere };

/// A key that a record's table may have.
template <class Record>
struct Key {
    std::string_view name;
    Dialect since = Dialect::tutorial;  ///< enfilade: an error in a tutorial file
    Need need = Need::optional;
    Range range;
    void (*read)(Reading&, const NamedValue&, Range, Record&) = nullptr;
    /// Adds the key unless the field is as in `defaults`; null: written elsewhere, or an alias that is not written.
    void (*write)(TableText&, const Key&, const Record&, const Record& defaults) = nullptr;
    Files files = Files::none;
};

/// Where a message lists keys, the record's name comes with its article: "a wall".
template <class Record>
struct KeyList {
    std::string_view record;
    std::span<const Key<Record>> keys;
    /// Where a key that this record has not is at home, for those that are often looked for here; null or "": nothing.
    std::string_view (*home_of)(std::string_view key) = nullptr;
};

/// The keys of a kind of record, in the order they are written. Defined once for each, beside its keys.
template <class Record>
const KeyList<Record>& keys_of();

/// What is wrong with a record as a whole, once its keys are read. For most kinds nothing.
template <class Record>
void check_record(Reading&, TomlNode, std::span<const TomlEntry>, Record&) {}

/// Notes it. Returns the key that was meant, or nothing where none is near.
template <class Record>
std::string_view unknown_key(Reading& reading, const TomlEntry& entry, const KeyList<Record>& list) {
    std::vector<std::string_view> known;
    for (const Key<Record>& key : list.keys) known.push_back(key.name);
    const std::string home(list.home_of ? list.home_of(entry.key) : "");
    reading.error(entry.key_place, "unknown-key",
                  std::string(list.record) + " has no key " + in_quotes(entry.key) +
                      (home.empty() ? suggestion(entry.key, known) : "; " + home));
    return nearest_word(entry.key, known);
}

void needs_format_1(Reading& reading, const TomlEntry& entry);
void missing_key(Reading& reading, TextPlace place, std::string_view record, std::string_view key);

/// Fills in where a record's keys are and which of them are wrong, if the record wants to know.
template <class Record>
class RecordNotes {
public:
    RecordNotes(Reading& reading, Record& record, std::size_t keys) : reading_(reading), record_(record) {
        if constexpr (requires { record.places; }) record.places.reserve(keys);
    }

    void read(const Key<Record>& key, const NamedValue& value) {
        const std::size_t before = reading_.findings.size();
        key.read(reading_, value, key.range, record_);
        const std::size_t found = reading_.findings.size() - before;
        found_in_keys_ += found;
        if constexpr (requires { record_.places; }) record_.places.note(key.name, value.node.place(), found == 0);
    }

    /// At last: what was found, and not in one of the keys, is about the record; what is full finds nothing more.
    void end() {
        if constexpr (requires { record_.places; })
            if (reading_.findings.size() - at_start_ > found_in_keys_ || reading_.is_full())
                record_.places.note_fault();
    }

private:
    Reading& reading_;
    Record& record_;
    std::size_t at_start_ = reading_.findings.size(), found_in_keys_ = 0;
};

/// Reads a table into a record with the record's list of keys.
template <class Record>
void read_record(Reading& reading, TomlNode table, Record& record) {
    const KeyList<Record>& list = keys_of<Record>();
    const std::vector<TomlEntry> entries = table.entries();
    if constexpr (requires { record.place; }) record.place = table.place();
    RecordNotes notes(reading, record, entries.size());
    std::vector<std::string_view> misspelt;  // a key that is missing because of that is mended with it
    for (const TomlEntry& entry : entries) {
        if (reading.is_full()) return notes.end();
        const auto has_name = [&](const Key<Record>& key) { return key.name == entry.key; };
        const auto key = std::find_if(list.keys.begin(), list.keys.end(), has_name);
        if (key == list.keys.end())
            misspelt.push_back(unknown_key(reading, entry, list));
        else if (key->since > reading.dialect)
            needs_format_1(reading, entry);
        else
            notes.read(*key, {entry.key, entry.value});
    }
    for (const Key<Record>& key : list.keys) {
        const auto is_given = [&](const TomlEntry& entry) { return entry.key == key.name; };
        if (key.need == Need::required && std::none_of(entries.begin(), entries.end(), is_given) &&
            std::find(misspelt.begin(), misspelt.end(), key.name) == misspelt.end())
            missing_key(reading, table.place(), list.record, key.name);
    }
    check_record(reading, table, entries, record);
    notes.end();
}

template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
template <class T>
inline constexpr bool is_optional<Boxed<T>> = true;

/// Whether read_value has an overload for the type; the others are records, or vectors or optionals of them.
template <class T>
concept Plain =
    requires(Reading& reading, const NamedValue& value, T& field) { read_value(reading, value, Range{}, field); };

/// One key, for tests that hold the schemas and the manual to the readers.
struct KeyInfo {
    std::string path;  ///< "sectors.loops.walls.next"
    bool tutorial;     ///< may stand in a tutorial file
    bool required;
    Range range;
    Files files;
};

/// Adds a record's keys, each with the prefix before its name.
template <class Record>
void add_key_infos(std::vector<KeyInfo>& all, const std::string& prefix) {
    for (const Key<Record>& key : keys_of<Record>().keys)
        all.push_back({prefix + std::string(key.name), key.since == Dialect::tutorial, key.need == Need::required,
                       key.range, key.files});
}

/// How many members of an array are tables: room for others would only be taken in vain.
std::size_t tables_in(TomlNode array);

/// Fewer tables than this are not worth a thread of their own.
inline constexpr std::size_t kLeastTablesPerThread = 1024;

/// Parts in which tables are read: enough for any machine, and few enough that what each finds, up to kMaxFindings,
/// takes no memory to speak of.
inline constexpr std::size_t kMostParts = 64;

template <class Field>
void read_field(Reading& reading, const NamedValue& value, Range range, Field& field);

/// Reads an array that has nothing but tables, on several threads if there are many. What is found comes in the order
/// of the text, as if one had read them all.
template <class Record>
void read_tables(Reading& reading, const NamedValue& value, Range range, std::vector<Record>& records) {
    const std::size_t count = value.node.size();
    const std::size_t parts = std::min(count / kLeastTablesPerThread + 1, kMostParts);
    std::vector<Findings> found(parts);
    records.resize(count);
    parallel_for(parts, hardware_threads(), [&](std::size_t part, std::size_t) {
        Reading own{found[part], reading.dialect};
        for (std::size_t i = part * count / parts; i < (part + 1) * count / parts && !own.is_full(); ++i)
            read_field(own, {value.name, value.node.at(i)}, range, records[i]);
    });
    for (const Findings& findings : found)
        for (const Finding& finding : findings) reading.error(finding.place, finding.code, finding.sentence);
}

template <class Field>
void read_field(Reading& reading, const NamedValue& value, Range range, Field& field) {
    if constexpr (Plain<Field>) {
        read_value(reading, value, range, field);
    } else if constexpr (is_optional<Field>) {
        read_field(reading, value, range, field.emplace());
    } else if constexpr (is_vector<Field>) {
        if (!(Plain<typename Field::value_type> ? expect(reading, value, TomlKind::array)
                                                : expect_tables(reading, value)))
            return;
        const std::size_t tables = tables_in(value.node);
        if (tables == value.node.size() && tables >= kLeastTablesPerThread)
            return read_tables(reading, value, range, field);
        field.reserve(tables);
        for (std::size_t i = 0; i < value.node.size() && !reading.is_full(); ++i)
            read_field(reading, {value.name, value.node.at(i)}, range, field.emplace_back());
    } else if (expect_table(reading, value, keys_of<Field>().keys.front().name)) {
        read_record(reading, value.node, field);
    }
}

/// The record as "key = value" pairs, without what is as in `defaults`.
template <class Record>
std::string record_text(const Record& record, const Record& defaults, TableText::Style style) {
    TableText table(style);
    for (const Key<Record>& key : keys_of<Record>().keys)
        if (key.write) key.write(table, key, record, defaults);
    return table.text();
}

template <class Field>
std::string field_text(const Field& field, const Field& defaults) {
    if constexpr (Plain<Field> && !is_optional<Field>) {
        return value_text(field);
    } else if constexpr (is_optional<Field>) {
        return field_text(*field, defaults ? *defaults : typename Field::value_type{});
    } else if constexpr (is_vector<Field>) {
        if (field.size() == 1) return "[" + field_text(field.front(), {}) + "]";
        std::string lines = "[\n";
        for (const auto& record : field) lines += "  " + field_text(record, {}) + ",\n";
        return lines + "]";
    } else {
        return record_text(field, defaults, TableText::Style::braces);
    }
}

/// Whether there is nothing to write about a field.
template <class Field>
bool is_as_in(const Field& field, const Field& defaults) {
    if constexpr (is_optional<Field>)
        return !field;
    else if constexpr (Plain<Field>)
        return field == defaults;
    else if constexpr (is_vector<Field>)
        return field.empty();
    else
        return field_text(field, defaults) == "{}";
}

/// A texture's specification has the name of its picture in it.
template <class Field>
inline constexpr bool kNamesPicture =
    std::is_same_v<Field, TextureSpec> || std::is_same_v<Field, std::optional<TextureSpec>>;

template <class Pointer>
struct MemberPointer;
template <class R, class Field>
struct MemberPointer<Field R::*> {
    using Record = R;
};
/// A key for the field that a path of member pointers leads to: key<&ThingRecord::position, &Vec2::x>("x", …).
template <auto first, auto... rest>
constexpr auto key(std::string_view name, Dialect since, Need need = Need::optional, Range range = {}) {
    using Record = typename MemberPointer<decltype(first)>::Record;
    using Field = std::remove_cvref_t<decltype(((std::declval<Record&>().*first).*....*rest))>;
    return Key<Record>{name,
                       since,
                       need,
                       range,
                       [](Reading& reading, const NamedValue& value, Range within, Record& record) {
                           read_field(reading, value, within, ((record.*first).*....*rest));
                       },
                       [](TableText& table, const Key<Record>& k, const Record& record, const Record& defaults) {
                           const auto& field = ((record.*first).*....*rest);
                           const auto& usual = ((defaults.*first).*....*rest);
                           if (k.need != Need::optional || !is_as_in(field, usual))
                               table.add(k.name, field_text(field, usual));
                       },
                       kNamesPicture<Field> ? Files::below_folder : Files::none};
}

/// The same for what write_map lays out itself, as arrays of tables with headers of their own, or never writes.
template <auto first, auto... rest>
constexpr auto header_key(std::string_view name, Dialect since, Need need = Need::optional, Range range = {}) {
    auto only_read = key<first, rest...>(name, since, need, range);
    only_read.write = nullptr;
    return only_read;
}

}  // namespace enfilade
