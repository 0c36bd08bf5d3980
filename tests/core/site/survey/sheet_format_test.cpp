#include "core/site/survey/sheet_format.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numbers>

namespace hedr {
namespace {

TEST(LikelyFormats, PutsTheNearestFirstAndKeepsHowTheSheetLies) {
    const auto across = likelyFormats({1.405, 0.01});
    ASSERT_FALSE(across.empty());
    EXPECT_EQ(across.front().aspect, std::numbers::sqrt2);
    EXPECT_GT(across.front().probability, 0.7);
    const auto upright = likelyFormats({1.0 / 1.405, 0.01});
    ASSERT_FALSE(upright.empty());
    EXPECT_EQ(upright.front().aspect, 1.0 / std::numbers::sqrt2);
    EXPECT_NEAR(upright.front().probability, across.front().probability, 1e-9);
}

TEST(LikelyFormats, ProposesSeveralWhereTheShapeIsVague) {
    const auto vague = likelyFormats({1.38, 0.06});
    ASSERT_GE(vague.size(), 3U);
    EXPECT_EQ(vague.front().aspect, std::numbers::sqrt2);
    EXPECT_LT(vague.front().probability, 0.5);
    double sum = 0.0;
    for (const LikelySheetFormat& each : vague) sum += each.probability;
    EXPECT_LT(sum, 1.0);
    EXPECT_TRUE(std::ranges::is_sorted(vague, std::greater{}, &LikelySheetFormat::probability));
}

TEST(LikelyFormats, HasNoneForAShapeThatIsNone) {
    EXPECT_TRUE(likelyFormats({1.65, 0.005}).empty());
    EXPECT_TRUE(likelyFormats({4.0, 0.05}).empty());
}

}  // namespace
}  // namespace hedr
