#include "ui/calibration/calibration_page.h"

#include <gtest/gtest.h>

#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>

#include "tests/ui/calibration/samples.h"
#include "ui/calibration/evidence_plot_view.h"
#include "ui/calibration/scroll_box.h"
#include "ui/calibration/step_row.h"
#include "ui/calibration/verdict_box.h"

namespace hedr {
namespace {

// Finds things on the page as a person would: by their words.
class PageOfACalibration : public testing::Test {
  protected:
    PageOfACalibration() {
        page.setTheme(dayTheme());
        page.resize(1280, 720);
        show(test::squaresView(4));
        page.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&page));
        page.focusFirst();
    }
    void show(const CalibrationView& view) {
        page.show(view);
        for (int nested = 0; nested < 3; ++nested) QCoreApplication::processEvents();  // layouts
    }
    static void press(Qt::Key key, Qt::KeyboardModifiers with = {}) {
        QTest::keyClick(QApplication::focusWidget(), key, with);
    }
    QPushButton* button(const QString& name) const {
        for (auto* candidate : page.findChildren<QPushButton*>()) {
            const bool named = candidate->text() == name || candidate->accessibleName() == name;
            if (named && candidate->isVisible()) return candidate;
        }
        return nullptr;
    }
    // Of a painted row.
    QString said(const QString& name) const {
        for (const auto* widget : page.findChildren<QWidget*>()) {
            if (widget->accessibleName() != name || !widget->isVisible()) continue;
            return widget->accessibleDescription().replace(QChar(0x00A0), ' ');
        }
        return "not there";
    }
    QString verdict() const { return page.findChild<VerdictBox*>()->accessibleName(); }
    QString plot() const { return page.findChild<EvidencePlotView*>()->accessibleName(); }
    ScrollBox* scroll(const QString& name) const {
        for (auto* widget : page.findChildren<QScrollArea*>()) {
            if (widget->accessibleName() == name) return static_cast<ScrollBox*>(widget);
        }
        return nullptr;
    }
    // Where everything is.
    QMap<const QWidget*, QRect> places() const {
        QMap<const QWidget*, QRect> all;
        for (const auto* widget : page.findChildren<QWidget*>()) {
            if (!widget->isVisible() || qobject_cast<const QScrollBar*>(widget)) continue;
            all[widget] = {widget->mapTo(&page, QPoint()), widget->size()};
        }
        return all;
    }
    // What Tab reaches, until it comes round.
    QStringList reached() const {
        QStringList names;
        const QWidget* first = QApplication::focusWidget();
        do {
            const QWidget* now = QApplication::focusWidget();
            const auto* pressed = qobject_cast<const QAbstractButton*>(now);
            names << (now->accessibleName().isEmpty() && pressed ? pressed->text()
                                                                 : now->accessibleName());
            press(Qt::Key_Tab);
        } while (QApplication::focusWidget() != first && names.size() < 30);
        return names;
    }

    CalibrationPage page;
};

TEST_F(PageOfACalibration, ShowsWhatWasFound) {
    EXPECT_EQ(said("Wheelbase"), "0.5531 m, ± 0.0021, was 0.4100 m");
    EXPECT_EQ(said("Worst return error, held out"), "was 0.205 m, now 0.016 m");
    EXPECT_EQ(verdict(), "Better, 12.8 times");
    EXPECT_EQ(said("Wheel parameters · squares (UMBmark)"),
              "PackBot 3 · concrete floor · step 2 of 3");
}

TEST_F(PageOfACalibration, MarksTheFirstStepThatIsNotDone) {
    QStringList steps;
    for (const auto* row : page.findChildren<StepRow*>()) steps << row->accessibleName();
    EXPECT_EQ(steps.at(1), "Step 2, done: Drive 5 squares clockwise");
    EXPECT_EQ(steps.at(2), "Step 3, now: Drive 5 counter-clockwise");
    EXPECT_EQ(steps.at(3), "Step 4, later: Enter where it stopped");
}

TEST_F(PageOfACalibration, SaysWhatIsWishedFor) {
    const QSignalSpy primary(&page, &CalibrationPage::primaryRequested);
    const QSignalSpy secondary(&page, &CalibrationPage::secondaryRequested);
    const QSignalSpy action(&page, &CalibrationPage::procedureActionRequested);
    const QSignalSpy canceled(&page, &CalibrationPage::canceled);
    press(Qt::Key_Return);
    EXPECT_EQ(primary.count(), 1);
    button("Start again")->setFocus();
    press(Qt::Key_Return);
    EXPECT_EQ(secondary.count(), 1) << "Enter is the focused button's";
    button("Click on the map")->setFocus();
    press(Qt::Key_Space);
    EXPECT_EQ(action.count(), 1);
    press(Qt::Key_Escape);
    EXPECT_EQ(canceled.count(), 1);
    EXPECT_EQ(primary.count(), 1);
}

TEST_F(PageOfACalibration, DoesNothingByEnterWhileTheButtonIsOff) {
    const QSignalSpy primary(&page, &CalibrationPage::primaryRequested);
    show(test::decidedView(Verdict::kRefused));
    EXPECT_FALSE(button("Accept")->isEnabled());
    press(Qt::Key_Return);
    EXPECT_EQ(primary.count(), 0);
}

TEST_F(PageOfACalibration, IsGoneThroughByTab) {
    page.resize(1024, 640);
    show(test::wordyView());
    EXPECT_EQ(reached().join(" | ").toStdString(),
              "Accept and write to the robot | Steps | Click on the map | Rate while "
              "standing | Values | Close, and keep the record | Start again with new samples");
}

TEST_F(PageOfACalibration, ChoosesAPlotByTheArrows) {
    show(test::warmUpView());
    EXPECT_EQ(plot(), "Rate while standing");
    button("Rate while standing")->setFocus();
    press(Qt::Key_Right);
    EXPECT_EQ(plot(), "What the model leaves");
    show(test::warmUpView());
    EXPECT_EQ(plot(), "What the model leaves") << "new values change nothing chosen";
    EXPECT_EQ(QApplication::focusWidget(), button("What the model leaves"));
}

TEST_F(PageOfACalibration, ScrollsByTheArrowsWhereThereIsNoRoom) {
    page.resize(1024, 640);
    show(test::wordyView());
    ScrollBox* values = scroll("Values");
    values->setFocus();
    press(Qt::Key_Down);
    press(Qt::Key_Down);
    EXPECT_GT(values->verticalScrollBar()->value(), 0);
    show(test::squaresView(4));
    page.resize(1600, 1000);
    QCoreApplication::processEvents();
    EXPECT_EQ(values->focusPolicy(), Qt::NoFocus) << "nothing to scroll";
}

TEST_F(PageOfACalibration, KeepsFocusAndScrollPositionWhileValuesCome) {
    page.resize(1024, 640);
    CalibrationView view = test::wordyView();
    show(view);
    button("Close, and keep the record")->setFocus();
    for (const char* name : {"Values", "Steps"}) {
        scroll(name)->verticalScrollBar()->triggerAction(QScrollBar::SliderToMinimum);
        scroll(name)->verticalScrollBar()->triggerAction(QScrollBar::SliderPageStepAdd);
    }
    const int values_at = scroll("Values")->verticalScrollBar()->value();
    const int steps_at = scroll("Steps")->verticalScrollBar()->value();
    EXPECT_GT(values_at, 0);
    EXPECT_GT(steps_at, 0);
    for (int i = 0; i < 5; ++i) {
        view.calibration.found[0].now.value *= 1.01;
        view.calibration.progress.share += 0.05;
        show(view);
    }
    EXPECT_EQ(QApplication::focusWidget(), button("Close, and keep the record"));
    EXPECT_EQ(scroll("Values")->verticalScrollBar()->value(), values_at);
    EXPECT_EQ(scroll("Steps")->verticalScrollBar()->value(), steps_at);
}

TEST_F(PageOfACalibration, MovesNothingWhileFiguresRun) {
    for (const QSize size : {QSize(1600, 1000), QSize(1280, 720), QSize(1024, 640)}) {
        page.resize(size);
        CalibrationView view = test::squaresView(4);
        show(view);
        const auto before = places();
        view.calibration.progress.share = 1.0;
        view.calibration.found[0].now.value = 0.4911;
        view.calibration.found[1].now.value = 0.21111;
        view.calibration.proof->after = 0.111;
        view.calibration.proof->times_better = 1.85;
        show(view);
        EXPECT_EQ(places(), before) << size.width();
    }
}

TEST_F(PageOfACalibration, KeepsRoomForAProof) {
    page.resize(1600, 1000);
    CalibrationView view = test::squaresView(4);
    show(view);
    const auto with_proof = places();
    view.calibration.proof.reset();
    show(view);
    EXPECT_EQ(said("Held-out error"), "Nothing could be held out yet.");
    const auto* box = page.findChild<VerdictBox*>();
    EXPECT_EQ(places()[box].bottom(), with_proof[box].bottom());
}

// The focus would go on to the next button otherwise, and Space would cancel.
TEST_F(PageOfACalibration, GivesTheFocusBackToAButtonThatIsOnAgain) {
    CalibrationView view = test::squaresView(4);
    view.primary.enabled = false;
    show(view);
    const QSignalSpy canceled(&page, &CalibrationPage::canceled);
    press(Qt::Key_Space);
    EXPECT_EQ(canceled.count(), 0);
    view.primary.enabled = true;
    show(view);
    EXPECT_EQ(QApplication::focusWidget(), button("Accept"));
    button("Close, and keep the record")->setFocus();
    view.primary.enabled = false;
    show(view);
    view.primary.enabled = true;
    show(view);
    EXPECT_EQ(QApplication::focusWidget(), button("Close, and keep the record"))
        << "it had gone elsewhere";
}

TEST_F(PageOfACalibration, HidesButtonsWithoutAText) {
    show(test::emptyView());
    EXPECT_EQ(button("Start again"), nullptr);
    EXPECT_EQ(button("Click on the map"), nullptr);
    EXPECT_FALSE(button("Start")->isEnabled());
    EXPECT_EQ(verdict(), "No verdict yet");
}

TEST_F(PageOfACalibration, BringsTheNextStepIntoSight) {
    page.resize(1024, 640);
    show(test::wordyView());
    const auto rows = page.findChildren<StepRow*>();
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return rows.at(6)->visibleRegion().boundingRect().size() == rows.at(6)->size(); }));
}

// Nothing is cut off on the right, whatever the words and the room.
TEST_F(PageOfACalibration, HasRoomForItsWordsInEverySize) {
    for (const QSize size : {QSize(1600, 1000), QSize(1280, 720), QSize(1024, 640)}) {
        page.resize(size);
        for (const CalibrationView& view :
             {test::emptyView(), test::squaresView(4), test::warmUpView(), test::wordyView()}) {
            show(view);
            EXPECT_LE(page.minimumSizeHint().width(), size.width());
            EXPECT_LE(page.minimumSizeHint().height(), size.height());
            for (const auto* label : page.findChildren<QLabel*>()) {
                if (!label->isVisible()) continue;
                const int needed_px = label->hasHeightForWidth()
                                          ? label->heightForWidth(label->width())
                                          : label->sizeHint().height();
                EXPECT_GE(label->height(), needed_px) << label->text().toStdString();
            }
        }
    }
}

}  // namespace
}  // namespace hedr
