// `hedr fuse`: one track or all, of a log or a mission, and what it says of them.
#include <gtest/gtest.h>

#include <QDir>
#include <QProcess>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <span>

#include "core/mission/mission_writer.h"
#include "core/robot/sensor_csv.h"
#include "tests/e2e/tool_fixture.h"
#include "tests/radio/spoken_drive.h"

namespace hedr {
namespace {

class HedrFuse : public ToolFixture {};

// The rows of a table by their first word.
std::map<QString, QStringList> rowsOf(const QString& table) {
    std::map<QString, QStringList> rows;
    for (const QString& line : table.split('\n')) {
        const QStringList words = line.split(' ', Qt::SkipEmptyParts);
        if (!words.isEmpty()) rows[words.first()] = words.mid(1);
    }
    return rows;
}

TEST_F(HedrFuse, FusesByAllEstimatorsIntoAFolderAndOneTable) {
    ASSERT_EQ(run(kHedrTool, {"simulate", "packbot-45", "--seed", "3", "--out", path("drive"),
                              "--set", "duration_s=120"})
                  .exit_code,
              0);
    const Outcome fused =
        run(kHedrTool, {"fuse", path("drive/sensors.csv"), "--vehicle", path("drive/vehicle.toml"),
                        "--estimator", "all", "--out", path("tracks")});
    EXPECT_EQ(fused.exit_code, 0);
    for (const char* name : {"odometry", "gyro", "gyrodometry", "hedr", "hedr_bayes"}) {
        EXPECT_TRUE(fused.out.contains(name)) << name;
        EXPECT_TRUE(QFile::exists(path("tracks/") + name + ".csv")) << name;
    }
    QFile track(path("tracks/hedr_bayes.csv"));
    ASSERT_TRUE(track.open(QIODevice::ReadOnly));
    EXPECT_EQ(track.readLine().trimmed(),
              "t_s,x_m,y_m,heading_rad,var_x_m2,cov_xy_m2,var_y_m2,var_heading_rad2,"
              "gyro_bias_rad_s");
}

TEST_F(HedrFuse, PutsATruthBesideAllEstimators) {
    run(kHedrTool, {"simulate", "packbot-corridors", "--seed", "3", "--out", path("drive"), "--set",
                    "duration_s=120"});
    const QStringList fuse{"fuse",      path("drive/sensors.csv"),
                           "--vehicle", path("drive/vehicle.toml"),
                           "--out",     path("tracks"),
                           "--truth",   path("drive/truth.csv")};
    const Outcome fused = run(kHedrTool, fuse + QStringList{"--estimator", "all"});
    ASSERT_EQ(fused.exit_code, 0) << fused.err.toStdString();
    auto rows = rowsOf(fused.out);
    const QStringList columns = rows.at("estimator");
    for (const char* name : {"odometry", "hedr_bayes"}) {
        const Outcome judged =
            run(kHedrTool, {"evaluate", path("tracks/") + name + ".csv", "--truth",
                            path("drive/truth.csv"), "--align", "start", "--json"});
        const auto figures = nlohmann::json::parse(judged.out.toStdString());
        for (const char* figure : {"heading_rmse_deg", "ape_rmse_m", "end_position_error_m"}) {
            const QString shown = rows.at(name).at(columns.indexOf(figure));
            EXPECT_NEAR(shown.toDouble(), figures.at(figure), 0.005 + 1e-9) << name << figure;
        }
    }
    const QStringList lines = fused.out.split('\n', Qt::SkipEmptyParts);
    for (const QString& line : lines) {
        // Not in the table.
        if (line.contains(" cannot run: ") || line.startsWith("sigma:")) continue;
        EXPECT_EQ(line.size(), lines.first().size()) << line.toStdString();
    }
    expectWrongUsage(fuse + QStringList{"--estimator", "hedr"}, {"--truth", "all"});
    write("later.csv", "t_s,x_m,y_m\n9000,0,0\n9001,0,0\n");
    expectFailure({"fuse", path("drive/sensors.csv"), "--vehicle", path("drive/vehicle.toml"),
                   "--estimator", "all", "--truth", path("later.csv"), "--out", path("none")},
                  {"matches the truth in time"});
    EXPECT_FALSE(QFile::exists(path("none")));
    EXPECT_TRUE(fused.out.contains("sigma: one standard deviation")) << fused.out.toStdString();
}

const char* const kReasons =
    "gyro_kalman cannot run: the vehicle file lacks gyro_drift_c1_rad_s, gyro_drift_c2_rad_s and "
    "gyro_drift_time_s (fitted to a log of the robot at rest, from switch-on)\n"
    "gh_magnetometer cannot run: there is no magnetometer (mag_x, mag_y, mag_z)\n"
    "gh_combined cannot run: there is no magnetometer (mag_x, mag_y, mag_z)\n";

TEST_F(HedrFuse, SaysOfALogWhyAnEstimatorCannotRun) {
    write("v.toml", kGoodVehicle);
    write("log.csv", "t_s,left_ticks,right_ticks,gyro_z_rad_s\n0,1,2,0\n0.1,3,4,0\n");
    const QStringList fuse{"fuse",  path("log.csv"), "--vehicle",  path("v.toml"),
                           "--out", path("out"),     "--estimator"};
    const Outcome all = run(kHedrTool, fuse + QStringList{"all"});
    EXPECT_TRUE(all.out.endsWith(kReasons)) << all.out.toStdString();
    expectFailure(fuse + QStringList{"gh_magnetometer"},
                  {"it has no magnetometer (mag_x, mag_y, mag_z), which gh_magnetometer needs"});
    expectFailure({"fuse", path("log.csv"), "--vehicle", "nopreset", "--out", path("out"),
                   "--estimator", "hedr"},
                  {"nopreset", "packbot, labmate, romi"});
}

// Up a corridor, then `times` a wide arc, which no corridor is, and a straight.
std::vector<SensorReport> arcs(int times) {
    constexpr double kStep_s = 0.05;
    const double track_m = spokenVehicle().geometry.wheelbase_m;
    std::vector<SensorReport> reports;
    double left_m = 0.0;
    double right_m = 0.0;
    const auto drive = [&](double seconds, double speed_m_s, double rate_rad_s) {
        for (double t_s = 0.0; t_s < seconds; t_s += kStep_s) {
            left_m += kStep_s * (speed_m_s - rate_rad_s * track_m / 2.0);
            right_m += kStep_s * (speed_m_s + rate_rad_s * track_m / 2.0);
            const WheelTicks ticks{std::llround(1000.0 * left_m), std::llround(1000.0 * right_m)};
            reports.push_back({.robot_time_s = kStep_s * static_cast<double>(reports.size()),
                               .odometry = ticks,
                               .gyro = GyroRate{rate_rad_s}});
        }
    };
    drive(3.0, 0.0, 0.0);
    drive(60.0, 0.5, 0.0);
    for (int i = 0; i < times; ++i) {
        drive(157.0, 0.5, 0.02);
        drive(60.0, 0.5, 0.0);
    }
    return reports;
}

TEST_F(HedrFuse, NamesTheEstimatorThatLostTheCorridors) {
    write("v.toml", formatVehicle(spokenVehicle()).c_str());
    const auto fuse = [&](int times, const QString& estimator) {
        EXPECT_TRUE(saveSensorLog(path("log.csv").toStdString(), arcs(times)));
        return run(kHedrTool, {"fuse", path("log.csv"), "--vehicle", path("v.toml"), "--estimator",
                               estimator, "--out", path("out_" + estimator)})
            .err;
    };
    const QString alone = fuse(1, "hedr");
    EXPECT_TRUE(alone.startsWith("hedr: LOST LOCK from ")) << alone.toStdString();
    EXPECT_EQ(alone.count('\n'), 1);
    const QString beside = fuse(2, "all");
    EXPECT_TRUE(beside.startsWith("hedr: LOST LOCK from ")) << beside.toStdString();
    EXPECT_GT(beside.indexOf("hedr_bayes: LOST"), beside.lastIndexOf("hedr: LOST"));
    const QString many = fuse(7, "hedr");
    EXPECT_TRUE(many.startsWith("hedr: LOST LOCK 7 times, ")) << many.toStdString();
    EXPECT_EQ(many.count('\n'), 1);
}

TEST_F(HedrFuse, SaysOfAMissionWhatItSaysOfItsLog) {
    write("v.toml", formatVehicle(spokenVehicle()).c_str());
    auto mission = MissionWriter::create(path("m.hedr").toStdString(), {});
    ASSERT_TRUE(mission && mission->writeVehicle(spokenVehicle()));
    const std::vector<std::uint8_t> bytes = spoken(arcs(1));
    constexpr std::size_t kRow = 64;
    for (std::size_t at = 0; at < bytes.size(); at += kRow) {
        const auto row = std::span(bytes).subspan(at, std::min(kRow, bytes.size() - at));
        ASSERT_TRUE(mission->writeBytes(1e-3 * static_cast<double>(at), row));
    }
    ASSERT_TRUE(mission->commit());
    ASSERT_TRUE(saveSensorLog(path("log.csv").toStdString(), arcs(1)));
    const auto said = [&](const QString& input, const QString& estimator) {
        return run(kHedrTool, {"fuse", path(input), "--vehicle", path("v.toml"), "--estimator",
                               estimator, "--out", path("out_" + estimator)})
            .err;
    };
    for (const char* estimator : {"hedr", "hedr_bayes", "all"}) {
        const QString of_mission = said("m.hedr", estimator);
        EXPECT_TRUE(of_mission.contains(": LOST LOCK from ")) << estimator;
        EXPECT_EQ(of_mission.toStdString(), said("log.csv", estimator).toStdString());
    }
}

TEST_F(HedrFuse, RefusesAKnobOfAnotherEstimator) {
    write("v.toml", kGoodVehicle);
    write("log.csv", "t_s,left_ticks,right_ticks,gyro_z_rad_s\n0,1,2,0\n0.1,3,4,0\n");
    const auto fuse = [&](const QString& estimator, const QString& setting) {
        return QStringList{
            "fuse",    path("log.csv"), "--vehicle", path("v.toml"), "--estimator",
            estimator, "--set",         setting,     "--out",        path("out_" + estimator)};
    };
    expectWrongUsage(fuse("odometry", "gain_deg_s2=3"),
                     {"--set: gain_deg_s2 is for hedr, not for odometry\n"});
    expectWrongUsage(fuse("gh_gyro", "gh_gamma=0.5"), {"gh_gamma is for gh_combined"});
    for (const char* estimator : {"gh_gyro", "all"}) {
        EXPECT_EQ(run(kHedrTool, fuse(estimator, "gh_alpha=0.5")).exit_code, 0) << estimator;
    }
}

TEST_F(HedrFuse, FusesAMissionByAllEstimators) {
    run(kHedrTool, {"simulate", "packbot-corridors", "--seed", "3", "--out", path("drive"), "--set",
                    "duration_s=60"});
    QProcess robot;
    robot.start(kHedrTool, {"replay", path("drive/sensors.csv"), "--vehicle",
                            path("drive/vehicle.toml"), "--pty", path("robot"), "--speed", "20"});
    ASSERT_TRUE(QTest::qWaitFor([&] { return QFile::exists(path("robot")); }, 10000));
    QProcess recorder;
    recorder.start(kHedrTool, {"record", "--port", path("robot"), "--out", path("m.hedr")});
    ASSERT_TRUE(robot.waitForFinished(30000));
    recorder.terminate();
    ASSERT_TRUE(recorder.waitForFinished(10000));

    const Outcome fused = run(kHedrTool, {"fuse", path("m.hedr"), "--estimator", "all", "--truth",
                                          path("drive/truth.csv"), "--out", path("tracks")});
    ASSERT_EQ(fused.exit_code, 0) << fused.err.toStdString();
    EXPECT_TRUE(fused.out.endsWith(kReasons + QString("bit for bit the live tracks\n")))
        << fused.out.toStdString();
    const auto rows = rowsOf(fused.out);
    const auto ape = rows.at("estimator").indexOf("ape_rmse_m");
    for (const char* name : {"odometry", "gyro", "gyrodometry", "hedr", "hedr_bayes", "robot"}) {
        ASSERT_TRUE(rows.contains(name)) << name;
        EXPECT_LT(rows.at(name).at(ape).toDouble(), 3.0) << name;
        EXPECT_TRUE(QFile::exists(path("tracks/") + name + ".csv")) << name;
    }
    run(kHedrTool, {"fuse", path("m.hedr"), "--estimator", "gyro", "--out", path("gyro.csv")});
    QFile alone(path("gyro.csv"));
    QFile beside(path("tracks/gyro.csv"));
    ASSERT_TRUE(alone.open(QIODevice::ReadOnly) && beside.open(QIODevice::ReadOnly));
    EXPECT_EQ(alone.readAll(), beside.readAll());

    const Outcome changed = run(kHedrTool, {"fuse", path("m.hedr"), "--estimator", "all", "--set",
                                            "gain_deg_s2=0.02", "--out", path("tracks")});
    EXPECT_TRUE(changed.out.endsWith("not the live track: hedr\n")) << changed.out.toStdString();
}

TEST_F(HedrFuse, NamesTheVehiclesKeysThatAnEstimatorNeeds) {
    write("v.toml", kGoodVehicle);
    write(
        "log.csv",
        "t_s,left_ticks,right_ticks,gyro_z_rad_s,mag_x,mag_y,mag_z\n0,1,2,0,,,\n0.1,3,4,0,1,2,3\n");
    const auto fuse = [&](const QString& estimator, const QString& vehicle) {
        return QStringList{"fuse",        path("log.csv"), "--vehicle", path(vehicle),
                           "--estimator", estimator,       "--out",     path("t.csv")};
    };
    expectFailure(fuse("gyro_kalman", "v.toml"),
                  {"v.toml", "gyro_drift_c1_rad_s", "gyro_drift_c2_rad_s", "gyro_drift_time_s"});
    for (const char* name : {"gh_magnetometer", "gh_combined"}) {
        expectFailure(fuse(name, "v.toml"), {"v.toml", "mag_centre_x", "mag_range_y", "rotation"});
    }
    write("half.toml", QByteArray(kGoodVehicle) + "gyro_drift_time_s = 300\n");
    expectFailure(fuse("gyro_kalman", "half.toml"), {"half.toml", "gyro_drift_c1_rad_s"});
    write("whole.toml", QByteArray(kGoodVehicle) +
                            "gyro_drift_time_s = 300\ngyro_drift_c1_rad_s = 0\n"
                            "gyro_drift_c2_rad_s = 0\nmag_centre_x = 0\nmag_centre_y = 0\n"
                            "mag_range_x = 3\nmag_range_y = 3\n");
    for (const char* name : {"gyro_kalman", "gh_magnetometer", "gh_combined"}) {
        EXPECT_EQ(run(kHedrTool, fuse(name, "whole.toml")).exit_code, 0) << name;
    }
}

TEST_F(HedrFuse, CountsTheSamplesThatItLeavesOut) {
    write("v.toml", kGoodVehicle);
    QByteArray log = "t_s,left_ticks,right_ticks,gyro_z_rad_s\n";
    for (int i = 0; i < 400; ++i) {
        const double t_s = i < 300 ? 0.02 * i : 0.02 * (i - 300);  // time goes back once
        const long long jump = i == 100 ? 1LL << 31 : 0;
        const double rate = i == 150 ? 1e300 : 0.0;
        const double gap_s = i >= 200 && i < 300 ? 3600.0 : 0.0;
        log += QByteArray::number(t_s + gap_s) + ',' + QByteArray::number(20 * i + jump) + ',' +
               QByteArray::number(20 * i) + ',' + QByteArray::number(rate) + '\n';
    }
    write("log.csv", log);
    const Outcome fused = run(kHedrTool, {"fuse", path("log.csv"), "--vehicle", path("v.toml"),
                                          "--estimator", "all", "--out", path("tracks")});
    EXPECT_EQ(fused.exit_code, 0);
    EXPECT_TRUE(fused.err.contains("2 samples left out")) << fused.err.toStdString();
    EXPECT_TRUE(fused.err.contains("went back or jumped 1 times")) << fused.err.toStdString();
    for (const char* name : {"odometry", "gyro", "gyrodometry", "gh_gyro", "hedr", "hedr_bayes"}) {
        QFile track(path("tracks/") + name + ".csv");
        ASSERT_TRUE(track.open(QIODevice::ReadOnly)) << name;
        const QByteArray text = track.readAll();
        EXPECT_GT(text.count('\n'), 390) << name;
        EXPECT_FALSE(text.contains("nan") || text.contains("inf")) << name;
    }
}

TEST_F(HedrFuse, OverwritesNoSource) {
    write("v.toml", kGoodVehicle);
    write("log.csv", "t_s,left_ticks,right_ticks\n0,1,2\n0.1,3,4\n");
    for (const char* source : {"log.csv", "v.toml"}) {
        expectWrongUsage({"fuse", path("log.csv"), "--vehicle", path("v.toml"), "--estimator",
                          "hedr", "--out", path(source)},
                         {source});
    }
    QDir().mkpath(path("tracks"));
    ASSERT_TRUE(QFile::rename(path("log.csv"), path("tracks/gyro.csv")));
    expectWrongUsage({"fuse", path("tracks/gyro.csv"), "--vehicle", path("v.toml"), "--estimator",
                      "all", "--out", path("tracks")},
                     {"gyro.csv"});
}

}  // namespace
}  // namespace hedr
