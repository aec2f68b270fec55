#include "app/play/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/user_folders.h"
#include "base/files.h"
#include "base/owned_folder.h"
#include "formats/text_parts.h"
#include "formats/toml.h"

namespace enfilade {
namespace {

constexpr std::string_view kKeysTable = "keys";
constexpr std::size_t kMostNotes = 4;

constexpr std::string_view kHead =
    "# What Enfilade remembers for you. The menu writes this file when you change something there; you may also edit\n"
    "# it while the game is closed. A key that is missing is as usual. `enfilade play --help` has each as an option.\n";

constexpr std::string_view kUnknownHead = "\n# Not known to this version of Enfilade.\n";

void note(SettingsReading& reading, TextPlace place, Severity severity, std::string code, std::string sentence) {
    reading.findings.push_back({place, severity, std::move(code), std::move(sentence)});
}

/// The value as the text that a setting reads.
std::string plain_text(const TomlNode& node) {
    return node.kind() == TomlKind::string ? std::string(node.text()) : value_text(node);
}

/// What nobody knows is of some later version. So much of it can only be a mistake [bytes]; a file that is longer than
/// what is read could never be read again.
constexpr std::size_t kMostUnknown = std::size_t{1} << 16;

void keep_line(SettingsReading& reading, std::string& lines, const TomlEntry& entry) {
    const std::string line = string_text(entry.key) + " = " + value_text(entry.value) + "\n";
    if (reading.unknown.settings.size() + reading.unknown.keys.size() + line.size() > kMostUnknown)
        return note(reading, entry.key_place, Severity::error, "too-large",
                    "expected at most 64 KiB of keys that nobody knows; this one and some others are not kept");
    lines += line;
}

void read_keys_of(SettingsReading& reading, const TomlEntry& entry, Control control) {
    const std::string expected = "expected up to two names of keys, such as [\"W\", \"Up\"]";
    const TomlNode& list = entry.value;
    if (list.kind() != TomlKind::array || list.size() > 2)
        return note(reading, list.place(), Severity::error, "wrong-type", expected);
    ControlKeys keys{};
    for (std::size_t i = 0; i < list.size(); ++i) {
        const TomlNode name = list.at(i);
        if (name.kind() == TomlKind::string) keys[i] = key_named(name.text());
        if (keys[i] == KeyCode::unknown)
            return note(reading, name.place(), Severity::error, "unknown-word",
                        expected + "; found " + in_quotes(value_text(name)));
    }
    reading.settings.bindings[static_cast<std::size_t>(control)] = keys;
}

void read_bindings(SettingsReading& reading, const TomlEntry& table) {
    if (table.value.kind() != TomlKind::table)
        return note(reading, table.value.place(), Severity::error, "wrong-type", "expected a table of keys, [keys]");
    for (const TomlEntry& entry : table.value.entries()) {
        if (const auto control = control_named(entry.key)) {
            read_keys_of(reading, entry, *control);
            continue;
        }
        std::vector<std::string_view> known;
        for (int i = 0; i < kControls; ++i) known.push_back(info_of(static_cast<Control>(i)).name);
        note(reading, entry.key_place, Severity::warning, "unknown-key",
             "nothing can be bound to " + in_quotes(entry.key) + nearest_suggestion(entry.key, known) +
                 "; it is kept as it is");
        keep_line(reading, reading.unknown.keys, entry);
    }
}

void read_setting(SettingsReading& reading, const TomlEntry& entry, const Setting& setting) {
    if (const Result<void> valid = setting.read(setting, plain_text(entry.value), reading.settings); !valid.ok())
        note(reading, entry.value.place(), Severity::error, "valid-value",
             in_quotes(entry.key) + ": " + valid.error().what + "; it is as usual until this is put right");
}

void keep_unknown(SettingsReading& reading, const TomlEntry& entry) {
    std::vector<std::string_view> known{kKeysTable};
    for (const Setting& setting : all_settings()) known.push_back(setting.name);
    note(
        reading, entry.key_place, Severity::warning, "unknown-key",
        "there is no setting " + in_quotes(entry.key) + nearest_suggestion(entry.key, known) + "; it is kept as it is");
    keep_line(reading, reading.unknown.settings, entry);
}

}  // namespace

SettingsReading read_settings(std::string_view text) {
    SettingsReading reading;
    const auto document = TomlDocument::parse(text, {}, reading.findings);
    if (!document) return reading;
    for (const TomlEntry& entry : document->root().entries()) {
        const auto settings = all_settings();
        const auto setting = std::ranges::find(settings, entry.key, &Setting::name);
        if (entry.key == kKeysTable)
            read_bindings(reading, entry);
        else if (setting != settings.end())
            read_setting(reading, entry, *setting);
        else
            keep_unknown(reading, entry);
    }
    return reading;
}

std::string write_settings(const Settings& settings, const UnknownKeys& unknown) {
    std::string text(kHead);
    for (const Setting& setting : all_settings()) {
        const std::string value = setting.text(setting, settings);
        const std::string written = setting.is_flag   ? std::string(value == "on" ? "true" : "false")
                                    : setting.is_word ? string_text(value)
                                                      : value;
        text += fmt::format("\n# {}\n{} = {}\n", setting.help, setting.name, written);
    }
    if (!unknown.settings.empty()) text += std::string(kUnknownHead) + unknown.settings;
    text += "\n# Up to two keys for each thing that keys do; Esc always opens the menu.\n[keys]\n";
    for (int i = 0; i < kControls; ++i) {
        const auto control = static_cast<Control>(i);
        std::vector<std::string> keys;
        for (const KeyCode key : keys_for(settings.bindings, control))
            if (key != KeyCode::unknown) keys.emplace_back(name_of(key));
        text += fmt::format("{} = {}\n", info_of(control).name, value_text(keys));
    }
    if (!unknown.keys.empty()) text += std::string(kUnknownHead) + unknown.keys;
    return text;
}

std::string settings_path() { return in_user_folder(UserFolder::config, "settings.toml"); }

SettingsStore::SettingsStore(std::string path) : path_(std::move(path)) {
    std::error_code unknown;
    if (path_.empty() || !std::filesystem::exists(path_, unknown)) return;
    const auto bytes = read_file(path_);
    SettingsReading reading;
    if (bytes.ok())
        reading = read_settings(as_text(bytes.value()));
    else
        note(reading, {}, Severity::error, "unreadable", bytes.error().what);
    is_damaged_ = has_errors(reading.findings);
    for (const Finding& finding : reading.findings)
        if (notes_.size() < kMostNotes) notes_.push_back(to_text(path_, finding));
    if (is_damaged_)
        notes_.push_back(
            "What could not be read of the settings is as usual. The file is set aside before it is written anew.");
    now_ = kept_ = std::move(reading.settings);
    unknown_ = std::move(reading.unknown);
}

void SettingsStore::change(const Settings& settings) {
    keep_changes(now_, settings, kept_);
    now_ = settings;
    is_changed_ = true;
}

Result<void> SettingsStore::save() {
    if (!is_changed_ || path_.empty()) return {};
    std::error_code failed;
    std::filesystem::create_directories(std::filesystem::path(path_).parent_path(), failed);
    if (failed) return Error{path_, "the folder for the settings cannot be made: " + failed.message()};
    if (is_damaged_)
        if (const auto aside = set_aside(path_); !aside.ok()) return aside.error();
    if (const Result<void> done = write_file(path_, std::string_view(write_settings(kept_, unknown_))); !done.ok())
        return done.error();
    is_changed_ = is_damaged_ = false;
    return {};
}

}  // namespace enfilade
