// Holds the tree as it stands to the rules of the house.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "base/files.h"
#include "house/rules.h"

namespace enfilade::house {
namespace {

namespace fs = std::filesystem;

bool is_source(const std::string& path) { return path.ends_with(".h") || path.ends_with(".cpp"); }

bool is_build_file(const std::string& path) {
    return path.ends_with("CMakeLists.txt") || path.ends_with(".cmake") || path.ends_with("CMakePresets.json");
}

/// Every source and build file below the given folders or at the given paths, sorted.
std::vector<SourceFile> files_under(const std::vector<std::string>& places) {
    const fs::path top = ENFILADE_SOURCE_DIR;
    std::vector<SourceFile> files;
    const auto add = [&](const fs::path& path) {
        const auto text = read_file(path.string());
        ASSERT_TRUE(text.ok()) << text.error().text();
        files.push_back({fs::relative(path, top).generic_string(), std::string(as_text(text.value()))});
    };
    for (const std::string& place : places) {
        if (fs::is_regular_file(top / place)) add(top / place);
        if (!fs::is_directory(top / place)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(top / place))
            if (entry.is_regular_file() && (is_source(entry.path().string()) || is_build_file(entry.path().string())))
                add(entry.path());
    }
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    return files;
}

std::vector<SourceFile> sources() {
    auto files = files_under({"engine", "wadconv", "tests", "maps"});
    std::erase_if(files, [](const SourceFile& file) { return !is_source(file.path); });
    return files;
}

/// All complaints of one rule about the whole tree.
template <class Rule>
Complaints complaints(const std::vector<SourceFile>& files, Rule rule) {
    Complaints all;
    for (const SourceFile& file : files)
        for (const std::string& complaint : rule(file)) all.push_back(complaint);
    return all;
}

using ::testing::IsEmpty;

TEST(House, HasSourcesToLookAt) { EXPECT_GT(sources().size(), 30u); }

TEST(House, IncludesPointOnlyDownward) { EXPECT_THAT(complaints(sources(), check_layers), IsEmpty()); }

TEST(House, LibrariesStayBehindTheirFences) { EXPECT_THAT(complaints(sources(), check_fenced_libraries), IsEmpty()); }

TEST(House, AtMostOneSourceFileIncludesToml) {
    auto files = sources();
    std::erase_if(files, [](const SourceFile& file) {
        return file.path.starts_with("tests/") || file.text.find("#include <toml++") == std::string::npos;
    });
    EXPECT_LE(files.size(), 1u);
    for (const SourceFile& file : files) EXPECT_TRUE(file.path.ends_with(".cpp")) << file.path;
}

TEST(House, HeadersSayWhatTheyHold) { EXPECT_THAT(complaints(sources(), check_header_form), IsEmpty()); }

/// Comments that name a source file of ours which there is not, engine/ and wadconv/ only: tests make up names.
Complaints check_named_files(const std::vector<SourceFile>& files) {
    std::set<std::string> names;
    for (const SourceFile& file : files) names.insert(fs::path(file.path).filename());
    const std::regex name(R"(//.*?\b([a-z_]+\.(h|cpp))\b)"), further(R"(\b([a-z_]+\.(h|cpp))\b)");
    Complaints all;
    for (const SourceFile& file : files) {
        if (file.path.starts_with("tests/")) continue;
        std::istringstream text(file.text);
        for (std::string line; std::getline(text, line);) {
            if (!std::regex_search(line, name)) continue;
            const std::string comment = line.substr(line.find("//"));
            for (std::sregex_iterator it(comment.begin(), comment.end(), further), end; it != end; ++it)
                if (!names.contains((*it)[1])) all.push_back(file.path + ": there is no " + (*it)[1].str());
        }
    }
    return all;
}

TEST(House, CommentsNameFilesThatAreThere) { EXPECT_THAT(check_named_files(sources()), IsEmpty()); }

TEST(House, FilesAreShort) { EXPECT_THAT(complaints(sources(), check_length), IsEmpty()); }

TEST(House, NothingIsLeftUnfinished) { EXPECT_THAT(complaints(sources(), check_forbidden_words), IsEmpty()); }

TEST(House, ErrorsAreResults) { EXPECT_THAT(complaints(sources(), check_exceptions), IsEmpty()); }

// hard cases D1, D2
TEST(House, NoFlagChangesWhatTheCodeComputes) {
    const auto files =
        files_under({"engine", "wadconv", "tests", "maps", "CMakeLists.txt", "CMakePresets.json", "run", ".ci/run"});
    EXPECT_THAT(complaints(files, check_float_flags), IsEmpty());
}

// hard case D3
TEST(House, NoInstructionApproximates) { EXPECT_THAT(complaints(sources(), check_approximations), IsEmpty()); }

TEST(House, FilesAreOpenedByOneWay) { EXPECT_THAT(complaints(sources(), check_opening), IsEmpty()); }

TEST(House, StandardOutputIsWrittenByOneWay) { EXPECT_THAT(complaints(sources(), check_standard_output), IsEmpty()); }

TEST(House, WordsReachTheTerminalByOneWay) { EXPECT_THAT(complaints(sources(), check_printing), IsEmpty()); }

TEST(House, NamesBecomePathsByOneWay) { EXPECT_THAT(complaints(sources(), check_names_of_files), IsEmpty()); }

TEST(House, NothingGoesBeforeItsSuccessorIsThere) {
    EXPECT_THAT(complaints(sources(), check_removals), IsEmpty());
    const auto script = files_under({"run"});
    ASSERT_EQ(script.size(), 1u);
    EXPECT_THAT(complaints(script, check_removals), IsEmpty());
}

/// How many lines of the text are this one, whatever their indentation.
int count_lines(const std::string& text, const std::string& wanted) {
    int count = 0;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        count += line.find_first_not_of(' ') != std::string::npos && line.substr(line.find_first_not_of(' ')) == wanted;
    return count;
}

/// hard_cases/break_lines.sh breaks lines of the source, and can only break those that are there.
TEST(House, EachLineThatIsBrokenOnPurposeIsThereOnce) {
    const auto list = files_under({"tests/hard_cases/broken_lines.txt"});
    ASSERT_EQ(list.size(), 1u);
    std::istringstream lines(list[0].text);
    std::string file;
    int tried = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("= ")) std::getline(lines, file);
        if (!line.starts_with("- ")) continue;
        const auto broken = files_under({file});
        ASSERT_EQ(broken.size(), 1u) << file;
        EXPECT_EQ(count_lines(broken[0].text, line.substr(2)), 1) << file << ": " << line;
        ++tried;
    }
    EXPECT_GE(tried, 60);
}

// hard case D4
TEST(House, SimulationStateUsesOnlyOurOwnTrigonometry) { EXPECT_THAT(complaints(sources(), check_libm), IsEmpty()); }

}  // namespace
}  // namespace enfilade::house
