// Logs and tracks whose numbers say nothing: the command line names file and reason, and leaves
// what is there alone.
#include <gtest/gtest.h>

#include <QDir>

#include "tests/e2e/tool_fixture.h"

namespace hedr {
namespace {

class UnusableNumbers : public ToolFixture {
  protected:
    QByteArray read(const QString& name) const {
        QFile file(path(name));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
        return file.readAll();
    }

    QStringList fuse(const QString& estimator, const QString& out) const {
        return {"fuse",        path("log.csv"), "--vehicle", path("v.toml"),
                "--estimator", estimator,       "--out",     path(out)};
    }
};

TEST_F(UnusableNumbers, OfALogWithoutMotionLeaveTheOldTracks) {
    write("v.toml", kGoodVehicle);
    QDir().mkpath(path("tracks"));
    write("good.csv", "t_s,x_m,y_m\n0,1,2\n");
    write("tracks/odometry.csv", "t_s,x_m,y_m\n0,1,2\n");
    const QByteArray header = "t_s,left_ticks,right_ticks\n";
    const std::vector<std::pair<QByteArray, QString>> logs{
        {"1600000000000,0,0\n1600000000020,9,9\n1600000000040,19,19\n",
         "all of its 3 samples were left out, their times are too large: t_s is in seconds"},
        {"0,1,2\n", "it has one sample"},
        {"0,1,2\n0,3,4\n0,5,6\n", "the times of its 3 samples never go forward"},
        {"2,1,2\n1,3,4\n", "the times of its 2 samples never go forward"},
        {"0,1,2\n20000000,3,4\n", "left out: 1, too fast to be true or a day apart"}};
    for (const auto& [rows, reason] : logs) {
        write("log.csv", header + rows);
        expectFailure(fuse("odometry", "good.csv"), {path("log.csv"), reason});
        expectFailure(fuse("all", "tracks"), {path("log.csv"), reason});
        expectFailure(fuse("all", "none"), {path("log.csv"), reason});
    }
    EXPECT_EQ(read("good.csv"), "t_s,x_m,y_m\n0,1,2\n");
    EXPECT_EQ(read("tracks/odometry.csv"), "t_s,x_m,y_m\n0,1,2\n");
    EXPECT_FALSE(QFile::exists(path("none")));
}

TEST_F(UnusableNumbers, OfALogAreToldByTuneAsByFuse) {
    write("v.toml", kGoodVehicle);
    QByteArray log = "t_s,left_ticks,right_ticks,gyro_z_rad_s,battery_v\n";
    QByteArray truth = "t_s,x_m,y_m\n";
    for (int i = 0; i < 100; ++i) {
        const QByteArray t_s = QByteArray::number(i == 50 ? 1.6e12 : 0.02 * i);
        const QByteArray ticks = QByteArray::number(20 * i);
        log += t_s + ',' + ticks + ',' + ticks + ",0,12\n";
        truth += QByteArray::number(0.02 * i) + ',' + QByteArray::number(0.01 * i) + ",0\n";
    }
    write("log.csv", log);
    write("truth.csv", truth);
    const QStringList tune{"tune",    path("log.csv"),   "--vehicle",   path("v.toml"),
                           "--truth", path("truth.csv"), "--estimator", "gh_gyro"};
    const QString of_fuse = run(kHedrTool, fuse("gh_gyro", "track.csv")).err;
    EXPECT_TRUE(of_fuse.contains("not used: battery_v\n")) << of_fuse.toStdString();
    EXPECT_TRUE(of_fuse.contains(": 1 samples left out")) << of_fuse.toStdString();
    EXPECT_EQ(run(kHedrTool, tune).err.toStdString(), of_fuse.toStdString());
    write("log.csv", "t_s,left_ticks,right_ticks,gyro_z_rad_s\n1.6e12,1,2,0\n1.7e12,1,2,0\n");
    expectFailure(tune, {path("log.csv"), "all of its 2 samples were left out"});
}

TEST_F(UnusableNumbers, OfAnEmptyFirstRowHideNoSensor) {
    write("v.toml", kGoodVehicle);
    write("log.csv", "t_s,left_ticks,right_ticks,gyro_z_rad_s\n0,,,\n0.1,3,4,0\n0.2,5,6,0\n");
    for (const char* estimator : {"odometry", "gyro", "gyrodometry", "hedr", "hedr_bayes"}) {
        EXPECT_EQ(run(kHedrTool, fuse(estimator, "track.csv")).exit_code, 0) << estimator;
    }
}

TEST_F(UnusableNumbers, WithoutAHeadingMakeNoTrack) {
    write("v.toml", kGoodVehicle);
    write("log.csv", "t_s,dist_m\n0,0\n0.1,0.1\n0.2,0.2\n");
    for (const char* estimator : {"hedr", "hedr_bayes"}) {
        expectFailure(fuse(estimator, "track.csv"),
                      {path("log.csv"), "it has no heading (", "gyro_z_rad_s", "left_ticks",
                       "odo_heading_rad", QString("which %1 needs").arg(estimator)});
    }
    EXPECT_FALSE(QFile::exists(path("track.csv")));
    expectFailure(fuse("all", "tracks"), {path("log.csv"), "none of the estimators can run"});
    EXPECT_FALSE(QFile::exists(path("tracks")));
    const QString reasons = run(kHedrTool, fuse("all", "tracks")).out;
    for (const char* estimator : {"hedr", "hedr_bayes"}) {
        EXPECT_TRUE(
            reasons.contains(QString("%1 cannot run: there is no heading (").arg(estimator)))
            << reasons.toStdString();
    }
}

TEST_F(UnusableNumbers, OfAThousandColumnsAreNamedInOneShortLine) {
    write("v.toml", kGoodVehicle);
    QByteArray header = "t_s,left_ticks,right_ticks," + QByteArray(1000, 'x');
    QByteArray rest = ",0";
    for (int i = 1; i < 1000; ++i) {
        header += ",c" + QByteArray::number(i);
        rest += ",0";
    }
    write("log.csv", header + "\n0,1,2" + rest + "\n0.1,3,4" + rest + '\n');
    const Outcome fused = run(kHedrTool, fuse("odometry", "track.csv"));
    EXPECT_EQ(fused.exit_code, 0);
    EXPECT_TRUE(fused.err.contains("xxx..., c1, c2, c3, c4, c5, c6, c7 and 992 more\n"))
        << fused.err.toStdString();
    EXPECT_LT(fused.err.size(), 300);
}

TEST_F(UnusableNumbers, TooLargeToBeComparedAreAnError) {
    const QByteArray small = "t_s,x_m,y_m,heading_rad\n0,0,0,0\n1,1,0,0\n2,2,0,0\n";
    write("small.csv", small);
    write("huge.csv", QByteArray(small).replace("1,1,0", "1,1e200,0"));
    for (const char* alignment : {"none", "start", "rigid"}) {
        for (const auto& [track, truth] :
             {std::pair("huge.csv", "small.csv"), std::pair("small.csv", "huge.csv")}) {
            expectFailure({"evaluate", path(track), "--truth", path(truth), "--align", alignment},
                          {path(track), path(truth), "its positions are too large to be compared"});
        }
    }
    const Outcome good =
        run(kHedrTool, {"evaluate", path("small.csv"), "--truth", path("small.csv"), "--json"});
    EXPECT_EQ(good.exit_code, 0) << good.err.toStdString();
    write("v.toml", kGoodVehicle);
    write("log.csv", "t_s,left_ticks,right_ticks\n0,1,2\n1,3,4\n2,5,6\n");
    expectFailure(fuse("all", "tracks") + QStringList{"--truth", path("huge.csv")},
                  {"odometry", "too large to be compared"});
    EXPECT_FALSE(QFile::exists(path("tracks")));
}

}  // namespace
}  // namespace hedr
