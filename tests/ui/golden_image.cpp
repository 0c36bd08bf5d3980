#include "tests/ui/golden_image.h"

#include <gtest/gtest.h>

#include <QDir>
#include <algorithm>
#include <cstdlib>

namespace hedr::test {
namespace {

constexpr int kTolerance = 40;             // of 255, in one channel
constexpr double kDifferentShare = 0.001;  // of all pixels

int distance(QRgb a, QRgb b) {
    return std::max({std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)),
                     std::abs(qBlue(a) - qBlue(b))});
}

// Red where the pictures differ, a pale copy elsewhere; gives how many pixels differ.
int differences(const QImage& a, const QImage& b, QImage& shown) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const bool differs = distance(a.pixel(x, y), b.pixel(x, y)) > kTolerance;
            const int pale = 192 + qGray(a.pixel(x, y)) / 4;
            shown.setPixel(x, y, differs ? qRgb(220, 0, 0) : qRgb(pale, pale, pale));
            count += differs ? 1 : 0;
        }
    }
    return count;
}

}  // namespace

void expectGolden(const QString& name, const QImage& image) {
    const QString golden_file =
        QStringLiteral(HEDR_SOURCE_DIR "/tests/golden/images/%1.png").arg(name);
    if (qEnvironmentVariableIntValue("HEDR_REFRESH_GOLDEN") == 1) {
        EXPECT_TRUE(image.save(golden_file)) << golden_file.toStdString();
        return;
    }
    const QImage golden = QImage(golden_file).convertToFormat(QImage::Format_RGB32);
    ASSERT_EQ(golden.size(), image.size()) << golden_file.toStdString();
    QImage shown(image.size(), QImage::Format_RGB32);
    const int count = differences(golden, image, shown);
    if (count <= kDifferentShare * image.width() * image.height()) return;
    const QString folder = QStringLiteral(HEDR_BINARY_DIR "/golden");
    QDir().mkpath(folder);
    image.save(QStringLiteral("%1/%2.png").arg(folder, name));
    shown.save(QStringLiteral("%1/%2-difference.png").arg(folder, name));
    ADD_FAILURE() << count << " pixels of " << name.toStdString() << " differ, see "
                  << folder.toStdString();
}

}  // namespace hedr::test
