// Every reader of foreign bytes has a fuzz target.
#include <gmock/gmock.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "base/files.h"
#include "house/rules.h"

namespace enfilade::house {
namespace {

using ::testing::IsEmpty;
namespace fs = std::filesystem;

const fs::path kProject = ENFILADE_SOURCE_DIR;

std::string content_of(const fs::path& path) { return std::string(as_text(read_file(path.string()).value())); }

/// "HEADER READER" of each function of a header that is named as a reader and is given a text, bytes, a path, or who
/// reads files.
std::set<std::string> readers_in(const std::string& header, const std::string& text) {
    static const std::regex kDeclaration(
        R"(\b((?:read|parse|load|decode|set_dial|set_accuracy)(?:_\w+)?)\(((?:[^;{}]|\{\})*?)\))"
        R"((?: const)?;)");
    static const std::regex kForeign(
        R"(string_view (?!key|code)|span<const std::byte>|const std::string& |Bytes |const Lump|const MapLumps|const WadPile|const FileReader& )");
    std::set<std::string> readers;
    const std::string code = without_comments_and_strings(text);
    for (std::sregex_iterator found(code.begin(), code.end(), kDeclaration), end; found != end; ++found)
        if (std::regex_search((*found)[2].str(), kForeign)) readers.insert(header + " " + (*found)[1].str());
    return readers;
}

std::set<std::string> all_readers() {
    std::set<std::string> readers;
    for (const char* folder : {"engine", "wadconv"})
        for (const auto& entry : fs::recursive_directory_iterator(kProject / folder))
            if (entry.path().extension() == ".h")
                readers.merge(
                    readers_in(fs::relative(entry.path(), kProject).generic_string(), content_of(entry.path())));
    return readers;
}

std::set<std::string> without(std::set<std::string> all, const std::set<std::string>& some) {
    std::erase_if(all, [&](const std::string& one) { return some.contains(one); });
    return all;
}

/// Lines of words, without comments.
std::vector<std::vector<std::string>> table_in(const fs::path& path) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream text(content_of(path));
    for (std::string line; std::getline(text, line);) {
        std::istringstream words(line);
        std::vector<std::string> row;
        for (std::string word; words >> word;) row.push_back(word);
        if (!row.empty() && row[0] != "#") rows.push_back(row);
    }
    return rows;
}

TEST(Readers, AreFoundInHeaders) {
    EXPECT_THAT(readers_in("a.h", "Result<Map> read_map(std::string_view text, int n);\n"),
                ::testing::ElementsAre("a.h read_map"));
    EXPECT_THAT(readers_in("a.h", "Map read_map(std::string_view text, const Files& files = {});\n"),
                ::testing::SizeIs(1));
    EXPECT_THAT(readers_in("a.h", "static Result<Wad> read(std::string file, Bytes bytes);\n"),
                ::testing::ElementsAre("a.h read"));
    EXPECT_THAT(
        readers_in("a.h", "void read_value(Reading& reading, std::string& field); // read_map(string_view a);\n"),
        IsEmpty());
}

TEST(Readers, HaveAFuzzTargetEach) {
    std::set<std::string> listed;
    for (const auto& row : table_in(kProject / "tests/fuzz/readers.txt")) {
        ASSERT_EQ(row.size(), 3u) << row[0];
        listed.insert(row[0] + " " + row[1]);
        EXPECT_TRUE(fs::is_directory(kProject / "tests/fuzz/corpus" / row[2])) << "there is no target " << row[2];
    }
    EXPECT_THAT(without(all_readers(), listed), IsEmpty()) << "need a fuzz target, named in tests/fuzz/readers.txt";
    EXPECT_THAT(without(listed, all_readers()), IsEmpty()) << "are no readers, but stand in tests/fuzz/readers.txt";
}

/// `./run fuzz all` asks for 95 % of the lines of each source file in the list, or for what the list says and why.
TEST(Readers, HaveTheirSourcesMeasured) {
    for (const auto& row : table_in(kProject / "tests/fuzz/coverage.txt")) {
        EXPECT_TRUE(fs::exists(kProject / row[0])) << row[0];
        EXPECT_TRUE(row.size() == 2 || row.size() > 4)
            << row[0] << ": expected a target, or a target, percents and why";
        EXPECT_TRUE(fs::is_directory(kProject / "tests/fuzz/corpus" / row.at(1))) << row[0];
    }
}

}  // namespace
}  // namespace enfilade::house
