// What commands say to other programs: valid by its schema, and true.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "app/cli/program.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

using nlohmann::json;
using test::Ended;
using test::Program;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kStand = "map = \"map.toml\"\nsize = [32, 20]\nrate = 4\n[[legs]]\nwait = 1\n";

class MachineOutput : public ::testing::Test {
protected:
    MachineOutput() {
        program_.write("map.toml", test::kTwoRooms);
        program_.write("stand.toml", kStand);
    }

    /// What was said, once it is valid by the schema of that name, as another program judges.
    json read(const Ended& ended, const std::string& schema) const {
        program_.write("said.json", ended.out);
        const std::string path = ENFILADE_SOURCE_DIR "/maps/" + schema + ".schema.json";
        const Ended judged = program_.run_other("/usr/bin/python3", {"-m", "jsonschema", "-i", "said.json", path});
        EXPECT_EQ(judged.exit_code, 0) << judged.err << ended.out << ended.err;
        return json::parse(ended.out, nullptr, false);
    }

    /// The same of a file.
    json read_file(const char* path, const std::string& schema) const {
        Ended ended;
        ended.out = program_.text(path);
        return read(ended, schema);
    }

    /// Makes the first room lower, which every frame shows.
    void repaint() const {
        std::string text = test::kTwoRooms;
        text.replace(text.find("z = 3"), 5, "z = 2");
        program_.write("map.toml", text);
    }

    Program program_;
};

TEST_F(MachineOutput, OfCheckHasEveryFinding) {
    program_.write("bad \xff.toml", "format = 1\nnonsense = 3\n" + std::string(test::kTwoRooms).substr(11));
    const Ended ended = program_.run({"check", "map.toml", "bad \xff.toml", "gone.toml", "--format", "json"});
    EXPECT_EQ(ended.exit_code, 1);
    const json said = read(ended, "check");
    EXPECT_EQ(said["refused"], 2);
    EXPECT_EQ(said["errors"], 2);
    EXPECT_EQ(said["warnings"], 4);
    EXPECT_EQ(said["maps"][0]["findings"].size(), 2u);
    EXPECT_EQ(said["maps"][0]["refused"], false);
    const json& error = said["maps"][1]["findings"][0];
    EXPECT_EQ(error["code"], "unknown-key");
    EXPECT_EQ(error["line"], 2);
    EXPECT_FALSE(said["maps"][2]["findings"][0].contains("line"));
}

TEST_F(MachineOutput, OfCheckAsSarifNamesPlaces) {
    program_.write("bad map.toml", "format = 1\nnonsense = 3\n" + std::string(test::kTwoRooms).substr(11));
    const json said = json::parse(program_.run({"check", "bad map.toml", "--format", "sarif"}).out, nullptr, false);
    EXPECT_EQ(said["version"], "2.1.0");
    const json& result = said["runs"][0]["results"][0];
    EXPECT_EQ(result["ruleId"], "unknown-key");
    EXPECT_EQ(result["level"], "error");
    const json& place = result["locations"][0]["physicalLocation"];
    EXPECT_EQ(place["artifactLocation"]["uri"], "bad%20map.toml");
    EXPECT_EQ(place["region"]["startLine"], 2);
}

TEST_F(MachineOutput, OfCheckIsJsonWhateverAMapIsCalled) {
    for (const std::string name : {"\x01\x1F\x7F.toml", "\xEF\xBF\xBE\xFF\xC3.toml", "\xED\xA0\x80.toml"}) {
        program_.write(name, "format = 1\n\"\\u0001\\uFFFE\" = 3\n");
        for (const char* format : {"json", "sarif"})
            EXPECT_TRUE(json::accept(program_.run({"check", name, "--format", format}).out)) << format;
    }
}

TEST_F(MachineOutput, OfFlyNamesTheFramesThatDiffer) {
    program_.run({"fly", "stand.toml", "--record"});
    const Ended same = program_.run({"fly", "stand.toml", "--check", "--format", "json"});
    EXPECT_EQ(same.exit_code, 0);
    EXPECT_EQ(read(same, "fly")["passed"], true);
    repaint();
    const Ended other = program_.run({"fly", "stand.toml", "--check", "--frames", "1..3", "--format", "json"});
    EXPECT_EQ(other.exit_code, 1);
    const json said = read(other, "fly");
    EXPECT_EQ(said["differing"], json({1, 2, 3}));
    EXPECT_EQ(said["report"], "stand.failed/index.html");
    EXPECT_EQ(said["compared_with"], "recording");
}

TEST_F(MachineOutput, OfFlyAsJunitHasACaseForEachFrame) {
    program_.run({"fly", "stand.toml", "--record"});
    EXPECT_THAT(program_.run({"fly", "stand.toml", "--check", "--format", "junit"}).out,
                HasSubstr("<testsuite name=\"stand.toml\" tests=\"5\" failures=\"0\">"));
    repaint();
    const std::string said = program_.run({"fly", "stand.toml", "--check", "--format", "junit"}).out;
    EXPECT_THAT(said, HasSubstr("failures=\"5\""));
    EXPECT_THAT(said, HasSubstr("name=\"frame 4\"><failure message=\"differs from the recording; see "));
    program_.write("said.xml", said);
    const Ended judged =
        program_.run_other("/usr/bin/python3", {"-c", "import xml.dom.minidom as m; m.parse(\"said.xml\")"});
    EXPECT_EQ(judged.exit_code, 0) << judged.err;
}

/// Whether another program takes the file for XML.
void expect_xml(const Program& program, const std::string& name) {
    const Ended judged = program.run_other(
        "/usr/bin/python3", {"-c", "import sys, xml.etree.ElementTree as e; e.parse(sys.argv[1])", name});
    EXPECT_EQ(judged.exit_code, 0) << judged.err;
}

TEST_F(MachineOutput, OfFlyAsJunitIsXmlWhateverTheScriptIsCalled) {
    const std::string name = "a\x01\x1F&<\"\n\xEF\xBF\xBE\xFF.toml";
    program_.write(name, kStand);
    program_.run({"fly", name, "--record"});
    repaint();
    program_.write("said.xml", program_.run({"fly", name, "--check", "--format", "junit"}).out);
    expect_xml(program_, "said.xml");
}

TEST_F(MachineOutput, OfDrawIsXmlWhateverRoomsAreCalled) {
    for (const char* name : {"\\u0001", "\\u001F", "\\u007F", "\\u0085", "\\u2028", "\\uFFFE", "\\uFFFF", "<&\\\""}) {
        std::string text = test::kTwoRooms;
        for (const char* word : {"hall", "border", "Two rooms"})
            for (std::size_t at = 0; (at = text.find(word, at)) != text.npos; at += std::string(name).size())
                text.replace(at, std::string(word).size(), name);
        program_.write("named.toml", text);
        EXPECT_EQ(program_.run({"draw", "named.toml", "--out", "named.svg"}).exit_code, 0);
        expect_xml(program_, "named.svg");
    }
}

/// In UTF-8, whether it is a character or not.
std::string bytes_of(std::uint32_t code) {
    const auto byte = [](std::uint32_t bits) { return static_cast<char>(bits); };
    const auto next = [&](std::uint32_t shift) { return byte(0x80 | (code >> shift & 0x3F)); };
    if (code < 0x80) return {byte(code)};
    if (code < 0x800) return {byte(0xC0 | code >> 6), next(0)};
    if (code < 0x10000) return {byte(0xE0 | code >> 12), next(6), next(0)};
    return {byte(0xF0 | code >> 18), next(12), next(6), next(0)};
}

// By another program's rules: a character is lost exactly where its reader of XML would not take it.
TEST_F(MachineOutput, AsXmlHoldsAllCharactersThatXmlCanHold) {
    std::string all;
    for (std::uint32_t code = 0; code <= 0x10FFFF; ++code) all += bytes_of(code);
    for (int byte = 0x80; byte <= 0xFF; ++byte) all += {static_cast<char>(byte), ' '};
    program_.write("all", all);
    program_.write("all.xml", "<a b=\"" + xml_escaped(all) + "\">" + xml_escaped(all) + "</a>");
    program_.write("judge.py", R"(import re, xml.etree.ElementTree as e
text = open("all", "rb").read().decode("utf-8", "surrogateescape")
lost = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
read = e.parse("all.xml").getroot()
assert read.text == read.get("b") == lost.sub("\ufffd", text)
)");
    const Ended judged = program_.run_other("/usr/bin/python3", {"judge.py"});
    EXPECT_EQ(judged.exit_code, 0) << judged.err;
}

TEST_F(MachineOutput, OfFlyAgainstAnotherRendererNamesIt) {
    const Ended ended = program_.run(
        {"fly", "stand.toml", "--check", "--against", "reference", "--tolerance", "100", "--format", "json"});
    EXPECT_EQ(read(ended, "fly")["compared_with"], "reference");
}

TEST_F(MachineOutput, OfBenchHasEveryFrame) {
    const Ended ended = program_.run(
        {"bench", "map.toml", "stand.toml", "--size", "32x20", "--rounds", "1", "--threads", "1", "--format", "json"});
    EXPECT_EQ(ended.exit_code, 0);
    const json said = read(ended, "bench");
    EXPECT_EQ(said["frames"].size(), 6u);
    EXPECT_EQ(said["frames"][1]["subject"], "stand.toml");
    EXPECT_EQ(said["width"], 32);
}

TEST_F(MachineOutput, IsRefusedWhereThereIsNone) {
    const std::vector<std::vector<std::string>> wrong{{"check", "map.toml", "--format", "junit"},
                                                      {"check", "map.toml", "--format", "json", "--effects"},
                                                      {"fly", "stand.toml", "--check", "--format", "sarif"},
                                                      {"fly", "stand.toml", "--record", "--format", "json"},
                                                      {"bench", "map.toml", "--format", "json", "--csv", "-"},
                                                      {"bench", "map.toml", "--format", "json", "--instructions"},
                                                      {"bench", "map.toml", "--format", "junit"}};
    for (const auto& arguments : wrong) {
        const Ended ended = program_.run(arguments);
        EXPECT_EQ(ended.exit_code, 2) << ended.err;
        EXPECT_EQ(ended.out, "");
    }
}

TEST_F(MachineOutput, QuietSaysOnlyErrors) {
    const auto expect_silence = [&](std::vector<std::string> arguments) {
        EXPECT_THAT(program_.run(arguments).out + program_.run(arguments).err, HasSubstr("map.toml")) << arguments[0];
        arguments.push_back("--quiet");
        const Ended ended = program_.run(arguments);
        EXPECT_EQ(ended.exit_code, 0);
        EXPECT_EQ(ended.out + ended.err, "") << arguments[0];
    };
    expect_silence({"check", "map.toml"});
    expect_silence({"render", "map.toml", "--out", "a.png"});
    expect_silence({"fly", "stand.toml", "--record"});
    expect_silence({"fly", "stand.toml", "--check"});
    const Ended bench = program_.run({"bench", "map.toml", "--rounds", "1", "--size", "8x8", "--quiet"});
    EXPECT_EQ(bench.err, "");
    EXPECT_THAT(bench.out, HasSubstr("map.toml"));
    program_.write("bad.toml", "format = 1\nnonsense = 3\n" + std::string(test::kTwoRooms).substr(11));
    const Ended bad = program_.run({"check", "bad.toml", "--quiet"});
    EXPECT_THAT(bad.out, HasSubstr("bad.toml:2:1: error: "));
    EXPECT_THAT(bad.out, Not(HasSubstr("warning")));
}

TEST_F(MachineOutput, OfAccuracyHasARowForEachSettingAndKindOfPoses) {
    ASSERT_EQ(program_.run({"accuracy", "--quick", "map.toml", "--out", "report"}).exit_code, 0);
    const json said = read_file("report/report.json", "accuracy");
    ASSERT_EQ(said["scenes"].size(), 1u);
    const json& rows = said["scenes"][0]["rows"];
    EXPECT_EQ(rows[0]["setting"], "exact");
    EXPECT_EQ(rows.size() % 2, 0u);
    EXPECT_EQ(rows.front()["poses"], "random");
    EXPECT_EQ(rows.back()["poses"], "lattice");
    EXPECT_THAT(rows[1]["command"].get<std::string>(), HasSubstr(rows[1]["setting"].get<std::string>()));
}

}  // namespace
}  // namespace enfilade
