#include "core/text/plain_toml.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

TEST(PlainToml, LeavesWhatIsPlain) {
    for (const char* text : {"", "a = 1.5\n[[floor.plan]]\n", "p = [[1.0, -2.5], [1e-3, 4.25]]\n",
                             "image = \"a.b.c/d.e.png\"\n", "s = \"x\\\\\"\nx = \"\\\".\\\\\"\n",
                             "empty = \"\"\n", "\"a.b.c\".d = 1\n"}) {
        EXPECT_EQ(plainToml(text, "x").value_or("refused"), text);
    }
}

TEST(PlainToml, WritesLettersInAsciiAndDropsComments) {
    EXPECT_EQ(plainToml("\xEF\xBB\xBF"
                        "a = \"T\xC3\xBCr # 1.2.3\"  # T\xC3\xBCr 1.2.3\nb = 1",
                        "x")
                  .value(),
              "a = \"T\\u00FCr # 1.2.3\"  \nb = 1\n");
    EXPECT_EQ(plainToml("a = 'T\xC3\xBCr \"\\'", "x").value(), "a = \"T\\u00FCr \\\"\\\\\"\n");
    EXPECT_EQ(plainToml("a = \"\xF0\x9F\x8F\xA0\"", "x").value(), "a = \"\\U0001F3E0\"\n");
}

TEST(PlainToml, RefusesNestedKeysHoweverTheyAreWritten) {
    for (const char* text :
         {"a.b.c = 1", "\na . b . c = 1", "\n[a.b.c]", "1.1.1.1 = 2", "\"a\".\"b\".'c' = 1",
          "x = {a.b = {c.d = 1}}", "s = \"\\\"\" a.b.c = 1"}) {
        const auto plain = plainToml(text, "x");
        ASSERT_FALSE(plain) << text;
        EXPECT_EQ(plain.error().code, ErrorCode::kBadFormat);
        EXPECT_EQ(plain.error().subject, text[0] == '\n' ? "x:2" : "x:1");
        EXPECT_NE(plain.error().detail.find("too deep"), std::string::npos);
    }
}

TEST(PlainToml, RefusesWhatTheLibraryStumblesOver) {
    for (const char* text :
         {"s = \"\"\"\n", "s = '''\n", "s = \"\n\"", "s = 5\"\xC3\xBC", "s = \"\\",
          "t\xC3\xBCr = 1", "[t\xC3\xBCr]", "a = 1 \xC2\xA0", "a = \"\" \xC3\xA4", "a = \"\xFF\"",
          "a = \"\xC3\"", "a = \"\xC0\x80\""}) {
        EXPECT_FALSE(plainToml(text, "x")) << text;
    }
}

TEST(PlainToml, QuotesWhatWouldEndAString) {
    EXPECT_EQ(quotedToml("a \"b\" \\ \n\x7F \xC3\xA4"),
              "\"a \\\"b\\\" \\\\ \\u000A\\u007F \xC3\xA4\"");
}

}  // namespace
}  // namespace hedr
