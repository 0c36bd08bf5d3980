#include "radio/wire/text_line/text_line_decoder.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "radio/wire/text_line/plain_text.h"
#include "tests/radio/wire/text_line/text_robot.h"

namespace hedr {
namespace {

using Lines = std::vector<std::string>;  // "!" stands for a bad one

Lines linesOf(std::string_view text) {
    Lines lines;
    TextLineDecoder decoder;
    decoder.feed(test::bytesOf(text), [&](std::optional<std::string_view> line) {
        lines.emplace_back(line.value_or("!"));
    });
    return lines;
}

TEST(TextLineDecoder, TakesEveryEndOfALine) {
    EXPECT_EQ(linesOf("a\nb\rc\r\nd\n\re\n\n\nf"), (Lines{"a", "b", "c", "d", "e"}));
}

TEST(TextLineDecoder, CountsALineThatIsTooLongOnce) {
    const std::string longest(TextLineDecoder::kLongestLine, 'x');
    EXPECT_EQ(linesOf(longest + "\n" + longest + "y\n" + std::string(100000, 'z') + "\na\n"),
              (Lines{longest, "!", "!", "a"}));
}

TEST(TextLineDecoder, RefusesControlBytesExceptTabs) {
    for (int byte = 1; byte < 256; ++byte) {
        const std::string line = std::string("a") + static_cast<char>(byte) + "b";
        if (byte == '\n' || byte == '\r') continue;
        const bool bad = (byte < 0x20 && byte != '\t') || byte == 0x7F;
        EXPECT_EQ(linesOf(line + "\n"), Lines{bad ? "!" : line}) << byte;
    }
    EXPECT_EQ(linesOf(std::string("a\0b\nc\n", 6)), (Lines{"!", "c"}));
}

struct Words {
    const char* printed;
    std::optional<std::string> shown;
};

class PlainText : public testing::TestWithParam<Words> {};

TEST_P(PlainText, ShowsWhatMayBeShown) {
    EXPECT_EQ(plainText(GetParam().printed, 12), GetParam().shown);
}

INSTANTIATE_TEST_SUITE_P(
    Words, PlainText,
    testing::Values(Words{"ready", "ready"}, Words{"a\tb\x1B[31mc", "a b[31mc"},
                    Words{"gr\u00FCn \U0001F916", "gr\u00FCn \U0001F916"},
                    Words{"abcdefghijk\u00FC", "abcdefghijk"},  // cut between letters
                    Words{"abcdefghij\u00FCk", "abcdefghij\u00FC"},
                    Words{"a\u202Eb\u200Fc\uFEFF\u0085", "abc"},  // turns, hides
                    Words{"\xFF", std::nullopt}, Words{"a\x80", std::nullopt},
                    Words{"\xC0\xAF", std::nullopt},      // overlong
                    Words{"\xED\xA0\x80", std::nullopt},  // surrogate
                    Words{"\xF4\x90\x80\x80", std::nullopt}, Words{"\xE2\x82", std::nullopt}));

}  // namespace
}  // namespace hedr
