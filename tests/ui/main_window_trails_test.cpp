// The trails in the window: which are shown, which one carries the robot, what the map makes of
// them.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QSignalSpy>
#include <QTest>

#include "tests/ui/scene.h"
#include "tests/ui/window_user.h"
#include "ui/main_window.h"
#include "ui/map/map_view.h"

namespace hedr {
namespace {

TEST(MainWindow, HidesATrailByItsLegend) {
    WindowUser w;
    w.live(150.0);
    ASSERT_TRUE(soon([&] { return w.button("Odometry") != nullptr; }));
    const QColor orange = dayTheme().odometry;
    EXPECT_TRUE(soon([&] { return w.map().isSharp(); }));
    EXPECT_GT(w.pixels(orange), 20);
    w.button("Odometry")->click();
    EXPECT_TRUE(soon([&] { return w.map().isSharp(); }));
    EXPECT_EQ(w.pixels(orange), 0);
}

// The middle of a drive: odometry has left the building by metres.
TEST(MainWindow, MakesAnotherTrailThePrimaryOneWithAllThatItHasDrawn) {
    WindowUser w;
    w.window.setPlan(test::samplePlan());
    w.live(0.0);
    w.live(150.0);
    ASSERT_TRUE(soon([&] { return w.button("Odometry carries the robot") != nullptr; }));
    ASSERT_TRUE(soon([&] { return w.map().isSharp(); }));
    const Theme day = dayTheme();
    const QString home = w.tile("HOME");
    const int accent = w.pixels(day.accent);
    EXPECT_EQ(w.pixels(day.hedr_bayes), 0);
    EXPECT_TRUE(w.tile("TRUST").startsWith("GOOD"));
    const QPoint before = w.robotAt(test::sampleBatch(150.0), "hedr_bayes");
    const QPoint after = w.robotAt(test::sampleBatch(150.0), "odometry");
    ASSERT_GT((before - after).manhattanLength(), 60);

    QSignalSpy spy(&w.window, &MainWindow::trailChoiceChanged);
    w.button("Odometry carries the robot")->click();
    EXPECT_EQ(spy.count(), 1);
    EXPECT_TRUE(w.tile("TRUST").startsWith("OFF, no heading check"));
    EXPECT_NE(w.tile("HOME"), home);
    ASSERT_TRUE(soon([&] { return w.map().isSharp(); }));
    EXPECT_EQ(w.pixels(day.odometry), 0) << "all of it is in the accent now";
    EXPECT_GT(w.pixels(day.accent), accent / 2);
    EXPECT_GT(w.pixels(day.hedr_bayes), 200) << "the old one is still there, all of it";
    EXPECT_EQ(w.colourAt(after), day.accent);
    EXPECT_NE(w.colourAt(before), day.accent);
    w.live(150.5);
    EXPECT_TRUE(w.tile("TRUST").startsWith("OFF"));

    w.map().setFocus();
    for (const char* trust : {"GOOD", "GOOD", "OFF"}) {  // hedr_bayes, robot, odometry
        QTest::keyClick(&w.map(), Qt::Key_T);
        EXPECT_TRUE(w.tile("TRUST").startsWith(trust)) << w.tile("TRUST").toStdString();
    }
}

TEST(MainWindow, ShowsTheSameMapWhetherATrailWasPrimaryFromTheStartOrLater) {
    QImage pictures[2];
    for (const bool from_the_start : {true, false}) {
        WindowUser w;
        w.window.setPlan(test::samplePlan());
        if (from_the_start) w.window.setTrailChoice({.primary = "odometry"});
        w.live(0.0);
        w.live(150.0);
        if (!from_the_start) w.window.setTrailChoice({.primary = "odometry"});
        ASSERT_TRUE(soon([&] { return w.map().isSharp(); }));
        pictures[from_the_start] = w.mapPicture();
    }
    EXPECT_EQ(pictures[0], pictures[1]);
}

TEST(MainWindow, FollowsTheTrailThatIsPrimary) {
    WindowUser w;
    w.live(1.0);
    LiveBatch batch = test::sampleBatch(1.1, 1.0);
    batch.tracks = {{"odometry", {{1.1, {{500.0, 500.0}, 0.0}, 0.0}}}};
    w.window.applyBatch(batch);
    const auto inSight = [&] {
        const Point<View> at = w.map().view().viewFromWorld() * Point<World>{500.0, 500.0};
        return w.map().rect().contains(QPoint(qRound(at.x), qRound(at.y)));
    };
    EXPECT_FALSE(inSight());
    w.window.setTrailChoice({.primary = "odometry"});
    EXPECT_TRUE(inSight());
}

// Plain odometry after a long drive: it may be anywhere.
TEST(MainWindow, ShowsTheSameMapHoweverUncertainThePositionIs) {
    QImage pictures[2];
    ViewTransform views[2];
    for (const bool uncertain : {true, false}) {
        WindowUser w;
        w.window.setPlan(test::samplePlan());
        w.window.setTrailChoice({.primary = "odometry"});
        LiveBatch batch = test::sampleBatch(150.0);
        if (uncertain) batch.tracks[0].points.back().variance = {1200.0F, 0.0F, 1200.0F, 0.7F};
        w.hand.set(150.0);
        w.window.applyBatch(batch);
        EXPECT_EQ(w.tile("TRUST").contains("heading unknown"), uncertain);
        w.button("Fit")->click();
        ASSERT_TRUE(soon([&] { return w.map().isSharp(); }));
        pictures[uncertain] = w.mapPicture();
        views[uncertain] = w.map().view();
    }
    EXPECT_EQ(views[0], views[1]);
    EXPECT_EQ(pictures[0], pictures[1]) << "no ellipse hides the plan";
}

}  // namespace
}  // namespace hedr
