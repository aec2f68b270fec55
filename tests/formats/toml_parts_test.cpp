// Long TOML texts, which are cut into parts and parsed by several threads: nobody may notice.
#include <gmock/gmock.h>

#include "formats/findings.h"
#include "formats/toml.h"
#include "formats/toml_guard.h"

namespace enfilade {
namespace {

using testing::ElementsAre;
using testing::Gt;
using testing::IsEmpty;
using testing::SizeIs;

constexpr TomlLimits kLimits{std::size_t{16} << 20, std::size_t{1} << 22};
constexpr std::size_t kWorkers = 4;

/// A record with tables of its own, padded so that few of them are a part.
std::string record(std::string_view kind, int number) {
    return "[[" + std::string(kind) + "]] # [[not]]\nname = '" + std::to_string(number) + "'\nnote = \"\"\"\n[[" +
           std::string(kind) + "]]\n" + std::string(kLeastTomlPart / 16, 'x') + "\"\"\"\nv = [ 1.5,\n [2, 3] ]\n[" +
           std::string(kind) + ".floor]\nz = 0.25\n";
}

/// Four parts and a bit of sectors, and in the middle some things.
std::string long_text() {
    std::string text = "name = 'all'\n[player]\nx = 1\n";
    for (int i = 0; i < 70; ++i) text += record(i / 10 == 3 ? "things" : "sectors", i);
    return text;
}

std::optional<TomlDocument> parsed(std::string_view text, std::size_t workers, Findings& findings) {
    return TomlDocument::parse(text, kLimits, findings, workers);
}

std::vector<std::string> complaints(std::string_view text, std::size_t workers) {
    Findings findings;
    const bool is_parsed = parsed(text, workers, findings).has_value();
    EXPECT_EQ(is_parsed, findings.empty());
    return codes_and_places(findings);
}

/// Every value with its place, in the order of the text.
void tell(TomlNode node, std::string& told) {
    told += std::to_string(node.place().line) + ':' + std::to_string(node.place().column) + ' ';
    switch (node.kind()) {
        case TomlKind::table:
            for (const TomlEntry& entry : node.entries()) {
                told += std::string(entry.key) + '@' + std::to_string(entry.key_place.line) + ' ';
                tell(entry.value, told);
            }
            break;
        case TomlKind::array:
            for (std::size_t i = 0; i < node.size(); ++i) tell(node.at(i), told);
            break;
        case TomlKind::string: told += node.text(); break;
        default: told += std::to_string(node.number());
    }
    told += '\n';
}

std::string told(std::string_view text, std::size_t workers) {
    Findings findings;
    const auto document = parsed(text, workers, findings);
    EXPECT_THAT(codes_and_places(findings), IsEmpty());
    std::string all;
    if (document) tell(document->root(), all);
    return all;
}

/// What is wrong is found at the same place, whoever parses.
void expect_same_complaint(const std::string& text, const std::string& complaint) {
    EXPECT_THAT(complaints(text, 1), ElementsAre(complaint));
    EXPECT_THAT(complaints(text, kWorkers), ElementsAre(complaint));
}

std::string line_after(const std::string& text) {
    return std::to_string(std::count(text.begin(), text.end(), '\n') + 1);
}

TEST(TomlParts, AreCutAtHeadersOnly) {
    const std::string text = long_text();
    const TomlScan scan = scan_toml(text, kLimits);
    EXPECT_THAT(scan.cuts, SizeIs(Gt(3u)));
    for (const std::size_t cut : scan.cuts) {
        EXPECT_EQ(text.substr(cut, 2), "[[");
        EXPECT_THAT(text.substr(cut, 40), testing::HasSubstr("# [[not]]"));
    }
}

TEST(TomlParts, TogetherAreTheWhole) {
    const std::string text = long_text();
    EXPECT_EQ(told(text, kWorkers), told(text, 1));
}

TEST(TomlParts, OfATextThatSpeaksOfALaterTableFirstAreTheWhole) {
    // The last part begins with things and then goes on with the last sector of the part before.
    const std::string text = long_text() + record("things", 70) + "[sectors.ceiling]\nz = 1\n";
    EXPECT_EQ(told(text, kWorkers), told(text, 1));
}

TEST(TomlParts, NameThePlaceOfAnErrorInAnyOfThem) {
    const std::string text = long_text();
    expect_same_complaint(text + "v = [1\nw = 2\n", "bad-toml " + line_after(text + "\n") + ":1");
}

TEST(TomlParts, DoNotHideThatATableIsGivenTwice) {
    const std::string text = long_text();
    expect_same_complaint(text + "[player]\ny = 2\n", "bad-toml " + line_after(text) + ":1");
}

TEST(TomlParts, DoNotAddToAnArrayThatIsWrittenOut) {
    const std::string start = "sectors = [{ name = 'first' }]\n" + record("things", 0);
    std::string text = start;
    for (int i = 0; i < 20; ++i) text += record("things", i);
    EXPECT_THAT(complaints(text + record("sectors", 1), 1), SizeIs(1));
    EXPECT_EQ(complaints(text + record("sectors", 1), kWorkers), complaints(text + record("sectors", 1), 1));
}

}  // namespace
}  // namespace enfilade
