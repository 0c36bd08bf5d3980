#include "ui/map/view_transform.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

double number(int low, int high) { return *rc::gen::inRange(1000 * low, 1000 * high) / 1000.0; }

ViewTransform anyView() {
    return {{number(-900, 900), number(-900, 900)},
            number(1, 400),
            number(-7, 7),
            number(100, 3000),
            number(100, 2000)};
}

void expectNear(Point<View> a, Point<View> b) { RC_ASSERT((a - b).length() < 1e-6); }

RC_GTEST_PROP(ViewTransform, ComesBackFromTheWorldToTheSamePixel, ()) {
    const ViewTransform view = anyView();
    const Point<View> p{number(-500, 3500), number(-500, 2500)};
    expectNear(view.viewFromWorld() * (view.worldFromView() * p), p);
}

RC_GTEST_PROP(ViewTransform, KeepsThePointUnderTheCursorWhenZooming, ()) {
    const ViewTransform view = anyView();
    const Point<View> cursor{number(0, 3000), number(0, 2000)};
    const ViewTransform zoomed = view.zoomed(cursor, number(1, 9) / 3.0);
    expectNear(zoomed.viewFromWorld() * (view.worldFromView() * cursor), cursor);
}

RC_GTEST_PROP(ViewTransform, MovesEveryPointByThePan, ()) {
    const ViewTransform view = anyView();
    const Vector<View> by{number(-800, 800), number(-800, 800)};
    const Point<World> p{number(-900, 900), number(-900, 900)};
    expectNear(view.panned(by).viewFromWorld() * p, view.viewFromWorld() * p + by);
}

RC_GTEST_PROP(ViewTransform, ShowsTheWholeBoxWithinTheMargins, ()) {
    const ViewMargins margins{60.0, 20.0, 10.0, 30.0};
    const WorldBox box =
        boxAround({{number(-90, 90), number(-90, 90)}, {number(-90, 90), number(-90, 90)}});
    const ViewTransform view = anyView().fitted(box, margins);
    for (const Point<World> corner : {box.min, box.max, Point<World>{box.min.x, box.max.y},
                                      Point<World>{box.max.x, box.min.y}}) {
        const Point<View> p = view.viewFromWorld() * corner;
        RC_ASSERT(p.x > margins.left_px - 1e-6 && p.x < view.width_px - margins.right_px + 1e-6);
        RC_ASSERT(p.y > margins.top_px - 1e-6 && p.y < view.height_px - margins.bottom_px + 1e-6);
    }
}

TEST(ViewTransform, ShowsPlusYUpwards) {
    const ViewTransform view{{0, 0}, 10.0, 0.0, 200.0, 100.0};
    EXPECT_EQ((view.viewFromWorld() * Point<World>{0, 0}), (Point<View>{100, 50}));
    EXPECT_EQ((view.viewFromWorld() * Point<World>{1, 2}), (Point<View>{110, 30}));
}

TEST(ViewTransform, TurnsTheWorldCounterClockwiseOnTheScreen) {
    const ViewTransform view{{0, 0}, 10.0, kPi / 2.0, 200.0, 100.0};
    const Point<View> p = view.viewFromWorld() * Point<World>{1, 0};
    EXPECT_NEAR(p.x, 100.0, 1e-9);
    EXPECT_NEAR(p.y, 40.0, 1e-9);
}

TEST(ViewTransform, StopsZoomingAtItsLimits) {
    const ViewTransform view{{0, 0}, 10.0, 0.0, 200.0, 100.0};
    EXPECT_EQ(view.zoomed({0, 0}, 1e9).pixels_per_metre, kMostPixelsPerMetre);
    EXPECT_EQ(view.zoomed({0, 0}, 1e-9).pixels_per_metre, kLeastPixelsPerMetre);
}

TEST(ViewTransform, KnowsTheUprightBoxAroundATurnedView) {
    const ViewTransform view{{5, 5}, 10.0, kPi / 2.0, 200.0, 100.0};
    const WorldBox area = view.visibleArea();
    EXPECT_NEAR(area.max.x - area.min.x, 10.0, 1e-9);
    EXPECT_NEAR(area.max.y - area.min.y, 20.0, 1e-9);
}

}  // namespace
}  // namespace hedr
