// Each rule of the house sees the mistake it is there for, in a source file made up on the spot.
#include "house/rules.h"

#include <gmock/gmock.h>

namespace enfilade::house {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

SourceFile including(const std::string& path, const std::string& what) { return {path, "#include " + what + "\n"}; }

TEST(Layers, AllowWhatLiesBelow) {
    EXPECT_THAT(check_layers(including("engine/space/trace.cpp", "\"math/vec.h\"")), IsEmpty());
    EXPECT_THAT(check_layers(including("engine/space/trace.cpp", "\"space/trace.h\"")), IsEmpty());
    EXPECT_THAT(check_layers(including("engine/render/column/walls.cpp", "\"render/view.h\"")), IsEmpty());
    EXPECT_THAT(check_layers(including("engine/app/play/loop.cpp", "\"app/draw/overlay.h\"")), IsEmpty());
    EXPECT_THAT(check_layers(including("engine/enfilade.h", "\"flight/flight.h\"")), IsEmpty());
    EXPECT_THAT(check_layers(including("engine/examples/walk.cpp", "\"enfilade.h\"")), IsEmpty());
    EXPECT_THAT(check_layers(including("wadconv/convert.cpp", "\"map/load.h\"")), IsEmpty());
    EXPECT_THAT(check_layers(including("wadconv/convert.cpp", "\"wadconv/wad.h\"")), IsEmpty());
}

TEST(Layers, RefuseWhatLiesAbove) {
    EXPECT_THAT(check_layers(including("engine/math/vec.h", "\"map/map.h\"")),
                ElementsAre("engine/math/vec.h:1: includes point only downward, not at map/map.h"));
    EXPECT_THAT(check_layers(including("engine/render/view.h", "\"render/column/walls.h\"")),
                ElementsAre(HasSubstr("only downward")));
    EXPECT_THAT(check_layers(including("engine/world/effects/door.cpp", "\"app/draw/overlay.h\"")),
                ElementsAre(HasSubstr("only downward")));
}

TEST(Layers, KeepTheEngineAwayFromItsFacade) {
    for (const char* file : {"engine/flight/flight.h", "wadconv/convert.cpp"})
        EXPECT_THAT(check_layers(including(file, "\"enfilade.h\"")), ::testing::SizeIs(1)) << file;
    EXPECT_THAT(check_layers(including("engine/enfilade.h", "\"app/options.h\"")),
                ElementsAre(HasSubstr("only downward")));
}

TEST(Layers, KeepTheRenderersApart) {
    EXPECT_THAT(check_layers(including("engine/render/column/walls.cpp", "\"render/reference/ray.h\"")),
                ElementsAre(HasSubstr("only downward")));
    EXPECT_THAT(check_layers(including("engine/render/stencil/mesh.cpp", "\"render/column/walls.h\"")),
                ElementsAre(HasSubstr("only downward")));
}

TEST(Layers, KeepTheConverterAwayFromTheWorld) {
    EXPECT_THAT(check_layers(including("wadconv/convert.cpp", "\"world/effects.h\"")),
                ElementsAre(HasSubstr("wadconv must not know")));
}

TEST(Layers, RefuseIncludesThatAreNotWrittenFromEngine) {
    EXPECT_THAT(check_layers(including("engine/space/trace.cpp", "\"trace.h\"")),
                ElementsAre(HasSubstr("written from engine/")));
    EXPECT_THAT(check_layers(including("engine/space/trace.cpp", "\"../math/vec.h\"")),
                ElementsAre(HasSubstr("written from engine/")));
}

TEST(Layers, RefuseFoldersNobodyKnows) {
    EXPECT_THAT(check_layers(including("engine/helpers/misc.cpp", "\"math/vec.h\"")),
                ElementsAre(HasSubstr("not in the table")));
}

TEST(Fences, KeepSdlInPlatform) {
    EXPECT_THAT(check_fenced_libraries(including("engine/platform/window.cpp", "<SDL2/SDL.h>")), IsEmpty());
    EXPECT_THAT(check_fenced_libraries(including("engine/world/world.cpp", "<SDL2/SDL.h>")),
                ElementsAre(HasSubstr("only engine/platform knows SDL")));
    EXPECT_THAT(check_fenced_libraries(including("engine/app/main.cpp", "<SDL.h>")),
                ElementsAre(HasSubstr("only engine/platform knows SDL")));
}

TEST(Fences, KeepTomlInFormats) {
    EXPECT_THAT(check_fenced_libraries(including("engine/formats/top_keys.cpp", "<toml++/toml.h>")), IsEmpty());
    EXPECT_THAT(check_fenced_libraries(including("engine/flight/script.cpp", "<toml++/toml.h>")),
                ElementsAre(HasSubstr("only engine/formats knows toml++")));
}

TEST(Fences, KeepOpenGlInTheStencilRenderer) {
    EXPECT_THAT(check_fenced_libraries(including("engine/render/stencil/gl.cpp", "<epoxy/gl.h>")), IsEmpty());
    EXPECT_THAT(check_fenced_libraries(including("engine/render/frame.cpp", "<epoxy/gl.h>")),
                ElementsAre(HasSubstr("OpenGL")));
}

TEST(Fences, KeepLibrariesOfCommandsFromTheEngine) {
    EXPECT_THAT(check_fenced_libraries(including("engine/app/bench.cpp", "<fmt/format.h>")), IsEmpty());
    for (const char* header : {"<fmt/format.h>", "<nlohmann/json.hpp>", "<CLI/CLI.hpp>"})
        EXPECT_THAT(check_fenced_libraries(including("engine/render/choice/renderer.cpp", header)),
                    ElementsAre(HasSubstr("only commands know fmt")));
}

TEST(Fences, KeepThreadsInParallel) {
    EXPECT_THAT(check_fenced_libraries(including("engine/base/parallel.cpp", "<thread>")), IsEmpty());
    EXPECT_THAT(check_fenced_libraries(including("engine/flight/fly.cpp", "<mutex>")),
                ElementsAre(HasSubstr("threads live in")));
}

TEST(HeaderForm, WantsAFirstSentenceAndPragmaOnce) {
    EXPECT_THAT(check_header_form({"engine/base/a.h", "// What it holds.\n#pragma once\n"}), IsEmpty());
    EXPECT_THAT(check_header_form({"engine/base/a.h", "#pragma once\n"}),
                ElementsAre(HasSubstr("first line"), HasSubstr("pragma")));
    EXPECT_THAT(check_header_form({"engine/base/a.h", "// What it holds.\n#include <vector>\n"}),
                ElementsAre(HasSubstr("pragma")));
}

TEST(Length, StopsBelowFiveHundredLines) {
    EXPECT_THAT(check_length({"engine/base/a.cpp", std::string(499, '\n')}), IsEmpty());
    EXPECT_THAT(check_length({"engine/base/a.cpp", std::string(500, '\n')}), ElementsAre(HasSubstr("500 lines")));
}

TEST(ForbiddenWords, SeeUnfinishedWorkAndSharedOwnership) {
    EXPECT_THAT(check_forbidden_words({"tests/a.cpp",
                                       "// TO"
                                       "DO: later\n"}),
                ElementsAre(HasSubstr("tests/a.cpp:1")));
    EXPECT_THAT(check_forbidden_words({"tests/a.cpp",
                                       "TEST(A, DISA"
                                       "BLED_B) {}\n"}),
                ElementsAre(HasSubstr("unfinished")));
    EXPECT_THAT(check_forbidden_words({"engine/a.cpp",
                                       "std::sha"
                                       "red_ptr<int> p;\n"}),
                ElementsAre(HasSubstr("owns")));
    EXPECT_THAT(check_forbidden_words({"engine/a.cpp", "// today, method, mastodon\n"}), IsEmpty());
}

// hard case D2
TEST(FloatFlags, SeeEveryFlagThatChangesResults) {
    for (const char* flag : {"-f"
                             "fast-math",
                             "-O"
                             "fast",
                             "-f"
                             "p-contract=fast",
                             "-f"
                             "unsafe-math-optimizations"})
        EXPECT_THAT(check_float_flags({"CMakeLists.txt", std::string("x\n") + flag + "\n"}),
                    ElementsAre(HasSubstr("CMakeLists.txt:2")));
    EXPECT_THAT(check_float_flags({"CMakeLists.txt", "-ffp-contract=off -O3\n"}), IsEmpty());
}

// hard case D3
TEST(Approximations, AreSeenByTheirNames) {
    for (const char* call :
         {"_mm_rcp_ps(x)", "_mm256_rsqrt_ps(x)", "_mm512_rcp14_ps(x)", "vrecpeq_f32(x)", "__builtin_ia32_rcpps(x)"})
        EXPECT_THAT(check_approximations({"engine/render/a.cpp", std::string("y = ") + call + ";\n"}),
                    ElementsAre(HasSubstr("divide")))
            << call;
    EXPECT_THAT(check_approximations({"engine/render/a.cpp", "y = _mm_div_ps(a, b); // not _mm_rcp_ps(b)\n"}),
                IsEmpty());
}

TEST(Libm, IsSeenInSimulationStateOnly) {
    EXPECT_THAT(check_libm({"engine/world/a.cpp", "x = std::sin(y);\n"}), ElementsAre(HasSubstr("std::sin(")));
    EXPECT_THAT(check_libm({"engine/space/a.cpp", "x = atan2(y, z);\n"}), ElementsAre(HasSubstr("atan2(")));
    EXPECT_THAT(check_libm({"engine/space/a.cpp", "x = powf(y, 2);\n"}), ElementsAre(HasSubstr("powf(")));
    EXPECT_THAT(check_libm({"engine/world/a.cpp", "x = std::sqrt(y) + std::floor(z);\n"}), IsEmpty());
    EXPECT_THAT(check_libm({"engine/world/a.cpp", "// sin(x) would differ\nbasin(x); box.cos(x);\n"}), IsEmpty());
    EXPECT_THAT(check_libm({"engine/render/a.cpp", "x = std::sin(y);\n"}), IsEmpty());
}

TEST(Exceptions, StayWhereAttemptsAreMade) {
    for (const char* code : {"throw 1;\n", "try { f(); }\n", "} catch (...) {\n"}) {
        EXPECT_THAT(check_exceptions({"engine/world/a.cpp", code}), ElementsAre(HasSubstr("engine/world/a.cpp:1")))
            << code;
        EXPECT_THAT(check_exceptions({"engine/base/attempt.cpp", code}), IsEmpty()) << code;
        EXPECT_THAT(check_exceptions({"tests/base/a_test.cpp", code}), IsEmpty()) << code;
    }
    EXPECT_THAT(check_exceptions({"engine/world/a.cpp", "// try this\nretry(catcher);\n"}), IsEmpty());
}

TEST(Fences, KeepFilesInBase) {
    for (const char* header : {"<fstream>", "<fcntl.h>"}) {
        EXPECT_THAT(check_fenced_libraries(including("engine/base/files.cpp", header)), IsEmpty());
        EXPECT_THAT(check_fenced_libraries(including("tests/base/files_test.cpp", header)), IsEmpty());
        for (const char* file : {"engine/app/play/map_list.cpp", "wadconv/wad.cpp"})
            EXPECT_THAT(check_fenced_libraries(including(file, header)), ElementsAre(HasSubstr("base/files.h")));
    }
}

TEST(Opening, IsSeenInOthersCalls) {
    for (const char* code : {"std::fopen(x, y);", "f = fopen (x, y);", "freopen(x, y, stdin);", "fdopen(x, y);",
                             "toml::parse_file(x);", "SDL_RWFromFile(x, y);", "SDL_LoadWAV(x, y, z, w);"})
        for (const char* path : {"engine/app/a.cpp", "wadconv/main.cpp"})
            EXPECT_THAT(check_opening({path, code}), ElementsAre(HasSubstr("base/files.h"))) << code;
    EXPECT_THAT(check_opening({"engine/app/a.cpp",
                               "popen(x, y); OutputFile::open(x); menu.open(); SDL_LoadWAV_RW(x); // fopen(x)"}),
                IsEmpty());
    EXPECT_THAT(check_opening({"tests/bench/a.cpp", "std::fopen(x, y);"}), IsEmpty());
}

TEST(Printing, IsSeenOutsideOfTheTerminal) {
    for (const char* code :
         {"fmt::print(stderr, x);", "std::printf(x);", "std::fprintf(stderr, x);", "puts(x);", "std::fputs(x, stdout);",
          "std::cout << x;", "std::cerr << x;", "putchar (c);", "perror(x);"})
        for (const char* path : {"engine/app/a.cpp", "wadconv/main.cpp"})
            EXPECT_THAT(check_printing({path, code}), ElementsAre(HasSubstr("base/text.h"))) << code;
    EXPECT_THAT(check_printing({"engine/base/text.cpp", "std::fputs(x, stderr);"}), IsEmpty());
    EXPECT_THAT(check_printing({"tests/bench/a.cpp", "std::puts(x);"}), IsEmpty());
    EXPECT_THAT(
        check_printing({"engine/app/a.cpp", "std::snprintf(t, n, x); print_to_stdout(x); inputs(); // puts(x)"}),
        IsEmpty());
}

TEST(StandardOutput, IsNamedByNothingThatLosesWords) {
    for (const char* code : {"std::fwrite(x, 1, n, stdout);", "::write(STDOUT_FILENO, x, n);", "fflush(stdout);"})
        for (const char* path : {"engine/app/a.cpp", "engine/base/text.cpp", "wadconv/main.cpp"})
            EXPECT_THAT(check_standard_output({path, code}), ElementsAre(HasSubstr("command/command.h"))) << code;
    EXPECT_THAT(check_standard_output({"engine/base/output_file.cpp", "fstat(STDOUT_FILENO, &out)"}), IsEmpty());
    EXPECT_THAT(check_standard_output({"engine/app/a.cpp", "print_to_stdout(x); // to stdout"}), IsEmpty());
}

TEST(NamesOfFiles, AreSeenWhereTheyAreTakenAsTheyWereFound) {
    for (const char* code : {"folder / wad.stem();", "wad.filename().string();", "folder / file_stem_of(wad);",
                             "path.substr(path.rfind('/') + 1);"})
        for (const char* path : {"engine/app/a.cpp", "wadconv/main.cpp"})
            EXPECT_THAT(check_names_of_files({path, code}), ElementsAre(HasSubstr("base/file_name.h"))) << code;
    EXPECT_THAT(check_names_of_files({"engine/base/file_name.cpp", "fs::path(path).stem();"}), IsEmpty());
    EXPECT_THAT(check_names_of_files({"tests/base/a.cpp", "path.stem();"}), IsEmpty());
    EXPECT_THAT(check_names_of_files({"engine/app/a.cpp", "folder / safe_file_name(file_stem_of(wad));"}), IsEmpty());
}

TEST(Removals, AreSeenOutsideOfBase) {
    for (const char* code :
         {"fs::remove(path, e);", "fs::remove_all(path);", "std::filesystem::remove(path);", "fs::rename(a, b);",
          "std::rename(a.c_str(), b.c_str());", "std::remove(a.c_str());", "unlink(a.c_str());", "::rmdir(a.c_str());"})
        for (const char* path : {"engine/app/a.cpp", "wadconv/main.cpp"})
            EXPECT_THAT(check_removals({path, code}), ElementsAre(HasSubstr("base/owned_folder.h"))) << code;
    for (const char* line : {"rm -rf \"$scratch\"", "  if [ -e \"$a\" ]; then mv \"$a\" b; fi", "cd x && rmdir y"})
        EXPECT_THAT(check_removals({"run", line}), ElementsAre(HasSubstr("the program's to keep"))) << line;
    EXPECT_THAT(check_removals({"run", "say 'what rm -r does' # mv\n"}), IsEmpty());
    EXPECT_THAT(check_removals({"engine/base/owned_folder.cpp", "fs::remove_all(path);"}), IsEmpty());
    EXPECT_THAT(check_removals({"tests/a.cpp", "fs::remove_all(path);"}), IsEmpty());
    EXPECT_THAT(check_removals({"engine/app/a.cpp",
                                "std::ranges::remove(a, b); std::erase(a, b); remove_superseded(a, b); rename(name);"
                                " remove_owned_folder(a); // fs::remove(a)"}),
                IsEmpty());
}

TEST(Blanking, KeepsCodeAndLinesAndDropsTheRest) {
    EXPECT_EQ(without_comments_and_strings("a /* b\nc */ d \"e\\\"f\" g // h\ni 'j' k"),
              "a     \n     d        g     \ni     k");
    EXPECT_EQ(without_comments_and_strings("1'000'000 + x"), "1'000'000 + x");
}

}  // namespace
}  // namespace enfilade::house
