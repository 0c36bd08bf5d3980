#include "core/calibration/squares/umbmark_text.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

TEST(UmbmarkText, ReadsLengthsInTheUnitThatFits) {
    EXPECT_EQ(readLength(0.0032), "3.2 mm");
    EXPECT_EQ(readLength(0.14), "14 cm");
    EXPECT_EQ(readLength(2.34), "2.3 m");
}

TEST(UmbmarkText, ListsRunsShortly) {
    EXPECT_EQ(runsText({3}), "run 3");
    EXPECT_EQ(runsText({3, 4}), "runs 3 and 4");
    EXPECT_EQ(runsText({1, 3, 5, 6, 7, 8}), "runs 1, 3 and 5 to 8");
    EXPECT_EQ(runsText({1, 2, 3}), "runs 1 to 3");
}

TEST(UmbmarkText, NamesARunAndWhyItDoesNotCount) {
    EXPECT_EQ(sentenceOf(LeftOutRun{3, "turned both ways"}), "Run 3 turned both ways.");
}

}  // namespace
}  // namespace hedr
