// hedr-ocu on a real X server, drawn by the platform plugin that an operator has.
#include <gtest/gtest.h>

#include <QImage>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "tests/e2e/program.h"

namespace hedr {
namespace {

// Number of pixels near the colour of the primary trail by day.
int trailPixels(const QImage& picture) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const QColor colour = picture.pixelColor(x, y);
            if (colour.red() < 20 && std::abs(colour.green() - 0x72) < 12 &&
                std::abs(colour.blue() - 0xB2) < 12) {
                ++count;
            }
        }
    }
    return count;
}

TEST(RealWindow, ShowsTheDemosTrail) {
    const QString server = QStandardPaths::findExecutable("Xvfb");
    if (server.isEmpty()) GTEST_SKIP() << "Xvfb is not installed";
    QProcess screen;
    screen.start(server, {"-displayfd", "1", "-screen", "0", "1600x1000x24", "-nolisten", "tcp"});
    ASSERT_TRUE(screen.waitForReadyRead(20000)) << screen.readAllStandardError().toStdString();
    const QString display = ':' + QString(screen.readAllStandardOutput()).trimmed();

    const QTemporaryDir folder;
    QProcess ocu;
    QProcessEnvironment surroundings = QProcessEnvironment::systemEnvironment();
    surroundings.insert("DISPLAY", display);
    surroundings.insert("QT_QPA_PLATFORM", "xcb");
    surroundings.insert("XDG_DATA_HOME", folder.path());
    surroundings.insert("XDG_CONFIG_HOME", folder.path());
    // Leaks of the X and font libraries at exit are not what is tested here.
    surroundings.insert("ASAN_OPTIONS", "detect_leaks=0");
    ocu.setProcessEnvironment(surroundings);
    ocu.start(kHedrOcu, {"--demo", "--screenshot", folder.filePath("shot.png"), "--after", "8",
                         "--exit-after", "9"});
    ASSERT_TRUE(ocu.waitForFinished(60000));
    EXPECT_EQ(ocu.exitCode(), 0) << ocu.readAllStandardError().toStdString();
    const QImage picture(folder.filePath("shot.png"));
    ASSERT_FALSE(picture.isNull());
    EXPECT_GE(picture.width(), 1024);
    EXPECT_GT(trailPixels(picture), 500);
    screen.terminate();
    screen.waitForFinished(5000);
}

}  // namespace
}  // namespace hedr
