#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <QWheelEvent>

#include "core/calibration/procedures.h"
#include "tests/ui/window_user.h"
#include "ui/calibration/calibration_desk.h"
#include "ui/calibration/calibration_page.h"
#include "ui/calibration/ends_card.h"
#include "ui/site/site_desk.h"

namespace hedr {
namespace {

// A robot that is heard with its sensors.
void hear(WindowUser& w, double second) {
    w.hand.set(second);
    LiveBatch batch = test::sampleBatch(second, -1.0);
    batch.vehicle = Vehicle{};
    w.window.applyBatch(batch);
}

void openSquares(WindowUser& w) {
    QTest::keyClick(&w.map(), Qt::Key_K);
    w.window.chooseCalibration(CalibrationPast{});
    for (const Procedure& procedure : procedures()) {
        if (procedure.name == "umbmark") break;
        QTest::keyClick(w.window.focusWidget(), Qt::Key_Down);
    }
    QTest::keyClick(w.window.focusWidget(), Qt::Key_Return);
}

// An operator with ten squares driven, and a plan instead of a tape.
class EndsOnTheMap : public testing::Test {
  protected:
    EndsOnTheMap() {
        w.window.setPlan(test::samplePlan());
        hear(w, 1.0);
        w.window.fitMap();
    }

    void goToTheMap() {
        openSquares(w);
        ASSERT_TRUE(w.button("Click on the map"));
        w.button("Click on the map")->click();
        ASSERT_TRUE(w.window.desk().open());
        ASSERT_FALSE(page()->isVisible());
    }
    CalibrationPage* page() const { return w.window.findChild<CalibrationPage*>(); }
    QPoint at(Point<World> place) const {
        const Point<View> view = w.map().view().viewFromWorld() * place;
        return {qRound(view.x), qRound(view.y)};
    }
    void click(Point<World> place) { QTest::mouseClick(&w.map(), Qt::LeftButton, {}, at(place)); }
    // Start at the middle of the view, the first side 4 m to the right.
    Point<World> start() const { return w.map().view().centre; }
    Point<World> fromStart(double x_m, double y_m) const {
        return start() + Vector<World>{x_m, y_m};
    }
    QStringList fields() const {
        QStringList texts;
        for (const auto* field : page()->findChildren<QLineEdit*>()) {
            if (field->isVisible()) texts << field->text();
        }
        return texts;
    }
    QString card() const {
        QString all;
        for (const auto* label : w.window.findChild<EndsCard*>()->findChildren<QLabel*>()) {
            if (label->isVisible()) all += label->text() + '\n';
        }
        return all;
    }
    double pixel_m() const { return 1.0 / w.map().view().pixels_per_metre; }

    WindowUser w;
};

TEST_F(EndsOnTheMap, AreTakenIntoTheFieldsOfTheirRuns) {
    goToTheMap();
    click(start());
    click(fromStart(4.0, 0.0));
    click(fromStart(1.0, 0.5));
    w.button("Skip run 2")->click();
    click(fromStart(-0.5, 0.0));
    w.button("Done")->click();
    EXPECT_FALSE(w.window.desk().open());
    ASSERT_TRUE(page()->isVisible());
    const QStringList texts = fields();  // the floor, runs 1 to 4
    ASSERT_EQ(texts.size(), 5) << texts.join('|').toStdString();
    const QStringList first = texts[1].split(' ');
    EXPECT_NEAR(first[0].toDouble(), 1.0, 2.0 * pixel_m());
    EXPECT_NEAR(first[1].toDouble(), 0.5, 2.0 * pixel_m());
    EXPECT_EQ(texts[2], "");
    EXPECT_NEAR(texts[3].split(' ')[0].toDouble(), -0.5, 2.0 * pixel_m());
}

TEST_F(EndsOnTheMap, AreThereWhenOneComesBackAndGoAwayByUndo) {
    goToTheMap();
    click(start());
    click(fromStart(4.0, 0.0));
    click(fromStart(1.0, 0.5));
    w.button("Done")->click();
    w.button("Click on the map")->click();
    EXPECT_TRUE(w.button("Skip run 2")) << card().toStdString();
    click(fromStart(1.0, 0.5));
    EXPECT_TRUE(w.button("Skip run 3")) << "one end beside the other";
    QTest::keyClick(&w.map(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(w.button("Skip run 2"));
    QTest::keyClick(&w.map(), Qt::Key_Z, Qt::ControlModifier);
    w.button("Done")->click();
    EXPECT_EQ(fields().join(""), "") << "that of the first visit was taken back too";
}

TEST_F(EndsOnTheMap, AreLeftAsTheyWereByEscape) {
    goToTheMap();
    click(start());
    click(fromStart(4.0, 0.0));
    click(fromStart(1.0, 0.5));
    QTest::keyClick(&w.map(), Qt::Key_Escape);
    ASSERT_TRUE(page()->isVisible());
    EXPECT_EQ(fields().join(""), "");
    EXPECT_TRUE(page()->isAncestorOf(w.window.focusWidget()) || page()->hasFocus())
        << "the keys are the page's again";
}

TEST_F(EndsOnTheMap, AreMovedByDraggingTheirMarks) {
    goToTheMap();
    click(start());
    click(fromStart(4.0, 0.0));
    click(fromStart(1.0, 0.5));
    QTest::mousePress(&w.map(), Qt::LeftButton, {}, at(fromStart(1.0, 0.5)));
    QTest::mouseMove(&w.map(), at(fromStart(2.0, -0.5)));
    QTest::mouseRelease(&w.map(), Qt::LeftButton, {}, at(fromStart(2.0, -0.5)));
    w.button("Done")->click();
    const QStringList first = fields()[1].split(' ');
    EXPECT_NEAR(first[0].toDouble(), 2.0, 2.0 * pixel_m());
    EXPECT_NEAR(first[1].toDouble(), -0.5, 2.0 * pixel_m());
}

TEST_F(EndsOnTheMap, SayWhatIsTooNearToTellADirection) {
    goToTheMap();
    click(start());
    click(fromStart(0.5, 0.0));
    EXPECT_TRUE(card().contains("less than a metre from the start")) << card().toStdString();
    click(fromStart(2.0, 0.0));
    EXPECT_FALSE(card().contains("less than a metre"));
}

TEST_F(EndsOnTheMap, HaveRoomForTheirWords) {
    const auto fits = [&] {
        for (const auto* label : w.window.findChild<EndsCard*>()->findChildren<QLabel*>()) {
            if (!label->isVisible()) continue;
            const QSize needed = label->wordWrap() ? QSize(0, label->heightForWidth(label->width()))
                                                   : label->sizeHint();
            EXPECT_EQ(label->size().expandedTo(needed), label->size())
                << label->text().toStdString();
        }
    };
    goToTheMap();
    fits();
    click(start());
    fits();
    click(fromStart(4.0, 0.0));
    for (int run = 1; run <= 10; ++run) click(fromStart(0.1 * run, -12.3));
    fits();
}

TEST_F(EndsOnTheMap, SayWhatAPixelIsWhereItIsTooCoarse) {
    goToTheMap();
    QTest::mouseMove(&w.map(), at(start()));
    EXPECT_TRUE(card().contains("Zoom in before you click")) << card().toStdString();
    while (pixel_m() > 0.009) {
        QWheelEvent turn(at(start()), w.map().mapToGlobal(at(start())), {}, {0, 120}, Qt::NoButton,
                         Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&w.map(), &turn);
    }
    EXPECT_FALSE(card().contains("Zoom in before you click")) << card().toStdString();
}

TEST_F(EndsOnTheMap, DoNotMoveWithTheRobotWhileTheyAreClicked) {
    while (pixel_m() > 0.009) w.map().zoomBy(1.25);
    ASSERT_TRUE(w.map().following());
    goToTheMap();
    const ViewTransform before = w.map().view();
    hear(w, 30.0);
    EXPECT_EQ(w.map().view(), before);
    QTest::keyClick(&w.map(), Qt::Key_Escape);
    hear(w, 31.0);
    EXPECT_NE(w.map().view(), before);
}

// Whatever else is asked for: the page that waits is not forgotten.
TEST_F(EndsOnTheMap, DoNotLoseThePageByOtherKeys) {
    goToTheMap();
    QTest::keyClick(&w.map(), Qt::Key_K);
    EXPECT_TRUE(page()->isVisible());
    w.button("Click on the map")->click();
    w.window.setPlan(test::samplePlan());
    hear(w, 2.0);
    QTest::keyClick(&w.map(), Qt::Key_Escape);
    EXPECT_TRUE(page()->isVisible());
}

// Pictures for people to look at.
TEST_F(EndsOnTheMap, LookWellByDayAndByNight) {
    QDir().mkpath(QStringLiteral(HEDR_BINARY_DIR "/screenshots"));
    for (const ThemeName theme : {ThemeName::kDay, ThemeName::kNight}) {
        w.window.setTheme(theme);
        goToTheMap();
        const QString name = theme == ThemeName::kDay ? "day" : "night";
        const auto write = [&](const char* state) {
            EXPECT_TRUE(soon([&] { return w.map().isSharp(); }));
            EXPECT_TRUE(w.window.grab().save(
                QStringLiteral(HEDR_BINARY_DIR "/screenshots/ends-%1-%2.png").arg(state, name)));
        };
        write("begun");
        while (pixel_m() > 0.009) w.map().zoomBy(1.25);
        click(start());
        click(fromStart(4.0, 0.0));
        click(fromStart(0.25, 0.15));
        w.button("Skip run 2")->click();
        click(fromStart(0.3, -0.4));
        QTest::mouseMove(&w.map(), at(fromStart(-0.4, 0.3)));
        QCoreApplication::processEvents();
        write("clicked");
        w.button("Done")->click();
        w.window.resize(1024, 640);
        write("taken");
        w.window.resize(1280, 800);
        QTest::keyClick(w.window.focusWidget(), Qt::Key_Escape);
    }
}

TEST_F(EndsOnTheMap, GoOnAfterThoseThatWereTyped) {
    openSquares(w);
    auto* first = page()->findChildren<QLineEdit*>().at(1);
    first->setFocus();
    QTest::keyClicks(first, "0.12 -0.03");
    w.button("Click on the map")->click();
    click(start());
    click(fromStart(4.0, 0.0));
    click(fromStart(1.0, 0.5));
    w.button("Done")->click();
    EXPECT_EQ(fields().at(1), "0.12 -0.03");
    EXPECT_NEAR(fields().at(2).split(' ')[0].toDouble(), 1.0, 2.0 * pixel_m());
    w.button("Start again")->click();
    EXPECT_EQ(fields().join(""), "") << "those squares are forgotten";
}

TEST_F(EndsOnTheMap, DoNotBreakOffOtherWorkOnTheMap) {
    QTest::keyClick(&w.map(), Qt::Key_A);
    ASSERT_TRUE(w.window.desk().open());
    QTest::keyClick(&w.map(), Qt::Key_K);
    EXPECT_TRUE(w.window.desk().open());
    EXPECT_FALSE(page()->isVisible());
}

TEST(EndsWithoutAPlan, AreMeasuredByTape) {
    WindowUser w;
    hear(w, 1.0);
    openSquares(w);
    ASSERT_TRUE(w.button("Click on the map"));
    EXPECT_FALSE(w.button("Click on the map")->isEnabled());
    EXPECT_TRUE(w.button("Click on the map")->toolTip().contains("floor plan"));
}

}  // namespace
}  // namespace hedr
