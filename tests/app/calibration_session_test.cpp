// Calibrations in the window, with a robot that talks over a pseudo-terminal.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QTemporaryDir>
#include <QTest>
#include <filesystem>

#include "app/calibration_keeper.h"
#include "app/session.h"
#include "app/settings_store.h"
#include "core/calibration/vehicle_history.h"
#include "core/geometry/angle.h"
#include "core/simulation/random.h"
#include "tests/e2e/talking_robot.h"
#include "ui/main_window.h"
#include "ui/panels/banner.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

// With a bias of 0.9 °/s.
std::vector<SensorReport> standing(double seconds) {
    Random random(1);
    std::vector<SensorReport> reports;
    for (double t_s = 0.0; t_s < seconds; t_s += 0.02) {
        const double rate_rad_s = radFromDeg(0.9 + 0.1 * random.normal());
        reports.push_back(
            {.robot_time_s = t_s, .odometry = WheelTicks{5, 5}, .gyro = GyroRate{rate_rad_s}});
    }
    return reports;
}

class CalibrationsOfASession : public testing::Test {
  protected:
    CalibrationsOfASession() {
        saveSettings({});
        fs::remove_all(own_vehicle.parent_path());
        window.resize(1280, 800);
        window.show();
        window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
    }
    ~CalibrationsOfASession() override { saveSettings({}); }

    void press(Qt::Key key) {
        QTest::keyClick(window.focusWidget() ? window.focusWidget() : &window, key);
    }
    bool drives() const { return window.fleet().chosen().model.last().vehicle.has_value(); }
    QAbstractButton* button(const QString& text) const {
        for (auto* candidate : window.findChildren<QAbstractButton*>()) {
            if (candidate->isVisible() && candidate->text() == text) return candidate;
        }
        return nullptr;
    }
    bool canAccept() const { return button("Accept") && button("Accept")->isEnabled(); }
    QString banner() const {
        for (const auto* banner : window.findChildren<Banner*>()) {
            if (banner->isVisible()) return banner->text();
        }
        return {};
    }

    const fs::path own_vehicle = ownVehicleFile("test");
    QTemporaryDir folder;
    QString port = folder.filePath("robot");
    MainWindow window;
    Session session{window, {}};
};

TEST_F(CalibrationsOfASession, AreDoneFromTheKeyToTheVehicleFileOverAPseudoTerminal) {
    const TalkingRobot robot(port, standing(600.0), {.speed = 10.0});
    session.connectToAll({port});
    ASSERT_TRUE(QTest::qWaitFor([&] { return drives(); }, 20000));
    press(Qt::Key_K);
    press(Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return canAccept(); }, 30000));
    press(Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return banner().startsWith("Kept."); }, 20000));
    const auto vehicle = loadVehicle(own_vehicle);
    ASSERT_TRUE(vehicle) << vehicle.error().detail;
    EXPECT_NEAR(vehicle->gyro_bias_rad_s.value_or(0.0), radFromDeg(0.9), radFromDeg(0.01));
    const auto history = loadHistory(historyFolderOf(own_vehicle));
    ASSERT_TRUE(history);
    ASSERT_EQ(history->size(), 1U);
    EXPECT_EQ(history->front().record->procedure, "gyro-bias");
    EXPECT_EQ(loadSettings().connection.vehicle_file.toStdString(), own_vehicle.string())
        << "the next connection has the new values";
}

TEST_F(CalibrationsOfASession, NeedARobot) {
    press(Qt::Key_K);
    EXPECT_TRUE(banner().startsWith("Connect to a robot first")) << banner().toStdString();
}

TEST_F(CalibrationsOfASession, LeaveEverythingWhereTheyAreCanceled) {
    const TalkingRobot robot(port, standing(600.0), {.speed = 10.0});
    session.connectToAll({port});
    ASSERT_TRUE(QTest::qWaitFor([&] { return drives(); }, 20000));
    press(Qt::Key_K);
    press(Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return canAccept(); }, 30000));
    press(Qt::Key_Escape);
    EXPECT_EQ(button("Accept"), nullptr);
    EXPECT_FALSE(fs::exists(own_vehicle));
    EXPECT_FALSE(fs::exists(historyFolderOf(own_vehicle)));
}

}  // namespace
}  // namespace hedr
