// `hedr fuse`: which sensor tells the heading.
#include <gtest/gtest.h>

#include <QByteArray>
#include <QFile>

#include "tests/e2e/tool_fixture.h"

namespace hedr {
namespace {

class HedrFuseHeading : public ToolFixture {
  protected:
    // A way that bends slowly; wheels only.
    void writeBend() const {
        QByteArray text("t_s,left_m,right_m\n");
        for (int i = 0; i <= 1000; ++i) {
            text += QByteArray::number(0.1 * i) + ',' + QByteArray::number(0.0497 * i) + ',' +
                    QByteArray::number(0.0503 * i) + '\n';
        }
        write("log.csv", text);
    }
    QByteArray fusedBy(const QStringList& more) const {
        const Outcome fused =
            run(kHedrTool, QStringList{"fuse", path("log.csv"), "--vehicle", "packbot",
                                       "--estimator", "hedr", "--out", path("track.csv")} +
                               more);
        EXPECT_EQ(fused.exit_code, 0) << fused.err.toStdString();
        QFile track(path("track.csv"));
        EXPECT_TRUE(track.open(QIODevice::ReadOnly));
        return track.readAll();
    }
};

// The vehicle file does not say it, and the log leaves no choice.
TEST_F(HedrFuseHeading, IsThatOfTheEncodersWhereThereIsNoGyro) {
    writeBend();
    const QByteArray by_default = fusedBy({});
    EXPECT_EQ(by_default, fusedBy({"--set", "heading_source=encoders"}));
    EXPECT_NE(by_default, fusedBy({"--set", "heading_source=gyro"}));
}

}  // namespace
}  // namespace hedr
