// The command line as scripts see it: files, figures, exit codes, one sentence for each failure.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/e2e/tool_fixture.h"

namespace hedr {
namespace {

class HedrTool : public ToolFixture {};

TEST_F(HedrTool, SimulatesFusesAndEvaluates) {
    ASSERT_EQ(run(kHedrTool, {"simulate", "packbot-corridors", "--seed", "3", "--out",
                              path("drive"), "--set", "duration_s=300"})
                  .exit_code,
              0);
    for (const char* name : {"sensors.csv", "truth.csv", "vehicle.toml", "plan.png", "plan.toml"}) {
        EXPECT_TRUE(QFile::exists(path("drive/") + name)) << name;
    }
    ASSERT_EQ(
        run(kHedrTool, {"fuse", path("drive/sensors.csv"), "--vehicle", path("drive/vehicle.toml"),
                        "--estimator", "hedr", "--out", path("track.csv")})
            .exit_code,
        0);
    const Outcome judged = run(kHedrTool, {"evaluate", path("track.csv"), "--truth",
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

TEST_F(HedrTool, TunesAGhFilterAndSaysWhetherItHelps) {
    run(kHedrTool, {"simulate", "packbot-corridors", "--seed", "3", "--out", path("drive"), "--set",
                    "duration_s=60"});
    const QStringList tune{
        "tune",      path("drive/sensors.csv"),  "--truth",    path("drive/truth.csv"),
        "--vehicle", path("drive/vehicle.toml"), "--estimator"};
    const Outcome text = run(kHedrTool, tune + QStringList{"gh_gyro"});
    EXPECT_EQ(text.exit_code, 0) << text.err.toStdString();
    EXPECT_TRUE(text.out.contains("best: --set gh_alpha=")) << text.out.toStdString();
    EXPECT_TRUE(text.out.contains("odometry alone: "));
    EXPECT_TRUE(text.out.startsWith("gain    value  mean absolute error in m  (*: the best)\n"));
    const Outcome json = run(kHedrTool, tune + QStringList{"gh_gyro", "--json"});
    const auto figures = nlohmann::json::parse(json.out.toStdString());
    EXPECT_GE(figures.at("gh_alpha"), 0.0);
    EXPECT_GE(figures.at("trials").size(), 16u);
    EXPECT_FALSE(figures.contains("gh_gamma"));
    expectFailure(tune + QStringList{"gh_combined"}, {"mag_x"});
    expectWrongUsage(tune + QStringList{"hedr"}, {"gh_magnetometer"});
}

TEST_F(HedrTool, TunesNothingWhereTheGainsMakeNoDifference) {
    write("v.toml", kGoodVehicle);
    QByteArray log = "t_s,left_ticks,right_ticks,gyro_z_rad_s\n";
    QByteArray truth = "t_s,x_m,y_m\n";
    for (int i = 0; i < 200; ++i) {
        const QByteArray t_s = QByteArray::number(0.02 * i);
        const QByteArray ticks = QByteArray::number(20 * i);
        log += t_s + ',' + ticks + ',' + ticks + ",0\n";
        truth += t_s + ',' + QByteArray::number(0.01 * i) + ",0\n";
    }
    write("straight.csv", log);
    write("truth.csv", truth);
    const Outcome text = run(kHedrTool, {"tune", path("straight.csv"), "--truth", path("truth.csv"),
                                         "--vehicle", path("v.toml"), "--estimator", "gh_gyro"});
    EXPECT_EQ(text.exit_code, 0) << text.err.toStdString();
    EXPECT_TRUE(text.out.contains("alpha makes no difference")) << text.out.toStdString();
    EXPECT_TRUE(text.out.contains("beta makes no difference")) << text.out.toStdString();
    EXPECT_FALSE(text.out.contains("best:") || text.out.contains(" *\n")) << text.out.toStdString();
}

TEST_F(HedrTool, TheSameSeedGivesTheSameFiles) {
    for (const char* folder : {"a", "b"}) {
        run(kHedrTool, {"simulate", "packbot-corridors", "--seed", "5", "--out", path(folder),
                        "--set", "duration_s=60"});
    }
    QFile a(path("a/sensors.csv"));
    QFile b(path("b/sensors.csv"));
    ASSERT_TRUE(a.open(QIODevice::ReadOnly) && b.open(QIODevice::ReadOnly));
    EXPECT_EQ(a.readAll(), b.readAll());
}

TEST_F(HedrTool, WrongUsageEndsWithTwo) {
    EXPECT_EQ(run(kHedrTool, {}).exit_code, 2);
    EXPECT_EQ(run(kHedrTool, {"fuse"}).exit_code, 2);
    EXPECT_EQ(run(kHedrTool, {"--help"}).exit_code, 0);
}

TEST_F(HedrTool, SaysInOneSentenceWhichWordsThereAre) {
    expectWrongUsage({"dance"}, {"\"dance\" is no subcommand; known are simulate, fuse"});
    expectWrongUsage({"evaluate", "t.csv", "--truth", "u.csv", "--align", "well"},
                     {"--align: \"well\" is none of none, start, rigid\n"});
    expectWrongUsage({"fuse", "m.hedr", "--out", "t.csv", "--estimator", "magic"},
                     {"--estimator: \"magic\" is none of odometry, gyro", "hedr_bayes, all\n"});
    expectWrongUsage({"fuse", "m.hedr", "--out", "t.csv", "--estimator", "hedr", "--initial", "1"},
                     {"--initial: is \"1\", must be X,Y,HEADING_DEG"});
    expectWrongUsage(
        {"fuse", "m.hedr", "--out", "t.csv", "--estimator", "gh_gyro", "--set", "gh_alpha=2"},
        {"--set: gh_alpha is \"2\", must be a number from 0 to 1\n"});
}

TEST_F(HedrTool, HelpsWithDefaultsAndPresets) {
    const QString fuse = run(kHedrTool, {"fuse", "--help"}).out;
    EXPECT_TRUE(fuse.contains("(default 0.01)")) << fuse.toStdString();
    EXPECT_TRUE(fuse.contains("packbot, labmate, romi")) << fuse.toStdString();
    const QString simulate = run(kHedrTool, {"simulate", "--help"}).out;
    EXPECT_TRUE(simulate.contains("(default 1200)")) << simulate.toStdString();
    EXPECT_TRUE(run(kHedrTool, {"evaluate", "--help"}).out.contains("none (the default)"));
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

TEST_F(HedrTool, RefusesWhatIsNoMission) {
    write("picture.hedr", "\x89PNG\r\n");
    expectFailure({"info", path("picture.hedr")}, {"picture.hedr"});
    expectFailure({"record", "--port", path("none"), "--out", path("m.hedr")}, {"none"});
    EXPECT_FALSE(QFile::exists(path("m.hedr")));
}

TEST_F(HedrTool, ReadsALogFromAPipe) {
    QProcess process;
    process.start(kHedrTool, {"fuse", "/dev/stdin", "--vehicle", "packbot", "--estimator",
                              "odometry", "--out", path("track.csv")});
    process.write("t_s,left_m,right_m\n0,0,0\n1,1,1\n");
    process.closeWriteChannel();
    EXPECT_TRUE(process.waitForFinished());
    EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
    EXPECT_TRUE(QFile::exists(path("track.csv")));
}

}  // namespace
}  // namespace hedr
