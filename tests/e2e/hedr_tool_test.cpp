// The command line as scripts see it: files, figures, exit codes, one sentence for each failure.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/e2e/program.h"

namespace hedr {
namespace {

class HedrTool : public ::testing::Test {
  protected:
    QString path(const QString& name) const { return folder_.filePath(name); }

    void write(const QString& name, const QByteArray& text) const {
        QFile file(path(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    }

    // One line, the program's name, the words; exit code 1.
    void expectFailure(const QStringList& arguments, const QStringList& words) const {
        const Outcome outcome = run(kHedr, arguments);
        const std::string said = outcome.err.toStdString();
        EXPECT_EQ(outcome.exit_code, 1) << said;
        EXPECT_EQ(outcome.err.count('\n'), 1) << said;
        EXPECT_TRUE(outcome.err.startsWith("hedr: ")) << said;
        for (const QString& word : words) EXPECT_TRUE(outcome.err.contains(word)) << said;
    }

    void expectWrongUsage(const QStringList& arguments, const QStringList& words) const {
        const Outcome outcome = run(kHedr, arguments);
        EXPECT_EQ(outcome.exit_code, 2) << outcome.err.toStdString();
        for (const QString& word : words) {
            EXPECT_TRUE(outcome.err.contains(word)) << outcome.err.toStdString();
        }
    }

    static constexpr const char* kGoodVehicle =
        "name = \"v\"\nleft_wheel_diameter_m = 0.2\nright_wheel_diameter_m = 0.2\n"
        "wheelbase_m = 0.4\nticks_per_revolution = 1000\n";

    QTemporaryDir folder_;
};

TEST_F(HedrTool, SimulatesFusesAndEvaluates) {
    ASSERT_EQ(run(kHedr, {"simulate", "packbot-corridors", "--seed", "3", "--out", path("drive"),
                          "--set", "duration_s=300"})
                  .exit_code,
              0);
    for (const char* name : {"sensors.csv", "truth.csv", "vehicle.toml", "plan.png", "plan.toml"}) {
        EXPECT_TRUE(QFile::exists(path("drive/") + name)) << name;
    }
    ASSERT_EQ(
        run(kHedr, {"fuse", path("drive/sensors.csv"), "--vehicle", path("drive/vehicle.toml"),
                    "--estimator", "hedr", "--out", path("track.csv")})
            .exit_code,
        0);
    const Outcome judged = run(kHedr, {"evaluate", path("track.csv"), "--truth",
                                       path("drive/truth.csv"), "--align", "start", "--json"});
    const auto figures = nlohmann::json::parse(judged.out.toStdString());
    EXPECT_LT(figures.at("heading_rmse_deg"), 3.0);
    for (const char* name :
         {"samples", "duration_s", "distance_m", "end_position_error_m", "end_heading_error_deg",
          "return_position_error_m", "return_position_error_percent", "heading_max_deg",
          "ape_rmse_m", "ape_mean_m", "ape_median_m", "ape_max_m"}) {
        EXPECT_TRUE(figures.contains(name)) << name;
    }
}

TEST_F(HedrTool, FusesByAllEstimatorsIntoAFolderAndOneTable) {
    ASSERT_EQ(run(kHedr, {"simulate", "packbot-45", "--seed", "3", "--out", path("drive"), "--set",
                          "duration_s=120"})
                  .exit_code,
              0);
    const Outcome fused =
        run(kHedr, {"fuse", path("drive/sensors.csv"), "--vehicle", path("drive/vehicle.toml"),
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

// The rows of a table by their first word.
std::map<QString, QStringList> rowsOf(const QString& table) {
    std::map<QString, QStringList> rows;
    for (const QString& line : table.split('\n')) {
        const QStringList words = line.split(' ', Qt::SkipEmptyParts);
        if (!words.isEmpty()) rows[words.first()] = words.mid(1);
    }
    return rows;
}

TEST_F(HedrTool, PutsATruthBesideAllEstimators) {
    run(kHedr, {"simulate", "packbot-corridors", "--seed", "3", "--out", path("drive"), "--set",
                "duration_s=120"});
    const QStringList fuse{"fuse",      path("drive/sensors.csv"),
                           "--vehicle", path("drive/vehicle.toml"),
                           "--out",     path("tracks"),
                           "--truth",   path("drive/truth.csv")};
    const Outcome fused = run(kHedr, fuse + QStringList{"--estimator", "all"});
    ASSERT_EQ(fused.exit_code, 0) << fused.err.toStdString();
    auto rows = rowsOf(fused.out);
    const QStringList columns = rows.at("estimator");
    for (const char* name : {"odometry", "hedr_bayes"}) {
        const Outcome judged = run(kHedr, {"evaluate", path("tracks/") + name + ".csv", "--truth",
                                           path("drive/truth.csv"), "--align", "start", "--json"});
        const auto figures = nlohmann::json::parse(judged.out.toStdString());
        for (const char* figure : {"heading_rmse_deg", "ape_rmse_m", "end_position_error_m"}) {
            const QString shown = rows.at(name).at(columns.indexOf(figure));
            EXPECT_NEAR(shown.toDouble(), figures.at(figure), 0.005 + 1e-9) << name << figure;
        }
    }
    const QStringList lines = fused.out.split('\n', Qt::SkipEmptyParts);
    for (const QString& line : lines) {
        if (line.contains(" needs ")) continue;  // not in the table
        EXPECT_EQ(line.size(), lines.first().size()) << line.toStdString();
    }
    expectWrongUsage(fuse + QStringList{"--estimator", "hedr"}, {"--truth", "all"});
    write("later.csv", "t_s,x_m,y_m\n9000,0,0\n9001,0,0\n");
    expectFailure({"fuse", path("drive/sensors.csv"), "--vehicle", path("drive/vehicle.toml"),
                   "--estimator", "all", "--truth", path("later.csv"), "--out", path("none")},
                  {"matches the truth in time"});
    EXPECT_FALSE(QFile::exists(path("none")));
}

TEST_F(HedrTool, FusesAMissionByAllEstimators) {
    run(kHedr, {"simulate", "packbot-corridors", "--seed", "3", "--out", path("drive"), "--set",
                "duration_s=60"});
    QProcess robot;
    robot.start(kHedr, {"replay", path("drive/sensors.csv"), "--vehicle",
                        path("drive/vehicle.toml"), "--pty", path("robot"), "--speed", "20"});
    ASSERT_TRUE(QTest::qWaitFor([&] { return QFile::exists(path("robot")); }, 10000));
    QProcess recorder;
    recorder.start(kHedr, {"record", "--port", path("robot"), "--out", path("m.hedr")});
    ASSERT_TRUE(robot.waitForFinished(30000));
    recorder.terminate();
    ASSERT_TRUE(recorder.waitForFinished(10000));

    const Outcome fused = run(kHedr, {"fuse", path("m.hedr"), "--estimator", "all", "--truth",
                                      path("drive/truth.csv"), "--out", path("tracks")});
    ASSERT_EQ(fused.exit_code, 0) << fused.err.toStdString();
    EXPECT_TRUE(fused.out.endsWith("bit for bit the live tracks\n")) << fused.out.toStdString();
    const auto rows = rowsOf(fused.out);
    const auto ape = rows.at("estimator").indexOf("ape_rmse_m");
    for (const char* name : {"odometry", "gyro", "gyrodometry", "hedr", "hedr_bayes", "robot"}) {
        ASSERT_TRUE(rows.contains(name)) << name;
        EXPECT_LT(rows.at(name).at(ape).toDouble(), 3.0) << name;
        EXPECT_TRUE(QFile::exists(path("tracks/") + name + ".csv")) << name;
    }
    run(kHedr, {"fuse", path("m.hedr"), "--estimator", "gyro", "--out", path("gyro.csv")});
    QFile alone(path("gyro.csv"));
    QFile beside(path("tracks/gyro.csv"));
    ASSERT_TRUE(alone.open(QIODevice::ReadOnly) && beside.open(QIODevice::ReadOnly));
    EXPECT_EQ(alone.readAll(), beside.readAll());

    const Outcome changed = run(kHedr, {"fuse", path("m.hedr"), "--estimator", "all", "--set",
                                        "gain_deg_s2=0.02", "--out", path("tracks")});
    EXPECT_TRUE(changed.out.endsWith("not the live track: hedr\n")) << changed.out.toStdString();
}

TEST_F(HedrTool, TunesAGhFilterAndSaysWhetherItHelps) {
    run(kHedr, {"simulate", "packbot-corridors", "--seed", "3", "--out", path("drive"), "--set",
                "duration_s=60"});
    const QStringList tune{
        "tune",      path("drive/sensors.csv"),  "--truth",    path("drive/truth.csv"),
        "--vehicle", path("drive/vehicle.toml"), "--estimator"};
    const Outcome text = run(kHedr, tune + QStringList{"gh_gyro"});
    EXPECT_EQ(text.exit_code, 0) << text.err.toStdString();
    EXPECT_TRUE(text.out.contains("best: --set gh_alpha=")) << text.out.toStdString();
    EXPECT_TRUE(text.out.contains("odometry alone: "));
    const Outcome json = run(kHedr, tune + QStringList{"gh_gyro", "--json"});
    const auto figures = nlohmann::json::parse(json.out.toStdString());
    EXPECT_GE(figures.at("gh_alpha"), 0.0);
    EXPECT_GE(figures.at("trials").size(), 16u);
    EXPECT_FALSE(figures.contains("gh_gamma"));
    expectFailure(tune + QStringList{"gh_combined"}, {"mag_x"});
    expectWrongUsage(tune + QStringList{"hedr"}, {"gh_magnetometer"});
}

TEST_F(HedrTool, TheSameSeedGivesTheSameFiles) {
    for (const char* folder : {"a", "b"}) {
        run(kHedr, {"simulate", "packbot-corridors", "--seed", "5", "--out", path(folder), "--set",
                    "duration_s=60"});
    }
    QFile a(path("a/sensors.csv"));
    QFile b(path("b/sensors.csv"));
    ASSERT_TRUE(a.open(QIODevice::ReadOnly) && b.open(QIODevice::ReadOnly));
    EXPECT_EQ(a.readAll(), b.readAll());
}

TEST_F(HedrTool, WrongUsageEndsWithTwo) {
    EXPECT_EQ(run(kHedr, {}).exit_code, 2);
    EXPECT_EQ(run(kHedr, {"dance"}).exit_code, 2);
    EXPECT_EQ(run(kHedr, {"fuse"}).exit_code, 2);
    EXPECT_EQ(run(kHedr, {"evaluate", "t.csv", "--truth", "u.csv", "--align", "well"}).exit_code,
              2);
    EXPECT_EQ(run(kHedr, {"--help"}).exit_code, 0);
}

TEST_F(HedrTool, NamesTheFileThatIsMissing) {
    expectFailure({"info", path("no.hedr")}, {"no.hedr"});
    expectFailure({"evaluate", path("no.csv"), "--truth", path("no.csv")}, {"no.csv"});
    write("v.toml", kGoodVehicle);
    expectFailure({"fuse", path("no.csv"), "--vehicle", path("v.toml"), "--estimator", "hedr",
                   "--out", path("t.csv")},
                  {"no.csv"});
}

TEST_F(HedrTool, NamesTheLineOfADamagedLog) {
    write("v.toml", kGoodVehicle);
    const auto fuse = [&](const QString& name) {
        return QStringList{"fuse",        path(name), "--vehicle", path("v.toml"),
                           "--estimator", "odometry", "--out",     path("t.csv")};
    };
    write("empty.csv", "");
    expectFailure(fuse("empty.csv"), {"empty.csv"});
    write("short.csv", "t_s,left_ticks,right_ticks\n0,1,2\n0.1,3\n");
    expectFailure(fuse("short.csv"), {"short.csv:3"});
    write("text.csv", "t_s,left_ticks,right_ticks\n0,1,2\n0.1,many,2\n");
    expectFailure(fuse("text.csv"), {"text.csv:3", "left_ticks"});
    write("untimed.csv", "left_ticks,right_ticks\n1,2\n");
    expectFailure(fuse("untimed.csv"), {"t_s"});
    write("magnetic.csv", "t_s,mag_x,mag_y,mag_z\n0,1,2,3\n");
    expectFailure(fuse("magnetic.csv"), {"magnetic.csv"});
    EXPECT_FALSE(QFile::exists(path("t.csv")));
}

TEST_F(HedrTool, NamesTheKeyOfABadVehicle) {
    write("log.csv", "t_s,left_ticks,right_ticks\n0,1,2\n0.1,3,4\n");
    const auto expectBad = [&](const QByteArray& from, const QByteArray& to, const QString& word) {
        write("bad.toml", QByteArray(kGoodVehicle).replace(from, to));
        expectFailure({"fuse", path("log.csv"), "--vehicle", path("bad.toml"), "--estimator",
                       "hedr", "--out", path("t.csv")},
                      {"bad.toml", word});
    };
    expectBad("wheelbase_m = 0.4", "wheelbase_m = \"wide\"", "wheelbase_m");
    expectBad("left_wheel_diameter_m = 0.2", "left_wheel_diameter_m = -0.2",
              "left_wheel_diameter_m");
    expectBad("wheelbase_m = 0.4\n", "", "wheelbase_m");
    expectBad("wheelbase_m", "wheelbsae_m", "wheelbsae_m");
    expectBad("= 0.4", "= ", "bad.toml:4");
}

TEST_F(HedrTool, SaysWhichEstimatorsAndKeysThereAre) {
    write("v.toml", kGoodVehicle);
    write("log.csv", "t_s,left_ticks,right_ticks\n0,1,2\n0.1,3,4\n");
    const QStringList fuse{"fuse",         path("log.csv"), "--vehicle",
                           path("v.toml"), "--out",         path("t.csv")};
    expectFailure(fuse + QStringList{"--estimator", "gyro"}, {"gyro_z_rad_s"});
    expectWrongUsage(fuse + QStringList{"--estimator", "magic"}, {"magic", "gyrodometry"});
    expectWrongUsage(fuse + QStringList{"--estimator", "hedr", "--set", "gain=1"},
                     {"gain", "gain_deg_s2"});
    expectWrongUsage(fuse + QStringList{"--estimator", "hedr", "--initial", "1,2"},
                     {"X,Y,HEADING"});
    expectWrongUsage({"simulate", "moon-base", "--seed", "1", "--out", path("x")},
                     {"moon-base", "packbot-corridors"});
    expectWrongUsage({"fuse", path("log.csv"), "--estimator", "hedr", "--out", path("t.csv")},
                     {"--vehicle"});
    expectWrongUsage({"record", "--port", "x", "--out", ""}, {"--out"});
    expectWrongUsage({"replay", path("log.csv"), "--vehicle", path("v.toml"), "--pty", path("l"),
                      "--speed", "nan"},
                     {"nan"});
}

TEST_F(HedrTool, NamesTheVehiclesKeysThatAnEstimatorNeeds) {
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
        EXPECT_EQ(run(kHedr, fuse(name, "whole.toml")).exit_code, 0) << name;
    }
}

TEST_F(HedrTool, CountsTheSamplesThatItLeavesOut) {
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
    const Outcome fused = run(kHedr, {"fuse", path("log.csv"), "--vehicle", path("v.toml"),
                                      "--estimator", "all", "--out", path("tracks")});
    EXPECT_EQ(fused.exit_code, 0);
    EXPECT_TRUE(fused.err.contains("2 samples left out")) << fused.err.toStdString();
    EXPECT_TRUE(fused.err.contains("went back 1 times")) << fused.err.toStdString();
    for (const char* name : {"odometry", "gyro", "gyrodometry", "gh_gyro", "hedr", "hedr_bayes"}) {
        QFile track(path("tracks/") + name + ".csv");
        ASSERT_TRUE(track.open(QIODevice::ReadOnly)) << name;
        const QByteArray text = track.readAll();
        EXPECT_GT(text.count('\n'), 390) << name;
        EXPECT_FALSE(text.contains("nan") || text.contains("inf")) << name;
    }
}

TEST_F(HedrTool, OverwritesNoSource) {
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

TEST_F(HedrTool, RefusesWhatIsNoMission) {
    write("picture.hedr", "\x89PNG\r\n");
    expectFailure({"info", path("picture.hedr")}, {"picture.hedr"});
    expectFailure({"record", "--port", path("none"), "--out", path("m.hedr")}, {"none"});
    EXPECT_FALSE(QFile::exists(path("m.hedr")));
}

}  // namespace
}  // namespace hedr
