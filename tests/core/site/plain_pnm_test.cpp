#include "core/site/plain_pnm.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>

namespace hedr {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes parsed(std::string_view text) {
    const auto level = parsePlainPnm(text, "map.pgm");
    return level ? *level->pixels : Bytes{};
}

TEST(PlainPnm, ReadsGreyWithCommentsAndItsOwnWhite) {
    EXPECT_EQ(parsed("P2\n# map\n3 1\n255\n0 128\n# more\n255\n"), (Bytes{0, 128, 255}));
    EXPECT_EQ(parsed("P2 3 1 15 0 5 15"), (Bytes{0, 85, 255}));
    EXPECT_EQ(parsed("P2 2 1 65535 32768 65535"), (Bytes{128, 255}));
}

TEST(PlainPnm, ReadsColourAsBlueGreenRed) {
    EXPECT_EQ(parsed("P3 1 1 255 10 20 30"), (Bytes{30, 20, 10, 255}));
}

TEST(PlainPnm, ReadsBitsOfWhichOneIsBlack) {
    EXPECT_EQ(parsed("P1 3 2 0 1 0\n101"), (Bytes{255, 0, 255, 0, 255, 0}));
    EXPECT_EQ(parsed(std::string("P4 9 1 ") + '\x80' + '\x80'),
              (Bytes{0, 255, 255, 255, 255, 255, 255, 255, 0}));
}

TEST(PlainPnm, TakesAValueAboveWhiteAsWhite) { EXPECT_EQ(parsed("P2 1 1 7 9"), Bytes{255}); }

TEST(PlainPnm, RefusesDamage) {
    for (const char* bad :
         {"P2", "P2 3", "P2 0 1 255", "P2 -3 1 255 0", "P2 1 1 0 0", "P2 2 1 255 0",
          "P2 2 1 255 0 x", "P4 9 1 a", "P2 1 1 99999 0", "P3 1 1 255 1 2"}) {
        const auto result = parsePlainPnm(bad, "map.pgm");
        ASSERT_FALSE(result) << bad;
        EXPECT_EQ(result.error().code, ErrorCode::kNotAnImage) << bad;
        EXPECT_EQ(result.error().subject, "map.pgm");
    }
}

TEST(PlainPnm, RefusesAHeaderThatAsksForGigabytes) {
    EXPECT_EQ(parsePlainPnm("P2 99999 99999 255 0", "m").error().code, ErrorCode::kImageTooLarge);
    EXPECT_EQ(parsePlainPnm("P2 20000 20000 255 0", "m").error().code, ErrorCode::kNotAnImage);
}

RC_GTEST_PROP(PlainPnm, NeverCrashesWhateverFollowsItsHeader, (const std::string& noise)) {
    for (const char* head : {"P1 ", "P2 ", "P3 2 2 9 ", "P4 3 3 ", "P2 3 3 255 "}) {
        const auto level = parsePlainPnm(head + noise, "m");
        if (level) {
            RC_ASSERT(level->pixels->size() ==
                      static_cast<std::size_t>(level->width_px) *
                          static_cast<std::size_t>(level->height_px * level->channels));
        }
    }
}

}  // namespace
}  // namespace hedr
