#include "ui/map/follow.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

const ViewTransform kView{{0, 0}, 20.0, 0.0, 1600.0, 900.0};

TEST(Follow, LeavesTheMapAloneWhileTheRobotIsInTheMiddle) {
    EXPECT_EQ(followed(kView, {{3, -2}, 1.0}, {}), kView);
}

TEST(Follow, ShowsMoreOfTheWayAhead) {
    const Pose<World> east{{25, 0}, 0.0};
    const Pose<World> west{{25, 0}, kPi};
    const double x_going_east = (followed(kView, east, {}).viewFromWorld() * east.position).x;
    const double x_going_west = (followed(kView, west, {}).viewFromWorld() * west.position).x;
    EXPECT_LT(x_going_east, x_going_west - 100.0);
}

RC_GTEST_PROP(Follow, AlwaysShowsTheRobotAndThenStandsStill, ()) {
    const auto number = [](int n) { return *rc::gen::inRange(-n, n) / 10.0; };
    const Pose<World> robot{{number(9000), number(9000)}, number(60)};
    const ViewMargins margins{124.0, 40.0, 124.0, 84.0};
    const ViewTransform view = followed(kView, robot, margins);
    const Point<View> at = view.viewFromWorld() * robot.position;
    RC_ASSERT(at.x > margins.left_px && at.x < kView.width_px - margins.right_px);
    RC_ASSERT(at.y > margins.top_px && at.y < kView.height_px - margins.bottom_px);
    // Whole pixels: what is left is less than one.
    const Vector<View> rest = followed(view, robot, margins).viewFromWorld() * robot.position - at;
    RC_ASSERT(rest.length() < 1.5);
}

}  // namespace
}  // namespace hedr
