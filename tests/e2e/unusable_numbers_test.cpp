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

TEST_F(UnusableNumbers, OfAnEmptyFirstRowHideNoSensor) {
    write("v.toml", kGoodVehicle);
    write("log.csv", "t_s,left_ticks,right_ticks,gyro_z_rad_s\n0,,,\n0.1,3,4,0\n0.2,5,6,0\n");
    for (const char* estimator : {"odometry", "gyro", "gyrodometry", "hedr", "hedr_bayes"}) {
        EXPECT_EQ(run(kHedr, fuse(estimator, "track.csv")).exit_code, 0) << estimator;
    }
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
        run(kHedr, {"evaluate", path("small.csv"), "--truth", path("small.csv"), "--json"});
    EXPECT_EQ(good.exit_code, 0) << good.err.toStdString();
    write("v.toml", kGoodVehicle);
    write("log.csv", "t_s,left_ticks,right_ticks\n0,1,2\n1,3,4\n2,5,6\n");
    expectFailure(fuse("all", "tracks") + QStringList{"--truth", path("huge.csv")},
                  {"odometry", "too large to be compared"});
    EXPECT_FALSE(QFile::exists(path("tracks")));
}

}  // namespace
}  // namespace hedr
