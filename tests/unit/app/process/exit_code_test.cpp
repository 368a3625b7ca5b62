// What a program says where it ends.
#include "app/process/exit_code.hpp"

#include <gtest/gtest.h>

namespace stria {
namespace {

TEST(LineOfAnEnd, ShowsLettersOfAnyLanguage) {
    for (const char* text : {"", "a.msh:3: expects a number",
                             "Kr\xC3\xBC"
                             "ckstock.msh",
                             "\xE6\xA2\x81 \xF0\x9F\x8C\x89"})
        EXPECT_EQ(in_one_line(text), text);
}

// A mesh or a table may hold anything, and a message may cite it.
TEST(LineOfAnEnd, ShowsNoBytesThatAreNone) {
    EXPECT_EQ(in_one_line("bot\ntom\r"), "bot?tom?");
    EXPECT_EQ(in_one_line("\x1B[31mred"), "?[31mred");
    EXPECT_EQ(in_one_line(std::string_view("m\0a\0x", 5)), "m?a?x");
    EXPECT_EQ(in_one_line("\xFF\xE9 \xC3("), "?? ?(");
    EXPECT_EQ(in_one_line("cut \xE6\xA2"), "cut ??");
    EXPECT_EQ(in_one_line("\xC2\x9B"
                          "2J"),
              "??2J");
}

}  // namespace
}  // namespace stria
