#include "ui/map/miniature.h"

#include <gtest/gtest.h>

#include "tests/ui/scene.h"

namespace hedr {
namespace {

TEST(Miniature, ShowsThePlansAndTheTrailsOfAFloor) {
    LiveTrail trail{"hedr", {}};
    for (const TrackPoint& point : test::drift(test::kDrive_s, 0.0)) trail.track.append(point);
    PlanImage aside = test::colouredPlan();
    aside.placement.origin.position = {30.0, -45.0};
    const QColor line(255, 0, 0);
    const MapScene scene{{{test::samplePlan()}, {aside}}, {{trail, QPen(line, 2.0)}}, dayTheme()};
    const QImage picture = miniatureOf(scene, {72, 48}, 1.0);
    int paper = 0;
    int red = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const QColor at = picture.pixelColor(x, y);
            paper += at.lightness() > 250 ? 1 : 0;
            red += at.red() > 200 && at.green() < 120 ? 1 : 0;
        }
    }
    EXPECT_GT(paper, 200);
    EXPECT_GT(red, 30);
}

}  // namespace
}  // namespace hedr
