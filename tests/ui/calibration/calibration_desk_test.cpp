#include "ui/calibration/calibration_desk.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QCheckBox>
#include <QCompleter>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

#include "core/geometry/angle.h"
#include "core/simulation/random.h"
#include "tests/core/calibration/wheels/loop_bench.h"
#include "tests/ui/calibration/samples.h"
#include "ui/calibration/calibration_page.h"
#include "ui/calibration/page_header.h"

namespace hedr {
namespace {

// An operator at the desk of a robot whose gyro has a bias of 0.9 °/s.
class DeskOfCalibrations : public testing::Test {
  protected:
    DeskOfCalibrations() {
        window.resize(1280, 800);
        desk.setTheme(dayTheme());
        QObject::connect(
            &desk, &CalibrationDesk::concluded, &window,
            [this](const CalibrationOutcome& outcome) { outcomes.push_back(outcome); });
        window.show();
        window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
        desk.choose({.robot = "PackBot 3"});
    }

    void press(Qt::Key key) { QTest::keyClick(window.focusWidget(), key); }
    // The first of the procedures.
    void startGyroBias() { press(Qt::Key_Return); }
    void stand(double seconds, std::uint64_t boot = 1) {
        desk.take(test::standingSensors(time_s_, seconds, random_, boot));
        time_s_ += seconds;
    }
    bool says(const QString& words) const {
        for (const auto* label : window.findChildren<QLabel*>()) {
            if (label->isVisible() && label->text().contains(words)) return true;
        }
        return false;
    }
    QAbstractButton* button(const QString& text) const {
        for (auto* candidate : window.findChildren<QAbstractButton*>()) {
            if (candidate->isVisible() && candidate->text() == text) return candidate;
        }
        return nullptr;
    }
    bool canAccept() const { return button("Accept") && button("Accept")->isEnabled(); }

    QWidget window;
    CalibrationDesk desk{&window};
    QSignalSpy wishes{&desk, &CalibrationDesk::samplesWished};
    std::vector<CalibrationOutcome> outcomes;

  private:
    Random random_{1};
    double time_s_ = 100.0;
};

TEST_F(DeskOfCalibrations, IsGoneThroughFromTheListToTheAcceptedValuesByKeysOnly) {
    startGyroBias();
    EXPECT_EQ(wishes.last().at(0), true);
    stand(40.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return canAccept(); }, 10000));
    press(Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !outcomes.empty(); }, 10000));
    EXPECT_EQ(outcomes[0].calibration.verdict, Verdict::kAccepted);
    EXPECT_NEAR(outcomes[0].calibration.found[0].now.value, radFromDeg(0.9), radFromDeg(0.01));
    EXPECT_EQ(outcomes[0].input.sets.at(0).reports.size(), 2000U);
    EXPECT_FALSE(desk.open());
    EXPECT_EQ(wishes.last().at(0), false);
}

TEST_F(DeskOfCalibrations, KnowsNothingBeforeItHasSamplesAndOffersNothing) {
    startGyroBias();
    EXPECT_TRUE(QTest::qWaitFor([&] { return says("No verdict yet"); }, 10000));
    stand(3.0);
    EXPECT_TRUE(QTest::qWaitFor([&] { return says("It has not stood for long."); }, 10000));
    EXPECT_FALSE(canAccept());
    press(Qt::Key_Return);
    EXPECT_TRUE(desk.open());
    EXPECT_TRUE(outcomes.empty());
}

TEST_F(DeskOfCalibrations, IsLeftByEscapeAndKeepsWhatWasMeasured) {
    startGyroBias();
    stand(40.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return canAccept(); }, 10000));
    press(Qt::Key_Escape);
    EXPECT_FALSE(desk.open());
    EXPECT_EQ(wishes.last().at(0), false);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !outcomes.empty(); }, 10000));
    EXPECT_TRUE(outcomes[0].declined);
    EXPECT_EQ(outcomes[0].input.sets.at(0).reports.size(), 2000U);
}

TEST_F(DeskOfCalibrations, KeepsNothingOfAFewReadings) {
    startGyroBias();
    stand(5.0);
    EXPECT_TRUE(QTest::qWaitFor([&] { return button("Cancel"); }, 10000));
    press(Qt::Key_Escape);
    QTest::qWait(500);
    EXPECT_TRUE(outcomes.empty());
}

TEST_F(DeskOfCalibrations, ForgetsTheSamplesWhereTheOperatorStartsAgain) {
    startGyroBias();
    stand(40.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return canAccept(); }, 10000));
    button("Start again")->click();
    EXPECT_FALSE(canAccept());
    EXPECT_TRUE(desk.open());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !outcomes.empty(); }, 10000));
    EXPECT_TRUE(outcomes[0].declined);
    EXPECT_TRUE(desk.open()) << "on its way with new samples";
}

TEST_F(DeskOfCalibrations, TakesTheSamplesOfEachStartOfTheRobotByThemselves) {
    startGyroBias();
    stand(40.0);
    stand(40.0, 2);
    ASSERT_TRUE(QTest::qWaitFor([&] { return says("Of several records only"); }, 10000));
}

TEST_F(DeskOfCalibrations, SaysWhyNoSamplesCome) {
    startGyroBias();
    desk.sayLink("The robot is not heard");
    EXPECT_TRUE(says("The robot is not heard"));
    desk.sayLink({});
    EXPECT_FALSE(says("The robot is not heard"));
}

TEST_F(DeskOfCalibrations, TakesWhatIsTypedWhileItMeasures) {
    for (int i = 0; i < 3; ++i) press(Qt::Key_Down);  // to the gyro's scale
    press(Qt::Key_Return);
    auto* field = window.findChild<QLineEdit*>();
    ASSERT_TRUE(field && field->isVisible());
    field->setFocus();
    QTest::keyClicks(field, "2 times");
    EXPECT_TRUE(says("Turns each time: a number above 0, please"));
    stand(3.0);
    QTest::qWait(1200);
    EXPECT_EQ(field->text(), "2 times") << "is not overwritten";
    for (int i = 0; i < 6; ++i) press(Qt::Key_Backspace);
    EXPECT_FALSE(says("a number above 0, please"));
    press(Qt::Key_Return);
    EXPECT_TRUE(desk.open());
    EXPECT_FALSE(field->hasFocus());
}

TEST_F(DeskOfCalibrations, TakesThatTheRoomMayChange) {
    press(Qt::Key_Down);  // to the warm-up
    press(Qt::Key_Return);
    const auto boxes = window.findChildren<QCheckBox*>();
    const auto found = std::ranges::find_if(boxes, &QWidget::isVisible);
    ASSERT_NE(found, boxes.end());
    QCheckBox* box = *found;
    EXPECT_EQ(box->text(), "The room may warm or cool meanwhile");
    box->setFocus();
    press(Qt::Key_Space);
    stand(3.0);
    QTest::qWait(1200);
    EXPECT_TRUE(box->isChecked()) << "the next look keeps it";
    press(Qt::Key_Space);
    EXPECT_FALSE(box->isChecked());
}

TEST_F(DeskOfCalibrations, TakesAFloorThatIsPickedFromTheKnownOnes) {
    desk.choose({.robot = "PackBot 3", .surfaces = {{.surface = "carpet"}, {.surface = "tiles"}}});
    for (const Procedure& procedure : procedures()) {
        if (procedure.name == "wheels") break;
        press(Qt::Key_Down);
    }
    press(Qt::Key_Return);
    auto* field = window.findChild<QLineEdit*>();
    ASSERT_TRUE(field && field->completer());
    // As Qt does when one is picked; a list that pops up is not for every platform.
    field->setText("tiles");
    emit field->completer()->activated(QString("tiles"));
    EXPECT_TRUE(window.findChild<PageHeader*>()->accessibleDescription().contains("tiles"));
}

// What is pressed between Accept and the last look changes nothing of what was accepted.
TEST_F(DeskOfCalibrations, KeepsWhatWasAccepted) {
    desk.choose({.robot = "PackBot 3", .vehicle = test::believedRobot()});
    for (const Procedure& procedure : procedures()) {
        if (procedure.name == "wheels") break;
        press(Qt::Key_Down);
    }
    press(Qt::Key_Return);
    button("It is at its mark")->click();
    for (const SampleSet& loop : test::loopsOf({}, 1)) {
        std::vector<HeardSensors> heard;
        for (const SensorReport& report : loop.reports) heard.push_back({1, report});
        desk.take(heard);
        button("Back at its mark")->click();
    }
    ASSERT_TRUE(QTest::qWaitFor([&] { return canAccept(); }, 20000));
    button("Accept")->click();
    if (button("Back at its mark")) button("Back at its mark")->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !outcomes.empty(); }, 20000));
    QTest::qWait(300);
    ASSERT_EQ(outcomes.size(), 1U);
    EXPECT_EQ(outcomes[0].input.sets.size(), 10U);
}

// Ten drives round, from mark to mark, and one that is not at its end yet.
TEST_F(DeskOfCalibrations, TakesClosedDrivesFromMarkToMark) {
    desk.choose({.robot = "PackBot 3", .vehicle = test::believedRobot()});
    for (const Procedure& procedure : procedures()) {
        if (procedure.name == "wheels") break;
        press(Qt::Key_Down);
    }
    press(Qt::Key_Return);
    const auto drive = [&](const SampleSet& loop) {
        std::vector<HeardSensors> heard;
        for (const SensorReport& report : loop.reports) heard.push_back({1, report});
        desk.take(heard);
    };
    stand(5.0);  // on the way to the mark
    ASSERT_TRUE(button("It is at its mark"));
    button("It is at its mark")->click();
    const auto loops = test::loopsOf({}, 1);
    for (const SampleSet& loop : loops) {
        drive(loop);
        ASSERT_TRUE(button("Back at its mark"));
        button("Back at its mark")->click();
    }
    drive(loops[0]);
    ASSERT_TRUE(QTest::qWaitFor([&] { return canAccept(); }, 20000));
    EXPECT_TRUE(says("10 closed drives"));
    button("Accept")->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !outcomes.empty(); }, 20000));
    EXPECT_EQ(outcomes[0].input.sets.size(), 10U);
    EXPECT_TRUE(outcomes[0].input.settings.closed);
    EXPECT_NEAR(outcomes[0].calibration.found.at(0).now.value, 0.34 * 1.03, 0.34 * 0.005);
}

}  // namespace
}  // namespace hedr
