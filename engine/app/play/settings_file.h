// Where the settings are kept from one start of the program to the next: a TOML file with a comment for every key.
#pragma once
#include <string>
#include <vector>

#include "app/play/settings.h"
#include "base/finding.h"

namespace enfilade {

/// A text as settings, and what is wrong with it. What is wrong or missing is as usual.
struct SettingsReading {
    Settings settings;
    Findings findings;
    std::string unknown;  ///< top-level keys that nobody knows, as lines: another version may
};
SettingsReading read_settings(std::string_view text);

/// The whole file: every key with what it does.
std::string write_settings(const Settings& settings, std::string_view unknown = {});

/// $XDG_CONFIG_HOME/enfilade/settings.toml, or ~/.config/…; empty where there is no home.
std::string settings_path();

/// The settings of a player: those that are kept, and those that hold now, which options may have changed.
class SettingsStore {
public:
    /// Nothing is read, and nothing kept.
    SettingsStore() = default;
    /// Reads the file where there is one. path : empty: nothing is read, and nothing kept
    explicit SettingsStore(std::string path);

    /// What the player should know of the file: sentences, none where all is well.
    const std::vector<std::string>& notes() const { return notes_; }

    const Settings& now() const { return now_; }
    /// For this start of the program only.
    void change_for_now(const Settings& settings) { now_ = settings; }
    /// They hold now; what changed is kept by the next save().
    void change(const Settings& settings);

    /// Writes what changed, where something did. A file with errors is first set aside under a name of its own, with
    /// ".damaged" behind it.
    Result<void> save();

private:
    std::string path_;
    Settings now_, kept_;
    std::string unknown_;
    std::vector<std::string> notes_;
    bool is_damaged_ = false, is_changed_ = false;
};

}  // namespace enfilade
