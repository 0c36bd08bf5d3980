#include <QTest>

#include "tests/ui/window_user.h"
#include "ui/site/site_desk.h"
#include "ui/site/wall_layer.h"

namespace hedr {
namespace {

class WallsPage : public testing::Test {
  protected:
    WallsPage() {
        w.window.setPlan(test::samplePlan());
        w.window.desk().drawWalls();
        constexpr int kPatience_ms = 20'000;  // with sanitizers
        EXPECT_TRUE(
            QTest::qWaitFor([&] { return isWall(kOnAWall) && w.map().isSharp(); }, kPatience_ms));
    }
    QPoint onMap(Point<World> p) {
        const Point<View> at = w.map().view().viewFromWorld() * p;
        return {qRound(at.x), qRound(at.y)};
    }
    bool isWall(Point<World> p) { return w.colourAt(onMap(p)) == wallColour(dayTheme()); }
    void drag(Point<World> from, Point<World> to, Qt::MouseButton button = Qt::LeftButton) {
        QTest::mousePress(&w.map(), button, {}, onMap(from));
        const QPoint end = onMap(to);
        for (int i = 1; i <= 4; ++i) {
            const QPoint way = onMap(from) + (end - onMap(from)) * i / 4;
            // Qt Test's own move says nothing of a button that is not the left one.
            QMouseEvent move(QEvent::MouseMove, way, w.map().mapToGlobal(way), Qt::NoButton, button,
                             Qt::NoModifier);
            QCoreApplication::sendEvent(&w.map(), &move);
        }
        QTest::mouseRelease(&w.map(), button, {}, end);
    }
    const std::vector<WallStroke>& strokes() { return w.window.desk().site().floor().wall_strokes; }

    static constexpr Point<World> kOnAWall{40.0, 48.6};
    static constexpr Point<World> kFree{40.0, 9.8};
    WindowUser w;
};

TEST_F(WallsPage, ShowsTheWallsOfThePlanAndLeavesItsFreeSpaceReadable) {
    EXPECT_FALSE(isWall(kFree));
    EXPECT_NE(w.colourAt(onMap(kFree)), dayTheme().paper);
}

TEST_F(WallsPage, KeepsAWallThatWasDrawnOnDone) {
    w.button("50 cm")->click();
    drag({26.0, 25.0}, {30.0, 25.0});
    EXPECT_TRUE(isWall({28.0, 25.0}));
    w.button("Done")->click();
    ASSERT_EQ(strokes().size(), 1U);
    EXPECT_EQ(strokes()[0].pen, WallPen::kWall);
    EXPECT_DOUBLE_EQ(strokes()[0].width_m, 0.5);
    EXPECT_NEAR(strokes()[0].points.front().x, 26.0, 0.1);
    EXPECT_NEAR(strokes()[0].points.back().x, 30.0, 0.1);
    w.window.desk().undo();
    EXPECT_TRUE(strokes().empty());
}

TEST_F(WallsPage, MakesFreeSpaceWithTheEraser) {
    QTest::keyClick(&w.window, Qt::Key_E);
    QTest::keyClick(&w.window, Qt::Key_4);
    drag({39.0, 48.6}, {41.0, 48.6});
    EXPECT_FALSE(isWall(kOnAWall));
    w.button("Done")->click();
    ASSERT_EQ(strokes().size(), 1U);
    EXPECT_EQ(strokes()[0].pen, WallPen::kEraser);
    EXPECT_DOUBLE_EQ(strokes()[0].width_m, 1.0);
}

TEST_F(WallsPage, TakesOneStrokeAfterTheOtherBack) {
    w.button("1 m")->click();
    drag({26.0, 25.0}, {30.0, 25.0});
    drag({26.0, 15.0}, {30.0, 15.0});
    w.button("Undo")->click();
    EXPECT_TRUE(isWall({28.0, 25.0}));
    EXPECT_FALSE(isWall({28.5, 15.0}));
    w.button("Undo")->click();
    EXPECT_FALSE(isWall({28.5, 25.0}));
    EXPECT_FALSE(w.button("Undo")->isEnabled());
}

TEST_F(WallsPage, ForgetsWhatWasDrawnWhenCanceled) {
    drag({26.0, 25.0}, {30.0, 25.0});
    w.button("Cancel")->click();
    EXPECT_TRUE(strokes().empty());
    EXPECT_FALSE(isWall(kOnAWall));
}

TEST_F(WallsPage, LeavesTheMiddleButtonToTheMap) {
    const Point<World> before = w.map().view().centre;
    drag({26.0, 25.0}, {30.0, 25.0}, Qt::MiddleButton);
    EXPECT_NEAR(w.map().view().centre.x, before.x - 4.0, 0.3);
    EXPECT_FALSE(w.button("Undo")->isEnabled());
}

TEST(WallCells, LeaveOutWhatIsCutOff) {
    MapPlan plan{test::samplePlan()};
    const FreeSpace space{4, 1, 400.0, {Cell::kWall, Cell::kFree, Cell::kFree, Cell::kWall}};
    EXPECT_TRUE(wallCells(space, plan).any_walls);
    plan.crop = PlanCrop{{410.0, 0.0}, {1190.0, 980.0}};
    EXPECT_FALSE(wallCells(space, plan).any_walls);
}

}  // namespace
}  // namespace hedr
