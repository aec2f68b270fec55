// `enfilade render` from outside.
#include <gmock/gmock.h>

#include "app/cli/program.h"
#include "formats/png.h"

namespace enfilade {
namespace {

using test::Ended;
using test::Program;
using ::testing::HasSubstr;
using ::testing::Not;

class Render : public ::testing::Test {
protected:
    Render() { program_.write("map.toml", test::kTwoRooms); }

    /// Runs `render map.toml --size 64x40` with more arguments.
    Ended render(std::vector<std::string> more) const {
        std::vector<std::string> arguments{"render", "map.toml", "--size", "64x40"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return program_.run(arguments);
    }

    Image picture(const std::string& name) const {
        const auto bytes = read_file(program_.path(name));
        EXPECT_TRUE(bytes.ok()) << bytes.error().text();
        return read_png(bytes.value()).value();
    }

    Program program_;
};

TEST_F(Render, DrawsThePlayersView) {
    const Ended ended = render({"--out", "a.png"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_EQ(picture("a.png").width, 64u);
    EXPECT_EQ(picture("a.png").height, 40u);
}

TEST_F(Render, DrawsTheSameFromTheSamePlaceGivenByHand) {
    render({"--out", "a.png"});
    EXPECT_EQ(render({"--view", "2,3,1.5,0,0", "--out", "b.png"}).exit_code, 0);
    EXPECT_EQ(picture("a.png").pixels, picture("b.png").pixels);
}

TEST_F(Render, TakesAViewThatBeginsWithAMinus) {
    const Ended ended = render({"--view", "-1,3,1.5,0,0", "--out", "b.png"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.err, HasSubstr("(-1, 3)"));
}

TEST_F(Render, DrawsTheThingsOfTheSkill) {
    const std::string statue =
        "[[things]]\nx = 4\ny = 3\nskills = [5]\nlight = 0.2\nframes = [{ texture = \"statue\", origin = [32, 64] }]\n";
    program_.write("map.toml", test::kTwoRooms + std::string("\n") + statue);
    render({"--out", "usual.png"});
    EXPECT_EQ(render({"--skill", "5", "--out", "hard.png"}).exit_code, 0);
    EXPECT_NE(picture("usual.png").pixels, picture("hard.png").pixels);
    EXPECT_EQ(render({"--skill", "6", "--out", "no.png"}).exit_code, 2);
}

TEST_F(Render, TurnsThePictureWithTruePitchAndLeansItWithRoll) {
    const std::vector<std::string> down{"--view", "2,3,1.5,0,-30", "--renderer", "reference"};
    const auto drawn = [&](std::vector<std::string> more) {
        more.insert(more.end(), down.begin(), down.end());
        more.insert(more.end(), {"--out", "a.png"});
        EXPECT_EQ(render(more).exit_code, 0);
        return picture("a.png").pixels;
    };
    EXPECT_NE(drawn({}), drawn({"--true-pitch"}));
    EXPECT_NE(drawn({"--true-pitch"}), drawn({"--true-pitch", "--roll", "20"}));
    EXPECT_EQ(render({"--roll", "20", "--out", "a.png"}).exit_code, 2);
    EXPECT_EQ(render({"--true-pitch", "--out", "a.png"}).exit_code, 2) << "columns stay upright";
}

TEST_F(Render, LeavesThingsOut) {
    render({"--out", "empty.png"});
    program_.write("map.toml",
                   test::kTwoRooms + std::string("\n[[things]]\nx = 4\ny = 3\nlight = 0.2\n"
                                                 "frames = [{ texture = \"statue\", origin = [32, 64] }]\n"));
    render({"--out", "whole.png"});
    EXPECT_EQ(render({"--no-things", "--out", "without.png"}).exit_code, 0);
    EXPECT_NE(picture("whole.png").pixels, picture("without.png").pixels);
    EXPECT_EQ(picture("empty.png").pixels, picture("without.png").pixels);
}

TEST_F(Render, LetsLightStandStill) {
    program_.write("map.toml", test::kTwoRooms + std::string("\n[[lights]]\nx = 4\ny = 3\nz = 1\nbrightness = 0.5\n"
                                                             "effect = { kind = \"glow\", dark = 0.1, dark_s = 1 }\n"));
    render({"--time", "1", "--out", "dark.png"});
    render({"--still-light", "--out", "first.png"});
    EXPECT_EQ(render({"--still-light", "--time", "1", "--out", "later.png"}).exit_code, 0);
    EXPECT_NE(picture("dark.png").pixels, picture("later.png").pixels);
    EXPECT_EQ(picture("first.png").pixels, picture("later.png").pixels);
}

TEST_F(Render, DrawsViewsFromOutside) {
    const Ended ended = render({"--out", "a.png", "--from-above", "above.png", "--from-behind", "behind"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_EQ(picture("above.png").width, 64u);
    EXPECT_NE(picture("above.png").pixels, picture("a.png").pixels);
    EXPECT_NE(picture("above.png").pixels, picture("behind/000000.png").pixels);
    render({"--out", "a.png", "--from-above", "farther.png", "--reach", "60"});
    EXPECT_NE(picture("above.png").pixels, picture("farther.png").pixels);
}

TEST_F(Render, RefusesOutsideViewsThatCannotBe) {
    const Ended twice = render({"--out", "-", "--from-above", "-"});
    EXPECT_EQ(twice.exit_code, 2);
    EXPECT_THAT(twice.err, HasSubstr("only one of --out, --ids, --id-list, --from-above, --from-behind and --timing"));
    program_.write("views.csv", "x,y,z,yaw,pitch\n2,3,1.5,0,0\n2,3,1.5,9,0\n");
    const Ended many = render({"--views", "views.csv", "--out", "all", "--from-behind", "one.png"});
    EXPECT_EQ(many.exit_code, 2);
    EXPECT_THAT(many.err, HasSubstr("--from-behind: expected a folder for 2 pictures"));
    const Ended near = render({"--out", "a.png", "--from-above", "above.png", "--reach", "1"});
    EXPECT_EQ(near.exit_code, 2);
    EXPECT_THAT(near.err, HasSubstr("expected a number from 2 to 4096"));
    const Ended of_nothing = render({"--out", "a.png", "--reach", "60"});
    EXPECT_EQ(of_nothing.exit_code, 2);
    EXPECT_THAT(of_nothing.err, HasSubstr("--reach: needs --from-above or --from-behind"));
    const Ended over_itself = render({"--out", "a.png", "--from-above", "a.png"});
    EXPECT_EQ(over_itself.exit_code, 2);
    EXPECT_THAT(over_itself.err, HasSubstr("'a.png' is given twice"));
}

TEST_F(Render, TellsWhatPixelsShow) {
    const Ended ended = render({"--out", "a.png", "--at", "2,20", "--at", "32,39"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("2,20: wall 0 of sector 'hall', 3.2"));
    EXPECT_THAT(ended.out, HasSubstr(" of 'wall'; map.toml:18\n32,39: floor of sector 'hall', 2.4"));
    EXPECT_THAT(ended.out, HasSubstr(" of 'floor'; map.toml:13\n"));
}

TEST_F(Render, TellsNothingOfThingsThatAreLeftOut) {
    program_.write("map.toml", test::kTwoRooms + std::string("\n[[things]]\nx = 4\ny = 3\nname = \"statue\"\n"
                                                             "frames = [{ texture = \"statue\" }]\n"));
    const std::vector<std::string> look{"--view", "2,3,1,0,0", "--out", "a.png", "--at", "32,25"};
    std::vector<std::string> without = look;
    without.push_back("--no-things");
    EXPECT_THAT(render(look).out, HasSubstr("thing 0 ('statue')"));
    EXPECT_THAT(render(without).out, ::testing::Not(HasSubstr("thing")));
}

TEST_F(Render, TellsWhatPixelsOfEachViewShow) {
    program_.write("views.csv", "x,y,z,yaw,pitch\n2,3,1.5,0,0\n2,3,1.5,180,0\n");
    const Ended ended = render({"--views", "views.csv", "--out", "all", "--at", "32,20"});
    EXPECT_THAT(ended.out, HasSubstr("view 1: 32,20: wall 5 of sector 'hall', 2.00 m ahead"));
}

TEST_F(Render, RefusesPixelsOutsideThePictureAndTwoThingsOnStandardOutput) {
    const Ended outside = render({"--out", "a.png", "--at", "64,0"});
    EXPECT_EQ(outside.exit_code, 2);
    EXPECT_THAT(outside.err,
                HasSubstr("--at: expected X,Y in pixels of the picture, X from 0 to 63 and Y from 0 to 39"));
    EXPECT_EQ(render({"--out", "-", "--at", "1,1"}).exit_code, 2);
}

TEST_F(Render, DrawsAList) {
    program_.write("views.csv", "x,y,z,yaw,pitch,sector\n2,3,1.5,0,0,\n9,3,1.5,180,10,niche\n");
    EXPECT_EQ(render({"--views", "views.csv", "--out", "pictures/of/it"}).exit_code, 0);
    EXPECT_TRUE(program_.exists("pictures/of/it/000000.png"));
    EXPECT_TRUE(program_.exists("pictures/of/it/000001.png"));
    EXPECT_FALSE(program_.exists("pictures/of/it/000002.png"));
}

TEST_F(Render, DrawsAListTheSameWithAnyNumberOfThreads) {
    std::string list = "x,y,z,yaw,pitch\n";
    for (int yaw = 0; yaw < 360; yaw += 40) list += "2,3,1.5," + std::to_string(yaw) + ",0\n";
    program_.write("views.csv", list);
    render({"--views", "views.csv", "--out", "one", "--threads", "1"});
    render({"--views", "views.csv", "--out", "three", "--threads", "3"});
    for (int i = 0; i < 9; ++i) {
        const std::string name = "/00000" + std::to_string(i) + ".png";
        EXPECT_EQ(program_.text("one" + name), program_.text("three" + name));
        EXPECT_NE(program_.text("one" + name), "");
    }
}

TEST_F(Render, WritesSurfaceIdsThatBothRenderersAgreeOn) {
    render({"--view", "2.3,3.1,1.4,7,0", "--out", "a.png", "--ids", "column.png"});
    render({"--view", "2.3,3.1,1.4,7,0", "--out", "a.png", "--ids", "reference.png", "--renderer", "reference"});
    EXPECT_EQ(picture("column.png").pixels, picture("reference.png").pixels);
    EXPECT_EQ(picture("column.png").pixels.front(), 0xFF020000u);  // the hall's ceiling is 2, in blue
}

TEST_F(Render, ListsWhatSurfaceIdsStandFor) {
    const Ended ended = render({"--out", "a.png", "--ids", "ids.png", "--id-list", "ids.csv"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    const std::string list = program_.text("ids.csv");
    EXPECT_THAT(
        list, ::testing::StartsWith("id,surface,sector,place\n1,floor,hall,map.toml:13\n2,ceiling,hall,map.toml:14\n"));
    EXPECT_THAT(list, HasSubstr("\n5,wall 0,hall,map.toml:18\n"));
    EXPECT_THAT(list, ::testing::EndsWith("\n16777215,the end of a chain of links,,\n"));
    const Ended twice = render({"--out", "a.png", "--id-list", "t.csv", "--timing", "t.csv"});
    EXPECT_EQ(twice.exit_code, 2);
    EXPECT_THAT(twice.err, HasSubstr("'t.csv' is given twice"));
}

TEST_F(Render, WritesHowLongEachViewTook) {
    program_.write("views.csv", "x,y,z,yaw,pitch\n2,3,1.5,0,0\n2,3,1.5,90,0\n");
    EXPECT_EQ(render({"--views", "views.csv", "--out", "p", "--timing", "t.csv"}).exit_code, 0);
    EXPECT_THAT(program_.text("t.csv"), ::testing::MatchesRegex("view,ns\n0,[0-9]+\n1,[0-9]+\n"));
}

TEST_F(Render, RefusesOnePictureFileForSeveralViews) {
    program_.write("views.csv", "x,y,z,yaw,pitch\n2,3,1.5,0,0\n2,3,1.5,90,0\n");
    EXPECT_EQ(render({"--views", "views.csv", "--out", "a.png"}).exit_code, 2);
    EXPECT_FALSE(program_.exists("a.png"));
}

TEST_F(Render, RefusesPicturesThatAreNotPng) {
    const Ended ended = render({"--out", "a.jpg"});
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_THAT(ended.err, HasSubstr("--out: expected a .png picture, or a folder for 000000.png; found 'a.jpg'"));
    EXPECT_EQ(render({"--out", "a.mp4"}).exit_code, 2);
}

TEST_F(Render, OffersNoSinglePictureForSeveralViews) {
    program_.write("views.csv", "x,y,z,yaw,pitch\n2,3,1.5,0,0\n2,3,1.5,90,0\n");
    for (const char* path : {"a.jpg", "a.png"})
        EXPECT_THAT(render({"--views", "views.csv", "--out", path}).err,
                    HasSubstr("expected a folder for 2 pictures; found '" + std::string(path) + "'"));
}

TEST_F(Render, NamesTheLineOfAViewOutsideTheMap) {
    program_.write("views.csv", "x,y,z,yaw,pitch\n2,3,1.5,0,0\n99,3,1.5,0,0\n");
    const Ended ended = render({"--views", "views.csv", "--out", "p"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.err, HasSubstr("views.csv:3"));
    EXPECT_FALSE(program_.exists("p"));
}

TEST_F(Render, MentionsAnEyeAboveTheCeilingOrBelowTheFloor) {
    const Ended above = render({"--view", "2,3,3,0,0", "--out", "a.png"});
    EXPECT_EQ(above.exit_code, 0);
    EXPECT_EQ(above.err,
              "map.toml: 2 warnings; `enfilade check map.toml` shows them\nmap.toml: note: the eye at z = 3 is "
              "not below the ceiling of sector 'hall' at 3 m; the picture looks through it and smears it\n");
    EXPECT_THAT(render({"--view", "2,3,-1,0,0", "--out", "a.png"}).err, HasSubstr("not above the floor"));
    EXPECT_THAT(render({"--view", "2,3,2.9,0,0", "--out", "a.png"}).err, Not(HasSubstr("note")));
    program_.write("views.csv", "x,y,z,yaw,pitch\n2,3,1.5,0,0\n2,3,4,0,0\n2,3,5,0,0\n");
    const Ended many = render({"--views", "views.csv", "--out", "many"});
    EXPECT_THAT(many.err, HasSubstr("views.csv:3: note: the eye at z = 4"));
    EXPECT_THAT(many.err, HasSubstr("views.csv: note: 1 more like it"));
}

TEST_F(Render, DrawsByOpenGlWithoutADisplay) {
    const Ended ended = render({"--renderer", "stencil", "--out", "a.png", "--ids", "ids.png"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_TRUE(program_.exists("a.png"));
    EXPECT_TRUE(program_.exists("ids.png"));
}

TEST_F(Render, RefusesWhatDoesNotExistYet) {
    const Ended other = render({"--renderer", "vulkan", "--out", "a.png"});
    EXPECT_EQ(other.exit_code, 2);
    EXPECT_THAT(other.err, HasSubstr("expected column, stencil or reference"));
}

TEST_F(Render, SmoothsEdgesWithSamples) {
    render({"--out", "one.png"});
    EXPECT_EQ(render({"--samples", "4", "--out", "sixteen.png", "--ids", "ids.png"}).exit_code, 0);
    render({"--out", "one.png", "--ids", "same.png"});
    EXPECT_NE(program_.text("one.png"), program_.text("sixteen.png"));
    EXPECT_EQ(program_.text("ids.png"), program_.text("same.png")) << "ids are those of the pixels' middles";
    const Ended wide = program_.run({"render", "map.toml", "--samples", "8", "--size", "4000x10", "--out", "wide.png"});
    EXPECT_EQ(wide.exit_code, 2);
    EXPECT_THAT(wide.err, HasSubstr("--samples: expected at most 4 for a picture of 4000x10"));
}

TEST_F(Render, DrawsByDialsAndLeavesSurfacesWhereTheyAre) {
    render({"--out", "exact.png", "--ids", "exact_ids.png"});
    for (const std::vector<std::string>& options : {std::vector<std::string>{"--accuracy", "16"},
                                                    {"--dial", "span=32"},
                                                    {"--dial", "number=fixed", "--dial", "light=bands"},
                                                    {"--dial", "sampling=mip"},
                                                    {"--dial", "sampling=bilinear"},
                                                    {"--dial", "sampling=trilinear"}}) {
        std::vector<std::string> all = options;
        all.insert(all.end(), {"--out", "other.png", "--ids", "ids.png"});
        EXPECT_EQ(render(all).exit_code, 0) << options[1];
        EXPECT_TRUE(program_.text("other.png") != program_.text("exact.png")) << options[1];
        EXPECT_EQ(program_.text("ids.png"), program_.text("exact_ids.png")) << options[1];
    }
}

TEST_F(Render, RefusesDialsThatThereAreNot) {
    const auto refused = [&](std::vector<std::string> options) {
        options.insert(options.end(), {"--out", "a.png"});
        const Ended ended = render(options);
        EXPECT_EQ(ended.exit_code, 2);
        EXPECT_FALSE(program_.exists("a.png"));
        return ended.err;
    };
    EXPECT_THAT(refused({"--accuracy", "good"}),
                HasSubstr("--accuracy: expected exact, fine, fast, vanilla, or how many texels"));
    EXPECT_THAT(refused({"--dial", "spam=2"}),
                HasSubstr("--dial: expected NAME=VALUE, as in span=8; found 'spam=2'; did "
                          "you mean 'span'?"));
    EXPECT_THAT(refused({"--renderer", "reference", "--dial", "span=2"}),
                HasSubstr("the reference renderer cannot draw by span=2; it has the dials sampling, samples, light, "
                          "fog, light_grid and links; the column renderer has more"));
    EXPECT_THAT(refused({"--renderer", "stencil", "--dial", "sampling=bilinear"}),
                HasSubstr("the stencil renderer cannot draw by sampling=bilinear; it has the dials samples, light, "
                          "fog, light_grid, portals and links; the column renderer has more"));
    EXPECT_THAT(
        refused({"--dial", "tick_rate=35"}),
        HasSubstr("nothing moves in a picture: expected tick_rate and crossing only of `play`, found tick_rate=35"));
    EXPECT_THAT(
        refused({"--dial", "portals=plane24"}),
        HasSubstr("the column renderer cannot draw by portals=plane24; it has the dials accuracy, span, number"));
    EXPECT_THAT(refused({"--accuracy", "fast", "--dial", "number=float"}),
                HasSubstr("an accuracy is a promise that span and number would break"));
}

TEST_F(Render, RefusesAListWithoutViews) {
    program_.write("none.csv", "x,y,z,yaw,pitch\n");
    const Ended ended = render({"--views", "none.csv", "--out", "all"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.err, HasSubstr("none.csv: expected at least one view"));
    EXPECT_FALSE(program_.exists("all"));
}

TEST_F(Render, RefusesNumbersOutOfRange) {
    for (const auto& [option, value] : std::vector<std::pair<std::string, std::string>>{{"--fov", "180"},
                                                                                        {"--fov", "nan"},
                                                                                        {"--stretch", "0"},
                                                                                        {"--threads", "0"},
                                                                                        {"--samples", "9"},
                                                                                        {"--time", "-1"},
                                                                                        {"--size", "0x5"}})
        EXPECT_EQ(render({option, value, "--out", "a.png"}).exit_code, 2) << option << " " << value;
}

TEST_F(Render, LeavesNothingBehindForAMapThatIsRefused) {
    program_.write("map.toml", "format = 1\n");
    const Ended ended = render({"--out", "new/a.png"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.err, HasSubstr("map.toml"));
    EXPECT_FALSE(program_.exists("new"));
}

TEST_F(Render, DrawsIntoAStream) {
    render({"--out", "a.png"});
    for (const char* stream : {"-", "/dev/stdout"})
        EXPECT_TRUE(render({"--out", stream}).out == program_.text("a.png")) << stream;
    EXPECT_THAT(render({"--out", "b.png", "--timing", "-"}).out, ::testing::StartsWith("view,ns\n0,"));
    EXPECT_EQ(render({"--out", "-", "--ids", "-"}).exit_code, 2);
}

TEST_F(Render, WritesIntoADeviceAndLeavesItThere) {
    EXPECT_EQ(render({"--out", "/dev/null", "--timing", "/dev/null"}).exit_code, 0);
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
    const Ended full = render({"--out", "/dev/full"});
    EXPECT_EQ(full.exit_code, 1);
    EXPECT_THAT(full.err, HasSubstr("enfilade: /dev/full: cannot write the file: "));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST_F(Render, SaysWhenAPictureCannotBeWritten) {
    const Ended ended = render({"--out", "no/such/a.png"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.err, HasSubstr("no/such/a.png"));
}

/// A hall 125 m long of whose north walls, 500 of them, each leads in again by the south wall opposite.
std::string hall_of_links() {
    std::string north, south, vertices;
    for (int i = 0; i < 500; ++i) {
        const std::string n = std::to_string(i), s = std::to_string(499 - i);
        north += "{ name = \"n" + n + "\", next = \"hall\", via = \"s" + n + "\" }, ";
        south += "{ name = \"s" + s + "\", next = \"hall\", via = \"n" + s + "\" }, ";
        vertices += std::to_string(i / 4.0) + ", 0, ";
    }
    vertices += "125, 0, ";
    for (int i = 500; i > 0; --i) vertices += std::to_string(i / 4.0) + ", 4, ";
    return "format = 1\nrender = { max_depth = 1024 }\nplayer = { sector = \"hall\", x = 62, y = 2, z = 0, yaw = -90 "
           "}\n"
           "[[sectors]]\nname = \"hall\"\nfloor = { z = -500, texture = \"-\" }\n"
           "ceiling = { z = 500, texture = \"-\" }\n[[sectors.loops]]\nv = [" +
           vertices + "0, 4]\nwalls = [" + north + "{ texture = \"-\" }, " + south + "{ texture = \"-\" }]\n";
}

TEST_F(Render, SaysWhereLooksGoTooFar) {
    program_.write("links.toml", hall_of_links());
    for (const char* renderer : {"column", "stencil", "reference"}) {
        const Ended ended =
            program_.run({"render", "links.toml", "--size", "64x40", "--renderer", renderer, "--out", "a.png"});
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        EXPECT_THAT(ended.err, HasSubstr("a.png: note: in 1 picture looks through doorways went too far")) << renderer;
    }
    EXPECT_THAT(render({"--out", "a.png"}).err, Not(HasSubstr("went too far")));
}

}  // namespace
}  // namespace enfilade
