#include "core/fusion/lost_times.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

TEST(LostTimes, LastFromTheFirstLostPointToTheNextGoodOneOrTheEnd) {
    LostTimes lost;
    const bool points[] = {false, true, true, false, false, true, true};
    double t_s = 0.0;
    for (const bool point : points) lost.note(point, t_s++);
    ASSERT_EQ(lost.times().size(), 2u);
    EXPECT_EQ(lost.times()[0].from_s, 1.0);
    EXPECT_EQ(lost.times()[0].until_s, 3.0);
    EXPECT_EQ(lost.times()[1].from_s, 5.0);
    EXPECT_EQ(lost.times()[1].until_s, 6.0);
}

TEST(LostTimes, AreNoneWhereNothingIsLost) {
    LostTimes lost;
    for (double t_s = 0.0; t_s < 5.0; ++t_s) lost.note(false, t_s);
    EXPECT_TRUE(lost.times().empty());
}

}  // namespace
}  // namespace hedr
