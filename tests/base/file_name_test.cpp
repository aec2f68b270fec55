// Whatever a name is, what becomes of it is one component of a path, and another one for each.
#include "base/file_name.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "base/hash.h"
#include "base/text.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

/// What no name may be that is put into a path.
void expect_safe(const std::string& name) {
    EXPECT_FALSE(name.empty());
    EXPECT_NE(name, ".");
    EXPECT_NE(name, "..");
    EXPECT_LE(name.size(), kMostNameBytes);
    EXPECT_TRUE(is_printable_line(name)) << name;
    EXPECT_EQ(name.find_first_of("/\\:*?\"<>|"), std::string::npos) << name;
    EXPECT_EQ(std::string(".-~ ").find(name.front()), std::string::npos) << name;
    EXPECT_EQ(std::string(". ").find(name.back()), std::string::npos) << name;
    const fs::path below = fs::path("/top") / name;
    EXPECT_EQ(below.lexically_normal().parent_path(), "/top") << name;
}

TEST(FileNames, AreTheLastOfAPath) {
    EXPECT_EQ(file_name_of("a/g.wad"), "g.wad");
    EXPECT_EQ(file_stem_of("a/g.wad"), "g");
    EXPECT_EQ(file_stem_of("a/...wad"), "..");
    EXPECT_EQ(file_stem_of(""), "");
}

TEST(SafeFileNames, StayAsTheyAreWhereNothingIsWrongWithThem) {
    for (const char* name : {"freedoom2", "My map (2).final", "h\xC3\xB6hle", "a-b_c+d", "x~1", "Console", "it's"})
        EXPECT_EQ(safe_file_name(name), name);
}

TEST(SafeFileNames, SpellOutWhatIsWrong) {
    const std::pair<const char*, const char*> names[] = {{"", "%"},
                                                         {".", "%2e"},
                                                         {"..", "%2e%2e"},
                                                         {"...", "%2e.%2e"},
                                                         {"a/b", "a%2fb"},
                                                         {"../../x", "%2e.%2f..%2fx"},
                                                         {"a\\b", "a%5cb"},
                                                         {"-rf", "%2drf"},
                                                         {"a\nb", "a%0ab"},
                                                         {"50%", "50%25"},
                                                         {"end.", "end%2e"},
                                                         {"end ", "end%20"},
                                                         {" begin", "%20begin"},
                                                         {".hidden", "%2ehidden"},
                                                         {"~root", "%7eroot"},
                                                         {"CON", "%43ON"},
                                                         {"nul.txt", "%6eul.txt"},
                                                         {"\xFFx", "%ffx"},
                                                         {"\xE2\x80\xAE"
                                                          "dws",
                                                          "%e2%80%aedws"}};
    for (const auto& [name, safe] : names) EXPECT_EQ(safe_file_name(name), safe);
}

TEST(SafeFileNames, AreCutWhereTheyAreLongAndStayDifferent) {
    const std::string a = safe_file_name(std::string(500, 'a') + "1"), b = safe_file_name(std::string(500, 'a') + "2");
    expect_safe(a);
    EXPECT_NE(a, b);
    EXPECT_EQ(a.size(), kMostNameBytes);
    EXPECT_NE(safe_file_name(a), a) << "or a name might be made up that meets another one";
    std::string hearts;
    for (int i = 0; i < 200; ++i) hearts += "\xE2\x99\xA5";
    expect_safe(safe_file_name(hearts));
}

TEST(SafeFileNames, AreSafeAndDifferentForAnyBytes) {
    Random random(36);
    constexpr std::string_view kLikely = "../\\ -~%:aCoNnul\n\xC3\xA9\xFF";
    std::map<std::string, std::string> of;
    for (int i = 0; i < 200'000; ++i) {
        std::string name;
        for (std::uint64_t length = random.below(9); length > 0; --length)
            name += random.below(4) > 0 ? kLikely[random.below(kLikely.size())] : static_cast<char>(random.below(256));
        const std::string safe = safe_file_name(name);
        expect_safe(safe);
        const auto [known, is_new] = of.try_emplace(safe, name);
        ASSERT_TRUE(is_new || known->second == name) << safe;
    }
}

}  // namespace
}  // namespace enfilade
