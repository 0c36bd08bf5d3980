#include "core/text/clean_text.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

TEST(CleanText, LeavesGoodTextAlone) {
    for (const char* text : {"", "bumper %s %n", "Stra\u00dfe 5 \u2192 \U0001F916"})
        EXPECT_EQ(cleanText(text), text);
}

TEST(CleanText, MakesOneLineOfControlCharacters) {
    EXPECT_EQ(cleanText(std::string("a\nb\x1b[2Jc\x7f\0d", 11)), "a b [2Jc  d");
    EXPECT_EQ(cleanText("a\u0085b\u2028c"), "a b c");
}

TEST(CleanText, ReplacesWhatIsNoUtf8AndWhatTurnsTheWriting) {
    EXPECT_EQ(cleanText("a\xff"
                        "b\xc0\xaf"),
              "a\uFFFDb\uFFFD\uFFFD");
    EXPECT_EQ(cleanText("cut \xe2\x82"), "cut \uFFFD\uFFFD");
    EXPECT_EQ(cleanText("exe\u202Egpj"), "exe\uFFFDgpj");
}

TEST(Utf8, IsToldFromOtherBytes) {
    EXPECT_TRUE(isUtf8("R\u00e4der\n\t\u202e"));
    EXPECT_TRUE(isUtf8(""));
    for (const char* wrong : {"R\xe4"
                              "der",
                              "\xed\xa0\x80", "\xc3"})
        EXPECT_FALSE(isUtf8(wrong));
}

TEST(CleanText, IsNeverLongerThanWantedAndNotCutWithinACharacter) {
    EXPECT_EQ(cleanText(std::string(10000, 'x')).size(), 200U);
    EXPECT_EQ(cleanText("\u20ac\u20ac", 5), "\u20ac");
}

}  // namespace
}  // namespace hedr
