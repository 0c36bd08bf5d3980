// Calibrations in the window, from the key to the vehicle file.
#include <fstream>
#include <vector>

#include "core/geometry/angle.h"
#include "core/simulation/random.h"
#include "tests/app/calibrating_operator.h"
#include "tests/e2e/talking_robot.h"

namespace hedr {
namespace {

// What a robot says that is moved about; its gyro has a bias of 0.9 °/s, its right wheel and its
// wheelbase are not what it says.
class MovedRobot {
  public:
    explicit MovedRobot(double period_s = 0.05) : period_s_(period_s) {}

    double scale = 1.0;           // of the gyro, true per reported
    double noise_deg_s = 0.1;     // of a reading
    double right_per_left = 1.0;  // diameters
    double wheelbase_m = 0.5;
    bool right_reversed = false;
    bool has_compass = false;  // with a middle of (0.12, -0.31), and 0.25 and 0.21 about it
    std::vector<SensorReport> reports{};

    void move(double seconds, double speed_m_s, double turn_deg_s) {
        const Vehicle said = spokenVehicle();
        const double per_m =
            said.geometry.ticks_per_revolution / (kPi * said.geometry.left_wheel_diameter_m);
        for (const double end_s = time_s_ + seconds; time_s_ < end_s - 0.5 * period_s_;) {
            time_s_ += period_s_;
            const double side_m = 0.5 * wheelbase_m * radFromDeg(turn_deg_s) * period_s_;
            left_ += (speed_m_s * period_s_ - side_m) * per_m * std::sqrt(right_per_left);
            right_ += (speed_m_s * period_s_ + side_m) * per_m / std::sqrt(right_per_left);
            const double right = right_reversed ? -right_ : right_;
            const double rate_deg_s =
                turn_deg_s / scale + bias_deg_s(time_s_) + noise_deg_s * random_.normal();
            reports.push_back({.robot_time_s = time_s_,
                               .odometry = WheelTicks{std::llround(left_), std::llround(right)},
                               .gyro = GyroRate{radFromDeg(rate_deg_s)}});
            heading_rad_ += radFromDeg(turn_deg_s) * period_s_;
            if (has_compass) reports.back().magnetic_field = field();
        }
    }
    void stand(double seconds) { move(seconds, 0.0, 0.0); }

    std::function<double(double t_s)> bias_deg_s = [](double) { return 0.9; };

  private:
    MagneticField field() {
        constexpr double kNoise = 0.002;
        return {0.12 + 0.25 * std::cos(heading_rad_) + kNoise * random_.normal(),
                -0.31 - 0.21 * std::sin(heading_rad_) + kNoise * random_.normal(),
                0.4 + kNoise * random_.normal()};
    }

    double period_s_;
    double time_s_ = 0.0;
    double heading_rad_ = 0.0;
    double left_ = 0.0;
    double right_ = 0.0;
    Random random_{1};
};

using PagesOfCalibrations = CalibratingOperator;

TEST_F(PagesOfCalibrations, NeedARobot) {
    press(Qt::Key_K);
    EXPECT_TRUE(banner().startsWith("Connect to a robot first")) << banner().toStdString();
}

TEST_F(PagesOfCalibrations, LeaveTheVehicleAsItIsWhereTheyAreClosed) {
    MovedRobot moved(0.02);
    moved.stand(600.0);
    const TalkingRobot robot(port, moved.reports, {.speed = 10.0});
    begin("gyro-bias");
    ASSERT_TRUE(QTest::qWaitFor([&] { return canAccept(); }, 30000));
    press(Qt::Key_Escape);
    EXPECT_EQ(button("Accept"), nullptr);
    ASSERT_TRUE(QTest::qWaitFor([&] { return banner().startsWith("Kept in the history"); }, 20000));
    EXPECT_FALSE(std::filesystem::exists(own_vehicle));
    const auto history = loadHistory(historyFolderOf(own_vehicle));
    ASSERT_EQ(history->size(), 1U);
    EXPECT_FALSE(history->front().record->taken_over);
}

TEST_F(PagesOfCalibrations, FindTheBiasAndKeepItForTheNextConnection) {
    MovedRobot moved(0.02);
    moved.stand(600.0);
    const TalkingRobot robot(port, moved.reports, {.speed = 10.0});
    begin("gyro-bias");
    EXPECT_NEAR(accept().gyro_bias_rad_s.value_or(0.0), radFromDeg(0.9), radFromDeg(0.01));
    const auto history = loadHistory(historyFolderOf(own_vehicle));
    ASSERT_TRUE(history);
    ASSERT_EQ(history->size(), 1U);
    EXPECT_EQ(history->front().record->procedure, "gyro-bias");
    EXPECT_EQ(loadSettings().connection.vehicle_file.toStdString(), own_vehicle.string());
}

// From the history, by keys: the newest entry is the chosen one, and Back leads to the list.
TEST_F(PagesOfCalibrations, AreTakenBackFromTheHistory) {
    MovedRobot moved(0.02);
    moved.stand(600.0);
    const TalkingRobot robot(port, moved.reports, {.speed = 10.0});
    begin("gyro-bias");
    EXPECT_TRUE(accept().gyro_bias_rad_s);
    press(Qt::Key_K);
    for (std::size_t i = 0; i < procedures().size(); ++i) press(Qt::Key_Down);
    press(Qt::Key_Return);
    ASSERT_TRUE(window.showsHistory());
    QAbstractButton* before = button("Restore values before");
    ASSERT_TRUE(before && before->isEnabled());
    before->setFocus();
    press(Qt::Key_Return);
    EXPECT_FALSE(loadVehicle(own_vehicle).value().gyro_bias_rad_s);
    EXPECT_TRUE(says("What it had is kept."));
    emit window.exportWished(
        QString::fromStdString(loadHistory(historyFolderOf(own_vehicle))->front().name),
        folder.path(), kFirstRobot);
    EXPECT_TRUE(QTest::qWaitFor([&] { return says("Copied to"); }, 20000));
    press(Qt::Key_Escape);
    EXPECT_FALSE(window.showsHistory());
    press(Qt::Key_Escape);
    EXPECT_EQ(button("Restore values before"), nullptr);
}

class WithAFileOfAnotherRobot : public CalibratingOperator {
  protected:
    WithAFileOfAnotherRobot()
        : CalibratingOperator({.vehicle = Vehicle{}, .vehicle_file = ownVehicleFile("other")}) {
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file) << formatVehicle({});
    }
    const std::filesystem::path file = ownVehicleFile("other");
};

// The program was started with that file, but the operator chose what the robot is.
TEST_F(WithAFileOfAnotherRobot, PagesLeaveItAlone) {
    MovedRobot moved(0.02);
    moved.stand(600.0);
    const TalkingRobot robot(port, moved.reports, {.speed = 10.0});
    emit window.connectRequested({.port = port, .vehicle_preset = "romi"}, kFirstRobot);
    choose("gyro-bias");
    EXPECT_NEAR(accept().gyro_bias_rad_s.value_or(0.0), radFromDeg(0.9), radFromDeg(0.01));
    EXPECT_EQ(loadVehicle(file).value(), Vehicle{});
}

TEST_F(PagesOfCalibrations, FitAWarmUpThatBeganAMinuteBefore) {
    MovedRobot moved(0.1);
    moved.noise_deg_s = 0.05;
    moved.bias_deg_s = [](double t_s) { return 0.3 - 0.2 * std::exp(-(t_s + 60.0) / 200.0); };
    moved.stand(1500.0);
    const TalkingRobot robot(port, moved.reports, {.speed = 100.0});
    begin("warmup");
    type(0, "1");
    const auto drift = accept().gyro_drift;
    ASSERT_TRUE(drift);
    EXPECT_NEAR(drift->c1_rad_s, radFromDeg(0.2), radFromDeg(0.06));
    EXPECT_NEAR(drift->time_s, 200.0, 60.0);
}

TEST_F(PagesOfCalibrations, TellHowNoisyTheGyroIs) {
    MovedRobot moved;
    moved.stand(1200.0);
    const TalkingRobot robot(port, moved.reports, {.speed = 80.0});
    begin("allan");
    EXPECT_NEAR(accept().gyro_noise_rad_s_sqrthz, radFromDeg(0.1) * std::sqrt(0.05), 1e-4);
}

TEST_F(PagesOfCalibrations, FindTheScaleFromTurnsToAMark) {
    MovedRobot moved;
    moved.scale = 1.02;
    moved.stand(8.0);
    for (const double rate_deg_s : {60.0, -60.0, 60.0, -60.0, 60.0, -60.0}) {
        moved.move(12.0, 0.0, rate_deg_s);
        moved.stand(6.0);
    }
    const TalkingRobot robot(port, moved.reports, {.speed = 20.0});
    begin("gyro-scale");
    type(0, "2");
    EXPECT_NEAR(accept().gyro_scale, 1.02, 0.003);
}

TEST_F(PagesOfCalibrations, NameAnEncoderThatCountsBackwards) {
    MovedRobot moved;
    moved.right_reversed = true;
    moved.stand(4.0);
    moved.move(5.0, 0.2, 0.0);
    moved.stand(4.0);
    moved.move(6.0, 0.0, 60.0);
    moved.stand(30.0);
    const TalkingRobot robot(port, moved.reports, {.speed = 5.0});
    begin("encoder-check");
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return says("The right encoder counts backwards."); }, 60000));
    EXPECT_FALSE(canAccept());
}

// Driven along a tape, so every run ends at its mark but for some millimetres.
TEST_F(PagesOfCalibrations, FindTheWheelsFromSquaresBothWays) {
    MovedRobot moved;
    moved.right_per_left = 1.01;
    moved.wheelbase_m = 0.51;
    moved.stand(4.0);
    for (int run = 0; run < 10; ++run) {
        for (int side = 0; side < 4; ++side) {
            moved.move(8.0, 0.5, 0.0);
            moved.move(2.0, 0.0, run % 2 == 0 ? 45.0 : -45.0);
        }
        moved.stand(4.0);
    }
    const TalkingRobot robot(port, moved.reports, {.speed = 40.0});
    begin("umbmark");
    const QStringList ends{"0.003 -0.002",  "-0.004 0.001", "0.002 0.005",   "0.000 -0.004",
                           "-0.003 0.003",  "0.005 0.000",  "-0.001 -0.003", "0.002 0.002",
                           "-0.002 -0.001", "0.001 0.004"};
    type(0, "tiles");
    for (int run = 0; run < 10; ++run) type(run + 1, ends[run]);
    const VehicleGeometry found = accept().geometry;
    const auto kept = historyEntry(historyFolderOf(own_vehicle), "umbmark");
    ASSERT_TRUE(kept && kept->record);
    EXPECT_EQ(kept->record->surface, "tiles");
    EXPECT_EQ(kept->record->told.ends.size(), 10U);
    EXPECT_NEAR(found.right_wheel_diameter_m / found.left_wheel_diameter_m, 1.01, 0.001);
    EXPECT_NEAR(found.wheelbase_m, 0.51, 0.002);
}

TEST_F(PagesOfCalibrations, FindTheWheelsFromDrivingAbout) {
    MovedRobot moved;
    moved.right_per_left = 1.01;
    moved.wheelbase_m = 0.62;
    moved.stand(8.0);
    for (int corner = 0; corner < 24; ++corner) {
        moved.move(10.0 + corner % 5, 0.5, 0.0);
        moved.move(3.0, 0.2, corner % 3 == 0 ? 30.0 : -30.0);
        if (corner % 6 == 5) moved.stand(6.0);
    }
    moved.stand(3000.0);  // it takes parameters while it stands, however slow the machine is
    const TalkingRobot robot(port, moved.reports, {.speed = 40.0});
    begin("wheels");
    const QString also = "Accept, and write to the robot";
    ASSERT_TRUE(QTest::qWaitFor([&] { return button(also) && stands(); }, 120000));
    button(also)->setFocus();
    press(Qt::Key_Return);
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return banner() == "Kept, and the robot has the new values."; }, 30000))
        << banner().toStdString();
    const VehicleGeometry found = loadVehicle(own_vehicle).value_or(Vehicle{}).geometry;
    const auto& robots_own = window.fleet().chosen().model.last().robot->geometry;
    EXPECT_NEAR(robots_own.wheelbase_m, found.wheelbase_m, 1e-6);
    EXPECT_NEAR(found.right_wheel_diameter_m / found.left_wheel_diameter_m, 1.01, 0.001);
    EXPECT_NEAR(found.wheelbase_m, 0.62, 0.004);
}

TEST_F(PagesOfCalibrations, TakeTheRobotsIronOutOfItsCompass) {
    MovedRobot moved;
    moved.has_compass = true;
    moved.stand(8.0);
    for (const double rate_deg_s : {45.0, -45.0}) {
        moved.move(17.0, 0.0, rate_deg_s);
        moved.stand(4.0);
    }
    moved.stand(300.0);
    const TalkingRobot robot(port, moved.reports, {.speed = 10.0});
    begin("magnetometer");
    const auto compass = accept().magnetometer;
    ASSERT_TRUE(compass);
    EXPECT_NEAR(compass->centre_x / compass->centre_y, 0.12 / -0.31, 0.01);
    EXPECT_NEAR(compass->range_y / compass->range_x, 0.21 / 0.25, 0.02);
}

}  // namespace
}  // namespace hedr
