#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/calibration/history/vehicle_history.h"
#include "core/calibration/squares/square_runs.h"
#include "core/geometry/angle.h"
#include "core/robot/sensor_csv.h"
#include "core/robot/vehicle.h"
#include "core/simulation/random.h"
#include "core/simulation/umbmark_squares.h"
#include "core/text/text_file.h"
#include "tests/core/text/scratch_folder.h"
#include "tests/e2e/tool_fixture.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

// `hedr calibrate` on a log of a standing gyro, with a vehicle file of its own.
class Calibrate : public testing::Test {
  protected:
    Calibrate() {
        std::ofstream(vehicle_) << kVehicle;
        Random random(1);
        std::vector<SensorReport> reports;
        for (int i = 0; i < 60000; ++i) {
            reports.push_back({.robot_time_s = 0.02 * i,
                               .gyro = GyroRate{0.003 + radFromDeg(0.1) * random.normal()},
                               .temperature_c = 24.0});
        }
        EXPECT_TRUE(saveSensorLog(log_, reports));
    }

    struct Said {
        int exit_code = 0;
        std::string out{};
        std::string err{};
    };
    static Said calibrate(const QStringList& arguments) {
        const Outcome done = run(kHedrTool, QStringList{"calibrate"} + arguments);
        return {done.exit_code, done.out.toStdString(), done.err.toStdString()};
    }
    static QString text(const fs::path& path) { return QString::fromStdString(path.string()); }

    static constexpr const char* kVehicle =
        "# ours\nname = \"ours\"\nleft_wheel_diameter_m = 0.2\nright_wheel_diameter_m = 0.2\n"
        "wheelbase_m = 0.4\nticks_per_revolution = 1000\n";
    ScratchFolder folder_;
    fs::path vehicle_ = folder_.path() / "ours.toml";
    fs::path log_ = folder_.path() / "standing.csv";
};

TEST_F(Calibrate, SaysWhatItFoundAndTouchesNothing) {
    const auto done = calibrate({"allan", text(log_), "--vehicle", text(vehicle_), "--json"});
    ASSERT_EQ(done.exit_code, 0) << done.err;
    const auto object = nlohmann::json::parse(done.out);
    EXPECT_EQ(object["procedure"], "allan");
    EXPECT_EQ(object["verdict"], "accepted");
    EXPECT_EQ(object["written"], false);
    EXPECT_EQ(object["found"][0]["key"], "gyro_noise_rad_s_sqrthz");
    EXPECT_NEAR(object["found"][0]["now"], radFromDeg(0.1) * std::sqrt(0.02), 1e-5);
    EXPECT_EQ(readTextFile(vehicle_).value(), kVehicle);
    EXPECT_FALSE(fs::exists(folder_.path() / "ours.history"));
}

TEST_F(Calibrate, FindsTheBiasOfAStandingRobot) {
    const auto done = calibrate({"gyro-bias", text(log_), "--vehicle", text(vehicle_), "--write"});
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_NE(done.out.find("There are no encoders"), std::string::npos) << done.out;
    EXPECT_NEAR(loadVehicle(vehicle_)->gyro_bias_rad_s.value_or(0.0), 0.003, 1e-4);
}

// Turned by hand, twice each way, the third time told that it was two turns.
TEST_F(Calibrate, FindsTheScaleOfAGyroThatIsTurnedFromMarkToMark) {
    Random random(3);
    std::vector<SensorReport> reports;
    const auto add = [&](double seconds, double rate_deg_s) {
        for (int i = 0; i < 20 * seconds; ++i) {
            const double reading_deg_s = rate_deg_s / 1.02 + 0.3 + 0.1 * random.normal();
            reports.push_back({.robot_time_s = 0.05 * static_cast<double>(reports.size()),
                               .gyro = GyroRate{radFromDeg(reading_deg_s)}});
        }
    };
    add(6.0, 0.0);
    for (const double rate_deg_s : {60.0, -60.0, 60.0, -60.0, 60.0, -60.0}) {
        add(12.0, rate_deg_s);
        add(6.0, 0.0);
    }
    ASSERT_TRUE(saveSensorLog(log_, reports));
    const auto done = calibrate(
        {"gyro-scale", text(log_), "--vehicle", text(vehicle_), "--write", "--turns", "2"});
    ASSERT_EQ(done.exit_code, 0) << done.out << done.err;
    EXPECT_NEAR(loadVehicle(vehicle_)->gyro_scale, 1.02, 0.002);
    const auto other =
        calibrate({"gyro-scale", text(log_), "--vehicle", text(vehicle_), "--turns", "3"});
    EXPECT_EQ(other.exit_code, 1) << "they were two turns each";
    EXPECT_EQ(
        calibrate({"gyro-bias", text(log_), "--vehicle", text(vehicle_), "--turns", "2"}).exit_code,
        2);
}

TEST_F(Calibrate, NamesWhatIsWrongWithTheEncoders) {
    std::vector<SensorReport> reports;
    WheelTicks ticks;
    // Of a metre are 1,592 counts, of a turn on the spot 2,000 each.
    const auto move = [&](int left, int right, int steps) {
        for (int i = 0; i < steps; ++i) {
            ticks.left += left;
            ticks.right += right;
            reports.push_back(
                {.robot_time_s = 0.05 * static_cast<double>(reports.size()), .odometry = ticks});
        }
    };
    move(0, 0, 60);
    move(16, -16, 100);
    move(0, 0, 60);
    move(-20, -20, 100);
    move(0, 0, 60);
    ASSERT_TRUE(saveSensorLog(log_, reports));
    const auto done = calibrate({"encoder-check", text(log_), "--vehicle", text(vehicle_)});
    EXPECT_EQ(done.exit_code, 1);
    EXPECT_NE(done.err.find("The right encoder counts backwards."), std::string::npos) << done.err;
}

TEST_F(Calibrate, FindsWheelsFromADriveAndFromStraightRuns) {
    const auto drive = folder_.path() / "drive";
    const QStringList simulate{"simulate", "packbot-corridors", "--seed", "3",
                               "--out",    text(drive)};
    ASSERT_EQ(run(kHedrTool, simulate).exit_code, 0);
    const auto log = drive / "sensors.csv";
    const auto done = calibrate({"wheels", text(log), "--vehicle", "packbot", "--json"});
    ASSERT_EQ(done.exit_code, 0) << done.err;
    const auto found = nlohmann::json::parse(done.out);
    EXPECT_EQ(found["verdict"], "accepted") << done.out;
    EXPECT_EQ(found["found"][0]["key"], "wheelbase_m");
    EXPECT_NEAR(found["found"][0]["now"], 0.65, 0.04);
    EXPECT_EQ(found["found"][0]["stays"], false);
    const auto runs = calibrate({"wheels", text(log), "--vehicle", "packbot", "--distance", "10"});
    EXPECT_EQ(runs.exit_code, 1) << "those are no straight runs";
    const auto both =
        calibrate({"wheels", text(log), "--vehicle", "packbot", "--distance", "10", "--closed"});
    EXPECT_EQ(both.exit_code, 2);
    const auto backwards =
        calibrate({"wheels", text(log), "--vehicle", "packbot", "--distance", "-3"});
    EXPECT_EQ(backwards.exit_code, 2);
    EXPECT_NE(backwards.err.find("--distance: must be a number above 0"), std::string::npos)
        << backwards.err;
}

TEST_F(Calibrate, KeepsTheWheelsOfEachFloor) {
    const auto drive = folder_.path() / "drive";
    ASSERT_EQ(run(kHedrTool, {"simulate", "packbot-corridors", "--seed", "3", "--out", text(drive)})
                  .exit_code,
              0);
    std::ofstream(vehicle_) << formatVehicle(*loadVehicleOrPreset("packbot"));
    const double before_m = loadVehicle(vehicle_)->geometry.wheelbase_m;
    ASSERT_EQ(calibrate({"wheels", text(drive / "sensors.csv"), "--vehicle", text(vehicle_),
                         "--write", "--surface", "carpet"})
                  .exit_code,
              0);
    const double carpet_m = loadVehicle(vehicle_)->geometry.wheelbase_m;
    ASSERT_NE(carpet_m, before_m);
    const auto list = calibrate({"surfaces", "--vehicle", text(vehicle_), "--json"});
    const auto carpet = nlohmann::json::parse(list.out)["surfaces"][0];
    EXPECT_EQ(carpet["surface"], "carpet");
    EXPECT_EQ(carpet["numbers"][0]["value"], carpet_m);
    EXPECT_GE(carpet["track_widths"].size(), 2U);
    ASSERT_EQ(calibrate({"restore", "wheels", "--before", "--vehicle", text(vehicle_)}).exit_code,
              0);
    ASSERT_EQ(calibrate({"use-surface", "carpet", "--vehicle", text(vehicle_)}).exit_code, 0);
    EXPECT_EQ(loadVehicle(vehicle_)->geometry.wheelbase_m, carpet_m);
    const auto damaged = historyFolderOf(vehicle_.string()) / "9999-wheels";
    std::filesystem::create_directories(damaged);
    std::ofstream(damaged / "record.toml") << "format = 1\n";
    const auto unsure = calibrate({"use-surface", "carpet", "--vehicle", text(vehicle_)});
    EXPECT_EQ(unsure.exit_code, 1) << "it may have had newer wheels";
    EXPECT_NE(unsure.err.find("9999-wheels"), std::string::npos) << unsure.err;
    std::filesystem::remove_all(damaged);
    const auto misspelt = calibrate({"use-surface", "carpets", "--vehicle", text(vehicle_)});
    EXPECT_EQ(misspelt.exit_code, 1);
    EXPECT_NE(misspelt.err.find("it may be carpet"), std::string::npos) << misspelt.err;
}

TEST_F(Calibrate, TellsWrongUsageOfTheHistory) {
    const QStringList allan{"allan", text(log_), "--vehicle", text(vehicle_), "--write"};
    EXPECT_EQ(calibrate(allan + QStringList{"--surface", "--json"}).exit_code, 2);
    EXPECT_EQ(calibrate(allan + QStringList{"--surface", QString(61, 'x')}).exit_code, 2);
    EXPECT_EQ(calibrate({"restore", "", "--vehicle", text(vehicle_)}).exit_code, 2);
    const auto nan =
        calibrate({"encoder-check", text(log_), "--vehicle", text(vehicle_), "--distance", "nan"});
    EXPECT_EQ(nan.exit_code, 2);
    EXPECT_NE(nan.err.find("--distance: must be a number"), std::string::npos) << nan.err;
    const auto missing = calibrate({"history", "--vehicle", text(folder_.path() / "typo.toml")});
    EXPECT_EQ(missing.exit_code, 1);
    EXPECT_NE(missing.err.find("There is no file"), std::string::npos) << missing.err;
}

TEST_F(Calibrate, WritesWhatIsAcceptedAndRestoresIt) {
    const auto done = calibrate(
        {"allan", text(log_), "--vehicle", text(vehicle_), "--write", "--operator", "Ada"});
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_NE(done.out.find("accepted: "), std::string::npos);
    EXPECT_GT(loadVehicle(vehicle_)->gyro_noise_rad_s_sqrthz, 0.0);
    EXPECT_TRUE(readTextFile(vehicle_)->starts_with("# ours\n"));

    const auto list = calibrate({"history", "--vehicle", text(vehicle_), "--json"});
    const auto entry = nlohmann::json::parse(list.out)["entries"][0];
    EXPECT_EQ(entry["who"], "Ada");
    EXPECT_EQ(entry["temperature_c"], 24.0);
    EXPECT_EQ(entry["taken_over"], true);

    const auto out = folder_.path() / "copy";
    EXPECT_EQ(
        calibrate({"export", "allan", "--vehicle", text(vehicle_), "--out", text(out)}).exit_code,
        0);
    EXPECT_TRUE(fs::exists(out / "samples-1.csv"));
    EXPECT_EQ(calibrate({"restore", "allan", "--before", "--vehicle", text(vehicle_)}).exit_code,
              0);
    EXPECT_EQ(readTextFile(vehicle_).value(), kVehicle);
    const auto differ = calibrate({"compare", "allan", "--vehicle", text(vehicle_)});
    EXPECT_NE(differ.out.find("gyro_noise_rad_s_sqrthz"), std::string::npos);
}

TEST_F(Calibrate, FitsAWarmUpThatBeganBeforeTheRecord) {
    Random random(2);
    std::vector<SensorReport> reports;
    for (int i = 0; i < 15000; ++i) {
        const double t_s = 0.1 * i;
        const double rate_deg_s = 0.3 - 0.2 * std::exp(-(t_s + 60.0) / 200.0);
        reports.push_back({.robot_time_s = t_s,
                           .gyro = GyroRate{radFromDeg(rate_deg_s + 0.05 * random.normal())}});
    }
    ASSERT_TRUE(saveSensorLog(log_, reports));
    const auto done = calibrate(
        {"warmup", text(log_), "--vehicle", text(vehicle_), "--on-before-s", "60", "--write"});
    ASSERT_EQ(done.exit_code, 0) << done.out << done.err;
    const auto drift = loadVehicle(vehicle_)->gyro_drift;
    ASSERT_TRUE(drift);
    EXPECT_NEAR(drift->c1_rad_s, radFromDeg(0.2), radFromDeg(0.02));
    EXPECT_NEAR(drift->c2_rad_s, radFromDeg(0.1), radFromDeg(0.02));
    EXPECT_NEAR(drift->time_s, 200.0, 20.0);
}

// Told to be steady, it is refused and says what to do; then it is found, and the record says how.
TEST_F(Calibrate, FitsAWarmUpInARoomThatChanges) {
    Random random(3);
    std::vector<SensorReport> reports;
    for (int i = 0; i < 30000; ++i) {
        const double t_s = 0.1 * i;
        const double rate_deg_s = 0.3 - 0.2 * std::exp(-t_s / 200.0) + 0.04 * t_s / 3000.0;
        reports.push_back({.robot_time_s = t_s,
                           .gyro = GyroRate{radFromDeg(rate_deg_s + 0.05 * random.normal())}});
    }
    ASSERT_TRUE(saveSensorLog(log_, reports));
    const auto steady = calibrate({"warmup", text(log_), "--vehicle", text(vehicle_)});
    EXPECT_EQ(steady.exit_code, 1);
    EXPECT_NE((steady.out + steady.err).find("Say that its temperature may change"),
              std::string::npos);
    const auto done =
        calibrate({"warmup", text(log_), "--vehicle", text(vehicle_), "--room-changes", "--write"});
    ASSERT_EQ(done.exit_code, 0) << done.out << done.err;
    const auto drift = loadVehicle(vehicle_)->gyro_drift;
    ASSERT_TRUE(drift);
    EXPECT_NEAR(drift->c1_rad_s, radFromDeg(0.2), radFromDeg(0.01));
    EXPECT_NEAR(drift->time_s, 200.0, 20.0);
    const auto list = calibrate({"history", "--vehicle", text(vehicle_), "--json"});
    EXPECT_NE(list.out.find("\"room_changes\":true"), std::string::npos) << list.out;
}

TEST_F(Calibrate, KeepsARefusedOneAndLeavesTheVehicleFile) {
    std::ofstream(log_) << "t_s,gyro_z_rad_s\n0,0.1\n0.1,0.1\n0.2,0.1\n";
    const auto done = calibrate({"allan", text(log_), "--vehicle", text(vehicle_), "--write"});
    EXPECT_EQ(done.exit_code, 1);
    EXPECT_NE(done.err.find("refused"), std::string::npos) << done.err;
    EXPECT_EQ(readTextFile(vehicle_).value(), kVehicle);
    const auto list = calibrate({"history", "--vehicle", text(vehicle_)});
    EXPECT_NE(list.out.find("refused"), std::string::npos);
}

TEST_F(Calibrate, TellsWrongUsageFromWorkThatFailed) {
    EXPECT_EQ(calibrate({}).exit_code, 2);
    EXPECT_EQ(calibrate({"alan", text(log_)}).exit_code, 2);
    EXPECT_EQ(calibrate({"allan", text(log_)}).exit_code, 2) << "a log says nothing of its robot";
    EXPECT_EQ(calibrate({"allan", text(log_), "--vehicle", "packbot", "--write"}).exit_code, 2);
    EXPECT_EQ(calibrate({"allan", "/none.csv", "--vehicle", "packbot"}).exit_code, 1);
    EXPECT_EQ(calibrate({"restore", "x", "--vehicle", text(vehicle_)}).exit_code, 1);
}

// A LabMate whose wheels are E_d 1.002 and E_b 1.005 from what its vehicle file says.
class CalibrateUmbmark : public Calibrate {
  protected:
    CalibrateUmbmark() {
        const SimulatedMission mission = simulate(UmbmarkSquares{}, 1);
        EXPECT_TRUE(saveSensorLog(log_, mission.sensors));
        std::ofstream(vehicle_) << formatVehicle(mission.vehicle);
        const std::vector<SampleSet> sets{{"log", mission.sensors}};
        std::ofstream ends(ends_);
        ends << "run,x_m,y_m\n";
        for (const SquareRun& run : squareRunsOf(sets, mission.vehicle).runs) {
            const Pose<World>& start = mission.truth[run.first].pose;
            const Vector<World> way = mission.truth[run.last].pose.position - start.position;
            const double c = std::cos(start.heading_rad);
            const double s = std::sin(start.heading_rad);
            ends << run.number << ',' << c * way.x + s * way.y << ',' << c * way.y - s * way.x
                 << '\n';
        }
    }

    fs::path ends_ = folder_.path() / "ends.csv";
};

TEST_F(CalibrateUmbmark, FindsTheWheelsAndAsksForOneMoreSquare) {
    const auto done = calibrate(
        {"umbmark", text(log_), "--ends", text(ends_), "--vehicle", text(vehicle_), "--json"});
    ASSERT_EQ(done.exit_code, 0) << done.err;
    const auto object = nlohmann::json::parse(done.out);
    EXPECT_EQ(object["found"][0]["key"], "wheelbase_m");
    EXPECT_NEAR(object["found"][0]["now"], 0.340 * 1.005, 0.0003);
    EXPECT_EQ(object["verdict"], "not_proven");
    EXPECT_NE(std::string(object["reason"]).find("one more clockwise square"), std::string::npos);
}

TEST_F(CalibrateUmbmark, NamesTheLineOfTheEndsThatIsWrong) {
    std::ofstream(ends_) << "run,x_m,y_m\n1,left,0\n";
    const auto done =
        calibrate({"umbmark", text(log_), "--ends", text(ends_), "--vehicle", text(vehicle_)});
    EXPECT_EQ(done.exit_code, 1);
    EXPECT_NE(done.err.find("ends.csv:2"), std::string::npos) << done.err;
    EXPECT_EQ(calibrate({"umbmark", text(log_), "--vehicle", text(vehicle_)}).exit_code, 2);
}

}  // namespace
}  // namespace hedr
