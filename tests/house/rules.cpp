#include "house/rules.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <regex>
#include <sstream>

namespace enfilade::house {
namespace {

/// The layers from the ground up. What shares a rank does not know its equals.
struct Layer {
    std::string_view folder;
    int rank;
};
constexpr std::string_view kFacade = "enfilade.h";
constexpr std::array kLayers{Layer{"base", 0},
                             Layer{"math", 1},
                             Layer{"formats", 2},
                             Layer{"command", 3},
                             Layer{"map", 3},
                             Layer{"space", 4},
                             Layer{"world", 5},
                             Layer{"render", 6},
                             Layer{"render/column", 7},
                             Layer{"render/stencil", 7},
                             Layer{"render/reference", 7},
                             Layer{"render/outside", 7},
                             Layer{"render/choice", 8},
                             Layer{"flight", 9},
                             Layer{"platform", 10},
                             Layer{"testing", 10},
                             Layer{kFacade, 10},
                             Layer{"app", 11},
                             Layer{"examples", 11}};
constexpr int kHighestForWadconv = 3;

/// The layer of a folder or of the nearest folder around it: app/play belongs to app.
const Layer* layer_of(std::string_view folder) {
    const auto found = std::find_if(kLayers.begin(), kLayers.end(), [&](const Layer& l) { return l.folder == folder; });
    if (found != kLayers.end()) return &*found;
    const auto slash = folder.rfind('/');
    return slash == std::string_view::npos ? nullptr : layer_of(folder.substr(0, slash));
}

/// "render/column" of "render/column/walls.h"; "" of "walls.h".
std::string_view folder_of(std::string_view path) {
    const auto slash = path.rfind('/');
    return slash == std::string_view::npos ? "" : path.substr(0, slash);
}

/// The folder by which a file is ranked; the facade, which lies in none, by its own name.
std::string_view place_of(std::string_view path) { return path == kFacade ? path : folder_of(path); }

bool is_header(const SourceFile& file) { return file.path.ends_with(".h"); }

bool is_ours(const SourceFile& file) { return file.path.starts_with("engine/") || file.path.starts_with("wadconv/"); }

bool is_in(const SourceFile& file, std::string_view folder) { return file.path.starts_with(std::string(folder) + "/"); }

/// Calls visit(line number, line) for every line.
void for_each_line(std::string_view text, const std::function<void(int, const std::string&)>& visit) {
    std::istringstream lines{std::string(text)};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) visit(number, line);
}

std::string at(const SourceFile& file, int line, const std::string& sentence) {
    return file.path + ":" + std::to_string(line) + ": " + sentence;
}

/// A complaint for every line in which the pattern occurs.
Complaints lines_with(const SourceFile& file, std::string_view text, const std::regex& pattern,
                      const std::string& sentence) {
    Complaints complaints;
    for_each_line(text, [&](int number, const std::string& line) {
        if (std::smatch found; std::regex_search(line, found, pattern))
            complaints.push_back(at(file, number, sentence + ": " + found.str()));
    });
    return complaints;
}

/// What is wrong with `file` including `target` in quotes; empty if nothing is.
std::string layer_complaint(const SourceFile& file, std::string_view target) {
    const auto folder = place_of(target);
    const bool from_wadconv = is_in(file, "wadconv");
    if (from_wadconv && (folder.empty() || folder == "wadconv")) return "";
    const Layer* to = layer_of(folder);
    if (to == nullptr) return "an include of our own is written from engine/: ";
    if (from_wadconv) return to->rank <= kHighestForWadconv ? "" : "wadconv must not know ";
    const Layer* from = layer_of(place_of(file.path.substr(sizeof "engine/" - 1)));
    if (from == nullptr) return "a folder that is not in the table of layers includes ";
    return to == from || to->rank < from->rank ? "" : "includes point only downward, not at ";
}

struct Fence {
    std::regex include;
    std::vector<std::string> inside;  ///< the folders and files that may
    std::string sentence;
};

const std::vector<Fence>& fences() {
    static const std::vector<Fence> all{
        {std::regex(R"(^\s*#\s*include\s*[<"]SDL.*)"), {"engine/platform/"}, "only engine/platform knows SDL"},
        {std::regex(R"(^\s*#\s*include\s*[<"]toml.*)"), {"engine/formats/"}, "only engine/formats knows toml++"},
        {std::regex(R"(^\s*#\s*include\s*[<"](epoxy|GL|GLES\d|EGL)/.*)"),
         {"engine/render/stencil/", "engine/platform/"},
         "only the stencil renderer and engine/platform know OpenGL"},
        {std::regex(R"(^\s*#\s*include\s*[<"](fmt|nlohmann|CLI)/.*)"),
         {"engine/app/", "engine/command/", "wadconv/main.cpp"},
         "only commands know fmt, JSON and CLI11, so that who links the engine need not"},
        {std::regex(R"(^\s*#\s*include\s*<(fstream|fcntl\.h|sys/fcntl\.h)>)"),
         {"engine/base/files.cpp", "engine/base/output_file.cpp", "engine/base/owned_folder.cpp"},  // the last: locks
         "files are opened by base/files.h, which looks first and has a limit"},
        {std::regex(R"(^\s*#\s*include\s*<(thread|future|mutex|condition_variable)>)"),
         {"engine/base/parallel.cpp", "engine/platform/", "engine/app/"},
         "below platform, threads live in base/parallel.cpp"}};
    return all;
}

}  // namespace

Complaints check_layers(const SourceFile& file) {
    if (!is_ours(file)) return {};
    static const std::regex quoted(R"rx(^\s*#\s*include\s*"([^"]*)")rx");
    Complaints complaints;
    for_each_line(file.text, [&](int number, const std::string& line) {
        std::smatch found;
        if (!std::regex_search(line, found, quoted)) return;
        if (const auto wrong = layer_complaint(file, found[1].str()); !wrong.empty())
            complaints.push_back(at(file, number, wrong + found[1].str()));
    });
    return complaints;
}

Complaints check_fenced_libraries(const SourceFile& file) {
    if (!is_ours(file)) return {};
    Complaints complaints;
    for (const Fence& fence : fences()) {
        const auto may = [&](const std::string& start) { return file.path.starts_with(start); };
        if (std::any_of(fence.inside.begin(), fence.inside.end(), may)) continue;
        const auto found = lines_with(file, file.text, fence.include, fence.sentence);
        complaints.insert(complaints.end(), found.begin(), found.end());
    }
    return complaints;
}

Complaints check_header_form(const SourceFile& file) {
    Complaints complaints;
    if (!is_header(file)) return complaints;
    if (!file.text.starts_with("// ")) complaints.push_back(at(file, 1, "the first line says what the header holds"));
    if (file.text.find("\n#pragma once\n") == std::string::npos)
        complaints.push_back(at(file, 1, "a header needs #pragma once"));
    return complaints;
}

Complaints check_length(const SourceFile& file) {
    const auto lines = std::count(file.text.begin(), file.text.end(), '\n');
    if (lines < kMaxLines) return {};
    return {at(file, kMaxLines, std::to_string(lines) + " lines; cut the file by question")};
}

Complaints check_forbidden_words(const SourceFile& file) {
    // Spelt so that this file does not name what it forbids.
    static const std::regex unfinished(
        "\\b(TO"
        "DO|FIX"
        "ME|X"
        "XX)\\b|DISA"
        "BLED_");
    static const std::regex shared(
        "\\bsha"
        "red_ptr\\b");
    Complaints complaints = lines_with(file, file.text, unfinished, "unfinished work belongs in the tracker");
    if (is_ours(file)) {
        const auto found = lines_with(file, file.text, shared, "say who owns it");
        complaints.insert(complaints.end(), found.begin(), found.end());
    }
    return complaints;
}

Complaints check_float_flags(const SourceFile& file) {
    static const std::regex flags(
        "-O"
        "fast|-f"
        "fast-math|-f"
        "unsafe-math\\S*|-f"
        "associative-math|-f"
        "p-contract=(fast|on)");
    return lines_with(file, file.text, flags, "this flag changes what the code computes");
}

Complaints check_approximations(const SourceFile& file) {
    if (file.path.starts_with("tests/")) return {};
    static const std::regex calls(R"(\b(_mm\w*_(rcp|rsqrt)\w*|__builtin_ia32_(rcp|rsqrt)\w*|vr(ecp|sqrt)e\w*)\s*\()");
    return lines_with(file, without_comments_and_strings(file.text), calls,
                      "processors approximate reciprocals differently; divide");
}

Complaints check_libm(const SourceFile& file) {
    if (!is_in(file, "engine/space") && !is_in(file, "engine/world")) return {};
    static const std::regex calls(
        R"((^|[^\w.>])(std::)?(a?(sin|cos|tan)h?|atan2|sincos|pow|exp|exp2|expm1|log|log2|log10)"
        R"(|log1p|cbrt|hypot|fma|erf|tgamma|lgamma)[fl]?\s*\()");
    return lines_with(file, without_comments_and_strings(file.text), calls,
                      "the C library's answer differs between machines; see math/angle.h");
}

Complaints check_exceptions(const SourceFile& file) {
    constexpr std::array<std::string_view, 4> kMay{"engine/base/attempt.cpp", "engine/base/parallel.cpp",
                                                   "engine/formats/toml.cpp", "engine/command/command.cpp"};
    if (!is_ours(file) || std::find(kMay.begin(), kMay.end(), file.path) != kMay.end()) return {};
    static const std::regex words(R"(\b(throw|try|catch)\b)");
    return lines_with(file, without_comments_and_strings(file.text), words, "errors are Results; see base/attempt.h");
}

Complaints check_printing(const SourceFile& file) {
    // A broken contract is told in words of our own, by as little code as can be.
    if (!is_ours(file) || file.path == "engine/base/text.cpp" || file.path == "engine/base/attempt.cpp") return {};
    if (is_in(file, "engine/examples")) return {};  // programs of others, who print as they like
    static const std::regex calls(
        R"(\b(v?d?f?printf|f?puts|f?putc|putchar|perror)\s*\(|\bfmt::v?print(ln)?\b|\bstd::w?(cout|cerr|clog)\b)");
    return lines_with(file, without_comments_and_strings(file.text), calls,
                      "print to stdout by command/command.h and to stderr by base/text.h");
}

Complaints check_standard_output(const SourceFile& file) {
    if (!is_ours(file) || is_in(file, "engine/examples") || file.path == "engine/base/output_file.cpp") return {};
    static const std::regex words(R"(\bstdout\b|\bSTDOUT_FILENO\b)");
    return lines_with(file, without_comments_and_strings(file.text), words,
                      "command/command.h writes to standard output and reports what could not be written");
}

Complaints check_opening(const SourceFile& file) {
    if (!is_ours(file)) return {};
    static const std::regex calls(
        R"(\b(f(re|d)?open(64)?|parse_file|SDL_RWFromF(ile|P)|SDL_Load(WAV|BMP|File)|SDL_\w*FromFile)\s*\()");
    return lines_with(file, without_comments_and_strings(file.text), calls,
                      "files are opened by base/files.h, which looks first and has a limit");
}

Complaints check_names_of_files(const SourceFile& file) {
    if (!is_ours(file) || file.path == "engine/base/file_name.cpp") return {};
    static const std::regex calls(R"(\.(stem|filename)\s*\(|/\s*file_(stem|name)_of\b|rfind\('/'\))");
    return lines_with(file, file.text, calls,
                      "a name becomes a part of a path by safe_file_name() of base/file_name.h");
}

Complaints check_removals(const SourceFile& file) {
    static const std::regex commands(R"((^|[;&|(){]|then|else|do)\s*(rm|mv|rmdir|unlink)\s)");
    if (file.path == "run")
        return lines_with(file, file.text, commands, "whatever a player owns is the program's to keep");
    constexpr std::array<std::string_view, 2> kMay{"engine/base/output_file.cpp", "engine/base/owned_folder.cpp"};
    if (!is_ours(file) || std::find(kMay.begin(), kMay.end(), file.path) != kMay.end()) return {};
    static const std::regex calls(R"(\bremove_all\b|\b(fs|filesystem)::(remove|rename)\b|\bstd::(remove|rename)\s*\()"
                                  R"(|(^|[^\w.>:])(::)?(unlink|unlinkat|rmdir|renameat2?|rename)\s*\(\s*[^)]*c_str)");
    return lines_with(file, without_comments_and_strings(file.text), calls,
                      "files and folders go by base/owned_folder.h, when their successor is there");
}

std::string without_comments_and_strings(std::string_view text) {
    enum class In { code, line_comment, block_comment, string, character };
    std::string blanked(text);
    In in = In::code;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const char next = i + 1 < text.size() ? text[i + 1] : '\0';
        if (c == '\n') {
            if (in != In::block_comment) in = In::code;
            continue;
        }
        if (in == In::code) {
            if (c == '/' && next == '/') in = In::line_comment;
            if (c == '/' && next == '*') in = In::block_comment;
            if (c == '"') in = In::string;
            if (c == '\'' && (i == 0 || !std::isalnum(static_cast<unsigned char>(text[i - 1])))) in = In::character;
            if (in != In::code) blanked[i] = ' ';
            continue;
        }
        blanked[i] = ' ';
        if ((in == In::string || in == In::character) && c == '\\' && next != '\n' && i + 1 < text.size())
            blanked[++i] = ' ';
        else if ((in == In::string && c == '"') || (in == In::character && c == '\''))
            in = In::code;
        else if (in == In::block_comment && c == '*' && next == '/') {
            blanked[++i] = ' ';
            in = In::code;
        }
    }
    return blanked;
}

}  // namespace enfilade::house
