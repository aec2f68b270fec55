#include "wadconv/convert.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <optional>

#include "base/parallel.h"
#include "formats/map_toml.h"
#include "formats/text_parts.h"
#include "map/load.h"
#include "wadconv/pictures.h"
#include "wadconv/wad.h"
#include "wadconv/workbench.h"

namespace enfilade::wadconv {
namespace {

Result<WadPile> read_pile(const std::vector<std::string>& paths) {
    std::vector<Wad> wads;
    for (const std::string& path : paths) {
        Result<Bytes> bytes = read_file(path);
        if (!bytes) return bytes.error();
        Result<Wad> wad = Wad::read(path, std::move(bytes).value());
        if (!wad) return wad.error();
        wads.push_back(std::move(wad).value());
    }
    return WadPile(std::move(wads));
}

std::string in_case(std::string text, char from, char to) {
    for (char& c : text)
        if (c >= from && c <= from + 25) c = static_cast<char>(c - from + to);
    return text;
}

/// What there is instead.
std::string there_are(const std::vector<std::string>& all) {
    return all.size() == 1 ? "the only one is " + all.front()
                           : "there are " + all.front() + " to " + all.back() + ", " + counted(all.size(), "map");
}

/// The maps asked for, in the order of the archives.
Result<std::vector<std::string>> choose_maps(const WadPile& pile, const std::vector<std::string>& wanted) {
    const std::vector<std::string> all = map_names(pile);
    const std::string file = pile.wads().back().file();
    if (all.empty()) return Error{file, "there is no map in it: no lump called E1M1, MAP01 or the like"};
    if (wanted.empty()) return all;
    std::vector<std::string> chosen;
    for (const std::string& name : wanted)
        if (std::ranges::find(all, in_case(name, 'a', 'A')) == all.end())
            return Error{file, "there is no map " + in_quotes(name) + "; " + there_are(all)};
    for (const std::string& name : all)
        if (std::ranges::any_of(wanted, [&](const std::string& w) { return in_case(w, 'a', 'A') == name; }))
            chosen.push_back(name);
    return chosen;
}

/// What keeps the converted map from loading, or nothing.
std::string first_error(const MapFile& file, const TextureSet& sizes) {
    Findings findings;
    build_map(file, sizes, findings);
    const auto error = std::ranges::find(findings, Severity::error, &Finding::severity);
    return error == findings.end() ? "" : "the converted map is not sound: " + error->sentence;
}

/// Classic light darkens by a thirty-second a level; this says how far that is from what the WAD's own table does.
std::string light_text(const Pictures& pictures) {
    if (!pictures.light_levels()) return "There is no COLORMAP to compare classic light with";
    const auto& levels = *pictures.light_levels();
    double worst = 0;
    const auto count = static_cast<double>(levels.size());
    for (std::size_t i = 0; i < levels.size(); ++i)
        worst = std::max(worst, std::abs(levels[i] - (count - static_cast<double>(i)) / count));
    const int percent = static_cast<int>(std::ceil(100 * worst));
    return "COLORMAP's 32 levels of light are within " + std::to_string(percent) + " % of classic light's";
}

std::string guesses_text(const Report& report) {
    std::string text = "something had to be guessed, which strict conversion refuses:";
    for (const auto& [kind, numbers] : report.found)
        if (const KindFacts& facts = facts_of(kind); facts.fate == Fate::guessed)
            text += " " + std::string(facts.name) + ": " + std::to_string(numbers.size()) + ";";
    text.pop_back();
    return text;
}

bool is_converted(const Report& report) { return report.refused.empty(); }

std::string file_of(const std::string& map) { return in_case(map, 'A', 'a') + ".toml"; }

/// One run's maps.
class MapWriter {
public:
    MapWriter(const WadPile& pile, const Pictures& pictures, const Sounds& sounds, const RunOptions& options)
        : pile_(pile), pictures_(pictures), sounds_(sounds), options_(options), sizes_(pictures.sizes()) {}

    /// An error where a map was converted and cannot be written.
    Result<Report> convert(const std::string& name) const {
        Conversion conversion = convert_one(name);
        Report& report = conversion.report;
        report.map = name;
        if (report.refused.empty()) report.refused = first_error(*conversion.file, sizes_);
        if (report.refused.empty() && options_.strict && report.count(Fate::guessed) > 0)
            report.refused = guesses_text(report);
        if (report.refused.empty())
            if (const Result<void> done = write(name, *conversion.file); !done.ok()) return done.error();
        return std::move(report);
    }

private:
    Conversion convert_one(const std::string& name) const {
        const Result<MapLumps> lumps = find_map(pile_, name);
        if (!lumps) return refused(lumps.error());
        const Result<DoomMap> doom = decode_map(lumps.value());
        if (!doom) return refused(doom.error());
        return convert_map(doom.value(), pictures_, sounds_, options_.convert);
    }

    static Conversion refused(const Error& error) {
        Conversion conversion;
        conversion.report.refused = error.text();
        return conversion;
    }

    /// The report, written last, flushes the folder.
    Result<void> write(const std::string& name, const MapFile& file) const {
        const std::string text = write_map(file);
        return write_one_of_many(options_.out + "/" + file_of(name), std::as_bytes(std::span(text)));
    }

    const WadPile& pile_;
    const Pictures& pictures_;
    const Sounds& sounds_;
    const RunOptions& options_;
    const TextureSet sizes_;
};

Result<void> make_folder(const std::string& path) {
    std::error_code failed;
    std::filesystem::create_directories(path, failed);
    if (failed) return Error{path, "cannot make the folder: " + failed.message()};
    return {};
}

}  // namespace

bool RunResult::is_complete() const { return problems.empty() && std::ranges::all_of(reports, is_converted); }

Result<RunResult> convert_wads(const RunOptions& options, const StepListener& listener) {
    const Result<WadPile> pile = read_pile(options.wads);
    if (!pile) return pile.error();
    const Result<std::vector<std::string>> maps = choose_maps(pile.value(), options.maps);
    if (!maps) return maps.error();
    const Result<Pictures> listed = Pictures::list(pile.value(), idle_frames());
    if (!listed) return listed.error();
    const Pictures& pictures = listed.value();
    const Sounds sounds = Sounds::list(pile.value());

    if (const Result<void> made = make_folder(options.out); !made.ok()) return made.error();
    const std::size_t total = pictures.files().size() + maps.value().size();
    std::atomic<std::size_t> done{0};
    const auto step = [&](std::size_t worker) { listener(done.fetch_add(1) + 1, total, worker); };
    RunResult result;
    result.light = light_text(pictures);
    const auto add_problems = [&](const std::vector<Error>& errors) {
        for (const Error& problem : errors) result.problems.push_back(problem.text());
    };
    add_problems(pictures.problems());
    add_problems(sounds.problems());
    const MapWriter writer(pile.value(), pictures, sounds, options);
    result.reports.resize(maps.value().size());
    std::vector<Result<void>> converted(maps.value().size());
    parallel_for(maps.value().size(), options.jobs, [&](std::size_t i, std::size_t worker) {
        Result<Report> report = writer.convert(maps.value()[i]);
        if (report)
            result.reports[i] = std::move(report).value();
        else
            converted[i] = report.error();
        step(worker);
    });
    for (const Result<void>& one : converted)
        if (!one.ok()) return one.error();
    if (std::ranges::any_of(result.reports, is_converted)) {
        const auto problems = write_pictures(pictures, options.out + "/textures", options.jobs, step);
        if (!problems) return problems.error();
        add_problems(problems.value());
        if (const Result<void> written = sounds.write(options.out); !written.ok()) return written.error();
    } else {
        for (std::size_t i = 0; i < pictures.files().size(); ++i) step(0);
    }
    if (const Result<void> written = write_file(options.out + "/report.txt", to_text(result)); !written.ok())
        return written.error();
    return result;
}

std::string written_text(const RunResult& result, const std::string& out) {
    std::vector<std::string> files;
    for (const Report& report : result.reports)
        if (is_converted(report)) files.push_back(file_of(report.map));
    if (files.empty()) return "No map was converted; " + out + "/report.txt says why\n";
    std::string text = "Written to " + out + ": " + files.front();
    if (files.size() == 2) text += ", " + files.back();
    if (files.size() > 2) text += " to " + files.back() + " (" + counted(files.size(), "map") + ")";
    for (const char* folder : {"textures", "sounds"})
        if (std::filesystem::exists(out + "/" + folder)) text += std::string(", ") + folder;
    return text + ", report.txt\n`enfilade play " + out + "/" + files.front() + "` walks through it\n";
}

std::string to_text(const RunResult& result) {
    std::string text = totals_text(result.reports) + "  " + result.light + "\n";
    for (const std::string& problem : result.problems) text += "problem: " + problem + "\n";
    for (const Report& report : result.reports) text += "\n" + to_text(report);
    return text;
}

}  // namespace enfilade::wadconv
