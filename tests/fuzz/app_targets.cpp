// What the program keeps for its player and reads from its command line: settings, recordings in parts, the title's
// list, reports and options.
#include <stdlib.h>
#include <sys/stat.h>

#include <filesystem>

#include "app/accuracy/report.h"
#include "app/bench.h"
#include "app/options.h"
#include "app/pictures.h"
#include "app/play/map_list.h"
#include "app/play/settings.h"
#include "app/recorded_flight.h"
#include "base/files.h"
#include "base/hash.h"
#include "base/text.h"
#include "formats/frame_hashes.h"
#include "formats/png.h"
#include "fuzz/targets.h"
#include "render/choice/renderer.h"
#include "support/map_builder.h"
#include "support/temp_dir.h"

namespace enfilade::test {
namespace {

/// The texts between zero bytes, at most so many: the last one has what is left.
std::vector<std::string_view> texts_in(std::span<const std::byte> bytes, std::size_t most) {
    std::vector<std::string_view> texts;
    std::string_view rest = as_text(bytes);
    while (texts.size() + 1 < most && rest.find('\0') != rest.npos) {
        texts.push_back(rest.substr(0, rest.find('\0')));
        rest.remove_prefix(texts.back().size() + 1);
    }
    texts.push_back(rest);
    return texts;
}

// Settings.

/// What the menu shows, and what every renderer is told.
void look_at(const Settings& settings) {
    static const Map map = built(map_of({box_room("room", 0, 0, 8, 4)}));
    for (const Setting& setting : all_settings()) ENFILADE_CHECK(is_printable_line(setting.text(setting, settings)));
    for (const ControlKeys& keys : settings.bindings) ENFILADE_CHECK(is_printable_line(keys_text(keys)));
    for (const RendererKind kind : {RendererKind::column, RendererKind::stencil, RendererKind::reference})
        ENFILADE_CHECK(check_dials(kind, dials_of(settings, kind, map)).ok());
}

/// As the menu does it: what is shown may be typed, and every row may be turned both ways.
void turn_all(Settings settings) {
    for (const Setting& setting : all_settings())
        for (const int steps : {1, -2, 1}) {
            setting.turn(setting, steps, settings);
            ENFILADE_CHECK(setting.read(setting, setting.text(setting, settings), settings).ok());
        }
    bind(settings.bindings, Control::use, static_cast<KeyCode>(4));
    look_at(settings);
}

}  // namespace

void fuzz_settings(std::span<const std::byte> bytes) {
    const SettingsReading reading = read_settings(as_text(bytes));
    look_at(reading.settings);
    turn_all(reading.settings);
    const std::string text = write_settings(reading.settings, reading.unknown);
    const SettingsReading again = read_settings(text);
    ENFILADE_CHECK(!has_errors(again.findings));
    ENFILADE_CHECK(write_settings(again.settings, again.unknown) == text);
    static const TempDir folder;
    static const std::string path = folder.path("settings.toml");
    ENFILADE_CHECK(write_file(path, bytes).ok());
    SettingsStore store(path);
    for (const std::string& note : store.notes()) ENFILADE_CHECK(is_printable_line(note));
    Settings changed = store.now();
    changed.invert_mouse = !changed.invert_mouse;
    store.change(changed);
    ENFILADE_CHECK(store.save().ok());
    ENFILADE_CHECK(!has_errors(read_settings(content(path)).findings));
    ENFILADE_CHECK(read_settings(content(path)).settings.invert_mouse == changed.invert_mouse);
    for (const std::string& file : list_folder(folder.path())) std::filesystem::remove(folder.path(file));
}

// Recordings in parts.

namespace {

constexpr int kFrames = 8;

/// A sheet as a part of a small flight has one, and the word for it in a file of hashes.
const Image& some_sheet() {
    static const Image image = image_of(ContactSheet(kFrames, 16, 10).image());
    return image;
}

}  // namespace

/// Up to four files of hashes, each with a sheet that is whole, beside a script.
void fuzz_parts(std::span<const std::byte> bytes) {
    static const TempDir folder;
    static const std::string script = folder.path("tour.toml");
    static const Bytes sheet = write_png(some_sheet());
    int number = 0;
    for (const std::string_view text : texts_in(bytes, 4)) {
        ENFILADE_CHECK(write_file(part_path(script, number, number, ".hashes"), text).ok());
        ENFILADE_CHECK(write_file(part_path(script, number, number, ".sheet.png"), sheet).ok());
        ++number;
    }
    if (merge_parts(script, kFrames).ok()) {
        const auto whole = read_frame_hashes(content(hashes_path(script)));
        ENFILADE_CHECK(whole.ok() && whole.value().frames.size() == kFrames && whole.value().pictures);
        const RecordedPictures& pictures = *whole.value().pictures;
        DrawPlan plan;
        plan.width = static_cast<int>(pictures.width);
        plan.height = static_cast<int>(pictures.height);
        plan.last = kFrames - 1;
        const KeptPictures kept(script, whole.value(), plan);
        for (const FrameHash& frame : whole.value().frames) kept.of(frame);
    }
    for (const std::string& file : list_folder(folder.path())) std::filesystem::remove(folder.path(file));
}

// The title's list.

namespace {

/// What lies in a folder of maps, besides files of text.
void make(std::string_view text, const std::string& path) {
    const char kind = text.empty() ? 't' : text.front();
    std::error_code is_there;
    if (kind == 'f') static_cast<void>(::mkfifo(path.c_str(), 0600));
    if (kind == 'd') std::filesystem::create_directory(path, is_there);
    if (kind == 'l') std::filesystem::create_symlink(path, path, is_there);
    if (kind != 'f' && kind != 'd' && kind != 'l') static_cast<void>(write_file(path, text));
}

/// A name that a file can have, whatever its bytes.
std::string file_name(std::string_view text) {
    std::string name(text.substr(0, 60));
    for (char& letter : name)
        if (letter == '/' || letter == '\0') letter = '_';
    return name.empty() || name == "." || name == ".." ? "_" : name;
}

/// The player's folders below one of the test's own, empty.
class PlayersFolders {
public:
    PlayersFolders() {
        for (const char* name : {"XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME", "HOME", "DOOMWADDIR"}) {
            const char* before = ::getenv(name);
            before_.emplace_back(name, before ? std::optional<std::string>(before) : std::nullopt);
            ::setenv(name, folder().path(name).c_str(), 1);
        }
        for (const std::string& place : {maps(), wads()}) std::filesystem::create_directories(place);
    }
    ~PlayersFolders() {
        for (const std::string& place : {maps(), wads()})
            for (const auto& entry : std::filesystem::directory_iterator(place)) std::filesystem::remove(entry.path());
        for (const auto& [name, value] : before_)
            if (value)
                ::setenv(name, value->c_str(), 1);
            else
                ::unsetenv(name);
    }
    PlayersFolders(const PlayersFolders&) = delete;
    PlayersFolders& operator=(const PlayersFolders&) = delete;

    std::string maps() const { return folder().path("XDG_DATA_HOME/enfilade/maps"); }
    std::string wads() const { return folder().path("DOOMWADDIR"); }

private:
    /// Making and removing it takes longer than looking into it.
    static const TempDir& folder() {
        static const TempDir kept;
        return kept;
    }

    std::vector<std::pair<const char*, std::optional<std::string>>> before_;
};

}  // namespace

/// Names and contents of files in turn; every third goes among the WADs.
void fuzz_list(std::span<const std::byte> bytes) {
    const PlayersFolders player;
    const std::vector<std::string_view> texts = texts_in(bytes, 12);
    for (std::size_t i = 0; i + 1 < texts.size(); i += 2) {
        const bool is_wad = i % 3 == 2;
        make(texts[i + 1],
             (is_wad ? player.wads() : player.maps()) + "/" + file_name(texts[i]) + (is_wad ? ".wad" : ".toml"));
    }
    for (const ListedMap& map : find_maps()) ENFILADE_CHECK(!map.path.empty() && !printable_line(map.name).empty());
}

// The command line's values.

void fuzz_options(std::span<const std::byte> bytes) {
    const std::string text(as_text(bytes));
    if (const auto size = parse_size(text)) ENFILADE_CHECK(size.value().width >= 1 && size.value().height >= 1);
    if (const auto pixel = parse_pixel(text, {640, 400}))
        ENFILADE_CHECK(pixel.value().x >= 0 && pixel.value().x < 640 && pixel.value().y >= 0 && pixel.value().y < 400);
    if (const auto frames = parse_frames(text)) ENFILADE_CHECK(frames.value().first <= frames.value().last);
    if (const auto part = parse_part(text))
        if (const auto frames = frames_of(part.value(), 100)) ENFILADE_CHECK(frames.value().last < 100);
    if (const auto kind = parse_renderer(text)) ENFILADE_CHECK(name_of(kind.value()) == text);
    Dials dials;
    for (const std::string_view word : texts_in(bytes, 4)) {
        if (!set_dial(dials, word).ok() && !set_accuracy(dials, word).ok()) continue;
        ENFILADE_CHECK(is_printable_line(to_text(dials)));
        for (const RendererKind kind : {RendererKind::column, RendererKind::stencil, RendererKind::reference})
            ENFILADE_CHECK(check_dials(kind, dials_for(kind, dials)).ok() || !check_dials(kind, dials).ok());
    }
    constexpr std::array<std::string_view, 3> kCommands{"check", "play", "render"};
    ENFILADE_CHECK(is_printable_line(printable_line(unknown_command(text, kCommands))));
}

// Reports of measurements that commands read again.

void fuzz_report(std::span<const std::byte> bytes) {
    const std::string_view text = as_text(bytes);
    if (const auto report = read_accuracy_json("report.json", text)) {
        ENFILADE_CHECK(compare_errors("report.json", report.value().scenes, report.value().scenes).ok());
        accuracy_page(report.value().scenes, "");
        accuracy_csv(report.value().scenes);
        ENFILADE_CHECK(read_accuracy_json("", accuracy_json(report.value().run, report.value().scenes)).ok());
    }
    if (auto pass = read_pass("program", text)) {
        const std::array<Passes, 2> passes{Passes{pass.value()}, Passes{pass.value()}};
        ENFILADE_CHECK(compare_frames({"one", "other"}, passes).ok());
        comparison_table(passes);
    }
}

}  // namespace enfilade::test
