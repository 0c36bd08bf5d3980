#include <gtest/gtest.h>

#include <QDir>
#include <QPushButton>
#include <QTest>

#include "core/calibration/gyro/warmup.h"
#include "core/calibration/history/surface_profile.h"
#include "core/calibration/wheels/wheel_loops.h"
#include "tests/core/calibration/compass/simulated_magnetometer.h"
#include "tests/core/calibration/gyro/warmup_stand.h"
#include "tests/core/calibration/wheels/loop_bench.h"
#include "tests/core/calibration/wheels/simulated_drive.h"
#include "tests/ui/calibration/samples.h"
#include "ui/calibration/calibration_desk.h"
#include "ui/calibration/calibration_page.h"
#include "ui/calibration/procedure_entries.h"
#include "ui/calibration/procedure_list.h"

namespace hedr {
namespace {

// Pictures for people to look at, as those of screenshots_test.cpp.
void writePicture(const QString& name, QWidget& widget) {
    QDir().mkpath(QStringLiteral(HEDR_BINARY_DIR "/screenshots"));
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&widget));
    QCoreApplication::processEvents();
    const QString file = QStringLiteral(HEDR_BINARY_DIR "/screenshots/calibration-%1-%2.png")
                             .arg(name)
                             .arg(widget.width());
    EXPECT_TRUE(widget.grab().save(file)) << file.toStdString();
}

struct Shot {
    const char* name;
    CalibrationView (*view)();
};

class CalibrationStates : public testing::TestWithParam<Shot> {};

TEST_P(CalibrationStates, ShowThePageInEverySize) {
    for (const ThemeName theme : {ThemeName::kDay, ThemeName::kNight}) {
        CalibrationPage page;
        page.setTheme(themeOf(theme));
        page.show(GetParam().view());
        page.focusFirst();
        for (const QSize size : {QSize(1600, 1000), QSize(1280, 720), QSize(1024, 640)}) {
            page.resize(size);
            writePicture(QString(GetParam().name).replace('_', '-') +
                             (theme == ThemeName::kDay ? "-day" : "-night"),
                         page);
        }
    }
}

template <Verdict verdict>
CalibrationView decided() {
    return test::decidedView(verdict);
}

INSTANTIATE_TEST_SUITE_P(All, CalibrationStates,
                         testing::Values(Shot{"empty", test::emptyView},
                                         Shot{"squares", [] { return test::squaresView(4); }},
                                         Shot{"accepted", decided<Verdict::kAccepted>},
                                         Shot{"unchanged", decided<Verdict::kUnchanged>},
                                         Shot{"not_proven", decided<Verdict::kNotProven>},
                                         Shot{"refused", decided<Verdict::kRefused>},
                                         Shot{"warm_up", test::warmUpView},
                                         Shot{"wordy", test::wordyView}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(CalibrationScreenshots, ShowEveryPlotOfAWarmUp) {
    for (const ThemeName theme : {ThemeName::kDay, ThemeName::kNight}) {
        CalibrationPage page;
        page.setTheme(themeOf(theme));
        page.resize(1280, 800);
        page.show(test::warmUpView());
        for (const char* plot : {"What the model leaves", "Allan deviation"}) {
            for (auto* tab : page.findChildren<QPushButton*>()) {
                if (tab->accessibleName() == plot) tab->click();
            }
            writePicture(QString(plot).section(' ', 0, 0).toLower() +
                             (theme == ThemeName::kDay ? "-day" : "-night"),
                         page);
        }
    }
}

CalibrationView viewOf(const char* title, Calibration calibration) {
    CalibrationView view{.title = title, .context = "PackBot 3"};
    const bool wheels =
        calibration.procedure == "wheels" && calibration.verdict == Verdict::kAccepted;
    view.primary = {wheels ? "Accept here only" : "Accept",
                    calibration.verdict == Verdict::kAccepted};
    if (wheels) view.also = {"Accept, and write to the robot"};
    view.leave = {"Close, and keep the record"};
    view.secondary = {"Start again"};
    view.calibration = std::move(calibration);
    return view;
}

void writePicturesOf(const char* name, const CalibrationView& view) {
    for (const ThemeName theme : {ThemeName::kDay, ThemeName::kNight}) {
        CalibrationPage page;
        page.setTheme(themeOf(theme));
        page.show(view);
        page.focusFirst();
        const auto write = [&](int number) {
            page.resize(number == 1 ? QSize(1600, 1000) : QSize(1280, 720));
            writePicture(QStringLiteral("%1-%2-%3")
                             .arg(name)
                             .arg(number)
                             .arg(theme == ThemeName::kDay ? "day" : "night"),
                         page);
        };
        write(1);
        int number = 1;
        for (const EvidencePlot& plot : view.calibration.plots) {
            for (auto* tab : page.findChildren<QPushButton*>()) {
                if (tab->accessibleName() == QString::fromStdString(plot.title)) tab->click();
            }
            write(++number);
        }
    }
}

TEST(CalibrationScreenshots, ShowWheelsFromADrive) {
    const auto found = test::calibratedOn(
        {.duration_s = 2400.0, .believed_wheelbase_m = 0.45, .believed_right_larger = 0.02}, 3);
    CalibrationView view = viewOf("Wheels by driving", found.calibration);
    view.context = "PackBot 3 · concrete · step 3 of 3";
    view.entries = procedureEntries(*findProcedure("wheels"), {"concrete"});
    SurfaceProfile carpet{"carpet", {}, found.calibration.track_widths};
    for (TrackWidth& width : carpet.track_widths) width.wheelbase_m.value *= 1.06;
    showSurfaces(view.calibration, {carpet}, "concrete");
    writePicturesOf("wheels", view);
    const test::DriveOnBench begun = test::driven({.duration_s = 60.0}, 3);
    writePicturesOf(
        "wheels-begun",
        viewOf("Wheels by driving", calibrateByDriving(begun.sets, begun.believed).calibration));
}

TEST(CalibrationScreenshots, ShowAWarmUpInARoomThatChanges) {
    Random random(3);
    Stand stand{.minutes = 35.0, .rate_hz = 10.0};
    stand.besides = [](double t_s) { return radFromDeg(0.04) * t_s / 2100.0; };
    const auto reports = reportsOf(stand, random);
    const Warmup warmup = calibrateWarmup(reports, {}, {.room = RoomTemperature::kMayChange});
    CalibrationView view = viewOf("Gyro warm-up", warmup.calibration);
    const Procedure& procedure = *findProcedure("warmup");
    view.entries = procedureEntries(procedure, {"", kSwitchedOn.toString()});
    writePicturesOf("warm-up-changing", view);
    const Warmup steady = calibrateWarmup(std::span(reports).first(13000), {});
    view = viewOf("Gyro warm-up", steady.calibration);
    view.entries = procedureEntries(procedure, {});
    writePicturesOf("warm-up-steady", view);
}

TEST(CalibrationScreenshots, ShowWheelsFromClosedDrives) {
    CalibrationView view =
        viewOf("Wheels by driving",
               calibrateByLoops(test::loopsOf({}, 1), test::believedRobot()).calibration);
    view.entries = procedureEntries(*findProcedure("wheels"), {});
    view.procedure_action = {"Back at its mark"};
    writePicturesOf("loops", view);
}

TEST(CalibrationScreenshots, ShowACompassThatTurnedOnTheSpot) {
    writePicturesOf("compass", viewOf("Compass", test::calibrationOf({}, 3).calibration));
}

TEST(CalibrationScreenshots, ShowTheListOfProcedures) {
    for (const ThemeName theme : {ThemeName::kDay, ThemeName::kNight}) {
        ProcedureList list(nullptr);
        list.setTheme(themeOf(theme));
        list.show(test::procedureEntries());
        list.resize(720, 620);
        list.focusFirst();
        writePicture(theme == ThemeName::kDay ? "list-day" : "list-night", list);
    }
}

// As it comes from the sensors themselves.
TEST(CalibrationScreenshots, ShowTheDeskWhileARobotStands) {
    for (const ThemeName theme : {ThemeName::kDay, ThemeName::kNight}) {
        QWidget window;
        window.resize(1280, 800);
        CalibrationDesk desk(&window);
        desk.setTheme(themeOf(theme));
        window.show();
        window.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
        desk.choose({.robot = "PackBot 3", .kept = 12});
        const QString name = theme == ThemeName::kDay ? "live-%1-day" : "live-%1-night";
        writePicture(name.arg("list"), window);
        QTest::keyClick(window.focusWidget(), Qt::Key_Return);
        Random random(1);
        for (const double seconds : {8.0, 30.0}) {
            desk.take(test::standingSensors(100.0 + seconds, seconds, random));
            QTest::qWait(1300);
            writePicture(name.arg(seconds), window);
        }
        for (auto* tab : window.findChildren<QPushButton*>()) {
            if (tab->accessibleName().startsWith("Unrest")) tab->click();
        }
        writePicture(name.arg("unrest"), window);
    }
}

}  // namespace
}  // namespace hedr
