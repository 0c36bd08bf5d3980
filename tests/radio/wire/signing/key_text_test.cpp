#include "radio/wire/signing/key_text.h"

#include <gtest/gtest.h>

#include "tests/radio/wire/signing/signing_fixture.h"

namespace hedr {
namespace {

const std::string kHex = "0102030405060708090a0b0c0d0e0f10";

std::string complaintOf(const std::string& text) {
    const auto key = parseKey(text, "a.key");
    if (key) return {};
    EXPECT_EQ(key.error().code, ErrorCode::kBadFormat);
    return key.error().subject + ": " + key.error().detail;
}

TEST(KeyText, IsReadBack) {
    const RobotKey key{"Packbot 7 ä", test::kAtlasKey};
    EXPECT_EQ(parseKey(keyText(key), "a.key").value(), key);
    EXPECT_EQ(hexOf(key.key), kHex);
    const KeyCounters counters{17, 4294967295};
    EXPECT_EQ(parseCounters(countersText(counters), "a.counters").value(), counters);
}

TEST(KeyText, ToleratesBlanksAndWindows) {
    const std::string text = "\r\n  name=\"a\"\r\nkey  =\"" + kHex + "\"";
    EXPECT_EQ(parseKey(text, "a.key").value(), (RobotKey{"a", test::kAtlasKey}));
}

TEST(KeyText, SaysWhatIsWrongWithAKeyFile) {
    const std::string name = "name = \"atlas\"\n";
    const std::string key = "key = \"" + kHex + "\"\n";
    EXPECT_EQ(complaintOf(name + key), "");
    EXPECT_EQ(complaintOf(""), "a.key: \"name\" is missing");
    EXPECT_EQ(complaintOf(name), "a.key: \"key\" is missing");
    EXPECT_EQ(complaintOf(name + key + key), "a.key:3: \"key\" is there twice");
    EXPECT_EQ(complaintOf(name + "keys = 3\n"), "a.key:2: there is a name that is not known");
    EXPECT_EQ(complaintOf(name + "key\n"), "a.key:2: a line must be NAME = VALUE");
    EXPECT_EQ(complaintOf(name + "key = 12\n"), "a.key: \"key\" must stand in quotes");
    for (const std::string bad :
         {"", "01", "0102030405060708090a0b0c0d0e0f1", "0x02030405060708090a0b0c0d0e0f10",
          "0102030405060708090a0b0c0d0e0f1g", "+102030405060708090a0b0c0d0e0f10"}) {
        EXPECT_EQ(complaintOf(name + "key = \"" + bad + "\"\n"),
                  "a.key: \"key\" must be 32 hexadecimal digits")
            << bad;
    }
    EXPECT_EQ(complaintOf("name = \"../a\"\n" + key),
              "a.key: the robot's name must not begin with . or -");
}

TEST(KeyText, NeverPrintsWhatIsInTheFile) {
    EXPECT_EQ(complaintOf(kHex + " = 3\n").find("0102"), std::string::npos);
    EXPECT_EQ(complaintOf("name = \"a\"\nkey = \"" + kHex + "00\"\n").find("0102"),
              std::string::npos);
}

TEST(KeyText, RefusesNamesThatAreNoFileNames) {
    for (const std::string bad : {"", ".", "..", "-x", "a/b", "a\"b", "a\\b", "a\nb", " a", "a "}) {
        EXPECT_FALSE(checkRobotName(bad)) << bad;
    }
    EXPECT_FALSE(checkRobotName(std::string(64, 'a')));
    EXPECT_TRUE(checkRobotName(std::string(63, 'a')));
}

TEST(KeyText, RefusesCountersThatAreNone) {
    for (const char* bad :
         {"said = 1\n", "said = 1\nheard = -1\n", "said = 4294967296\nheard = 1\n",
          "said = 1\nheard = 1x\n", "said = \nheard = 1\n"}) {
        EXPECT_FALSE(parseCounters(bad, "a.counters")) << bad;
    }
}

TEST(KeyText, GivesAHeaderForTheFirmware) {
    const std::string header = cHeaderOf({"atlas", test::kAtlasKey});
    EXPECT_NE(header.find("#define HEDR_KEY {0x01, 0x02, "), std::string::npos) << header;
    EXPECT_NE(header.find(", 0x10}\n"), std::string::npos) << header;
}

}  // namespace
}  // namespace hedr
