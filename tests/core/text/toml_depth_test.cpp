#include "core/text/toml_depth.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

TEST(TomlDepth, AllowsWhatASiteHolds) {
    for (const char* text :
         {"", "a = 1.5\n[[floor.plan]]\n", "p = [[1.0, -2.5], [1e-3, 4.25]]",
          "image = \"a.b.c/d.e.png\" # v. 1.2.3", "s = 'a.b.c\\'\nx = \"\\\".\\\\\"",
          "empty = \"\"\nother = ''\n", "\"a.b.c\".d = 1"}) {
        EXPECT_TRUE(checkTomlDepth(text, "x")) << text;
    }
}

TEST(TomlDepth, RefusesNestedKeysHoweverTheyAreWritten) {
    for (const char* text :
         {"a.b.c = 1", "\na . b . c = 1", "\n[a.b.c]", "1.1.1.1 = 2", "\"a\".\"b\".'c' = 1",
          "x = {a.b = {c.d = 1}}", "s = \"\"\"\n", "s = '''\n", "s = \"\\\"\" a.b.c = 1"}) {
        const auto checked = checkTomlDepth(text, "x");
        ASSERT_FALSE(checked) << text;
        EXPECT_EQ(checked.error().code, ErrorCode::kBadFormat);
        EXPECT_EQ(checked.error().subject, text[0] == '\n' ? "x:2" : "x:1");
    }
}

TEST(TomlDepth, QuotesWhatWouldEndAString) {
    EXPECT_EQ(quotedToml("a \"b\" \\ \n\x7F ä"), "\"a \\\"b\\\" \\\\ \\u000A\\u007F ä\"");
}

}  // namespace
}  // namespace hedr
