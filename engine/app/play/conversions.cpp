#include "app/play/conversions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>

#include "app/messages.h"
#include "app/pictures.h"
#include "app/programs.h"
#include "app/user_folders.h"
#include "base/file_name.h"
#include "base/files.h"
#include "base/hash.h"
#include "base/owned_folder.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

constexpr const char* kReport = "report.txt";

std::string converted_folder() { return in_user_folder(UserFolder::cache, "converted"); }

std::vector<std::string> wad_folders() {
    const char* const named = std::getenv("DOOMWADDIR");
    std::vector<std::string> folders{named ? named : "", "/usr/share/games/doom", "/usr/local/share/games/doom",
                                     in_user_folder(UserFolder::data, "wads")};
    std::erase(folders, "");
    return folders;
}

// What a conversion is of, and whether it is whole.

/// What is converted, and by what.
struct Order {
    std::vector<std::string> wads;  ///< absolute: a name may begin with '-'
    std::string converter, name;
    std::uint64_t wads_hash = 0, converter_hash = 0;

    std::string folder() const {
        return (fs::path(converted_folder()) / fmt::format("{}-{:016x}", safe_file_name(name), wads_hash)).string();
    }
};

Result<void> add_file(const std::string& path, Hash& hash) {
    const auto bytes = read_file(path);
    if (!bytes.ok()) return bytes.error();
    hash.add(hash_of_bytes(bytes.value()));
    return {};
}

Result<Order> order_of(const std::vector<std::string>& wads, const std::string& program) {
    Order order{{}, program, file_stem_of(wads[0])};
    Hash archives, converter;
    for (const std::string& wad : wads) {
        if (const Result<void> done = add_file(wad, archives); !done.ok()) return done.error();
        order.wads.push_back(fs::absolute(wad).string());
    }
    if (const Result<void> done = add_file(program, converter); !done.ok()) return done.error();
    order.wads_hash = archives.value();
    order.converter_hash = converter.value();
    return order;
}

/// Of all that lies in the folder but its mark: names, and what is in the files.
std::uint64_t hash_of_folder(const fs::path& folder) {
    Hash hash;
    std::error_code unknown;
    for (const std::string& name : list_folder(folder.string())) {
        if (name == kFolderMark) continue;
        hash.add(name);
        const fs::path path = folder / name;
        if (fs::is_directory(fs::symlink_status(path, unknown)))
            hash.add(hash_of_folder(path));
        else if (!add_file(path.string(), hash).ok())
            hash.add(false);
    }
    return hash.value();
}

constexpr std::string_view kNameLine = "name: ";

/// What the mark of a folder says that was made to order.
std::string mark_text(const Order& order, std::uint64_t contents) {
    return fmt::format(
        "{}{}\nEnfilade converted these levels, and makes them again where a file here is changed. Copy what you want "
        "to change.\nWADs {:016x}, converter {:016x}, contents {:016x}\n",
        kNameLine, printable_line(order.name), order.wads_hash, order.converter_hash, contents);
}

bool is_whole(const Order& order) {
    const auto mark = mark_of(order.folder());
    return mark && *mark == mark_text(order, hash_of_folder(order.folder()));
}

void note_use(const std::string& folder) {
    std::error_code unknown;
    fs::last_write_time(fs::path(folder) / kFolderMark, fs::file_time_type::clock::now(), unknown);
}

// Making one.

Result<void> run_converter(const Order& order, const std::string& out) {
    std::vector<std::string> words{order.converter};
    words.insert(words.end(), order.wads.begin(), order.wads.end());
    words.insert(words.end(), {"--out", out});
    const auto end = run_child(words);
    if (!end.ok()) return end.error();
    // Status 1: some levels were refused; the report is written where the others are there.
    if (end.value().exit_code <= 1 && is_file((fs::path(out) / kReport).string())) return {};
    return Error{order.wads[0], "it cannot be converted: " + end.value().said.substr(0, end.value().said.find('\n'))};
}

/// Removes those that were used longest ago.
void keep_newest(const std::string& kept) {
    std::vector<std::pair<fs::file_time_type, std::string>> others;
    std::error_code unknown;
    for (const KeptConversion& conversion : kept_conversions())
        if (conversion.folder != kept)
            others.emplace_back(fs::last_write_time(fs::path(conversion.folder) / kFolderMark, unknown),
                                conversion.folder);
    std::ranges::sort(others, std::greater());
    for (std::size_t i = kMostConversions - 1; i < others.size(); ++i)
        static_cast<void>(remove_owned_folder(others[i].second));
}

Result<void> convert_anew(const Order& order) {
    auto scratch = ScratchFolder::make(converted_folder());
    if (!scratch.ok()) return scratch.error();
    if (const Result<void> done = run_converter(order, scratch.value().path()); !done.ok()) return done.error();
    const std::string mark = mark_text(order, hash_of_folder(scratch.value().path()));
    if (const Result<void> done = scratch.value().take_place(order.folder(), mark); !done.ok()) return done.error();
    keep_newest(order.folder());
    return {};
}

Result<void> convert_under_lock(const Order& order, const Teller& say) {
    std::error_code failed;
    fs::create_directories(converted_folder(), failed);
    if (failed) return Error{converted_folder(), "cannot make the folder: " + failed.message()};
    const auto lock = FileLock::take((fs::path(converted_folder()) / "lock").string(),
                                     [&] { say("waiting for another conversion"); });
    if (!lock.ok()) return lock.error();
    remove_left_scratch_folders(converted_folder());
    if (is_whole(order)) return {};
    say("converting " + printable_line(order.name) + ", which takes some seconds");
    return convert_anew(order);
}

}  // namespace

std::optional<std::string> find_converter() {
    const fs::path here = fs::path(this_program()).parent_path();
    for (const fs::path& path : {here / "wadconv", here / "../../wadconv/wadconv"})
        if (is_file(path.string())) return path.string();
    return find_program("wadconv");
}

std::vector<std::string> installed_wads() {
    std::vector<std::string> wads;
    for (const std::string& folder : wad_folders())
        for (const std::string& name : list_folder(folder))
            if (ending_of(name) == ".wad") wads.push_back((fs::path(folder) / name).string());
    return wads;
}

std::optional<std::string> find_wad(const std::string& word) {
    if (is_file(word)) return is_wad_file(word) ? std::optional(word) : std::nullopt;
    for (const std::string& wad : installed_wads())
        if (word == file_name_of(wad) || word == file_stem_of(wad)) return wad;
    return {};
}

bool is_level_name(std::string_view word) {
    const auto fits = [&](std::string_view pattern) {  // '#': a digit, others in any case
        return std::ranges::equal(word, pattern, [](char c, char wanted) {
            return wanted == '#' ? c >= '0' && c <= '9' : c == wanted || c == wanted - 'a' + 'A';
        });
    };
    return fits("e#m#") || fits("map##");
}

Result<std::string> convert_wads(const std::vector<std::string>& wads, const Teller& tell,
                                 const std::optional<std::string>& converter) {
    if (!converter) return Error{wads[0], "the converter, wadconv, is not installed beside this program, nor in PATH"};
    if (converted_folder().empty())
        return Error{wads[0], "there is no home folder to put the converted levels into; set HOME"};
    const auto order = order_of(wads, *converter);
    if (!order.ok()) return order.error();
    const Teller say = tell ? tell : [](const std::string&) {};
    if (!is_whole(order.value()))
        if (const Result<void> done = convert_under_lock(order.value(), say); !done.ok()) return done.error();
    note_use(order.value().folder());
    return order.value().folder();
}

Result<std::string> level_in(const std::string& folder, const std::string& level) {
    std::vector<std::string> names;
    for (const std::string& name : list_folder(folder))
        if (name.ends_with(".toml")) names.push_back(name);
    if (names.empty())
        return Error{folder, "no level of it could be converted; " + folder + "/" + kReport + " says why"};
    std::string wanted = level + ".toml";
    std::ranges::transform(wanted, wanted.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    const auto found = level.empty() ? names.begin() : std::ranges::find(names, wanted);
    if (found == names.end())
        return Error{folder, fmt::format("there is no level {}; there are {} to {}", level, file_stem_of(names.front()),
                                         file_stem_of(names.back()))};
    return folder + "/" + *found;
}

std::vector<KeptConversion> kept_conversions() {
    std::vector<KeptConversion> kept;
    for (const std::string& entry : list_folder(converted_folder())) {
        const std::string folder = (fs::path(converted_folder()) / entry).string();
        const auto mark = mark_of(folder);
        if (!mark || !mark->starts_with(kNameLine)) continue;
        kept.push_back({mark->substr(kNameLine.size(), mark->find('\n') - kNameLine.size()), folder});
    }
    return kept;
}

}  // namespace enfilade
