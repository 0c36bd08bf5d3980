#include "ui/site/align_page.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "tests/ui/window_user.h"
#include "ui/site/distance_panel.h"
#include "ui/site/points_panel.h"
#include "ui/site/site_desk.h"

namespace hedr {
namespace {

class AlignPage : public testing::Test {
  protected:
    AlignPage() {
        w.window.setPlan(test::samplePlan());
        w.window.desk().alignTopmost();
        QTest::qWait(0);
    }
    void click(Point<World> at) {
        const Point<View> p = w.map().view().viewFromWorld() * at;
        QTest::mouseClick(&w.map(), Qt::LeftButton, {}, {qRound(p.x), qRound(p.y)});
    }
    const PlanPlacement& placement() {
        return w.window.desk().site().floor().plans.front().placement;
    }
    WindowUser w;
};

TEST_F(AlignPage, MovesThePlanToItsFirstPointAndBackOnUndo) {
    const PlanPlacement before = placement();
    click({40.0, 20.0});
    click({45.0, 20.0});
    EXPECT_NEAR(placement().origin.position.x, before.origin.position.x + 5.0, 0.2);
    w.button("Undo")->click();
    EXPECT_EQ(placement(), before);
}

TEST_F(AlignPage, FindsItsPointsAgainToMendThem) {
    const auto placed_by = [this] {
        return w.window.desk().site().floor().plans.front().placed_by;
    };
    for (const Point<World> at :
         {Point<World>{20.0, 10.0}, {20.5, 10.0}, {60.0, 30.0}, {61.0, 30.0}}) {
        click(at);
    }
    w.button("Done")->click();
    ASSERT_EQ(placed_by().points.size(), 2u);
    const PlanPlacement before = placement();
    w.window.desk().alignTopmost();
    QTest::qWait(0);
    click({40.0, 20.0});
    click({40.0, 21.0});
    EXPECT_NE(placement(), before);
    w.button("Done")->click();
    EXPECT_EQ(placed_by().points.size(), 3u);
}

TEST_F(AlignPage, ForgetsPointsThatNoLongerSayWhereThePlanLies) {
    for (const Point<World> at :
         {Point<World>{20.0, 10.0}, {20.5, 10.0}, {60.0, 30.0}, {61.0, 30.0}}) {
        click(at);
    }
    w.button("Move")->click();
    w.map().setFocus();
    QTest::keyClick(&w.map(), Qt::Key_Right);
    w.button("Done")->click();
    EXPECT_TRUE(w.window.desk().site().floor().plans.front().placed_by.points.empty());
}

TEST(PlanThatSaysNoPlace, IsSaidToLieByGuessUntilItIsAligned) {
    WindowUser w;
    PlanImage plan = test::samplePlan();
    plan.placement_is_guess = true;
    w.window.setPlan(plan);
    EXPECT_TRUE(w.banner().contains("a guess until you align it")) << w.banner().toStdString();
    const SiteModel& site = w.window.desk().site();
    EXPECT_TRUE(site.liesByGuess(site.floor().plans.front()));
    w.window.desk().alignTopmost();
    w.button("Move")->click();
    w.map().setFocus();
    QTest::keyClick(&w.map(), Qt::Key_Right);
    w.button("Done")->click();
    EXPECT_FALSE(site.liesByGuess(site.floor().plans.front()));
}

TEST_F(AlignPage, NudgesThePlanWithTheArrowKeys) {
    const PlanPlacement before = placement();
    const Point<World> centre = w.map().view().centre;
    QTest::mouseClick(w.button("Move"), Qt::LeftButton);
    EXPECT_TRUE(w.map().hasFocus()) << "a click leaves the keys with the map";
    QTest::keyClick(&w.map(), Qt::Key_Right);
    QTest::keyClick(&w.map(), Qt::Key_Up);
    const double pixel_m = 1.0 / w.map().view().pixels_per_metre;
    EXPECT_NEAR(placement().origin.position.x, before.origin.position.x + pixel_m, 1e-9);
    EXPECT_NEAR(placement().origin.position.y, before.origin.position.y + pixel_m, 1e-9);
    EXPECT_EQ(w.map().view().centre, centre);
    w.button("Points")->click();
    w.map().setFocus();
    QTest::keyClick(&w.map(), Qt::Key_Right);
    EXPECT_NE(w.map().view().centre, centre);
}

TEST_F(AlignPage, ScalesThePlanByAKnownDistance) {
    w.button("Distance")->click();
    click({30.0, 20.0});
    click({50.0, 20.0});
    auto* field = w.window.findChild<DistancePanel*>()->findChild<QLineEdit*>();
    QTest::keyClicks(field, "40 m");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_NEAR(placement().resolution_m, 0.1, 0.001);
}

TEST_F(AlignPage, LeavesThePlanAsItWasWhenCanceled) {
    const PlanPlacement before = placement();
    click({40.0, 20.0});
    click({45.0, 22.0});
    w.button("Cancel")->click();
    EXPECT_EQ(placement(), before);
    EXPECT_FALSE(w.window.desk().open());
}

// Disconnect comes up where Done was.
TEST_F(AlignPage, DoesNotDisconnectOnAClickTooManyOnDone) {
    w.live(0.0);
    w.live(1.0);
    QSignalSpy disconnected(&w.window, &MainWindow::disconnectRequested);
    QTest::mouseClick(w.button("Done"), Qt::LeftButton);
    ASSERT_TRUE(soon([&] { return w.button("Disconnect") != nullptr; }));
    QTest::mouseClick(w.button("Disconnect"), Qt::LeftButton);
    EXPECT_TRUE(disconnected.isEmpty());
    QTest::qWait(1100);
    QTest::mouseClick(w.button("Disconnect"), Qt::LeftButton);
    EXPECT_EQ(disconnected.size(), 1);
}

TEST_F(AlignPage, EndsWithEscapeWhereverTheKeysAre) {
    w.button("Distance")->click();
    click({30.0, 20.0});
    click({50.0, 20.0});
    auto* field = w.window.findChild<DistancePanel*>()->findChild<QLineEdit*>();
    ASSERT_TRUE(field->hasFocus());
    QTest::keyClick(field, Qt::Key_Escape);
    EXPECT_FALSE(w.window.desk().open());
}

TEST_F(AlignPage, IsOneStepOfTheSiteOnceItIsDone) {
    const PlanPlacement before = placement();
    click({40.0, 20.0});
    click({45.0, 22.0});
    w.button("Done")->click();
    EXPECT_NE(placement(), before);
    w.window.desk().undo();
    EXPECT_EQ(placement(), before);
}

TEST_F(AlignPage, KeepsTheAlignmentWhenAnotherPlanComesMeanwhile) {
    click({40.0, 20.0});
    click({45.0, 22.0});
    const PlanPlacement aligned = placement();
    w.window.setPlan(test::colouredPlan());
    w.button("Done")->click();
    EXPECT_EQ(placement(), aligned);
}

class AlignByPoints : public AlignPage {
  protected:
    void type(const QString& text) {
        auto* field = w.window.findChild<PointsPanel*>()->findChild<QLineEdit*>();
        ASSERT_TRUE(field->isVisible());
        field->clear();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }
    QString text() {
        QString all;
        for (auto* label : w.window.findChild<PointsPanel*>()->findChildren<QLabel*>())
            all += label->text() + '\n';
        return all;
    }
    QString file(const QByteArray& text) {
        QFile file(folder.filePath("POINTS.csv"));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
        return file.fileName();
    }
    void take(const QString& points) {
        w.window.findChild<hedr::AlignPage*>()->takePointsOf(points);
    }
    QTemporaryDir folder;
};

TEST_F(AlignByPoints, TakesMetresThatAreTyped) {
    const PlanPlacement before = placement();
    click({40.0, 20.0});
    type("45.0, 20.0");
    EXPECT_NEAR(placement().origin.position.x, before.origin.position.x + 5.0, 0.2);
}

TEST_F(AlignByPoints, TakesPlacesOnTheGlobeOnceTheMapIsTied) {
    const PlanPlacement before = placement();
    click({40.0, 20.0});
    type("52.2197 N, 21.0122 E");
    EXPECT_TRUE(text().contains("not tied")) << text().toStdString();
    EXPECT_EQ(placement(), before);
    w.button("Cancel")->click();
    Site tied = w.window.desk().site().site();
    tied.geo_tie = GeoTie{{43.0, 20.0}, {52.2197, 21.0122}, 0.0};
    w.window.desk().site().edit(tied);
    w.window.desk().alignTopmost();
    click({40.0, 20.0});
    type("52.2197 N, 21.0122 E");
    EXPECT_NEAR(placement().origin.position.x, before.origin.position.x + 3.0, 0.2);
}

TEST_F(AlignByPoints, TakesTheirFile) {
    take(file("plan_x_px,plan_y_px,world_x_m,world_y_m\n0,0,0,0\n100,0,10,0\n0,100,0,-10\n"));
    EXPECT_NEAR(placement().resolution_m, 0.1, 1e-9);
    EXPECT_TRUE(text().contains("rms")) << text().toStdString();
    w.button("Undo")->click();
    EXPECT_NE(placement().resolution_m, 0.1);
}

TEST_F(AlignByPoints, SaysWhatIsWrongWithAFile) {
    const PlanPlacement before = placement();
    take(file("plan_x_px,plan_y_px,latitude_deg,longitude_deg\n0,0,52,21\n100,0,52,21.001\n"));
    EXPECT_TRUE(text().contains("not tied")) << text().toStdString();
    click({40.0, 20.0});
    type("garbage");
    EXPECT_TRUE(text().contains("must be metres")) << text().toStdString();
    w.button("Undo")->click();
    take(file("nothing of use"));
    EXPECT_TRUE(text().contains("POINTS.csv")) << text().toStdString();
    take(folder.filePath("none.csv"));
    EXPECT_TRUE(text().contains("none.csv")) << text().toStdString();
    EXPECT_EQ(placement(), before);
}

TEST(LengthFromText, TakesTheUnitsOfDrawings) {
    EXPECT_DOUBLE_EQ(*lengthFromText("12,5"), 12.5);
    EXPECT_DOUBLE_EQ(*lengthFromText("250 cm"), 2.5);
    EXPECT_DOUBLE_EQ(*lengthFromText("10 ft"), 3.048);
    for (const char* text : {"", "-3", "0", "nan", "inf", "m", "1e9"}) {
        EXPECT_FALSE(lengthFromText(text)) << text;
    }
}

}  // namespace
}  // namespace hedr
