// Texture specifications: every shape that is allowed, and those that look like one.
#include "formats/text_keys.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

struct SpecCase {
    const char* text;
    TextureSpec spec;
};

void PrintTo(const SpecCase& spec, std::ostream* out) { *out << spec.text; }

class GoodSpec : public testing::TestWithParam<SpecCase> {};

TEST_P(GoodSpec, IsRead) {
    const auto spec = parse_texture_spec(GetParam().text);
    ASSERT_TRUE(spec.ok()) << spec.error().text();
    EXPECT_TRUE(spec.value() == GetParam().spec);
}

TEST_P(GoodSpec, ReadsBackAsTheSame) {
    const auto spec = parse_texture_spec(to_text(GetParam().spec));
    ASSERT_TRUE(spec.ok()) << spec.error().text();
    EXPECT_TRUE(spec.value() == GetParam().spec);
}

INSTANTIATE_TEST_SUITE_P(Shapes, GoodSpec,
                         testing::Values(SpecCase{"BRICK", {"BRICK", {}, {}, {}}}, SpecCase{"-", {"-", {}, {}, {}}},
                                         SpecCase{"- 1,1", {"-", Vec2{1, 1}, {}, {}}},
                                         SpecCase{"A 2,0.5", {"A", Vec2{2, 0.5}, {}, {}}},
                                         SpecCase{"A -2,1e1", {"A", Vec2{-2, 10}, {}, {}}},
                                         SpecCase{"A 1,1 -3,4.5", {"A", Vec2{1, 1}, {-3, 4.5}, {}}},
                                         SpecCase{" \tA  1 , 1\t3 ,4 ", {"A", Vec2{1, 1}, {3, 4}, {}}},
                                         SpecCase{"A - 3,4", {"A", {}, {3, 4}, {}}},
                                         SpecCase{"A 1,1 -1.5m,0m", {"A", Vec2{1, 1}, {}, {}, Vec2{-1.5, 0}}},
                                         SpecCase{"A 1,1 3,4 1e1m , 2m", {"A", Vec2{1, 1}, {3, 4}, {}, Vec2{10, 2}}},
                                         SpecCase{"A - 2m,0m", {"A", {}, {}, {}, Vec2{2, 0}}},
                                         SpecCase{"a/b,c", {"a/b,c", {}, {}, {}}}, SpecCase{"..a", {"..a", {}, {}, {}}},
                                         SpecCase{"é漢", {"é漢", {}, {}, {}}}));

class BadSpec : public testing::TestWithParam<const char*> {};

TEST_P(BadSpec, IsRefused) { EXPECT_FALSE(parse_texture_spec(GetParam()).ok()); }

INSTANTIATE_TEST_SUITE_P(Shapes, BadSpec,
                         testing::Values("", "  ", "A 1", "A 1,", "A ,1", "A 1 1", "A 1,1,1", "A 1,1 2", "A 1,1 2,",
                                         "A 1,1 2,2 3", "A 1,1 2,2 3,3", "A -", "A - -", "A x,y", "A nan,1", "A inf,1",
                                         "A 0,1", "A 1,0", "A 1e9,1", "A 1e-9,1", "A 1,1 1e9,0", "A 1,1 1m",
                                         "A 1,1 1m,", "A 1,1 1m,1", "A 1,1 1,1m", "A 1m,1m", "A 1,1 m,m",
                                         "A 1,1 1mm,1m", "A 1,1 1m,1m 1,1", "A 1,1 1m,1m 1m,1m", "A 1,1 1e9m,0m",
                                         "../a", "a/../b", "a/..", "/a", "a\x01", "A 0x1,1"));

TEST(TextureSpec, SaysWhichPairIsHalf) {
    EXPECT_EQ(parse_texture_spec("A 1,1 2").error().what,
              "expected \"NAME [SU,SV [OU,OV] [OUm,OVm]]\": OU,OV is a pair, the second number is missing");
}

TEST(TextureSpec, SaysWhatItFoundInsteadOfANumber) {
    EXPECT_EQ(parse_texture_spec("A 1,b").error().what,
              "expected \"NAME [SU,SV [OU,OV] [OUm,OVm]]\": SU,SV is a pair of numbers, found 'b'");
}

TEST(TextureSpec, SaysThatNoBlankIsBeforeTheMetres) {
    EXPECT_EQ(parse_texture_spec("A 1,1 -2.5 m,0m").error().what,
              "expected 'm' right behind its number, found a blank between them");
}

TEST(TextureSpec, SaysWhereMetresAreMissing) {
    EXPECT_EQ(
        parse_texture_spec("A 1,1 2m,3").error().what,
        "expected \"NAME [SU,SV [OU,OV] [OUm,OVm]]\": OUm,OVm is a pair of numbers with 'm' behind each, found '3'");
}

}  // namespace
}  // namespace enfilade
